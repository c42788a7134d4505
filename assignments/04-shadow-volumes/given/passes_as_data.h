// Your StencilCounting and LightPass, looked through and handed to OpenGL.
#pragma once

#include "core/image.h"
#include "shadow_volumes.h"

namespace penumbra {

// Throw Error for a value that OpenGL does not know there.
StencilCounting checkedCounting(const StencilCounting& counting, const char* file);
LightPass checkedLightPass(const LightPass& pass);

StencilCounting exchanged(StencilCounting counting);  // front and back

// Counting in the stencil buffer. The framebuffer is bound; colours are not written.
void beginCounting(const StencilCounting& counting);

// The same in a float target: what a fragment adds, and which fragments do.
struct FloatCounting {
    GLenum depthTest;
    float front, back;
};
FloatCounting floatCounting(const StencilCounting& counting);

void beginLightPass(const LightPass& pass);
// Back to what other passes take for granted.
void endStencilPasses();

Image countingRows(const StencilCounting& zPass, const StencilCounting& zFail);
Image lightPassRow(const LightPass& pass);

}  // namespace penumbra
