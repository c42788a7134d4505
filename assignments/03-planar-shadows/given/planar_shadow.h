// What you write in C++: two matrices, and how the stencil buffer is set for two passes.
#pragma once

#include <glad/gl.h>

#include <glm/glm.hpp>

namespace penumbra {

// What happens to a fragment. The stencil test compares (reference FUNCTION stored), 8 bits a
// pixel, cleared to 0; then exactly one of the three operations is done to the stored value.
struct DrawState {
    GLenum stencilFunction = GL_ALWAYS;  // GL_NEVER, GL_LESS, GL_EQUAL, GL_ALWAYS …
    int stencilReference = 0;            // 0 to 255
    GLenum stencilFails = GL_KEEP;       // GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR …
    GLenum depthFails = GL_KEEP;         // when the stencil test passes and the depth test fails
    GLenum passes = GL_KEEP;             // when both pass, or the depth test is off
    bool depthTest = true;  // off: drawn whatever stands before it, and depth stays as it is
};

glm::mat4 groundShadowMatrix(glm::vec4 light);                  // shadow_matrix.cpp
glm::mat4 planeShadowMatrix(glm::vec4 plane, glm::vec4 light);  // shadow_matrix.cpp
DrawState receiverDrawing();                                    // shadow_drawing.cpp
DrawState shadowDrawing();                                      // shadow_drawing.cpp

}  // namespace penumbra
