// A Scene's triangles in GL buffers.
//
//   GpuScene gpuScene(scene);
//   gpuScene.draw(program);                        // every material, for the camera's pass
//   gpuScene.drawDepth(opaque, masked);            // for light passes: one call for all that is
//   opaque
//
// Attributes: 0 vec3 position, 1 vec3 normal, 2 vec2 uv; all in world space. material.glsl reads
// the material's block and texture.
#pragma once

#include <glad/gl.h>

#include <vector>

#include "gl/program.h"
#include "gl/texture.h"
#include "scene/scene.h"

namespace penumbra {

class GpuScene {
public:
    explicit GpuScene(const Scene& scene);
    ~GpuScene();
    GpuScene(const GpuScene&) = delete;
    GpuScene& operator=(const GpuScene&) = delete;

    // `program` is made current.
    void draw(const Program& program) const;
    // Two programs: an alpha test keeps a rasteriser from rejecting depth early, so only those that
    // need it pay.
    void drawDepth(const Program& opaque, const Program& masked) const;

private:
    struct Range {  // of the index buffer, one material
        int material;
        GLsizei count;
        std::size_t firstByte;
    };
    void drawRange(const Program& program, const Range& range) const;

    GLuint vertexArray_ = 0;
    GLuint buffers_[4] = {};  // positions, normals, uvs, indices
    GLuint materialBlock_ = 0;
    GLint materialStride_ = 0;
    std::vector<Range> ranges_;  // opaque materials first
    std::size_t opaqueRanges_ = 0;
    std::vector<int> materialTextures_;  // index into textures_ by material; 0 = white
    std::vector<Texture> textures_;
};

}  // namespace penumbra
