// What the checks of planar shadows share: a frame's matrices, casters of one polygon, rays beside
// frames, and rows of planes, lights and casters.
#pragma once

#include "core/checks.h"
#include "core/truths.h"
#include "planar_truth.h"
#include "scene/gallery.h"

namespace penumbra {

using Rows = std::vector<vec4>;
using Settings = std::vector<std::string>;

constexpr int kRows = 256;
constexpr int kSize = 256;

// --- Matrices ---

dmat4 matrixFrom(const Image& image);

// One frame's matrices, and what they were made from.
struct Matrices {
    dmat4 ground, plane;
    dvec4 planeVector, light;

    explicit Matrices(const Scene& scene);
    // Of one entry before its terms cancel: float32 rounds relative to this.
    double scale() const { return glm::length(planeVector) * glm::length(light); }
};

// --- One caster's exact polygon ---

inline const std::vector<dvec3> kFloating{{-1.0, 1.0, 0.9}, {1.4, 2.2, 0.2}, {0.1, 1.6, -1.2}};
inline const std::vector<dvec3> kThroughThePlane{
    {-1.2, -1.4, 0.4}, {1.6, 1.3, 0.9}, {0.3, 1.9, -1.3}};
inline const std::vector<dvec3> kPastTheLight{{-0.8, 0.9, 0.8}, {1.1, 7.5, 0.6}, {0.9, 1.2, -0.7}};
inline const std::vector<dvec3> kThroughBoth{{-1.5, -1.0, 0.5}, {1.3, 9.0, 0.7}, {0.8, 1.1, -0.9}};

Scene oneCaster(const std::vector<dvec3>& caster, bool directional, int pose);
void expectExactPolygon(const std::vector<dvec3>& caster, bool directional, int pose,
                        const Settings& settings);
// Area on the plane of homogeneous corners, none of them at infinity.
double areaOf(const Corners& corners);

// --- Rays beside frames ---

// The receiver's part of a mask.
Image onReceiver(Image mask, const Image& receiver);

// Rays from the receiver, and where they can be held to a pixel: farther than one from an edge of
// the shadow.
struct RayTruth {
    Receivers receivers;
    Image visibility, interior;

    RayTruth(const Scene& scene, glm::ivec2 size);
};

// Of the receiver's pixels whose light is blocked, the share that came out dark. Where nothing is
// drawn, nothing is drawn in the wrong place either: that is no merit.
double darkShare(const Rendered& frame, const Image& truth);

// The receiver against the rays, farther than a pixel from a shadow's edge.
void expectLikeRays(const Scene& scene, const Settings& settings, const std::string& cause);

// With a shadow texture: farther than 1.5 texels from a shadow's edge; `share` of the rest may be
// wrong.
void expectTextureLikeRays(const Scene& scene, const std::string& file, const Settings& settings,
                           double share, const std::string& cause);

// Five sheets one above another, and a box: its shadow has two layers everywhere.
Scene overlappingCasters();

// --- Rows of inputs ---

// Planes and lights on their lit side, and casters anywhere; none nearer than 0.1 to a boundary, so
// that rounding decides nothing.
struct Casters {
    enum Lights { points, pointsAndSuns };
    Rows planes, lights, casters, others;

    Casters(unsigned seed, Lights kinds);
    Rows ask(const char* chunk, const char* expression) const;

private:
    void add(Dice& dice, bool directional);
};

}  // namespace penumbra
