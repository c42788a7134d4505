#include "app/benchmark.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>

#include "app/headless.h"
#include "core/error.h"
#include "core/frame_file.h"
#include "core/metrics.h"
#include "render/passes.h"
#include "scene/gallery.h"
#include "truth/visibility.h"

namespace penumbra {

namespace {

double cpuMilliseconds() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

double wallMilliseconds() {
    return std::chrono::duration<double, std::milli>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// Milliseconds until all of it is drawn. Where the rasteriser is a process, what the machine does
// for others counts against nobody.
template <typename Draw>
double totalMilliseconds(Draw&& draw) {
    glFinish();
    if (usesTimerQueries()) {
        Times times;
        {
            const auto timing = times.time("total");
            draw();
        }
        return times.milliseconds().at("total");
    }
    const double start = cpuMilliseconds();
    draw();
    glFinish();
    return cpuMilliseconds() - start;
}

std::string totalsTimer() { return usesTimerQueries() ? "timer queries" : "process CPU time"; }

struct Repetition {
    double frame = 0, wall = 0, floor = 0;  // floor: mean of the one before and the one after
    std::map<std::string, double> passes = {};
};

struct Variation {
    std::string change;  // "" or name=value,name=value
    std::vector<Repetition> repetitions = {};

    std::vector<double> each(double (*value)(const Repetition&)) const {
        std::vector<double> values;
        for (const Repetition& r : repetitions) values.push_back(value(r));
        return values;
    }
};

// The old values come back even when the frame throws.
template <typename Draw>
void withSettings(Settings& settings, const std::string& change, Draw&& draw) {
    const std::vector<Setting> before = settings.all();
    try {
        for (std::size_t start = 0; start < change.size();) {
            const std::size_t end = std::min(change.find(',', start), change.size());
            settings.assign(change.substr(start, end - start));
            start = end + 1;
        }
        draw();
    } catch (...) {
        settings.all() = before;
        throw;
    }
    settings.all() = before;
}

// Frame, then floor, then the next variation's frame: what the machine does meanwhile is shared by
// all. The session's scene stays; only settings change.
class Bench {
public:
    Bench(Session& session, glm::ivec2 size) : session_(session), size_(size) {}

    void warmUp() {
        for (int i = 0; i < 2; ++i) floorTime();  // shaders compile at the first draw
    }

    // A frame of settings that were just changed makes textures and shaders: not the frame's cost.
    Repetition measure(bool warm, double advance = 0) {
        const double before = floorTime();
        if (warm) session_.render(size_, {{"color"}});
        if (advance > 0) session_.settings().advance(advance);
        Repetition r;
        glFinish();
        const double wall = wallMilliseconds();
        std::optional<Frame> frame;
        r.frame = totalMilliseconds([&] { frame.emplace(session_.render(size_, {{"color"}})); });
        r.wall = wallMilliseconds() - wall;
        r.passes = frame->milliseconds();
        r.floor = 0.5 * (before + floorTime());
        return r;
    }

private:
    double floorTime() {
        return totalMilliseconds([&] { floor_.render(session_.view(size_)); });
    }

    Session& session_;
    glm::ivec2 size_;
    FloorPasses floor_{1024};
};

std::vector<Variation> measureRounds(Session& session, const BenchmarkRequest& request) {
    std::vector<Variation> variations = {{""}};
    for (const std::string& change : request.varied) variations.push_back({change});
    Bench bench(session, request.size);
    bench.warmUp();
    const bool still = request.varied.empty() && !request.play;
    for (int i = 0; i < request.repetitions; ++i)
        for (Variation& v : variations)
            withSettings(session.settings(), v.change, [&] {
                const double advance = request.play ? (i + 1) / 60.0 : 0;
                v.repetitions.push_back(bench.measure(i == 0 || !still, advance));
            });
    return variations;
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

}  // namespace

void printBenchmark(Session& session, const Context& context, const BenchmarkRequest& request) {
    const auto [x, y] = std::pair(request.size.x, request.size.y);
    fmt::print(
        "{} · {} · {}x{} · {} repetitions · milliseconds by {}, minimum / median / maximum\n",
        context.renderer(), context.backend(), x, y, request.repetitions, totalsTimer());
    fmt::print("{:<28} {:>24} {:>24} {:>24} {:>8}\n", "scene", "floor", "frame", "frame / floor",
               "RMSE");
    for (const std::string& name : request.scenes) {
        session.open(loadScene(name));
        for (const Variation& v : measureRounds(session, request))
            withSettings(session.settings(), v.change, [&] {
                const auto floors = v.each([](const Repetition& r) { return r.floor; });
                const auto frames = v.each([](const Repetition& r) { return r.frame; });
                const auto ratios = v.each([](const Repetition& r) { return r.frame / r.floor; });
                fmt::print("{:<28} {:>24} {:>24} {:>24} {:>8.4f}\n",
                           v.change.empty() ? name : "  " + v.change, spread(floors).text(),
                           spread(frames).text(), spread(ratios).text(),
                           rmseAgainstRays(session, request.size));
                std::fflush(stdout);
            });
    }
    throwOnGlErrors();
}

void sweepToFrameFile(Session& session, const Context& context, const BenchmarkRequest& request,
                      const std::filesystem::path& file) {
    FrameFile result{.images = {}, .milliseconds = {}, .info = infoStrings(session, context)};
    Bench bench(session, request.size);
    result.info["totals_timer"] = totalsTimer();
    bench.warmUp();
    const std::size_t before = Texture::liveBytes();
    for (int r = 0; r < request.repetitions; ++r)
        for (std::size_t i = 0; i < request.varied.size(); ++i) {
            if (result.info.count(fmt::format("error.{}", i))) continue;
            try {
                withSettings(session.settings(), request.varied[i], [&] {
                    const Repetition one = bench.measure(true);
                    const std::string at = fmt::format(".{}.{}", i, r);
                    result.milliseconds["frame" + at] = one.frame;
                    result.milliseconds["wall" + at] = one.wall;
                    result.milliseconds["floor" + at] = one.floor;
                    for (const auto& [pass, ms] : one.passes)
                        result.milliseconds["pass" + at + "." + pass] = ms;
                    if (r > 0) return;
                    result.info[fmt::format("bytes.{}", i)] =
                        std::to_string(Texture::liveBytes() - before);
                    const Frame frame = session.render(request.size, {{"visibility"}});
                    result.info[fmt::format("notes.{}", i)] =
                        fmt::format("{}", fmt::join(frame.notes(), "\n"));
                    result.images[fmt::format("visibility.{}", i)] = frame.read().at("visibility");
                });
            } catch (const Error& error) {
                result.info[fmt::format("error.{}", i)] = error.what();
            }
        }
    throwOnGlErrors();
    saveFrameFile(file, result);
}

}  // namespace penumbra
