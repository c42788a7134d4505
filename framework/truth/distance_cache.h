// Distance fields kept on disk: a scene's field is made once.
//
//   DistanceField field = cachedDistanceField(cacheFolder(), blockers, grid, &progress);
#pragma once

#include <filesystem>
#include <span>

#include "truth/distance_field.h"

namespace penumbra {

// distanceField(meshes, grid, progress), or the same bits from `folder`/distance-fields, where they
// are kept under a hash of all that they depend on: corners and triangles of the meshes, the grid,
// and the version of this format. A file that is damaged, cut short or of another machine's byte
// order is made again. Files appear whole or not at all, so several programs may share the folder;
// the least recently used go when they are more than `bytesKept` together. A folder that cannot be
// written costs time, and a line on stderr, but is no error.
DistanceField cachedDistanceField(const std::filesystem::path& folder, std::span<const Mesh> meshes,
                                  const DistanceGrid& grid, Progress* progress = nullptr,
                                  std::uintmax_t bytesKept = std::uintmax_t(1) << 30);

}  // namespace penumbra
