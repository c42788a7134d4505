#include "gl/texture.h"

#include <algorithm>
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
        case GL_R8:
        case GL_R16F:
        case GL_R32F:
            return {GL_RED, 1};
        case GL_RG8:
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
    glBindTexture(GL_TEXTURE_2D, id_);
    const Transfer transfer = transferOf(description.format);
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(description.format), width, height, 0, transfer.format,
                 transfer.type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GLint(description.filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GLint(description.filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GLint(description.wrap));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GLint(description.wrap));
    if (description.compare) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
}

Texture::~Texture() {
    if (id_) glDeleteTextures(1, &id_);
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, 0)), description_(std::move(other.description_)) {}

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(description_, other.description_);
    return *this;
}

bool Texture::isDepth() const {
    return transferOf(description_.format).format == GL_DEPTH_COMPONENT || hasStencil();
}

bool Texture::hasStencil() const {
    return transferOf(description_.format).format == GL_DEPTH_STENCIL;
}

void Texture::upload(const Image& image) {
    const Transfer transfer = transferOf(description_.format);
    EXPECTS(image.width == size().x && image.height == size().y &&
            image.channels == transfer.channels && !hasStencil());
    Image flipped = image;
    flipRows(flipped);
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size().x, size().y, transfer.format, GL_FLOAT,
                    flipped.pixels.data());
}

void Texture::uploadBytes(const unsigned char* rgba) {
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size().x, size().y, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

Image Texture::read() const {
    EXPECTS(id_ != 0);
    const Transfer transfer = transferOf(description_.format);
    Image image(size().x, size().y, transfer.channels);
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    const GLenum format = hasStencil() ? GLenum(GL_DEPTH_COMPONENT) : transfer.format;
    glGetTexImage(GL_TEXTURE_2D, 0, format, GL_FLOAT, image.pixels.data());
    flipRows(image);
    return image;
}

}  // namespace penumbra
