// Frames that several checks share, and the soft shadow's steps done anew in float64 on the
// program's own shadow map.
#pragma once

#include "moment_checks.h"

namespace penumbra {

constexpr int kMapSize = 512;
constexpr double kTwinBias = 1e-2;  // moments far from singular: a twin may be held to 1e-3

// stairs@3 without the horizon, with bias kTwinBias: shadow_map, moments, receiver, light_height,
// box_moments, blocker_depth, blocker_share, visibility, light_clip_from_world.
Rendered searchFrame(int refinements, int cells = 1, bool receiverPlane = false);

// How far the receiver's plane falls towards the light's points between `low` and `high`, in units
// of the distance in depth to the blocker there; `height` as light_height has it. [0,1], README §4
double planeFall(const dvec3& height, dvec2 low, dvec2 high);

// What searchFrame()'s map holds.
class MapTwin {
public:
    explicit MapTwin(const Rendered& frame);

    // What is nearer than the receiver at (u, v, depth), less the bias, in the window that the
    // light covers, seen from it through `blockerDepth`: in all texels that the window touches, or
    // in the windows of cells² parts of the light, each compared below its part of a plane with
    // this light_height; (1, 0, 0) is parallel to the light. Depths in [0,1].
    Below search(const dvec3& uvDepth, double blockerDepth) const;
    double filteredVisibility(const dvec3& uvDepth, double blockerDepth, int cells,
                              const dvec3& height = {1, 0, 0}) const;

private:
    struct Box {
        dvec2 low, high;  // [texels]
    };
    Box window(const dvec3& uvDepth, double blockerDepth, dvec2 lightLow, dvec2 lightHigh) const;
    double bias(double depth) const;  // a texel's width, in depth
    Below blockers(double compared, const dvec4& moments) const;
    dvec4 sumBelow(dvec2 texels) const;
    dvec4 mean(const Box& box, bool wholeTexels) const;

    double nearPlane_, farPlane_;
    dvec2 tangents_, scaleUv_;
    std::vector<dvec4> sums_;  // over all texels to the left and below
};

// Scenes of our own.
Scene bareGround();
Scene settingLight();  // a wide light, half of it below the ground that it shines along

}  // namespace penumbra
