// Runs one GLSL expression on many inputs: how a single function of a chunk is tested and graded.
//
//   Image rows(1000, 1, 4);  …                                  // one row of inputs a pixel
//   Image y = evaluateGlsl(layers, "depth_bias.glsl", "vec4(slopeBias(a.x, a.y, a.z))", {{"a",
//   rows}});
#pragma once

#include <map>
#include <string>

#include "core/image.h"
#include "core/layers.h"

namespace penumbra {

// `inputs`: images of one size with four channels; the expression names them (vec4 a, b, …) and
// yields a vec4. Returns an image of that size with four channels. Throws Error when it does not
// compile.
Image evaluateGlsl(const Layers& layers, const std::string& chunk, const std::string& expression,
                   const std::map<std::string, Image>& inputs);

}  // namespace penumbra
