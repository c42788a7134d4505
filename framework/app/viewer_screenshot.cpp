#include "app/viewer_screenshot.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "core/error.h"
#include "core/image.h"

namespace penumbra {

namespace {

std::filesystem::path freeName(const std::string& scene) {
    std::string name = std::filesystem::path(scene).stem().string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '_'; },
        '-');
    const std::filesystem::path folder = "out/screenshots";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error("cannot make the folder", folder.string(), error.message());
    for (int n = 1;; ++n) {
        const auto path = folder / fmt::format("{}-{}.png", name, n);
        if (!std::filesystem::exists(path, error)) return path;
    }
}

Image readBackBuffer(glm::ivec2 size) {
    std::vector<unsigned char> bytes(3 * std::size_t(size.x) * std::size_t(size.y));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    Image image(size.x, size.y, 3);
    const std::size_t stride = 3 * std::size_t(size.x);
    for (std::size_t y = 0; y < std::size_t(size.y); ++y)  // OpenGL's row 0 is at the bottom
        for (std::size_t i = 0; i < stride; ++i)
            image.pixels[(std::size_t(size.y) - 1 - y) * stride + i] =
                float(bytes[y * stride + i]) / 255.0f;
    return image;
}

}  // namespace

std::filesystem::path saveScreenshot(glm::ivec2 pixels, const std::string& scene) {
    const Image image = readBackBuffer(pixels);
    const auto path = freeName(scene);
    savePng(path, image, Encoding::linear);
    return path;
}

}  // namespace penumbra
