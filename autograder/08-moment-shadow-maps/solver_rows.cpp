#include "solver_rows.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

Rows SolverRows::evaluate(const std::string& chunk, const std::string& expression) const {
    return penumbra::evaluate(
        {.chunk = chunk, .expression = expression, .inputs = {{"a", moments_}, {"b", t_}}});
}

Rows SolverRows::blockers(const std::string& method) const {
    const std::string call = method + "Blockers(a, b.x)";
    return evaluate(method + ".glsl", "vec4(" + call + ".share, " + call + ".depth, 0.0, 0.0)");
}

const RowTolerance kThreePoints{
    .absolute = 3e-4,
    .relative = 3e-4,
    .components = 2,
    .cause =
        "depths 0.25 apart with shares of 0.1 at least: moments rounded to 6e-8 move depths "
        "and shares by up to 1e-4, and the arithmetic rounds again"};
const std::string kShareCause =
    "1 is the rounding of moments and solver to 4 · 6e-8 over the smallest eigenvalue of the "
    "moments' matrix, 0.168 times the bias";

double worstShare(const Rows& mine, const std::vector<Below>& truth,
                  const std::vector<double>& allowed) {
    double worst = 0;
    for (std::size_t i = 0; i < mine.size(); ++i)
        worst = std::max(worst, std::abs(mine[i].x - truth[i].share) / allowed[i]);
    return worst;
}

double worstDepth(const Rows& mine, const std::vector<Below>& truth,
                  const std::vector<double>& allowed) {
    double worst = 0;
    for (std::size_t i = 0; i < mine.size(); ++i) {
        // A depth is a sum over a share: where there is little to divide by, it says little.
        if (truth[i].share < 0.05) continue;
        const double off = std::abs(mine[i].y - std::max(truth[i].depth(), -1.0));
        worst = std::max(worst, off * truth[i].share / (2 * allowed[i]));
    }
    return worst;
}

double mostOver(const Rows& mine, const std::vector<Below>& truth,
                const std::vector<double>& allowed) {
    double most = 0;
    for (std::size_t i = 0; i < mine.size(); ++i)
        most = std::max(most, (mine[i].x - truth[i].share) / allowed[i]);
    return most;
}

SolverRows anyMoments(unsigned seed) {
    Dice dice{std::mt19937(seed)};
    SolverRows rows;
    for (const double z : {-1.0, -0.5, 0.0, 1.0})
        for (const double t : {-1.0, -0.5, 0.0, 0.25, 1.0})
            rows.add(Distribution{{z}, {1}}.moments(), t);
    while (int(rows.size()) < kRows) {
        const Distribution d = randomDistribution(dice);
        const double places[] = {dice(-1, 1), -1, 1, d.depths[0], d.depths[0] + 1e-6};
        rows.add(d.moments(), std::clamp(places[dice.count(0, 4)], -1.0, 1.0));
    }
    return rows;
}

void expectShares(const Rows& mine, const SolverRows& rows) {
    double least = 0, most = 0, beyond = -2, before = 2;
    for (std::size_t i = 0; i < mine.size(); ++i) {
        least = std::min(least, double(mine[i].x));
        most = std::max(most, double(mine[i].x));
        if (mine[i].x <= 0) continue;
        before = std::min(before, double(mine[i].y));
        beyond = std::max(beyond, mine[i].y - rows.t(int(i)));
    }
    EXPECT_VALUE(least, GreaterOrEqual, 0, "a share");
    EXPECT_VALUE(most, LessOrEqual, 1, "a share");
    EXPECT_VALUE(most, Greater, 0.99, "some rows have all their depths before t");
    EXPECT_VALUE(before, GreaterOrEqual, -1, "no depth lies before the near plane");
    EXPECT_VALUE(beyond, LessOrEqual, 0, "what is nearer than t");
}

}  // namespace penumbra
