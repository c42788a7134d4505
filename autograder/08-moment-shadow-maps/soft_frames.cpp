#include "soft_frames.h"

#include <algorithm>
#include <cmath>

#include "scene/shapes.h"

namespace penumbra {

namespace {

constexpr const char* kScene = "stairs@3";

dvec4 momentsOf(double depth) {
    const double z = 2 * depth - 1;
    return {z, z * z, z * z * z, z * z * z * z};
}

}  // namespace

Rendered searchFrame(int refinements, int cells, bool receiverPlane) {
    return render({.scene = kScene,
                   .size = {128, 128},
                   .settings = {receiverPlane ? "receiver_plane=on" : "receiver_plane=off",
                                "horizon=off", "moment_bias=1e-2", "constant_bias=1",
                                "refinements=" + std::to_string(refinements),
                                "cells=" + std::to_string(cells)},
                   .images = {"visibility",
                              "receiver",
                              "light_height",
                              "box_moments",
                              "blocker_depth",
                              "blocker_share",
                              {"shadow_map", glm::ivec2(kMapSize)},
                              {"moments", glm::ivec2(kMapSize)},
                              {"light_clip_from_world", {4, 4}}}});
}

double planeFall(const dvec3& height, dvec2 low, dvec2 high) {
    double drop = 0;
    for (const double s : {low.x, high.x})
        for (const double t : {low.y, high.y})
            drop = std::max(drop, -(height.y * s + height.z * t));
    return drop <= 0 ? 0 : height.x > 0 ? std::min(drop / height.x, 1.0) : 1;
}

MapTwin::MapTwin(const Rendered& frame)
    : sums_(std::size_t((kMapSize + 1) * (kMapSize + 1)), dvec4(0)) {
    const Light light = loadScene(kScene).lights[0];
    glm::dmat4 m;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            m[column][row] = frame.at("light_clip_from_world").at(column, row);
    const glm::dmat4 p = m * glm::inverse(glm::dmat4(light.viewFromWorld()));
    nearPlane_ = p[3][2] / (p[2][2] - 1), farPlane_ = p[3][2] / (p[2][2] + 1);
    tangents_ = {2 / p[0][0], 2 / p[1][1]};
    scaleUv_ = double(light.width) * (1 / nearPlane_ - 1 / farPlane_) / tangents_;

    const Image& depths = frame.at("shadow_map");
    const auto at = [&](int x, int y) -> dvec4& {
        return sums_[std::size_t(y * (kMapSize + 1) + x)];
    };
    for (int y = 0; y < kMapSize; ++y)
        for (int x = 0; x < kMapSize; ++x)  // OpenGL's rows run upwards
            at(x + 1, y + 1) =
                momentsOf(depths.at(x, kMapSize - 1 - y)) + at(x, y + 1) + at(x + 1, y) - at(x, y);
}

dvec4 MapTwin::sumBelow(dvec2 texels) const {
    const glm::ivec2 whole = glm::min(glm::ivec2(texels), glm::ivec2(kMapSize - 1));
    const dvec2 part = texels - dvec2(whole);
    const auto first = std::size_t(whole.y * (kMapSize + 1) + whole.x);
    const auto row = [&](std::size_t i) { return glm::mix(sums_[i], sums_[i + 1], part.x); };
    return glm::mix(row(first), row(first + kMapSize + 1), part.y);
}

MapTwin::Box MapTwin::window(const dvec3& uvDepth, double blockerDepth, dvec2 lightLow,
                             dvec2 lightHigh) const {
    const dvec2 width = double(kMapSize) * scaleUv_ * std::max(uvDepth.z - blockerDepth, 0.0);
    const dvec2 center = double(kMapSize) * dvec2(uvDepth) + 0.5 * (lightLow + lightHigh) * width;
    const dvec2 half = 0.5 * glm::max((lightHigh - lightLow) * width, dvec2(1));
    return {center - half, center + half};
}

dvec4 MapTwin::mean(const Box& box, bool wholeTexels) const {
    const auto area = [](const Box& b) { return (b.high.x - b.low.x) * (b.high.y - b.low.y); };
    Box inside{glm::clamp(box.low, 0.0, double(kMapSize)),
               glm::clamp(box.high, 0.0, double(kMapSize))};
    const double share = area(inside) / area(box);
    if (share <= 0) return dvec4(1);
    if (wholeTexels) inside = {glm::floor(inside.low), glm::ceil(inside.high)};
    const dvec4 sum = sumBelow(inside.high) - sumBelow({inside.low.x, inside.high.y}) -
                      sumBelow({inside.high.x, inside.low.y}) + sumBelow(inside.low);
    // Beyond the map nothing is drawn: depth 1, all moments 1.
    return glm::mix(dvec4(1), sum / area(inside), share);
}

double MapTwin::bias(double depth) const {
    const double inverse = 1 / nearPlane_ + depth * (1 / farPlane_ - 1 / nearPlane_);
    return std::max(tangents_.x, tangents_.y) / kMapSize * inverse /
           (1 / nearPlane_ - 1 / farPlane_);
}

Below MapTwin::blockers(double compared, const dvec4& moments) const {
    const double t = 2 * compared - 1;
    Below below = threePoints(biased(moments, kTwinBias), t).below;
    below.sum = below.share * (0.5 * std::clamp(below.depth(), -1.0, t) + 0.5);
    return below;
}

Below MapTwin::search(const dvec3& uvDepth, double blockerDepth) const {
    return blockers(uvDepth.z - bias(uvDepth.z),
                    mean(window(uvDepth, blockerDepth, dvec2(-0.5), dvec2(0.5)), true));
}

double MapTwin::filteredVisibility(const dvec3& uvDepth, double blockerDepth, int cells,
                                   const dvec3& height) const {
    const double depth = uvDepth.z - bias(uvDepth.z),
                 distance = std::max(uvDepth.z - blockerDepth, 0.0);
    double blocked = 0;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const dvec2 low = dvec2(i, j) / double(cells) - 0.5, high = low + 1.0 / cells;
            const Box box = window(uvDepth, blockerDepth, low, high);
            const double compared = depth - 0.75 * planeFall(height, low, high) * distance;
            blocked += blockers(compared, mean(box, false)).share;
        }
    return 1 - blocked / (cells * cells);
}

Scene bareGround() {
    Scene scene;
    scene.name = "bare ground";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(4.0f, 1, 0)};
    scene.lights = {Light::lookingAt({1.0f, 7.0f, 0.5f}, {0.0f, 0.0f, 0.0f}, 1.0f)};
    scene.camera = {.eye = {0.0f, 3.0f, 6.0f},
                    .target = {0.0f, -0.4f, 0.0f},
                    .verticalFov = 0.85f,
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    return scene;
}

Scene settingLight() {
    Scene scene;
    scene.name = "setting light";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(6.0f, 1, 0)};
    scene.lights = {Light::lookingAt({1.0f, 0.5f, -6.0f}, {0.0f, -0.5f, 0.0f}, 3.0f)};
    scene.camera = {.eye = {0.0f, 4.0f, 6.0f},
                    .target = {0.0f, -0.2f, 0.0f},
                    .verticalFov = 0.8f,
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    return scene;
}

}  // namespace penumbra
