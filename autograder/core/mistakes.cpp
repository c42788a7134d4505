#include "core/mistakes.h"

#include <algorithm>
#include <fstream>
#include <optional>

#include "core/error.h"

namespace penumbra {

namespace fs = std::filesystem;

namespace {

const std::string kTag = "// Fails:";
const std::string kDot = "·";

std::string trimmed(const std::string& s) {
    const auto first = s.find_first_not_of(" \t\r"), last = s.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : s.substr(first, last - first + 1);
}

std::optional<Mistake> readFirstLine(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    if (!std::getline(stream, line) || line.rfind(kTag, 0) != 0) return std::nullopt;
    const auto dot = line.find(kDot);
    if (dot == std::string::npos)
        throw Error("a mistake has no name", file.string(),
                    "end its first line with: · what went wrong");
    Mistake mistake;
    mistake.name = trimmed(line.substr(dot + kDot.size()));
    std::string list = line.substr(kTag.size(), dot - kTag.size()) + ",";
    for (std::size_t comma; (comma = list.find(',')) != std::string::npos; list.erase(0, comma + 1))
        if (const auto check = trimmed(list.substr(0, comma)); !check.empty())
            mistake.fails.insert(check);
    return mistake;
}

Mistake readFolder(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files)
        if (auto mistake = readFirstLine(file)) {
            mistake->folder = folder.filename().string();
            return *mistake;
        }
    throw Error("a mistake does not say what it fails", folder.string(),
                "begin a file with: // Fails: Suite.Name · what went wrong");
}

// Shared over all: 1 equal, 0 nothing in common.
double jaccard(const std::set<std::string>& a, const std::set<std::string>& b) {
    const auto shared =
        double(std::count_if(a.begin(), a.end(), [&](const auto& x) { return b.count(x) > 0; }));
    return shared / (double(a.size() + b.size()) - shared);
}

}  // namespace

std::vector<Mistake> loadMistakes(const fs::path& wrong) {
    std::vector<Mistake> mistakes;
    if (!fs::is_directory(wrong)) return mistakes;
    for (const auto& entry : fs::directory_iterator(wrong))
        if (entry.is_directory()) mistakes.push_back(readFolder(entry.path()));
    std::sort(mistakes.begin(), mistakes.end(),
              [](const Mistake& a, const Mistake& b) { return a.folder < b.folder; });
    return mistakes;
}

std::string looksLike(const std::vector<Mistake>& mistakes, const std::set<std::string>& failed) {
    if (failed.empty()) return "";
    std::string equal, closest;
    double best = 0.5;  // less than half in common is a guess, not a hint
    for (const auto& mistake : mistakes) {
        const double likeness = jaccard(mistake.fails, failed);
        if (likeness == 1) equal += (equal.empty() ? "" : "; or: ") + mistake.name;
        if (likeness > best || (closest.empty() && likeness >= best))
            best = likeness, closest = mistake.name;
    }
    return equal.empty() ? closest : equal;
}

}  // namespace penumbra
