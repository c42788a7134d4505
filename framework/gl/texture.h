// A 2D texture and the way of its pixels to and from an Image.
//
//   Texture map({.size = {1024, 1024}, .format = GL_DEPTH_COMPONENT32F, .label = "shadow map"});
//   Image depth = map.read();   // one channel, row 0 on top
#pragma once

#include <glad/gl.h>

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/image.h"

namespace penumbra {

struct TextureDescription {
    glm::ivec2 size{0};          // texels, both > 0
    GLenum format = GL_RGBA32F;  // R/RG/RGB/RGBA 8, 16F, 32F, R/RG/RGBA 16, 32UI, SRGB8_ALPHA8,
                                 // DEPTH_COMPONENT16/24/32F, DEPTH24_STENCIL8, DEPTH32F_STENCIL8
    GLenum filter = GL_NEAREST;  // GL_NEAREST or GL_LINEAR; between levels likewise
    GLenum wrap = GL_CLAMP_TO_EDGE;  // GL_CLAMP_TO_BORDER: 0 beyond
    bool mipmaps = false;            // all levels down to 1x1: generateMipmaps() fills them
    bool compare = false;            // depth formats: sampler2DShadow, lit where reference <= texel
    std::string label = "";          // named in error messages
};

class Texture {
public:
    Texture() = default;
    explicit Texture(const TextureDescription& description);
    ~Texture();
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;

    void upload(const Image& image);              // same size, channels fit the format
    void uploadBytes(const unsigned char* rgba);  // 4 bytes a texel, row 0 at v = 0
    Image read() const;                           // of a depth-stencil texture: its depth
    void generateMipmaps();  // 2x2 means, level by level; `mipmaps` was asked for

    // Texels as they lie: row 0 at v = 0. For integer formats the second kind alone.
    void uploadTexels(std::span<const float> texels);
    void uploadTexels(std::span<const std::uint32_t> texels);
    std::vector<float> readTexels() const;
    std::vector<std::uint32_t> readIntegers() const;

    GLuint id() const { return id_; }
    glm::ivec2 size() const { return description_.size; }
    GLenum format() const { return description_.format; }
    const std::string& label() const { return description_.label; }
    bool isDepth() const;  // with or without stencil
    bool hasStencil() const;
    bool holdsIntegers() const;
    int channels() const;

    // Of all textures of this process, mip levels and volumes included.
    static std::size_t liveBytes();

private:
    GLuint id_ = 0;
    TextureDescription description_;
};

// What a texture of another kind adds to liveBytes() when it is made; negative when it goes.
void countTextureBytes(std::ptrdiff_t bytes);

}  // namespace penumbra
