#include "app/headless.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/frame_file.h"
#include "core/metrics.h"
#include "core/output_folder.h"
#include "gl/timer.h"
#include "render/passes.h"
#include "scene/gallery.h"
#include "truth/visibility.h"

namespace penumbra {

namespace {

std::map<std::string, std::string> infoStrings(Session& session, const Context& context) {
    return {{"light_model",
             session.assignment().lightModel() == LightModel::point ? "point" : "square"},
            {"directional_lights",
             session.assignment().takesDirectionalLights() ? "parallel" : "far point"},
            {"context", context.backend()},
            {"renderer", context.renderer()},
            {"version", context.version()},
            {"vendor", context.vendor()},
            {"timer", usesTimerQueries() ? "timer queries" : "glFinish and a steady clock"}};
}

// Depth and other unbounded images are stretched to [0,1] for the eye; the .exr keeps the values.
Image stretched(const Image& image) {
    float low = 1e30f, high = -1e30f;
    for (const float v : image.pixels)
        if (std::isfinite(v) && v < 1.0f) low = std::min(low, v), high = std::max(high, v);
    if (high <= low) return image;
    Image result = image;
    for (float& v : result.pixels) v = (v - low) / (high - low);
    return result;
}

void savePicture(const std::filesystem::path& path, const std::string& name, const Image& image) {
    const bool depth =
        name.find("depth") != std::string::npos || name.find("map") != std::string::npos;
    savePng(path, depth && image.channels == 1 ? stretched(image) : image,
            name == "color" ? Encoding::srgb : Encoding::linear);
}

double cpuMilliseconds() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

double wallMilliseconds() {
    return std::chrono::duration<double, std::milli>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

struct Spread {
    double minimum, median, maximum;
    std::string text() const {
        return fmt::format("{:.2f} / {:.2f} / {:.2f}", minimum, median, maximum);
    }
};

Spread spread(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {values.front(), values[values.size() / 2], values.back()};
}

double rmseAgainstRays(Session& session, glm::ivec2 size) {
    constexpr int kSamples = 256;  // standard error at most 1/32 in the middle of a penumbra
    const Image mine = session.render(size, {{"visibility"}}).read().at("visibility");
    const RayTracer tracer(session.scene());
    const Receivers receivers = tracer.receivers(session.camera, size);
    const Image truth = session.assignment().lightModel() == LightModel::point
                            ? pointVisibility(tracer, receivers, session.light)
                            : areaVisibility(tracer, receivers, session.light, kSamples);
    return compareVisibility(mine, truth).rmse;
}

// One row of the table: the settings as given, or one of them changed.
struct Variation {
    std::string name;  // "" or name=value
    std::vector<double> frames = {}, ratios = {};
};

// Rounds in which the floor and every variation stand side by side, so that what the machine does
// meanwhile is shared by all.
struct Rounds {
    std::vector<double> floors = {};
    std::vector<Variation> variations = {};
};

// The old value comes back even when the frame throws.
template <typename Draw>
void withSetting(Settings& settings, const std::string& assignment, Draw&& draw) {
    const std::vector<Setting> before = settings.all();
    try {
        if (!assignment.empty()) settings.assign(assignment);
        draw();
    } catch (...) {
        settings.all() = before;
        throw;
    }
    settings.all() = before;
}

Rounds measureRounds(Session& session, const BenchmarkRequest& request, double (*now)()) {
    const auto measure = [&](auto&& draw) {
        glFinish();
        const double start = now();
        draw();
        glFinish();
        return now() - start;
    };
    Rounds rounds{.variations = {{""}}};
    for (const std::string& assignment : request.varied) rounds.variations.push_back({assignment});
    FloorPasses floorPasses(1024);
    const auto floorTime = [&] {
        return measure([&] { floorPasses.render(session.view(request.size)); });
    };
    const auto frame = [&] { session.render(request.size, {{"color"}}); };
    constexpr int kWarmUp = 2;  // shaders compile at the first draw
    for (int i = -kWarmUp; i < request.repetitions; ++i) {
        double floorBefore = floorTime();
        for (Variation& v : rounds.variations)
            withSetting(session.settings(), v.name, [&] {
                // Once unmeasured: what a change of settings costs is not the frame's cost.
                if (!request.varied.empty() || request.play) frame();
                if (request.play) session.settings().advance((i + kWarmUp + 1) / 60.0);
                const double frameTime = measure(frame);
                const double floorAfter = floorTime();
                if (i < 0) return;
                rounds.floors.push_back(0.5 * (floorBefore + floorAfter));
                v.frames.push_back(frameTime);
                v.ratios.push_back(frameTime / rounds.floors.back());
                floorBefore = floorAfter;
            });
    }
    return rounds;
}

}  // namespace

void renderToFolder(Session& session, const Context& context, glm::ivec2 size,
                    const std::optional<std::set<std::string>>& wanted,
                    const std::filesystem::path& out) {
    const Frame frame = session.render(size, wanted);
    const auto images = frame.read();
    throwOnGlErrors();
    nlohmann::ordered_json json;
    json["scene"] = session.scene().name;
    json["size"] = {size.x, size.y};
    json["triangles"] = triangleCount(session.scene());
    for (const Setting& s : session.settings().all()) json["settings"][s.name] = Settings::text(s);
    for (const auto& [pass, ms] : frame.milliseconds()) json["milliseconds"][pass] = ms;
    if (!frame.notes().empty()) json["notes"] = frame.notes();
    for (const auto& [key, value] : infoStrings(session, context)) json["gl"][key] = value;
    for (const auto& [name, image] : images) {
        if (const auto bad = nonFiniteCount(image))
            throw Error(fmt::format("{} of {} values are not finite", bad, image.pixels.size()),
                        "image " + name,
                        "look for a division by zero or the root of a negative number");
        json["images"][name] = {image.width, image.height, image.channels};
    }
    OutputFolder folder(out);
    for (const auto& [name, image] : images) {
        saveExr(folder.file(name + ".exr"), image);
        savePicture(folder.file(name + ".png"), name, image);
    }
    writeText(folder.file("frame.json"), json.dump(2) + "\n");
    folder.commit();
}

void renderToFrameFile(Session& session, const Context& context, glm::ivec2 size,
                       const std::optional<std::set<std::string>>& wanted,
                       const std::filesystem::path& file) {
    const Frame frame = session.render(size, wanted);
    FrameFile result{.images = frame.read(),
                     .milliseconds = frame.milliseconds(),
                     .info = infoStrings(session, context)};
    result.info["notes"] = fmt::format("{}", fmt::join(frame.notes(), "\n"));
    throwOnGlErrors();
    saveFrameFile(file, result);
}

void printBenchmark(Session& session, const Context& context, const BenchmarkRequest& request) {
    const auto [x, y] = std::pair(request.size.x, request.size.y);
    fmt::print("{} · {} · {}x{} · {} repetitions · {} milliseconds, minimum / median / maximum\n",
               context.renderer(), context.backend(), x, y, request.repetitions,
               context.software() ? "process CPU" : "wall-clock");
    fmt::print("{:<28} {:>24} {:>24} {:>24} {:>8}\n", "scene", "floor", "frame", "frame / floor",
               "RMSE");
    for (const std::string& name : request.scenes) {
        session.open(loadScene(name));
        const Rounds rounds = measureRounds(
            session, request, context.software() ? cpuMilliseconds : wallMilliseconds);
        for (const Variation& v : rounds.variations)
            withSetting(session.settings(), v.name, [&] {
                fmt::print("{:<28} {:>24} {:>24} {:>24} {:>8.4f}\n",
                           v.name.empty() ? name : "  " + v.name, spread(rounds.floors).text(),
                           spread(v.frames).text(), spread(v.ratios).text(),
                           rmseAgainstRays(session, request.size));
                std::fflush(stdout);
            });
    }
    throwOnGlErrors();
}

}  // namespace penumbra
