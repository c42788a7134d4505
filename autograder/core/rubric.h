// rubric.json: what each check is worth. Every check of checks.cpp stands in it, and nothing else.
//
//   {"title": "Shadow maps",
//    "tasks": [{"name": "Task1LightFrustum", "title": "The light's frustum", "section":
//    "1-the-light",
//               "files": ["light_frustum.cpp"], "checks": {"HoldsEveryReceiver": 10, …}}, …],
//    "handout": {"light_frustum.cpp": "89abcdef01234567", …}}      // `N.grade --handout-hashes`
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace penumbra {

struct RubricTask {
    std::string name;  // the GoogleTest suite
    std::string title;
    std::string section;  // anchor in the handout's README.md
    std::vector<std::string> files;
    std::vector<std::pair<std::string, double>> checks;  // in the file's order
};

struct Rubric {
    std::string title;
    std::vector<RubricTask> tasks;
    std::map<std::string, std::string> handoutHashes;  // by file name
};

// Throws Error for anything amiss: points that do not add up to 100, a name used twice, …
Rubric loadRubric(const std::filesystem::path& path);

// Throws Error where rubric and program disagree. `checks` are "Suite.Name".
void requireSameChecks(const Rubric& rubric, const std::vector<std::string>& checks);

// Whether all files of the task still hold the handout's code.
bool isUntouched(const Rubric& rubric, const RubricTask& task,
                 const std::filesystem::path& studentFolder);

}  // namespace penumbra
