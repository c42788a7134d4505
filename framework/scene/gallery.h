// The standard scenes by name, and the one door through which every program opens a scene.
//
//   Scene a = loadScene("fence@7");        // built in; the number is its seed (default 1)
//   Scene b = loadScene("tilted@85");      // for `tilted`: the light's angle of incidence, degrees
//   Scene n = loadScene("nested@300");     // for `nested`: how many sheets; for `board`: its tilt
//   Scene c = loadScene("spiralStaircase") // an installed model: models/spiralStaircase.glb
//   Scene d = loadScene("path/to/any.glb");
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace penumbra {

// Throws Error for an unknown name (naming the known ones), a bad number or a broken file.
Scene loadScene(const std::string& nameOrPath);

std::vector<std::string> builtInSceneNames();
std::vector<std::string> installedModelNames();  // stems of models/*.glb, sorted

// The repository: the environment's PENUMBRA_ROOT, else where this was built.
std::filesystem::path repositoryRoot();

// Truth of `halfplane`: V(x) = clamp(1/2 + x (H - h) / (h L), 0, 1) on the ground y = 0. A light of
// width L at height H faces straight down; the blocker is x < 0 at height h. The seed moves the
// camera alone.
inline constexpr float kHalfPlaneLightHeight = 8.0f;    // H
inline constexpr float kHalfPlaneBlockerHeight = 4.0f;  // h
inline constexpr float kHalfPlaneLightWidth = 1.5f;     // L

// Truth of `polygon`: the ground's view of one convex planar polygon before a square light above
// the origin that faces straight down. Vertices in order around the polygon.
inline constexpr float kPolygonLightHeight = 8.0f;
inline constexpr float kPolygonLightWidth = 1.5f;
std::vector<glm::vec3> polygonSceneVertices(std::uint64_t seed);

// `courtyard`: casters are the closed meshes that stand in it, not its paving, walls and lanterns.
// Lanterns are meshes "bulb" and "hat", in the order of the lights, above the light's plane.
inline constexpr int kCourtyardLights = 10;
inline constexpr int kCourtyardCasters = 48;

}  // namespace penumbra
