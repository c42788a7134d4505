#include "scene/texture_file.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "core/error.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#if __has_include(<stb/stb_image.h>)
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#else
#include <stb_image.h>
#include <stb_image_write.h>
#endif
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace penumbra {

Texture2D decodeTexture(std::span<const std::uint8_t> bytes, const std::string& where) {
    const int size = int(std::min<std::size_t>(bytes.size(), std::size_t(1) << 30));
    int width = 0, height = 0, channels = 0;
    // The header first: a few bytes can declare a picture of gigabytes.
    if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels))
        throw Error("not a PNG or JPEG picture", where, stbi_failure_reason());
    if (width <= 0 || height <= 0 || std::max(width, height) > STBI_MAX_DIMENSIONS)
        throw Error("picture is too large", where, "use at most 16384 x 16384 pixels");
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), &std::free);
    if (!pixels) throw Error("broken picture", where, stbi_failure_reason());
    const std::size_t count = std::size_t(width) * std::size_t(height) * 4;
    return {width, height, {pixels.get(), pixels.get() + count}};
}

std::vector<std::uint8_t> encodeTexture(const Texture2D& texture) {
    EXPECTS(texture.width > 0 && texture.height > 0 &&
            texture.rgba.size() == 4 * std::size_t(texture.width) * std::size_t(texture.height));
    std::vector<std::uint8_t> png;
    const auto store = [](void* context, void* data, int size) {
        const auto* from = static_cast<std::uint8_t*>(data);
        auto* to = static_cast<std::vector<std::uint8_t>*>(context);
        to->insert(to->end(), from, from + size);
    };
    stbi_write_png_to_func(store, &png, texture.width, texture.height, 4, texture.rgba.data(),
                           4 * texture.width);
    return png;
}

}  // namespace penumbra
