// Every shader of every variant is GLSL 4.10 in the eyes of the reference compiler, which is
// stricter than Mesa: Mesa compiles #version 450 in a 4.1 context.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/session.h"
#include "gl/program.h"
#include "scene/gallery.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> foldersIn(const fs::path& folder) {
    std::vector<fs::path> result;
    if (!fs::is_directory(folder)) return result;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_directory()) result.push_back(entry.path());
    return result;
}

struct Variant {
    std::string name;
    std::vector<fs::path> folders;
};

std::vector<Variant> variants() {
    std::vector<Variant> result;
    for (const fs::path& handout : foldersIn(repositoryRoot() / "assignments")) {
        const std::string name = handout.filename().string();
        const fs::path solution = repositoryRoot() / "solutions" / name;
        result.push_back({name, {handout}});
        if (!fs::is_directory(solution)) continue;
        result.push_back({name + " solution", {handout, solution}});
        for (const fs::path& wrong : foldersIn(repositoryRoot() / "autograder" / name / "wrong"))
            result.push_back({name + " " + wrong.filename().string(), {handout, solution, wrong}});
    }
    return result;
}

std::string validate(const ShaderSource& source, const std::string& extension) {
    const fs::path file =
        fs::path(testing::TempDir()) / fmt::format("shader-{}.{}", getpid(), extension);
    std::ofstream(file) << source.text;
    FILE* pipe = popen(("glslangValidator " + file.string() + " 2>&1").c_str(), "r");
    std::string log;
    char buffer[512];
    while (pipe && std::fgets(buffer, sizeof buffer, pipe)) log += buffer;
    const int status = pipe ? pclose(pipe) : -1;
    fs::remove(file);
    return status == 0 ? "" : source.translate(log);
}

TEST(Shaders, AreStrictGlsl410InEveryVariant) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "glslangValidator is not installed (package glslang-tools)";
    std::set<std::string> checked;  // a mistake shares most of its text with the solution
    for (const Variant& variant : variants()) {
        const Layers layers = shaderLayers(variant.folders);
        std::set<std::string> entryPoints;
        for (const fs::path& folder : layers.folders())
            for (const auto& entry : fs::directory_iterator(folder))
                if (entry.path().extension() == ".vert" || entry.path().extension() == ".frag")
                    entryPoints.insert(entry.path().filename().string());
        for (const std::string& name : entryPoints) {
            const ShaderSource source = loadShader(layers, name);
            const std::string extension = name.substr(name.size() - 4);
            if (!checked.insert(extension + source.text).second) continue;
            EXPECT_EQ(validate(source, extension), "") << variant.name << ": " << name;
        }
    }
    EXPECT_GT(checked.size(), 10u);
}

}  // namespace
}  // namespace penumbra
