// Flattens #include and translates a driver's messages back: OSMesa 22.3 drops the source number of
// #line in some messages, while plain line numbers are right, so the table is ours.
#include <fmt/format.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "core/error.h"
#include "gl/program.h"

namespace penumbra {

namespace fs = std::filesystem;

namespace {

void append(const Layers& layers, const std::string& name, const std::string& includedFrom,
            std::set<fs::path>& taken, ShaderSource& source) {
    const auto path = layers.find(name);
    if (!path) {
        source.files[name] = {};  // watched: it may come
        throw Error(
            "no such shader file '" + name + "'", includedFrom,
            "check the name; chunks come from the assignment's folders and framework/shaders");
    }
    if (!taken.insert(*path).second) return;
    std::error_code ignored;
    source.files[name] = {*path, fs::last_write_time(*path, ignored)};
    std::ifstream file(*path);
    if (!file) throw Error("cannot read shader", path->string(), "check its permissions");

    static const std::regex include(R"(^\s*#\s*include\s+"([^"]+)\"\s*(//.*)?$)");
    static const std::regex version(R"(^\s*#\s*version\b.*$)");
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        const std::string where = fmt::format("{}:{}", path->filename().string(), number);
        std::smatch match;
        if (std::regex_match(line, match, include)) {
            append(layers, match[1], where, taken, source);
        } else if (std::regex_match(line, version)) {
            throw Error("#version is not yours to write", where,
                        "delete the line; the loader writes #version 410 core");
        } else {
            source.text += line + "\n";
            source.lines.push_back({*path, number});
        }
    }
}

}  // namespace

ShaderSource loadShader(const Layers& layers, const std::string& name,
                        const std::vector<std::string>& chunks) {
    ShaderSource source;
    loadShader(layers, name, chunks, source);
    return source;
}

void loadShader(const Layers& layers, const std::string& name,
                const std::vector<std::string>& chunks, ShaderSource& source) {
    source.text = "#version 410 core\n";
    source.lines.push_back({"", 0});
    std::set<fs::path> taken;
    append(layers, name, "the program's entry point", taken, source);
    for (const std::string& chunk : chunks) append(layers, chunk, name, taken, source);
}

std::string ShaderSource::translate(const std::string& log) const {
    // Mesa "0:31(5): error: …", NVIDIA "0(31) : error …", Apple and Intel "ERROR: 0:31: …".
    static const std::regex location(
        R"((?:ERROR:\s*)?\d+(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:\s*(.*))");
    std::string result;
    std::istringstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        if (line.empty()) continue;
        std::smatch match;
        if (std::regex_match(line, match, location)) {
            const auto number = std::size_t(std::stoul(match[1].matched ? match[1] : match[2]));
            if (number >= 1 && number <= lines.size()) {
                const Origin& origin = lines[number - 1];
                line = fmt::format("{}:{}: {}", origin.file.filename().string(), origin.line,
                                   match[3].str());
            }
        }
        result += (result.empty() ? "" : "\n") + line;
    }
    return result;
}

}  // namespace penumbra
