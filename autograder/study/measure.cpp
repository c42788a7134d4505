#include "study/measure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/handout_hash.h"
#include "core/progress.h"
#include "scene/gallery.h"
#include "truth/scene_truth.h"
#include "truth/visibility.h"

namespace penumbra {

namespace {

namespace fs = std::filesystem;

constexpr int kPictureSide = 256;  // pixels, on the page

std::vector<std::string> pointsOf(const StudyProgram& program, bool quick) {
    std::vector<std::string> points;
    for (const StudyCurve& curve : program.curves) {
        const auto& part = quick ? curve.quick : curve.points;
        points.insert(points.end(), part.begin(), part.end());
    }
    return points;
}

// Of a submission's files: they are staged anew each time, so that their dates say nothing.
std::string layersHash(const VariantProgram& program) {
    std::vector<fs::path> files;
    for (const fs::path& layer : program.layers)
        for (const auto& entry : fs::directory_iterator(layer)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::string hashes;
    for (const fs::path& file : files) hashes += contentHash(file) + " ";
    return hashes;
}

// The name under which an answer is kept: anything that changes the question changes it.
std::string keptName(const StudyRequest& request, const StudyProgram& program,
                     const std::string& scene, int round) {
    const std::string question =
        fmt::format("{}x{} {} {} {} {}", request.size.x, request.size.y, request.repetitions,
                    fmt::join(pointsOf(program, request.quick), " "),
                    fs::last_write_time(program.program.executable).time_since_epoch().count(),
                    layersHash(program.program));
    return fmt::format("{}-{}-{}-{:016x}.frame", scene, program.name, round,
                       std::hash<std::string>()(question));
}

// The answer of an interrupted study, or null.
std::shared_ptr<const FrameFile> keptAnswer(const fs::path& file) {
    if (!fs::exists(file)) return nullptr;
    try {
        return std::make_shared<FrameFile>(loadFrameFile(file, {.maximumImages = 256}));
    } catch (const Error&) {
        return nullptr;  // cut short by the interruption
    }
}

Image shrunk(const Image& image) {
    const int factor = std::max(1, image.width / kPictureSide);
    Image small(image.width / factor, image.height / factor, 1);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            float sum = 0;
            for (int j = 0; j < factor; ++j)
                for (int i = 0; i < factor; ++i) sum += image.at(factor * x + i, factor * y + j);
            small.at(x, y) = sum / float(factor * factor);
        }
    return small;
}

// All answers about one scene, by program and round.
struct Answer {
    const StudyProgram* program;
    std::string scene;
    std::vector<std::shared_ptr<const FrameFile>> rounds = {};
    std::string error = "";
};

class Truths {
public:
    Truths(const StudyRequest& request, StudyResults& results)
        : request_(request), results_(results) {}

    // One tracer at a time: scenes come one after the other.
    const Image& of(const std::string& scene, const std::string& light) {
        const std::string key = scene + " " + light;
        if (const auto it = images_.find(key); it != images_.end()) return it->second;
        Scene opened = loadScene(scene);
        for (Light& l : opened.lights) l.directional = false;
        const RayTracer tracer(opened);
        const Receivers receivers = tracer.receivers(opened.camera, request_.size);
        StudyTruth truth{.scene = scene, .light = light, .samples = 1, .picture = "truth " + key};
        Image image;
        if (light == "point")
            image = pointVisibility(tracer, receivers, opened.lights[0]);
        else if (auto exact = exactVisibility(opened, receivers)) {
            image = std::move(*exact);
            truth.samples = 0;
        } else
            image = averaged(tracer, receivers, opened.lights[0], truth);
        results_.pictures[truth.picture] = shrunk(image);
        results_.truths.push_back(truth);
        return images_[key] = std::move(image);
    }

private:
    // Two halves that share no ray: their difference is the noise.
    Image averaged(const RayTracer& tracer, const Receivers& receivers, const Light& light,
                   StudyTruth& truth) const {
        const int half = std::max(1, request_.truthSamples / 2);
        Image a = areaVisibility(tracer, receivers, light, half, nullptr, 1);
        const Image b = areaVisibility(tracer, receivers, light, half, nullptr, 2);
        double squares = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            const double difference = a.pixels[i] - b.pixels[i];
            squares += difference * difference;
            a.pixels[i] = 0.5f * (a.pixels[i] + b.pixels[i]);
        }
        truth.samples = 2 * half;
        truth.standardError = 0.5 * std::sqrt(squares / double(a.pixels.size()));
        return a;
    }

    const StudyRequest& request_;
    StudyResults& results_;
    std::map<std::string, Image> images_;
};

std::vector<Answer> ask(const StudyRequest& request) {
    std::vector<Answer> answers;
    for (const std::string& scene : request.scenes)
        for (const StudyProgram& program : request.programs) answers.push_back({&program, scene});
    fs::create_directories(request.kept);
    Progress progress("study", long(answers.size()) * request.rounds);
    for (int round = 0; round < request.rounds; ++round)
        for (Answer& answer : answers) {
            const fs::path file =
                request.kept / keptName(request, *answer.program, answer.scene, round);
            auto frame = keptAnswer(file);
            if (!frame && answer.error.empty()) {
                const ScratchFolder scratch;
                const RunOutcome run =
                    runSweep(answer.program->program,
                             {.scene = answer.scene,
                              .size = request.size,
                              .points = pointsOf(*answer.program, request.quick),
                              .repetitions = request.repetitions,
                              .limits = {.wallSeconds = 900, .cpuSeconds = 3600}},
                             scratch.path());
                answer.error = run.reason;
                frame = run.frame;
                if (frame) saveFrameFile(file, *frame);
            }
            if (frame) answer.rounds.push_back(std::move(frame));
            progress.advance();
        }
    return answers;
}

// Of variation i, over all rounds.
std::vector<double> values(const Answer& answer, const std::string& kind, std::size_t i) {
    std::vector<double> result;
    for (const auto& frame : answer.rounds)
        for (int r = 0;; ++r) {
            const auto it = frame->milliseconds.find(fmt::format("{}.{}.{}", kind, i, r));
            if (it == frame->milliseconds.end()) break;
            result.push_back(it->second);
        }
    return result;
}

std::map<std::string, double> passMedians(const Answer& answer, std::size_t i) {
    std::map<std::string, std::vector<double>> passes;
    const std::string start = fmt::format("pass.{}.", i);
    for (const auto& frame : answer.rounds)
        for (const auto& [key, ms] : frame->milliseconds)
            if (key.rfind(start, 0) == 0)
                passes[key.substr(key.find('.', start.size()) + 1)].push_back(ms);
    std::map<std::string, double> medians;
    for (auto& [pass, ms] : passes) medians[pass] = spread(ms).median;
    return medians;
}

void measurePoint(const Answer& answer, std::size_t i, const Image& truth, StudyPoint& point) {
    const FrameFile& first = *answer.rounds.front();
    const Image& mine = first.images.at(fmt::format("visibility.{}", i));
    point.metrics = compareVisibility(mine, truth);
    const std::vector<double> frames = values(answer, "frame", i),
                              floors = values(answer, "floor", i);
    std::vector<double> ratios;
    for (std::size_t r = 0; r < frames.size(); ++r) ratios.push_back(frames[r] / floors[r]);
    point.frame = spread(frames);
    point.floor = spread(floors);
    point.floors = spread(ratios);
    point.wall = spread(values(answer, "wall", i));
    point.passes = passMedians(answer, i);
    point.textureBytes = std::stod(first.info.at(fmt::format("bytes.{}", i)));
    point.notes = first.info.at(fmt::format("notes.{}", i));
    point.picture =
        fmt::format("{} {} {} {}", point.scene, point.program, point.curve, point.settings);
}

}  // namespace

StudyResults measure(const StudyRequest& request) {
    StudyResults results;
    results.size = request.size;
    results.quick = request.quick;
    results.repetitions = request.rounds * request.repetitions;
    for (const std::string& scene : request.scenes) loadScene(scene);  // complain before the work
    Truths truths(request, results);
    for (const Answer& answer : ask(request)) {
        std::size_t i = 0;
        for (const StudyCurve& curve : answer.program->curves)
            for (const std::string& settings : request.quick ? curve.quick : curve.points) {
                StudyPoint point{.program = answer.program->name,
                                 .curve = curve.name,
                                 .scene = answer.scene,
                                 .settings = settings,
                                 .error = answer.error,
                                 .competitor = answer.program->competitor,
                                 .submission = answer.program->submission};
                if (!answer.rounds.empty()) {
                    const auto& info = answer.rounds.front()->info;
                    point.light = info.at("light_model");
                    results.renderer = info.at("renderer");
                    results.version = info.at("version");
                    results.timer = info.at("timer");
                    results.totalsTimer = info.at("totals_timer");
                    if (const auto it = info.find(fmt::format("error.{}", i)); it != info.end())
                        point.error = it->second;
                }
                if (point.error.empty()) {
                    measurePoint(answer, i, truths.of(answer.scene, point.light), point);
                    results.pictures[point.picture] =
                        shrunk(answer.rounds.front()->images.at(fmt::format("visibility.{}", i)));
                }
                results.points.push_back(std::move(point));
                ++i;
            }
    }
    findFronts(results.points);
    for (const StudyTruth& t : results.truths)
        for (const StudyPoint& p : results.points)
            if (p.error.empty() && p.scene == t.scene && p.light == t.light &&
                p.metrics.rmse < 3 * t.standardError)
                results.warnings.push_back(fmt::format(
                    "{}: {}, {}: error {:.4f} is below 3 times the truth's own standard error "
                    "{:.4f}",
                    t.scene, p.curve, p.settings.empty() ? "defaults" : p.settings, p.metrics.rmse,
                    t.standardError));
    return results;
}

}  // namespace penumbra
