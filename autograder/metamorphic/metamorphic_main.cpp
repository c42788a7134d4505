// Relations between pictures of the solutions, on Mesa's two software rasterisers: relations.h.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/error.h"
#include "core/variant.h"
#include "metamorphic/relations.h"
#include "scene/gallery.h"

namespace penumbra {
namespace {

struct Options {
    std::string assignment, driver = "llvmpipe", wrong, relation, method;
    bool mistakes = false, brightening = false;
};

Place placeOf(const std::string& assignment) {
    return {.root = repositoryRoot(), .build = PENUMBRA_BUILD, .assignment = assignment};
}

void print(const Outcome& o) {
    const Difference& d = o.measured;
    fmt::print(
        "{:<7} {:<13} {:<26} {:<7} {:>5} differ, {:>4} by more than 1/256, most {:.2g} at ({}, {})",
        o.holds() ? "holds" : "BROKEN", o.relation, o.method, o.scene, d.any, d.visible, d.most,
        d.where.x, d.where.y);
    if (o.allowance) fmt::print("; allowed {}", o.allowance->pixels);
    if (!o.trouble.empty()) fmt::print("; {}", o.trouble);
    fmt::print("\n");
}

bool allHold(const std::vector<Outcome>& outcomes) {
    return std::all_of(outcomes.begin(), outcomes.end(),
                       [](const Outcome& o) { return o.holds(); });
}

// The mistakes that the plan names: each must break its relation, and by a picture.
int tryMistakes(const Place& place, const MetamorphicPlan& plan) {
    int kept = 0;
    for (const BreakingMistake& m : plan.mistakes) {
        const auto outcomes = tryRelations({.program = mistakeVariant(place, m.mistake).program,
                                            .plan = plan,
                                            .only = m.relation,
                                            .onlyMethod = m.method});
        for (const Outcome& o : outcomes) print(o);
        const bool breaks = !allHold(outcomes);
        fmt::print("{} {} {}\n", m.mistake, breaks ? "breaks" : "KEEPS", m.relation);
        kept += !breaks;
    }
    return kept > 0;
}

// What one more blocker does to each method on the gallery's scenes, as rows of a table: the share
// of pixels that brighten (least and most of seeds 1 to 3), by how much on average, and the most.
void printBrightening(const Place& place, const MetamorphicPlan& plan) {
    constexpr glm::ivec2 kSize{128, 128};
    fmt::print("| | boxes | fence | foliage | stairs |\n| --- | --- | --- | --- | --- |\n");
    for (const MetamorphicMethod& method : plan.methods) {
        std::string row = "| " + place.assignment.substr(0, 3) + method.name;
        for (const char* name : {"boxes", "fence", "foliage", "stairs"}) {
            const auto outcomes = tryRelations(
                {.program = solutionVariant(place).program,
                 .plan = plan,
                 .only = "any blocker",
                 .onlyMethod = method.name,
                 .scenes = {name, fmt::format("{}@2", name), fmt::format("{}@3", name)},
                 .size = kSize,
                 .excepted = true});
            double least = 1, largest = 0, sum = 0, most = 0;
            int count = 0;
            for (const Outcome& o : outcomes) {
                if (!o.trouble.empty()) throw Error(o.trouble, method.name, "mend it first");
                const double share = double(o.measured.visible) / double(kSize.x * kSize.y);
                least = std::min(least, share), largest = std::max(largest, share);
                sum += o.measured.sum, count += o.measured.visible;
                most = std::max(most, double(o.measured.most));
            }
            row += fmt::format(" | {:.1f} to {:.1f} %, {:.3f}, {:.2f}", 100 * least, 100 * largest,
                               count ? sum / count : 0.0, most);
        }
        fmt::print("{} |\n", row);
    }
}

int metamorphic(const Options& o) {
    const Place place = placeOf(o.assignment);
    const MetamorphicPlan plan = loadMetamorphicPlan(place.grader() / "metamorphic.json");
    if (o.mistakes) return tryMistakes(place, plan);
    if (o.brightening) return printBrightening(place, plan), 0;
    const Variant variant =
        o.wrong.empty() ? solutionVariant(place) : mistakeVariant(place, o.wrong);
    const auto outcomes = tryRelations({.program = variant.program,
                                        .plan = plan,
                                        .driver = o.driver,
                                        .only = o.relation,
                                        .onlyMethod = o.method});
    for (const Outcome& outcome : outcomes) print(outcome);
    fmt::print(
        "{}: {} of {} relations hold on {}\n", o.assignment,
        std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& x) { return x.holds(); }),
        outcomes.size(), o.driver);
    return allHold(outcomes) && !outcomes.empty() ? 0 : 1;
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
    penumbra::Options o;
    CLI::App app("Pictures of a scene and of its transforms, held against each other");
    app.add_option("assignment", o.assignment, "its full name")->required();
    app.add_option("--driver", o.driver, "llvmpipe or softpipe")
        ->check(CLI::IsMember({"llvmpipe", "softpipe"}));
    app.add_option("--wrong", o.wrong, "a known mistake instead of the solution");
    app.add_option("--relation", o.relation, "this one alone");
    app.add_option("--method", o.method, "this one alone");
    app.add_flag("--mistakes", o.mistakes,
                 "succeed if each mistake of the plan breaks its relation");
    app.add_flag("--brightening", o.brightening, "a table of what one more blocker brightens");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        fmt::print(stderr, "error: {}; see --help\n", e.what());
        return 2;
    }
    try {
        return penumbra::metamorphic(o);
    } catch (const std::exception& e) {
        fmt::print(stderr, "error: {}\n", e.what());
        return 2;
    }
}
