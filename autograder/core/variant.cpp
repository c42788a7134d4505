#include "core/variant.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/handout_hash.h"

namespace penumbra {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestFile = 1 << 20;  // a source text of 1 MB is none

VariantProgram built(const Place& place, const std::string& suffix) {
    const fs::path program = place.build / "bin" / (place.assignment + suffix);
    if (!fs::exists(program))
        throw Error("the program is not built", program.string(),
                    "run ./course grade, which builds it");
    return {.executable = program};
}

bool isPlainFile(const fs::path& path) { return fs::is_regular_file(fs::symlink_status(path)); }

bool holdsAny(const fs::path& folder, const std::set<std::string>& names) {
    for (const auto& name : names)
        if (isPlainFile(folder / name)) return true;
    return false;
}

// A zipped assignment folder often arrives one level down.
fs::path studentRoot(const fs::path& folder, const std::set<std::string>& names, Variant& variant) {
    if (!fs::is_directory(folder))
        throw Error("no such folder", folder.string(),
                    "give --submission the folder with the student's files");
    if (holdsAny(folder, names)) return folder;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_directory() && !entry.is_symlink() && holdsAny(entry.path(), names)) {
            variant.warnings.push_back(
                fmt::format("the files were found in {}/", entry.path().filename().string()));
            return entry.path();
        }
    std::string list;
    for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
    throw Error("no file of this assignment", folder.string(), "hand in " + list);
}

// Copies: a link that points at someone else's solution is no hand-in, and what is graded cannot
// change while it is graded.
void stage(const fs::path& from, const fs::path& to, const std::set<std::string>& names,
           Variant& variant) {
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(from)) {
        const std::string name = entry.path().filename().string();
        if (names.count(name) == 0) {
            if (name != "README.md" && name != "given" && name[0] != '.')
                variant.warnings.push_back(
                    fmt::format("{} is not part of this assignment: ignored", name));
        } else if (!isPlainFile(entry.path())) {
            variant.warnings.push_back(fmt::format("{} is no plain file: ignored", name));
        } else if (fs::file_size(entry.path()) > kLargestFile) {
            variant.warnings.push_back(fmt::format("{} is larger than 1 MB: ignored", name));
        } else {
            fs::copy_file(entry.path(), to / name, fs::copy_options::overwrite_existing);
        }
    }
}

bool holdsCpp(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") return true;
    return false;
}

}  // namespace

std::set<std::string> studentFiles(const Place& place) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(place.handout()))
        if (entry.is_regular_file() && entry.path().extension() != ".md" &&
            entry.path().filename().string()[0] != '.')
            names.insert(entry.path().filename().string());
    return names;
}

Variant handoutVariant(const Place& place) {
    return {.name = "handout", .program = built(place, ""), .studentFolder = place.handout()};
}

Variant solutionVariant(const Place& place) {
    if (!fs::is_directory(place.root / "solutions" / place.assignment))
        throw Error("this tree holds no solution", place.assignment,
                    "grade the handout or a submission");
    return {.name = "solution", .program = built(place, ".solution")};
}

Variant mistakeVariant(const Place& place, const std::string& mistake) {
    const fs::path folder = place.grader() / "wrong" / mistake;
    if (!fs::is_directory(folder))
        throw Error("no such mistake", folder.string(), "name a folder of wrong/");
    Variant variant = solutionVariant(place);
    variant.name = "wrong: " + mistake;
    if (holdsCpp(folder))
        variant.program = built(place, ".wrong." + mistake);
    else
        variant.program.layers = {folder};
    return variant;
}

Variant submissionVariant(const Place& place, const fs::path& folder) {
    Variant variant;
    const auto names = studentFiles(place);
    const fs::path absolute = fs::weakly_canonical(folder);
    variant.name = absolute.filename().string();
    const fs::path source = studentRoot(absolute, names, variant);
    // By path: grading a class side by side shares nothing; grading one again builds what changed.
    const fs::path work =
        place.build / "submission" / (place.assignment + "-" + hashOf(absolute.string()));
    fs::remove_all(work / "src");
    stage(source, work / "src", names, variant);
    if (holdsCpp(work / "src"))
        variant.program = buildSubmission(place, work / "src");
    else
        variant.program = built(place, "");
    variant.program.layers = {work / "src"};
    variant.studentFolder = work / "src";
    return variant;
}

}  // namespace penumbra
