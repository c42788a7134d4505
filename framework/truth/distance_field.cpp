#include "truth/distance_field.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "truth/inside_slices.h"
#include "truth/nearest_triangle.h"
#include "truth/parallel.h"

namespace penumbra {

namespace {

// Distances of one slice. The nearest triangles of the voxels before it in its row and of the one
// before that row are good guesses: no distance there differs by more than a cell.
void measure(const NearestTriangle& nearest, const DistanceGrid& grid, int k,
             const Progress* progress, float* values) {
    std::vector<std::uint32_t> guesses(std::size_t(grid.size.x), 0);  // by column
    for (int j = 0; j < grid.size.y; ++j) {
        if (progress && progress->cancelled) return;
        for (int i = 0; i < grid.size.x; ++i) {
            const auto column = std::size_t(i);
            const std::uint32_t guess = guesses[j == 0 && i > 0 ? column - 1 : column];
            const auto found = nearest.find(grid.center({i, j, k}), guess);
            guesses[column] = found.triangle;
            *values++ = float(found.distance);
        }
    }
}

}  // namespace

DistanceGrid DistanceGrid::around(const Box& box, int voxels, int padding) {
    EXPECTS(padding >= 0 && voxels > 2 * padding);
    const glm::dvec3 lower(box.lower), upper(box.upper), extent = upper - lower;
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (box.empty() || !(longest > 0.0))
        throw Error("no grid around nothing", "distance field",
                    "give it triangles that cover some space");
    // `lower` and `cell` are rounded to float32, by at most 2^-24 of themselves: `room` holds both,
    // at both ends, twice over.
    const auto size = [](glm::dvec3 p) {
        return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    };
    const double room = std::ldexp(std::max(size(lower), size(upper)) + longest, -22);
    DistanceGrid grid;
    grid.cell = float((longest + room) / (voxels - 2 * padding));
    for (int axis = 0; axis < 3; ++axis) {
        const int needed = int(std::ceil((extent[axis] + room) / double(grid.cell)));
        grid.size[axis] = std::min(needed + 2 * padding, voxels);
        const double middle = 0.5 * (lower[axis] + upper[axis]);
        grid.lower[axis] = float(middle - 0.5 * grid.size[axis] * double(grid.cell));
    }
    return grid;
}

float DistanceField::sample(glm::vec3 point) const {
    const glm::vec3 last(grid.size - 1);
    const glm::vec3 place =
        glm::clamp((point - grid.lower) / grid.cell - 0.5f, glm::vec3(0.0f), last);
    const glm::ivec3 low = glm::min(glm::ivec3(place), grid.size - 1);
    const glm::ivec3 high = glm::min(low + 1, grid.size - 1);
    const glm::vec3 part = place - glm::vec3(low);
    const auto alongX = [&](int y, int z) {
        return glm::mix(at({low.x, y, z}), at({high.x, y, z}), part.x);
    };
    const auto alongXY = [&](int z) {
        return glm::mix(alongX(low.y, z), alongX(high.y, z), part.y);
    };
    return glm::mix(alongXY(low.z), alongXY(high.z), part.z);
}

DistanceField distanceField(std::span<const Mesh> meshes, const DistanceGrid& grid,
                            Progress* progress) {
    EXPECTS(grid.cell > 0.0f && std::min({grid.size.x, grid.size.y, grid.size.z}) > 0);
    const NearestTriangle nearest(meshes);
    if (nearest.empty())
        throw Error("no distance to nothing", "distance field", "give it at least one triangle");
    const InsideSlices inside(meshes, grid);
    DistanceField field{grid, std::vector<float>(grid.count())};
    const std::size_t slice = std::size_t(grid.size.x) * std::size_t(grid.size.y);
    parallelFor(grid.size.z, [&](int k) {
        float* values = field.values.data() + std::size_t(k) * slice;
        measure(nearest, grid, k, progress, values);
        const auto within = inside.slice(k);
        for (std::size_t i = 0; i < slice; ++i)
            if (within[i] && values[i] > 0.0f) values[i] = -values[i];
        if (progress) progress->advance();
    });
    if (progress && progress->cancelled) field.values.clear();
    return field;
}

}  // namespace penumbra
