// How much of the shadow's place is left as a caster nears the height of its light.
#include "core/curves.h"
#include "near_the_light.h"

namespace penumbra {
namespace {

CURVE(caster_gap) {
    std::vector<double> gaps;
    for (int i = 0; i <= 10; ++i) gaps.push_back(std::pow(10.0, -0.5 * (10 - i)));
    const NearTheLight in(gaps, 512);
    const auto rays = in.errors("flattenAlongRay(a, b, c.xyz)");
    const auto matrices = in.errors(kMatrixForm);
    PlotSeries matrix{.name = "matrix"}, ray{.name = "ray form"};
    double least = INFINITY, steepest = 0;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        matrix.points.emplace_back(gaps[i], matrices[i].y);
        ray.points.emplace_back(gaps[i], rays[i].y);
        if (gaps[i] < 0.2) least = std::min(least, matrices[i].y / rays[i].y);
        steepest = std::max(steepest, rays[i].y * gaps[i]);
    }
    EXPECT_VALUE(least, GreaterOrEqual, 4,
                 "the matrix adds what n·l and n·v share and takes it away again, both rounded");
    EXPECT_VALUE(steepest, LessOrEqual, 4 * 6e-8,
                 "a few roundings of 6e-8 in n·(l - v), over a gap that n·l counts in");
    return {.title = "Error of a flattened point as the caster nears the light's height",
            .says =
                "Both errors grow as 1 / gap; the matrix form starts several times higher, for "
                "it subtracts what was rounded before.",
            .x = {"gap between caster and light [of the light's height]", true},
            .panels = {{{"error, root mean square [of the ray's length]", true}, {matrix, ray}}}};
}

}  // namespace
}  // namespace penumbra
