// Asks a variant's program for a frame, or for values of one GLSL function, and verifies the answer
// before anybody looks at it. Plain functions: checks, demo and study use the same ones.
//
//   RunOutcome run = runRender(program, {.scene = "tilted@85", .size = {256, 256},
//                                        .settings = {"map_size=512"}, .images = {"visibility"}},
//                                        scratch);
//   if (!run.frame) fmt::print("{}\n", run.reason);   // "crashed (segmentation fault)"
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/frame_file.h"
#include "core/process.h"

namespace penumbra {

// What is run: an executable and the folders laid over those it was built with.
struct VariantProgram {
    std::filesystem::path executable = {};
    std::vector<std::filesystem::path> layers = {};
    std::string broken = "";  // it could not be built: "does not compile: depth_bias.cpp:12: …"
    // Where Mesa keeps compiled shaders, and given code distance fields, for other runs; "" = in
    // the scratch folder, for this one.
    std::filesystem::path shaderCache = {};
    std::vector<std::string> environment = {};  // NAME=value, of the child alone
};

// An image of the frame: a name is enough where it has the frame's size.
struct ImageRequest {
    ImageRequest(const char* name) : name(name) {}
    ImageRequest(std::string name) : name(std::move(name)) {}
    // A size of its own: a shadow map, a matrix (4x4); {0, 0}: any.
    ImageRequest(std::string name, glm::ivec2 size) : name(std::move(name)), size(size) {}

    std::string name;
    glm::ivec2 size{-1, -1};  // -1: the frame's
};

struct RenderRequest {
    std::string scene;  // gallery name or path of a .glb
    glm::ivec2 size{256, 256};
    std::vector<std::string> settings = {};  // name=value
    std::vector<ImageRequest> images = {"visibility"};
    bool warm = false;  // draw once before, so that milliseconds hold no shader compilation
    ProcessLimits limits = {};
};

// One row of inputs is one call: vec4 a, b, c, d in the expression.
struct EvaluateRequest {
    std::string chunk;       // the student's file: depth_bias.glsl
    std::string expression;  // a vec4 of a, b, c, d: "vec4(slopeBias(a.x, a.y))"
    std::map<std::string, std::vector<glm::vec4>> inputs;  // "a" … "d", of equal length
    ProcessLimits limits = {};
};

// Several settings in one process, each measured `repetitions` times: app/benchmark.h says what the
// frame holds.
struct SweepRequest {
    std::string scene;
    glm::ivec2 size{512, 512};
    std::vector<std::string> points;  // name=value,name=value
    int repetitions = 3;
    ProcessLimits limits = {};
};

struct RunOutcome {
    std::shared_ptr<const FrameFile> frame;  // null: `reason` says why
    std::string reason;                      // in a person's words
    bool graderFault = false;                // not the program's doing: no points may be lost by it
    double seconds = 0;
    std::size_t peakBytes = 0;
};

RunOutcome runRender(const VariantProgram& program, const RenderRequest& request,
                     const std::filesystem::path& scratch);
RunOutcome runEvaluate(const VariantProgram& program, const EvaluateRequest& request,
                       const std::filesystem::path& scratch);  // frame->images.at("result")
RunOutcome runSweep(const VariantProgram& program, const SweepRequest& request,
                    const std::filesystem::path& scratch);

// The request as a person would type it; equal requests have equal text.
std::string inWords(const RenderRequest& request);

}  // namespace penumbra
