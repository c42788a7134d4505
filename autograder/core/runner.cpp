#include "core/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>

#include "core/error.h"
#include "core/exit_codes.h"

namespace penumbra {

namespace {

namespace fs = std::filesystem;
using End = ProcessResult::End;

// Its last line of stderr, made safe to print: the program's own words are the best reason.
std::string lastLine(const std::string& text) {
    std::string line, last;
    const auto keep = [&] {
        if (line.find_first_not_of(' ') != std::string::npos) last = line;
        line.clear();
    };
    for (const char c : text) {
        if (c == '\n' || c == '\r')
            keep();
        else if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f)
            line += c;
    }
    keep();
    constexpr std::size_t kLongest = 400;
    return last.size() > kLongest ? last.substr(0, kLongest) + " …" : last;
}

// What is wrong with how the process ended; "" = nothing.
std::string troubleOf(const ProcessResult& process, const ProcessLimits& limits, bool fileExists) {
    if (process.end != End::exited) return inWords(process, limits);
    if (process.code != 0) {
        const std::string line = lastLine(process.standardError);
        if (line.empty()) return inWords(process, limits) + " and no message";
        // "depth_bias.glsl:12: …" says where; say what, too.
        static const std::regex place(R"(^[\w.-]+\.(glsl|vert|frag|geom):\d+: .*)");
        return std::regex_match(line, place) ? "shader does not compile: " + line : line;
    }
    return fileExists ? "" : "ended without a frame (exit 0)";
}

// visibility, depth and color are the seam's own (app/assignment.h): a check may rely on their
// channels.
int expectedChannels(const std::string& name) {
    return name == "visibility" || name == "depth" ? 1
           : name == "color"                       ? 3
           : name == "result"                      ? 4
                                                   : 0;
}

std::string troubleOf(const std::string& name, const Image& image) {
    const std::size_t bad = nonFiniteCount(image);
    if (bad == 0) return "";
    const auto first = std::find_if(image.pixels.begin(), image.pixels.end(),
                                    [](float v) { return !std::isfinite(v); });
    const auto pixel = std::size_t(first - image.pixels.begin()) / std::size_t(image.channels);
    return fmt::format("writes {}: {} of {} values of {}, first at pixel ({}, {})",
                       std::isnan(*first) ? "NaN" : "infinity", bad, image.pixels.size(), name,
                       pixel % std::size_t(image.width), pixel / std::size_t(image.width));
}

std::string troubleOf(const FrameFile& frame, const std::vector<ImageRequest>& asked,
                      glm::ivec2 size) {
    for (const auto& request : asked) {
        const auto it = frame.images.find(request.name);
        if (it == frame.images.end()) return fmt::format("image '{}' missing", request.name);
        const Image& image = it->second;
        const glm::ivec2 want = request.size.x < 0 ? size : request.size;
        if (want.x > 0 && (image.width != want.x || image.height != want.y))
            return fmt::format("wrong size: asked {}x{} of '{}', got {}x{}", want.x, want.y,
                               request.name, image.width, image.height);
        const int channels = expectedChannels(request.name);
        if (channels > 0 && image.channels != channels)
            return fmt::format("wrong channels: '{}' has {}, needs {}", request.name,
                               image.channels, channels);
        if (auto trouble = troubleOf(request.name, image); !trouble.empty()) return trouble;
    }
    for (const auto& entry : frame.images) {
        const std::string& name = entry.first;  // clang 14 captures no structured binding
        if (std::none_of(asked.begin(), asked.end(), [&](const auto& r) { return r.name == name; }))
            return fmt::format("image '{}' was not asked for", name);
    }
    return "";
}

// `verify` says what is wrong with the answer; "" = nothing.
RunOutcome run(const VariantProgram& program, std::vector<std::string> arguments,
               const ProcessLimits& limits, std::size_t images, const fs::path& scratch,
               const std::function<std::string(const FrameFile&)>& verify) {
    RunOutcome outcome;
    if (!program.broken.empty()) {
        outcome.reason = program.broken;
        return outcome;
    }
    // The child works in a folder of its own: inputs of the grader lie outside it.
    const fs::path folder = scratch / "child";
    const fs::path file = folder / "answer.frame";
    fs::remove(file);
    fs::create_directories(folder);
    arguments.insert(arguments.end(), {"--frame-file", file.string()});
    for (const auto& layer : program.layers)
        arguments.insert(arguments.end(), {"--layer", layer.string()});
    std::vector<std::string> environment = program.environment;
    if (!program.shaderCache.empty())
        environment.insert(environment.end(),
                           {"MESA_SHADER_CACHE_DIR=" + program.shaderCache.string(),
                            "MESA_SHADER_CACHE_MAX_SIZE=256M",
                            "PENUMBRA_CACHE=" + (program.shaderCache / "penumbra").string()});
    const auto process = runProcess({.program = program.executable,
                                     .arguments = arguments,
                                     .folder = folder,
                                     .environment = environment,
                                     .limits = limits});
    outcome.seconds = process.seconds;
    outcome.peakBytes = process.peakBytes;
    outcome.reason = troubleOf(process, limits, fs::exists(fs::symlink_status(file)));
    outcome.graderFault = process.end == End::notStarted ||
                          (process.end == End::exited && process.code == kExitNoOpenGl);
    if (outcome.reason.empty()) try {
            auto frame = std::make_shared<FrameFile>(loadFrameFile(
                file, {.maximumBytes = limits.fileBytes, .maximumImages = int(images) + 8}));
            outcome.reason = verify(*frame);
            if (outcome.reason.empty()) outcome.frame = std::move(frame);
        } catch (const Error& error) {
            outcome.reason = error.what();
        }
    std::error_code ignored;
    fs::remove_all(file, ignored);  // it may be a folder, out of malice
    return outcome;
}

}  // namespace

std::string inWords(const RenderRequest& request) {
    std::string text = fmt::format("render --scene {} --size {}x{}", request.scene, request.size.x,
                                   request.size.y);
    for (const auto& setting : request.settings) text += " --set " + setting;
    for (const auto& image : request.images) text += " --image " + image.name;
    if (request.warm) text += " --warm";
    return text;
}

RunOutcome runRender(const VariantProgram& program, const RenderRequest& request,
                     const fs::path& scratch) {
    std::vector<std::string> arguments = {"render", "--scene", request.scene, "--size",
                                          fmt::format("{}x{}", request.size.x, request.size.y)};
    for (const auto& setting : request.settings)
        arguments.insert(arguments.end(), {"--set", setting});
    for (const auto& image : request.images)
        arguments.insert(arguments.end(), {"--image", image.name});
    if (request.warm) arguments.push_back("--warm");
    return run(program, std::move(arguments), request.limits, request.images.size(), scratch,
               [&](const FrameFile& f) { return troubleOf(f, request.images, request.size); });
}

RunOutcome runEvaluate(const VariantProgram& program, const EvaluateRequest& request,
                       const fs::path& scratch) {
    FrameFile rows;
    std::size_t count = 0;
    for (const auto& [name, values] : request.inputs) {
        if (values.empty() || values.size() > 8192 || (count > 0 && values.size() != count))
            throw Error("evaluate needs 1 to 8192 rows, as many for every input", "input " + name,
                        "repair the check");
        count = values.size();
        Image image(int(count), 1, 4);
        for (std::size_t i = 0; i < count; ++i)
            for (int c = 0; c < 4; ++c) image.at(int(i), 0, c) = values[i][c];
        rows.images.emplace(name, std::move(image));
    }
    if (count == 0) throw Error("evaluate has no inputs", request.chunk, "repair the check");
    const fs::path inputs = scratch / "rows.frame";
    saveFrameFile(inputs, rows);
    return run(program,
               {"evaluate", "--chunk", request.chunk, "--expression", request.expression,
                "--inputs", inputs.string()},
               request.limits, 1, scratch, [&](const FrameFile& f) {
                   return troubleOf(f, {"result"}, {int(count), 1});
               });
}

RunOutcome runSweep(const VariantProgram& program, const SweepRequest& request,
                    const fs::path& scratch) {
    std::vector<std::string> arguments = {"sweep",
                                          "--scene",
                                          request.scene,
                                          "--size",
                                          fmt::format("{}x{}", request.size.x, request.size.y),
                                          "--repeat",
                                          std::to_string(request.repetitions)};
    for (const auto& point : request.points) arguments.insert(arguments.end(), {"--vary", point});
    return run(program, std::move(arguments), request.limits, request.points.size(), scratch,
               [&](const FrameFile& f) {
                   std::vector<ImageRequest> images;  // of the points that did not fail
                   for (std::size_t i = 0; i < request.points.size(); ++i)
                       if (!f.info.count(fmt::format("error.{}", i)))
                           images.emplace_back(fmt::format("visibility.{}", i));
                   return troubleOf(f, images, request.size);
               });
}

}  // namespace penumbra
