#include "passes_as_data.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "core/error.h"
#include "value_rows.h"

namespace penumbra {

namespace {

void expectOneOf(GLenum value, std::initializer_list<GLenum> known, const char* what,
                 const char* file) {
    if (std::find(known.begin(), known.end(), value) == known.end())
        throw Error(std::string(what) + " cannot be " + std::to_string(value), file,
                    "use a constant that OpenGL knows there");
}

void expectTest(GLenum test, const char* what, const char* file) {
    expectOneOf(
        test,
        {GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS},
        what, file);
}

void expectFactor(GLenum factor, const char* what) {
    expectOneOf(factor,
                {GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR,
                 GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA,
                 GL_ONE_MINUS_DST_ALPHA},
                what, "several_lights.cpp");
}

float stepOf(GLenum operation) {
    if (operation == GL_INCR || operation == GL_INCR_WRAP) return 1.0f;
    if (operation == GL_DECR || operation == GL_DECR_WRAP) return -1.0f;
    return 0.0f;
}

GLenum opposite(GLenum test) {
    switch (test) {
        case GL_LESS:
            return GL_GEQUAL;
        case GL_LEQUAL:
            return GL_GREATER;
        case GL_GREATER:
            return GL_LEQUAL;
        case GL_GEQUAL:
            return GL_LESS;
        case GL_EQUAL:
            return GL_NOTEQUAL;
        case GL_NOTEQUAL:
            return GL_EQUAL;
        case GL_ALWAYS:
            return GL_NEVER;
        default:
            return GL_ALWAYS;
    }
}

}  // namespace

StencilCounting checkedCounting(const StencilCounting& counting, const char* file) {
    expectTest(counting.depthTest, "depthTest", file);
    for (const StencilOperations& side : {counting.front, counting.back})
        for (const GLenum operation : {side.stencilFail, side.depthFail, side.pass})
            expectOneOf(operation,
                        {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP,
                         GL_DECR_WRAP},
                        "a stencil operation", file);
    return counting;
}

LightPass checkedLightPass(const LightPass& pass) {
    expectTest(pass.depthTest, "depthTest", "several_lights.cpp");
    expectTest(pass.stencilTest, "stencilTest", "several_lights.cpp");
    expectFactor(pass.source, "source");
    expectFactor(pass.destination, "destination");
    return pass;
}

StencilCounting exchanged(StencilCounting counting) {
    std::swap(counting.front, counting.back);
    return counting;
}

void beginCounting(const StencilCounting& counting) {
    glDisable(GL_BLEND);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(counting.writesDepth);
    glDepthFunc(counting.depthTest);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    const StencilOperations &front = counting.front, &back = counting.back;
    glStencilOpSeparate(GL_FRONT, front.stencilFail, front.depthFail, front.pass);
    glStencilOpSeparate(GL_BACK, back.stencilFail, back.depthFail, back.pass);
}

FloatCounting floatCounting(const StencilCounting& counting) {
    const float front = stepOf(counting.front.depthFail), back = stepOf(counting.back.depthFail);
    if (front != 0 || back != 0) return {opposite(counting.depthTest), front, back};
    return {counting.depthTest, stepOf(counting.front.pass), stepOf(counting.back.pass)};
}

void beginLightPass(const LightPass& pass) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(pass.writesDepth);
    glDepthFunc(pass.depthTest);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(pass.stencilTest, pass.stencilReference, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glEnablei(GL_BLEND, 0);  // colours add up, visibility is one light's
    glBlendFunc(pass.source, pass.destination);
}

void endStencilPasses() {
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
}

Image countingRows(const StencilCounting& zPass, const StencilCounting& zFail) {
    Image image(8, 2, 1);
    for (int row = 0; row < 2; ++row) {
        const StencilCounting& c = row == 0 ? zPass : zFail;
        const float values[] = {float(c.depthTest),         float(c.writesDepth),
                                float(c.front.stencilFail), float(c.front.depthFail),
                                float(c.front.pass),        float(c.back.stencilFail),
                                float(c.back.depthFail),    float(c.back.pass)};
        std::copy(std::begin(values), std::end(values), &image.at(0, row));
    }
    return image;
}

Image lightPassRow(const LightPass& pass) {
    const float values[] = {float(pass.clearsStencil),    float(pass.depthTest),
                            float(pass.writesDepth),      float(pass.stencilTest),
                            float(pass.stencilReference), float(pass.source),
                            float(pass.destination)};
    return valueRows(values);
}

}  // namespace penumbra
