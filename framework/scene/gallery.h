// The standard scenes by name, and the one door through which every program opens a scene.
//
//   Scene a = loadScene("fence@7");        // built in; the number is its seed (default 1)
//   Scene b = loadScene("tilted@85");      // for `tilted`: the light's angle of incidence, degrees
//   Scene c = loadScene("spiralStaircase") // an installed model: models/spiralStaircase.glb
//   Scene d = loadScene("path/to/any.glb");
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace penumbra {

// Throws Error for an unknown name (naming the known ones), a bad number or a broken file.
Scene loadScene(const std::string& nameOrPath);

std::vector<std::string> builtInSceneNames();
std::vector<std::string> installedModelNames();  // stems of models/*.glb, sorted

}  // namespace penumbra
