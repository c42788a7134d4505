// A 3D texture of one float a texel, such as a distance field.
//
//   VolumeTexture volume({.size = grid.size, .format = GL_R16F, .label = "distance field"});
//   volume.upload(values);                  // x fastest, then y, then z
//   program.texture("distanceField", 0, volume);   // sampler3D
#pragma once

#include <glad/gl.h>

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace penumbra {

struct VolumeDescription {
    glm::ivec3 size{0};         // texels, all > 0
    GLenum format = GL_R32F;    // or GL_R16F
    GLenum filter = GL_LINEAR;  // or GL_NEAREST; past the outermost centres their values go on
    std::string label = "";     // named in error messages
};

class VolumeTexture {
public:
    VolumeTexture() = default;
    explicit VolumeTexture(const VolumeDescription& description);
    ~VolumeTexture();
    VolumeTexture(VolumeTexture&& other) noexcept;
    VolumeTexture& operator=(VolumeTexture&& other) noexcept;

    // Texel (x, y, z) at index (z size.y + y) size.x + x; its centre is at (x + 0.5) / size.x, …
    void upload(std::span<const float> texels);
    std::vector<float> read() const;

    GLuint id() const { return id_; }
    glm::ivec3 size() const { return description_.size; }
    const std::string& label() const { return description_.label; }

private:
    GLuint id_ = 0;
    VolumeDescription description_;
};

}  // namespace penumbra
