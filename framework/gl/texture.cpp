#include "gl/texture.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/error.h"

namespace penumbra {

namespace {

struct Transfer {
    GLenum format;
    int channels;
    GLenum type = GL_FLOAT;  // of a null upload: depth-stencil pairs know no plain float
};

Transfer transferOf(GLenum internal) {
    switch (internal) {
        case GL_DEPTH_COMPONENT16:
        case GL_DEPTH_COMPONENT24:
        case GL_DEPTH_COMPONENT32F:
            return {GL_DEPTH_COMPONENT, 1};
        case GL_DEPTH24_STENCIL8:
            return {GL_DEPTH_STENCIL, 1, GL_UNSIGNED_INT_24_8};
        case GL_DEPTH32F_STENCIL8:
            return {GL_DEPTH_STENCIL, 1, GL_FLOAT_32_UNSIGNED_INT_24_8_REV};
        case GL_R32UI:
            return {GL_RED_INTEGER, 1, GL_UNSIGNED_INT};
        case GL_RG32UI:
            return {GL_RG_INTEGER, 2, GL_UNSIGNED_INT};
        case GL_RGBA32UI:
            return {GL_RGBA_INTEGER, 4, GL_UNSIGNED_INT};
        case GL_R8:
        case GL_R16:
        case GL_R16F:
        case GL_R32F:
            return {GL_RED, 1};
        case GL_RG8:
        case GL_RG16:
        case GL_RG16F:
        case GL_RG32F:
            return {GL_RG, 2};
        case GL_RGB8:
        case GL_RGB16F:
        case GL_RGB32F:
            return {GL_RGB, 3};
        default:
            return {GL_RGBA, 4};
    }
}

// OpenGL's row 0 is at the bottom, an Image's on top.
void flipRows(Image& image) {
    const auto stride = std::ptrdiff_t(image.width) * image.channels;
    for (int y = 0; y < image.height / 2; ++y)
        std::swap_ranges(image.pixels.begin() + y * stride, image.pixels.begin() + (y + 1) * stride,
                         image.pixels.begin() + (image.height - 1 - y) * stride);
}

std::size_t texelValues(const Texture& texture) {
    return std::size_t(texture.size().x) * std::size_t(texture.size().y) *
           std::size_t(texture.channels());
}

std::size_t liveTextureBytes = 0;

std::size_t bytesPerTexel(GLenum internal) {
    switch (internal) {
        case GL_R8:
            return 1;
        case GL_RG8:
        case GL_R16:
        case GL_R16F:
        case GL_DEPTH_COMPONENT16:
            return 2;
        case GL_RGB8:
            return 3;
        case GL_RGB16F:
            return 6;
        case GL_RG32F:
        case GL_RG32UI:
        case GL_RGBA16:
        case GL_RGBA16F:
        case GL_DEPTH32F_STENCIL8:
            return 8;
        case GL_RGB32F:
            return 12;
        case GL_RGBA32F:
        case GL_RGBA32UI:
            return 16;
        default:
            return 4;
    }
}

std::size_t bytesOf(const TextureDescription& d) {
    std::size_t bytes = 0;
    for (glm::ivec2 size = d.size;; size = glm::max(size / 2, 1)) {
        bytes += bytesPerTexel(d.format) * std::size_t(size.x) * std::size_t(size.y);
        if (!d.mipmaps || size == glm::ivec2(1)) return bytes;
    }
}

}  // namespace

Texture::Texture(const TextureDescription& description) : description_(description) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const auto [width, height] = std::pair(description.size.x, description.size.y);
    if (width < 1 || height < 1 || width > largest || height > largest)
        throw Error("texture cannot have " + std::to_string(width) + "x" + std::to_string(height) +
                        " texels",
                    description.label, "stay within 1 to " + std::to_string(largest));
    glGenTextures(1, &id_);
    liveTextureBytes += bytesOf(description);
    glBindTexture(GL_TEXTURE_2D, id_);
    const Transfer transfer = transferOf(description.format);
    const int levels = description.mipmaps ? std::bit_width(unsigned(std::max(width, height))) : 1;
    for (int level = 0; level < levels; ++level)
        glTexImage2D(GL_TEXTURE_2D, level, GLint(description.format), std::max(1, width >> level),
                     std::max(1, height >> level), 0, transfer.format, transfer.type, nullptr);
    const GLenum between = description.filter == GL_LINEAR ? GLenum(GL_LINEAR_MIPMAP_LINEAR)
                                                           : GLenum(GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    GLint(description.mipmaps ? between : description.filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GLint(description.filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GLint(description.wrap));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GLint(description.wrap));
    if (description.compare) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
}

Texture::~Texture() {
    if (!id_) return;
    glDeleteTextures(1, &id_);
    liveTextureBytes -= bytesOf(description_);
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, 0)), description_(std::move(other.description_)) {}

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(description_, other.description_);
    return *this;
}

std::size_t Texture::liveBytes() { return liveTextureBytes; }

void countTextureBytes(std::ptrdiff_t bytes) { liveTextureBytes += std::size_t(bytes); }

bool Texture::isDepth() const {
    return transferOf(description_.format).format == GL_DEPTH_COMPONENT || hasStencil();
}

bool Texture::hasStencil() const {
    return transferOf(description_.format).format == GL_DEPTH_STENCIL;
}

bool Texture::holdsIntegers() const {
    return transferOf(description_.format).type == GL_UNSIGNED_INT;
}

int Texture::channels() const { return transferOf(description_.format).channels; }

void Texture::generateMipmaps() {
    EXPECTS(description_.mipmaps);
    glBindTexture(GL_TEXTURE_2D, id_);
    glGenerateMipmap(GL_TEXTURE_2D);
}

void Texture::uploadTexels(std::span<const float> texels) {
    EXPECTS(texels.size() == texelValues(*this) && !holdsIntegers() && !hasStencil());
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size().x, size().y,
                    transferOf(description_.format).format, GL_FLOAT, texels.data());
}

void Texture::uploadTexels(std::span<const std::uint32_t> texels) {
    EXPECTS(texels.size() == texelValues(*this) && holdsIntegers());
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size().x, size().y,
                    transferOf(description_.format).format, GL_UNSIGNED_INT, texels.data());
}

std::vector<float> Texture::readTexels() const {
    EXPECTS(id_ != 0 && !holdsIntegers());
    std::vector<float> texels(texelValues(*this));
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    const GLenum format =
        hasStencil() ? GLenum(GL_DEPTH_COMPONENT) : transferOf(description_.format).format;
    glGetTexImage(GL_TEXTURE_2D, 0, format, GL_FLOAT, texels.data());
    return texels;
}

std::vector<std::uint32_t> Texture::readIntegers() const {
    EXPECTS(id_ != 0 && holdsIntegers());
    std::vector<std::uint32_t> texels(texelValues(*this));
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, transferOf(description_.format).format, GL_UNSIGNED_INT,
                  texels.data());
    return texels;
}

void Texture::upload(const Image& image) {
    EXPECTS(image.width == size().x && image.height == size().y && image.channels == channels());
    Image flipped = image;
    flipRows(flipped);
    uploadTexels(std::span<const float>(flipped.pixels));
}

void Texture::uploadBytes(const unsigned char* rgba) {
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size().x, size().y, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

Image Texture::read() const {
    Image image(size().x, size().y, channels());
    image.pixels = readTexels();
    flipRows(image);
    return image;
}

}  // namespace penumbra
