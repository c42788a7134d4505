#include "app/app.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>

#include "app/benchmark.h"
#include "app/headless.h"
#include "app/viewer.h"
#include "core/error.h"
#include "core/exit_codes.h"
#include "core/frame_file.h"
#include "gl/evaluate.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

struct NoOpenGl : Error {
    explicit NoOpenGl(const Error& e) : Error(e) {}
};

std::unique_ptr<Context> headlessContext() {
    try {
        return createHeadlessContext();
    } catch (const Error& e) {
        throw NoOpenGl(e);
    }
}

struct Options {
    std::vector<std::string> layers, settings, images, scenes, varied;
    std::string size = "512x512", out, frameFile, chunk, expression, inputs;
    int repetitions = 15;
    bool warm = false, play = false;
};

std::vector<std::filesystem::path> variantFolders(const std::string& builtIn,
                                                  const std::vector<std::string>& added) {
    std::vector<std::filesystem::path> folders;
    for (std::size_t start = 0; start <= builtIn.size();) {
        const std::size_t end = std::min(builtIn.find('|', start), builtIn.size());
        folders.emplace_back(builtIn.substr(start, end - start));
        start = end + 1;
    }
    for (const std::string& folder : added) {
        if (!std::filesystem::is_directory(folder))
            throw Error("no such folder", folder, "give --layer a folder with .glsl files");
        folders.emplace_back(folder);
    }
    return folders;
}

std::optional<std::set<std::string>> wantedImages(const Options& options) {
    if (options.images.empty()) return std::nullopt;
    return std::set<std::string>(options.images.begin(), options.images.end());
}

void printSettings(Assignment& assignment) {
    Settings settings;
    assignment.settings(settings);
    for (const Setting& s : settings.all()) {
        std::string range = fmt::format("{} … {}", s.minimum, s.maximum);
        if (s.kind == Setting::Kind::choice) range = fmt::format("{}", fmt::join(s.choices, " | "));
        if (s.kind == Setting::Kind::toggle) range = "off | on";
        fmt::print("    {:<18} {:<34} default {:<8} {}{}{}\n", s.name,
                   range + (s.unit.empty() ? "" : " " + s.unit), Settings::text(s), s.help, "", "");
    }
}

Session openSession(const Options& options, const std::vector<std::filesystem::path>& variant,
                    std::unique_ptr<Assignment> (*make)()) {
    Session session(make(), shaderLayers(variant));
    for (const std::string& setting : options.settings) session.settings().assign(setting);
    if (options.scenes.empty())
        session.openDefault();
    else
        session.open(loadScene(options.scenes.front()));
    return session;
}

void evaluate(const Options& options, const std::vector<std::filesystem::path>& variant) {
    const FrameFile inputs = loadFrameFile(options.inputs);
    const auto context = headlessContext();
    FrameFile output;
    output.images["result"] =
        evaluateGlsl(shaderLayers(variant), options.chunk, options.expression, inputs.images);
    throwOnGlErrors();
    saveFrameFile(options.frameFile, output);
}

void run(const std::string& command, const Options& options, const std::string& layers,
         std::unique_ptr<Assignment> (*make)()) {
    const auto variant = variantFolders(layers, options.layers);
    if (command == "list") {
        printSettings(*make());
        return;
    }
    if (command == "evaluate") {
        evaluate(options, variant);
        return;
    }
    const glm::ivec2 size = parseSize(options.size);
    if (command == "open") {
        const auto context =
            createContext(Backend::window, {.width = 1440, .height = 900, .visible = true});
        Session session = openSession(options, variant, make);
        runViewer(session, *context);
        return;
    }
    const auto context = headlessContext();
    Session session = openSession(options, variant, make);
    if (command == "benchmark") {
        const std::vector<std::string> usual = {"boxes", "fence", "foliage", "stairs"};
        printBenchmark(session, *context,
                       {.scenes = options.scenes.empty() ? usual : options.scenes,
                        .size = size,
                        .repetitions = options.repetitions,
                        .varied = options.varied,
                        .play = options.play});
        return;
    }
    if (command == "sweep") {
        sweepToFrameFile(
            session, *context,
            {.size = size, .repetitions = options.repetitions, .varied = options.varied},
            options.frameFile);
        return;
    }
    if (options.frameFile.empty() == options.out.empty())
        throw Error("nowhere to write", "render",
                    "give --out DIR (or --frame-file FILE for the grader)");
    if (options.warm) session.render(size, wantedImages(options));
    if (!options.frameFile.empty())
        renderToFrameFile(session, *context, size, wantedImages(options), options.frameFile);
    else
        renderToFolder(session, *context, size, wantedImages(options), options.out);
}

}  // namespace

glm::ivec2 parseSize(const std::string& text) {
    int width = 0, height = 0;
    const char* end = text.data() + text.size();
    const auto [x, error] = std::from_chars(text.data(), end, width);
    const bool cross = error == std::errc() && x != end && *x == 'x';
    const auto [last, error2] = cross ? std::from_chars(x + 1, end, height)
                                      : std::from_chars_result{x, std::errc::invalid_argument};
    if (error2 != std::errc() || last != end || width < 1 || height < 1 || width > 8192 ||
        height > 8192)
        throw Error("'" + text + "' is not a size", "--size",
                    "write WxH with 1 to 8192 pixels a side, such as 512x512");
    return {width, height};
}

int runAssignment(int argc, char** argv, const std::string& layers,
                  std::unique_ptr<Assignment> (*make)()) {
    CLI::App app("One assignment of the Penumbra course");
    app.require_subcommand(1);
    Options o;
    const auto common = [&](CLI::App* sub) {
        sub->add_option("--layer", o.layers,
                        "folder whose .glsl files replace those of the same name");
        sub->add_option("--set", o.settings, "name=value; see list");
    };
    auto* open = app.add_subcommand("open", "the window");
    auto* render = app.add_subcommand("render", "one headless frame");
    auto* evaluateCommand = app.add_subcommand("evaluate", "one GLSL function on rows of inputs");
    auto* benchmark = app.add_subcommand("benchmark", "cost in floors");
    auto* sweep = app.add_subcommand("sweep", "cost and images of many settings, for the study");
    app.add_subcommand("list", "settings with range and unit");
    for (auto* sub : {open, render, benchmark, sweep, evaluateCommand}) common(sub);
    for (auto* sub : {open, render, benchmark, sweep})
        sub->add_option("--scene", o.scenes,
                        "built-in name, installed model, or path to a .glb or .gltf");
    for (auto* sub : {render, benchmark, sweep}) sub->add_option("--size", o.size, "WxH");
    render->add_option("--out", o.out, "folder for the images and frame.json");
    render->add_option("--image", o.images, "only these images");
    render->add_option("--frame-file", o.frameFile, "one file for the grader");
    render->add_flag("--warm", o.warm, "draw once before: times then hold no shader compilation");
    for (auto* sub : {benchmark, sweep}) {
        sub->add_option("--repeat", o.repetitions, "measured rounds")->check(CLI::Range(1, 1000));
        sub->add_option("--vary", o.varied,
                        "name=value,name=value: one more row, with those settings changed");
    }
    sweep->add_option("--frame-file", o.frameFile)->required();
    benchmark->add_flag("--play", o.play, "settings that play advance from frame to frame");
    evaluateCommand->add_option("--chunk", o.chunk)->required();
    evaluateCommand->add_option("--expression", o.expression)->required();
    evaluateCommand->add_option("--inputs", o.inputs)->required();
    evaluateCommand->add_option("--frame-file", o.frameFile)->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        fmt::print(stderr, "error: {}; see --help\n", e.what());
        return 2;
    }
    try {
        run(app.get_subcommands().front()->get_name(), o, layers, make);
        return 0;
    } catch (const NoOpenGl& e) {
        fmt::print(stderr, "error: {}\n", e.what());
        return kExitNoOpenGl;
    } catch (const std::exception& e) {
        fmt::print(stderr, "error: {}\n", e.what());
        return 2;
    }
}

}  // namespace penumbra
