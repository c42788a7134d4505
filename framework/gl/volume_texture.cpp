#include "gl/volume_texture.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "gl/texture.h"

namespace penumbra {

namespace {

std::size_t texelCount(glm::ivec3 size) {
    return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

std::ptrdiff_t bytesOf(const VolumeDescription& d) {
    return std::ptrdiff_t(texelCount(d.size)) * (d.format == GL_R16F ? 2 : 4);
}

}  // namespace

VolumeTexture::VolumeTexture(const VolumeDescription& description) : description_(description) {
    const glm::ivec3 size = description.size;
    GLint largest = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
    if (std::min({size.x, size.y, size.z}) < 1 || std::max({size.x, size.y, size.z}) > largest)
        throw Error("volume texture cannot have " + std::to_string(size.x) + "x" +
                        std::to_string(size.y) + "x" + std::to_string(size.z) + " texels",
                    description.label, "stay within 1 to " + std::to_string(largest));
    EXPECTS(description.format == GL_R32F || description.format == GL_R16F);
    glGenTextures(1, &id_);
    countTextureBytes(bytesOf(description));
    glBindTexture(GL_TEXTURE_3D, id_);
    glTexImage3D(GL_TEXTURE_3D, 0, GLint(description.format), size.x, size.y, size.z, 0, GL_RED,
                 GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GLint(description.filter));
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GLint(description.filter));
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
}

VolumeTexture::~VolumeTexture() {
    if (!id_) return;
    glDeleteTextures(1, &id_);
    countTextureBytes(-bytesOf(description_));
}

VolumeTexture::VolumeTexture(VolumeTexture&& other) noexcept
    : id_(std::exchange(other.id_, 0)), description_(std::move(other.description_)) {}

VolumeTexture& VolumeTexture::operator=(VolumeTexture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(description_, other.description_);
    return *this;
}

void VolumeTexture::upload(std::span<const float> texels) {
    EXPECTS(id_ != 0 && texels.size() == texelCount(size()));
    glBindTexture(GL_TEXTURE_3D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, size().x, size().y, size().z, GL_RED, GL_FLOAT,
                    texels.data());
}

std::vector<float> VolumeTexture::read() const {
    EXPECTS(id_ != 0);
    std::vector<float> texels(texelCount(size()));
    glBindTexture(GL_TEXTURE_3D, id_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTexImage(GL_TEXTURE_3D, 0, GL_RED, GL_FLOAT, texels.data());
    return texels;
}

}  // namespace penumbra
