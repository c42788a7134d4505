// penumbra-truth: the ray-traced visibility of a scene's light, for files (./course truth).
//
//   penumbra-truth --scene fence@7 --size 512x512 --samples 256 --out out/truth
//
// Writes visibility.exr, visibility.png and truth.json, all or none. Exit 0 done, 2 bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "app/app.h"
#include "core/error.h"
#include "core/output_folder.h"
#include "core/progress.h"
#include "scene/gallery.h"
#include "truth/visibility.h"

namespace penumbra {

namespace {

struct Options {
    std::string scene, size = "512x512", light = "square", out;
    int samples = 256;
};

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void run(const Options& options) {
    const glm::ivec2 size = parseSize(options.size);
    if (options.samples < 1 || options.samples > 65536)
        throw Error(fmt::format("{} is out of range", options.samples), "--samples",
                    "give 1 to 65536 light points per pixel");
    if (options.light != "square" && options.light != "point")
        throw Error("'" + options.light + "' is not a light", "--light", "write square or point");
    const Scene scene = loadScene(options.scene);
    OutputFolder folder(
        options.out);  // before the long work: a folder that cannot be made is said at once
    const RayTracer tracer(scene);
    const Receivers receivers = tracer.receivers(scene.camera, size);
    const Light& light = scene.lights.at(0);

    const bool square = options.light == "square" && !light.directional;
    const int samples = square ? options.samples : 1;
    const auto start = std::chrono::steady_clock::now();
    Image visibility;
    {
        Progress progress("tracing " + scene.name, size.y);
        visibility = square ? areaVisibility(tracer, receivers, light, samples, &progress)
                            : pointVisibility(tracer, receivers, light);
    }
    const double seconds = secondsSince(start);
    const auto hits = std::count(receivers.hit.begin(), receivers.hit.end(), 1);

    nlohmann::ordered_json json;
    json["scene"] = scene.name;
    json["triangles"] = triangleCount(scene);
    json["size"] = {size.x, size.y};
    json["light"] = light.directional ? "directional" : options.light;
    json["samples"] = samples;
    json["rays"] =
        std::int64_t(hits) * samples;  // those below a horizon are decided without Embree
    json["seconds"] = seconds;
    json["raysPerSecond"] = double(hits) * samples / seconds;
    json["standardError"] =
        square ? standardError(visibility, samples) : 0.0;  // a point leaves no noise
    saveExr(folder.file("visibility.exr"), visibility);
    savePng(folder.file("visibility.png"), visibility, Encoding::linear);
    writeText(folder.file("truth.json"), json.dump(2) + "\n");
    folder.commit();
}

}  // namespace

}  // namespace penumbra

int main(int argc, char** argv) {
    penumbra::Options options;
    CLI::App app("Ray-traced visibility of a scene's light");
    app.add_option("--scene", options.scene,
                   "built-in name, installed model, or path to a .glb or .gltf")
        ->required();
    app.add_option("--size", options.size, "WxH, 1 to 8192 pixels a side")->capture_default_str();
    app.add_option("--samples", options.samples, "light points per pixel, 1 to 65536")
        ->capture_default_str();
    app.add_option("--light", options.light, "square or point (the square's centre)")
        ->capture_default_str();
    app.add_option("--out", options.out, "folder for visibility.exr, visibility.png, truth.json")
        ->required();
    try {
        app.parse(argc, argv);
        penumbra::run(options);
        return 0;
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& e) {
        fmt::print(stderr, "error: {}; see --help\n", e.what());
    } catch (const std::exception& e) {
        fmt::print(stderr, "error: {}\n", e.what());
    }
    return 2;
}
