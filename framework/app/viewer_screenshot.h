// The whole window as a picture.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>

namespace penumbra {

// The window's back buffer to out/screenshots/<scene>-<n>.png, n the first that is free. Throws
// Error.
std::filesystem::path saveScreenshot(glm::ivec2 pixels, const std::string& scene);

}  // namespace penumbra
