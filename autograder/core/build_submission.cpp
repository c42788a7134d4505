// Student's C++ to a program, through framework/cmake/submission: the compiler sees the student's
// text, nothing of it runs here.
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "core/error.h"
#include "core/handout_hash.h"
#include "core/variant.h"

namespace penumbra {

namespace fs = std::filesystem;

namespace {

// A compiler that a recursive template keeps busy must end, too.
constexpr ProcessLimits kBuildLimits{.wallSeconds = 120, .cpuSeconds = 240};

ProcessResult cmake(const std::vector<std::string>& arguments, const fs::path& folder) {
    std::vector<std::string> environment;
    for (const char* name : {"PATH", "HOME", "CCACHE_DIR", "CMAKE_CXX_COMPILER_LAUNCHER"})
        if (const char* value = std::getenv(name))
            environment.push_back(std::string(name) + "=" + value);
    return runProcess({.program = PENUMBRA_CMAKE,
                       .arguments = arguments,
                       .folder = folder,
                       .environment = environment,
                       .limits = kBuildLimits});
}

}  // namespace

std::string firstComplaint(const std::string& output) {
    // gcc, clang: file:12:5: error: text; MSVC: file(12): error C1: text; then linkers.
    static const std::regex gnu(
        R"(^(?:.*[/\\])?([^/\\:]+):(\d+)(?::\d+)?: (?:fatal )?error: (.*)$)");
    static const std::regex msvc(
        R"(^(?:.*[/\\])?([^/\\(]+)\((\d+)(?:,\d+)?\): (?:fatal )?error [A-Z0-9]+: (.*)$)");
    static const std::regex linker(
        R"(.*(undefined reference to .*|multiple definition of .*?);? ?.*$)");
    std::istringstream stream(output);
    std::string unresolved;
    for (std::string line; std::getline(stream, line);) {
        if (line.size() > 2000) continue;  // std::regex recurses with the line's length
        std::smatch m;
        if (std::regex_match(line, m, gnu) || std::regex_match(line, m, msvc))
            return fmt::format("{}:{}: {}", m[1].str(), m[2].str(), m[3].str());
        if (unresolved.empty() && std::regex_match(line, m, linker)) unresolved = m[1].str();
    }
    return unresolved;
}

VariantProgram buildSubmission(const Place& place, const fs::path& staged) {
    const fs::path work = staged.parent_path(), build = work / "build";
    const VariantProgram program{.executable = build / "program"};
    const fs::path facts = place.build / "submission" / "framework.cmake";
    if (!fs::exists(facts))
        throw Error("the framework is not built", facts.string(),
                    "run ./course grade, which builds it");
    const auto configured = cmake(
        {"-S", (place.root / "framework/cmake/submission").string(), "-B", build.string(), "-G",
         PENUMBRA_GENERATOR, "-DPENUMBRA_FACTS=" + facts.string(),
         "-DPENUMBRA_HANDOUT=" + place.handout().string(), "-DPENUMBRA_STAGED=" + staged.string()},
        work);
    if (configured.end != ProcessResult::End::exited || configured.code != 0) {
        std::ofstream(work / "configure.log")
            << configured.standardOutput << configured.standardError;
        throw Error("cannot configure the submission's build", (work / "configure.log").string(),
                    "repair the build tree");
    }
    std::error_code ignored;
    fs::remove(program.executable, ignored);
    const auto compiled = cmake({"--build", build.string()}, work);
    if (compiled.end != ProcessResult::End::exited)
        return {.broken = "does not compile: the compiler " + inWords(compiled, kBuildLimits)};
    if (compiled.code == 0 && fs::exists(program.executable)) return program;
    const std::string complaint = firstComplaint(compiled.standardOutput + compiled.standardError);
    if (complaint.empty()) {
        std::ofstream(work / "build.log") << compiled.standardOutput << compiled.standardError;
        throw Error("cannot build the submission", (work / "build.log").string(), "see the log");
    }
    return {.broken = "does not compile: " + complaint};
}

}  // namespace penumbra
