#include "core/rubric.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"
#include "core/handout_hash.h"

namespace penumbra {

namespace {

using nlohmann::ordered_json;

RubricTask readTask(const ordered_json& entry) {
    RubricTask task{.name = entry.at("name"),
                    .title = entry.at("title"),
                    .section = entry.value("section", ""),
                    .files = entry.at("files"),
                    .checks = {}};
    for (const auto& [name, points] : entry.at("checks").items())
        task.checks.emplace_back(name, points.get<double>());
    return task;
}

void validate(const Rubric& rubric, const std::string& where) {
    double sum = 0;
    std::set<std::string> names;
    for (const auto& task : rubric.tasks) {
        if (!names.insert(task.name).second)
            throw Error("a task stands twice in the rubric", task.name, "repair " + where);
        for (const auto& file : task.files)
            if (rubric.handoutHashes.count(file) == 0)
                throw Error("the rubric has no hash of a task's file", file,
                            "paste what --handout-hashes prints");
        for (const auto& [check, points] : task.checks) {
            if (!(points > 0))
                throw Error("a check has no points", task.name + "." + check, "repair " + where);
            sum += points;
        }
    }
    if (std::abs(sum - 100) > 1e-9)
        throw Error(fmt::format("points add up to {:g}", sum), where, "make them 100");
}

}  // namespace

Rubric loadRubric(const std::filesystem::path& path) {
    std::ifstream stream(path);
    if (!stream) throw Error("cannot read rubric", path.string(), "write it beside checks.cpp");
    Rubric rubric;
    try {
        const auto json = ordered_json::parse(stream);
        rubric.title = json.at("title");
        for (const auto& entry : json.at("tasks")) rubric.tasks.push_back(readTask(entry));
        rubric.handoutHashes = json.at("handout").get<std::map<std::string, std::string>>();
    } catch (const nlohmann::json::exception& error) {
        throw Error("bad rubric", path.string(), error.what());
    }
    validate(rubric, path.string());
    return rubric;
}

void requireSameChecks(const Rubric& rubric, const std::vector<std::string>& checks) {
    std::set<std::string> written(checks.begin(), checks.end());
    for (const auto& task : rubric.tasks)
        for (const auto& [check, points] : task.checks)
            if (written.erase(task.name + "." + check) == 0)
                throw Error("the rubric names a check that checks.cpp has not",
                            task.name + "." + check, "repair rubric.json");
    if (!written.empty())
        throw Error("a check has no points in the rubric", *written.begin(), "repair rubric.json");
}

bool isUntouched(const Rubric& rubric, const RubricTask& task,
                 const std::filesystem::path& studentFolder) {
    if (task.files.empty()) return false;
    for (const auto& file : task.files) {
        const auto path = studentFolder / file;
        // A file that was not handed in is the handout's.
        if (std::filesystem::exists(path) && contentHash(path) != rubric.handoutHashes.at(file))
            return false;
    }
    return true;
}

}  // namespace penumbra
