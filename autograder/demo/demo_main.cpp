// `./course demo`: every solution graded, and rendered beside ray-traced truth on every scene; one
// page.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/cache_folder.h"
#include "core/error.h"
#include "core/metrics.h"
#include "core/output_folder.h"
#include "core/progress.h"
#include "core/runner.h"
#include "core/variant.h"
#include "demo/page.h"
#include "scene/gallery.h"
#include "truth/visibility.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

constexpr glm::ivec2 kSize{640, 480};
constexpr int kTruthSamples = 256;  // standard error at most 1/32 in the middle of a penumbra

// Compiled shaders and distance fields are made once, not in every child and again in the next
// demo: all that runs here is the tree's own.
fs::path keptFolder() {
    const fs::path folder = fs::absolute(cacheFolder() / "demo");
    fs::create_directories(folder);
    return folder;
}

std::vector<std::string> solvedAssignments() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(repositoryRoot() / "assignments"))
        if (fs::is_directory(repositoryRoot() / "solutions" / entry.path().filename()))
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

DemoGrade grade(const Place& place, const fs::path& out) {
    const fs::path grader = place.build / "bin" / (place.assignment + ".grade");
    const ScratchFolder scratch;
    const Command command{.program = grader,
                          .arguments = {"--solution", "--out", (out / place.assignment).string(),
                                        "--shader-cache", keptFolder().string()},
                          .folder = scratch.path(),
                          .limits = {.wallSeconds = 600, .cpuSeconds = 1200}};
    const ProcessResult result = runProcess(command);
    std::ifstream file(out / place.assignment / "results.json");
    if (!file)
        throw Error("no grade", place.assignment,
                    inWords(result, command.limits) + " " + result.standardError);
    const auto json = nlohmann::json::parse(file);
    return {.assignment = place.assignment,
            .score = json.at("score"),
            .seconds = json.at("execution_time"),
            .report = place.assignment + "/report.html"};
}

// Rays, once for all assignments that are held against the same.
class Truths {
public:
    const Image& visibility(const std::string& sceneName, const Scene& scene, bool point) {
        Image& image = images_[{sceneName, scene.lights[0].directional, point}];
        if (!image.empty()) return image;
        const RayTracer tracer(scene);
        const Receivers receivers = tracer.receivers(scene.camera, kSize);
        image = point ? pointVisibility(tracer, receivers, scene.lights[0])
                      : areaVisibility(tracer, receivers, scene.lights[0], kTruthSamples);
        return image;
    }

private:
    std::map<std::tuple<std::string, bool, bool>, Image> images_;
};

DemoCard card(const Place& place, const std::string& sceneName, Truths& truths,
              const fs::path& pictures) {
    const ScratchFolder scratch;
    VariantProgram program = solutionVariant(place).program;
    program.shaderCache = keptFolder();
    const RunOutcome run = runRender(program,
                                     {.scene = sceneName,
                                      .size = kSize,
                                      .images = {"visibility", "color"},
                                      .warm = true,
                                      .limits = {.wallSeconds = 120, .cpuSeconds = 240}},
                                     scratch.path());
    if (!run.frame) throw Error("no picture", place.assignment + " on " + sceneName, run.reason);
    Scene scene = loadScene(sceneName);
    if (run.frame->info.at("directional_lights") == "far point")
        for (Light& light : scene.lights) light.directional = false;
    const bool point = run.frame->info.at("light_model") == "point";
    const Image& truth = truths.visibility(sceneName, scene, point);
    const Image& mine = run.frame->images.at("visibility");
    const std::string stem = place.assignment + "-" + sceneName;
    savePng(pictures / (stem + "-color.png"), run.frame->images.at("color"), Encoding::srgb);
    savePng(pictures / (stem + "-mine.png"), mine, Encoding::linear);
    savePng(pictures / (stem + "-truth.png"), truth, Encoding::linear);
    savePng(pictures / (stem + "-difference.png"), falseColorDifference(mine, truth),
            Encoding::linear);
    return {.assignment = place.assignment,
            .scene = sceneName,
            .triangles = triangleCount(scene),
            .milliseconds = run.frame->milliseconds,
            .notes = run.frame->info.at("notes"),
            .metrics = compareVisibility(mine, truth),
            .stem = stem};
}

void demo(const fs::path& build, const fs::path& out) {
    const auto assignments = solvedAssignments();
    if (assignments.empty())
        throw Error("nothing to show", "solutions/", "this tree holds no solutions");
    std::vector<std::string> scenes = builtInSceneNames();
    const auto models = installedModelNames();
    scenes.insert(scenes.end(), models.begin(), models.end());

    OutputFolder folder(out);
    const fs::path pictures = folder.file("pictures");
    fs::create_directories(pictures);
    DemoPage page;
    Truths truths;
    Progress progress("demo", long(assignments.size() * (scenes.size() + 4)));
    for (const std::string& assignment : assignments) {
        const Place place{.root = repositoryRoot(), .build = build, .assignment = assignment};
        page.grades.push_back(grade(place, folder.file("grades")));
        progress.advance(4);
        for (const std::string& scene : scenes) {
            page.cards.push_back(card(place, scene, truths, pictures));
            progress.advance();
        }
    }
    writeText(folder.file("index.html"), demoPage(page));
    folder.commit();
    for (const DemoGrade& g : page.grades)
        fmt::print("{:<24} {:g} of 100 points\n", g.assignment, g.score);
    fmt::print("{} pictures on {} scenes, {} of them models\n{}\n", page.cards.size(),
               scenes.size(), models.size(), (out / "index.html").string());
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
    CLI::App app("Grades and renders every solution, and makes one page of it");
    std::string out = (penumbra::repositoryRoot() / "out/demo").string();
    app.add_option("--out", out, "folder of the page");
    CLI11_PARSE(app, argc, argv);
    try {
        penumbra::demo(PENUMBRA_BUILD, out);
        return 0;
    } catch (const std::exception& e) {
        fmt::print(stderr, "error: {}\n", e.what());
        return 2;
    }
}
