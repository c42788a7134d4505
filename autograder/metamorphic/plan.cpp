#include "metamorphic/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.h"
#include "metamorphic/relations.h"

namespace penumbra {

namespace {

using nlohmann::json;

std::vector<std::string> settingsOf(const std::string& text) {
    std::vector<std::string> settings;
    std::istringstream stream(text);
    for (std::string setting; std::getline(stream, setting, ',');) settings.push_back(setting);
    return settings;
}

MetamorphicMethod methodOf(const json& j) {
    MetamorphicMethod method{
        .name = j.at("name"), .settings = settingsOf(j.value("settings", "")), .limit = {}};
    for (const json& step : j.at("limit")) method.limit.push_back(settingsOf(step));
    return method;
}

Allowance allowanceOf(const json& j, bool asked) {
    return {.relation = j.at("relation"),
            .method = j.value("method", ""),
            .driver = j.value("driver", ""),
            .cause = j.at("cause"),
            .pixels = asked ? j.at("pixels").get<int>() : -1};
}

void validate(const MetamorphicPlan& plan, const std::string& file) {
    const auto known = [&](const std::string& relation, const std::string& method) {
        const auto& relations = relationNames();
        if (std::find(relations.begin(), relations.end(), relation) == relations.end())
            throw Error("no such relation: '" + relation + "'", file,
                        fmt::format("choose of {}", fmt::join(relations, ", ")));
        if (!method.empty() &&
            std::none_of(plan.methods.begin(), plan.methods.end(),
                         [&](const MetamorphicMethod& m) { return m.name == method; }))
            throw Error("no such method: '" + method + "'", file, "name one of \"methods\"");
    };
    for (const Allowance& a : plan.allowances) {
        known(a.relation, a.method);
        if (a.cause.empty()) throw Error("an allowance without a cause", file, "say why");
    }
    for (const BreakingMistake& m : plan.mistakes) known(m.relation, m.method);
    for (const MetamorphicMethod& m : plan.methods)
        if (m.limit.empty()) throw Error("no limit of method '" + m.name + "'", file, "see plan.h");
}

}  // namespace

const Allowance* MetamorphicPlan::allowance(const std::string& relation, const std::string& method,
                                            const std::string& driver) const {
    const auto it = std::find_if(allowances.begin(), allowances.end(), [&](const Allowance& a) {
        return a.relation == relation && (a.method.empty() || a.method == method) &&
               (a.driver.empty() || a.driver == driver);
    });
    return it == allowances.end() ? nullptr : &*it;
}

MetamorphicPlan loadMetamorphicPlan(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw Error("no plan for relations", file.string(), "write it: see plan.h");
    MetamorphicPlan plan;
    try {
        const json j = json::parse(stream);
        plan.scenes = j.at("scenes");
        plan.oneMesh = j.value("one_mesh", false);
        for (const json& m : j.at("methods")) plan.methods.push_back(methodOf(m));
        for (const json& a : j.at("except")) plan.allowances.push_back(allowanceOf(a, false));
        for (const json& a : j.at("allow")) plan.allowances.push_back(allowanceOf(a, true));
        for (const json& m : j.at("mistakes"))
            plan.mistakes.push_back({m.at("relation"), m.at("mistake"), m.value("method", "")});
    } catch (const json::exception& e) {
        throw Error(e.what(), file.string(), "see the example in autograder/metamorphic/plan.h");
    }
    validate(plan, file.string());
    return plan;
}

}  // namespace penumbra
