#include "study/style.h"

#include <algorithm>
#include <cstdlib>
#include <map>

namespace penumbra {

namespace {

// Told apart with any kind of colour vision, neighbours best [Okabe and Ito 2008]; without its
// yellow and black, in shades that can be read on white and on black. By an assignment's number,
// so that it has its colour in every study.
constexpr const char* kColors[] = {"#8c8a1e", "#a8502f", "#5f7f99", "#2f9fdf", "#d55e00",
                                   "#7a68c8", "#0072b2", "#e08e00", "#009e73", "#cc5f9e"};
constexpr const char* kCompetitors[] = {"var(--ink)", "var(--soft)"};
constexpr const char* kMarkers[] = {"M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0Z",
                                    "M-.85-.85H.85V.85H-.85Z",
                                    "M0-1.1L1.05.8H-1.05Z",
                                    "M0-1.2L1.2 0 0 1.2-1.2 0Z",
                                    "M0 1.1L1.05-.8H-1.05Z",
                                    "M-.4-1H.4V-.4H1V.4H.4V1H-.4V.4H-1V-.4H-.4Z"};
constexpr const char* kDashes[] = {"", "6 3", "2 3", "8 3 2 3", "4 2", "1 2"};

const char* techniqueColor(const StudyPoint& p) {
    const auto number = std::size_t(std::max(0, std::atoi(p.program.c_str())));
    // A submission comes alone with its solution: any other colour tells the two apart.
    return kColors[(number + (p.submission ? 4 : 0)) % std::size(kColors)];
}

}  // namespace

std::vector<CurveStyle> curveStyles(const StudyResults& results) {
    std::vector<CurveStyle> styles;
    std::map<std::string, std::size_t> competitors, curves;  // place; curves so far
    for (const StudyPoint& p : results.points) {
        if (std::any_of(styles.begin(), styles.end(), [&](const CurveStyle& s) {
                return s.program == p.program && s.curve == p.curve;
            }))
            continue;
        if (p.competitor) competitors.emplace(p.program, competitors.size());
        const std::size_t curve = curves[p.program]++;
        styles.push_back(
            {p.program, p.curve,
             p.competitor ? kCompetitors[competitors[p.program] % std::size(kCompetitors)]
                          : techniqueColor(p),
             kMarkers[curve % std::size(kMarkers)], kDashes[curve % std::size(kDashes)]});
    }
    return styles;
}

}  // namespace penumbra
