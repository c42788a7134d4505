// C++ twins of the std140 blocks in framework/shaders; a use in GLSL tells its origin (camera.eye).
//
//   UniformBuffer<CameraBlock> block;
//   block.upload(cameraBlock(camera, aspect));
//   block.bind(program, "Camera", 0);
#pragma once

#include <glad/gl.h>

#include <cstddef>
#include <glm/glm.hpp>

#include "gl/program.h"
#include "scene/camera.h"
#include "scene/light.h"

namespace penumbra {

struct CameraBlock {  // camera.glsl
    glm::mat4 clipFromWorld;
    glm::mat4 viewFromWorld;
    glm::vec3 eye;
    float padding = 0;
};
static_assert(offsetof(CameraBlock, viewFromWorld) == 64 && offsetof(CameraBlock, eye) == 128);

struct LightBlock {  // light.glsl
    glm::mat4 viewFromWorld;
    glm::vec3 center;
    float width;
    glm::vec3 right;
    float padding0 = 0;
    glm::vec3 up;
    float padding1 = 0;
    glm::vec3 forward;
    float padding2 = 0;
    glm::vec3 color;
    float inverseRange;
    glm::vec4 position;
};
static_assert(offsetof(LightBlock, center) == 64 && offsetof(LightBlock, width) == 76 &&
              offsetof(LightBlock, right) == 80 && offsetof(LightBlock, up) == 96 &&
              offsetof(LightBlock, forward) == 112 && offsetof(LightBlock, color) == 128 &&
              offsetof(LightBlock, inverseRange) == 140 && offsetof(LightBlock, position) == 144);

CameraBlock cameraBlock(const Camera& camera, glm::ivec2 size);
LightBlock lightBlock(const Light& light);

template <typename Block>
class UniformBuffer {
public:
    UniformBuffer() { glGenBuffers(1, &id_); }
    ~UniformBuffer() { glDeleteBuffers(1, &id_); }
    UniformBuffer(const UniformBuffer&) = delete;
    UniformBuffer& operator=(const UniformBuffer&) = delete;

    void upload(const Block& block) {
        glBindBuffer(GL_UNIFORM_BUFFER, id_);
        glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
    }
    void bind(const Program& program, const char* name, int binding) const {
        program.block(name, binding);
        glBindBufferBase(GL_UNIFORM_BUFFER, GLuint(binding), id_);
    }

private:
    GLuint id_ = 0;
};

}  // namespace penumbra
