// Where results that take long may be kept between runs.
//
//   DistanceField field = cachedDistanceField(cacheFolder(), meshes, grid);
#pragma once

#include <filesystem>

namespace penumbra {

// PENUMBRA_CACHE, else penumbra/ in XDG_CACHE_HOME, in LOCALAPPDATA, in ~/.cache, or where none is
// set among the system's temporary files. The folder may not exist yet. It may be deleted at any
// time.
std::filesystem::path cacheFolder();

}  // namespace penumbra
