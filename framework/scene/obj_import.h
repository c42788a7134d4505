// Wavefront OBJ models with their MTL materials, for the model installer.
//
//   Scene chair = importObj("antiqueChair.obj");   // the file's own units; no camera, no light
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace penumbra {

// One mesh a material. Textures come from map_Kd; holes from map_d or that picture's own alpha.
// Untextured glass (d < 1/2) is left out, since it casts no shadow worth the name. Throws Error.
Scene importObj(const std::filesystem::path& path);

}  // namespace penumbra
