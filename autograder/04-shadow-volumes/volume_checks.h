// What the checks of shadow volumes share: the lists of a frame by mesh, counts beside their truth,
// pictures beside theirs, and meshes to ask about.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <random>

#include "core/checks.h"
#include "core/truths.h"
#include "scene/gallery.h"
#include "scene/mesh_edges.h"
#include "scene/orientation.h"
#include "scene/shapes.h"

namespace penumbra {

using glm::dvec3;
using glm::dvec4;
using glm::vec3;
using glm::vec4;
using Rows = std::vector<vec4>;
using SettingList = std::vector<std::string>;

constexpr int kSize = 256;
constexpr int kCountSize = 128;  // exact crossings are the dearest truth

struct Dice {
    std::mt19937 engine;
    double operator()(double low, double high) {
        return low + (high - low) * double(engine()) / 4294967295.0;
    }
    // Whole numbers, so that a float64 determinant of them is exact.
    vec3 lattice(int size) {
        return glm::round(vec3((*this)(-size, size), (*this)(-size, size), (*this)(-size, size)));
    }
};

// --- Scenes ---

Light lampAt(vec3 center);  // shines down
Light sunFrom(vec3 direction);

// A scene of these meshes as it is after a file has been written and read: what the program under
// test sees. The camera is somewhere; for lists it does not matter.
struct Stage {
    Scene scene;
    std::string file;
    vec4 light() const { return scene.lights[0].position(); }
};
Stage staged(std::vector<Mesh> meshes, std::vector<Light> lights);
Stage staged(Scene scene);

Mesh triangleMesh(const std::vector<vec3>& corners);  // three by three, each its own vertices
Mesh potato(unsigned seed);  // closed, about 0.7 around the origin, oblique facets
Mesh insideOut(Mesh mesh);
Mesh withoutTriangle(Mesh mesh, std::size_t triangle);

// --- Lists ---

struct VolumeCorner {
    int vertex;  // of the mesh, welded
    bool far;
    auto operator<=>(const VolumeCorner&) const = default;
};
using VolumeTriangle = std::array<VolumeCorner, 3>;

struct MeshLists {
    MeshEdges edges;
    std::vector<int> facing, weights, edgeSums;
    int kind = 0;
    std::vector<VolumeTriangle> sides, outwardCaps, inwardCaps;
};
std::vector<MeshLists> listsOf(const Stage& stage, const SettingList& settings = {});

// Every number of two lists equal; the report shows the first that differ.
void expectEqualLists(const char* subject, const std::vector<int>& mine,
                      const std::vector<int>& truth, const std::string& cause);
// orientation()'s signs of all triangles.
std::vector<int> sidesOfLight(const Mesh& mesh, vec4 light);

// A sum of triangles by its boundary: how often each directed edge is run, less the other way.
// Zero entries are left out. `sunlit`: all far corners are one point.
using Boundary = std::map<std::pair<VolumeCorner, VolumeCorner>, int>;
void addBoundary(Boundary& boundary, const std::vector<VolumeTriangle>& triangles, int times,
                 bool sunlit);
void addEdge(Boundary& boundary, VolumeCorner from, VolumeCorner to, int times, bool sunlit);
int differences(const Boundary& mine, const Boundary& truth);

// --- Counts ---

// The counts of one frame against exact crossings, modulo 256 unless `counter=float` is set.
// `mayDiffer`: decidable pixels, with their cause.
struct CountTolerance {
    int mayDiffer = 0;
    std::string cause =
        "whole numbers; pixels within half a pixel of a volume's side, or at a surface's edge, are "
        "left out";
};
void expectCounts(const std::string& scene, const SettingList& settings,
                  const CountTolerance& tolerance = {});

// --- Pictures ---

// The share of pixels that are 0. Where nothing is drawn, nothing goes wrong: that is no merit.
double shareOfZeros(const Image& image);

// Rays, and where the rasteriser can be held to them to the pixel: farther than a pixel from every
// edge of a shadow or of a surface.
struct RayPicture {
    RayPicture(const Scene& scene, glm::ivec2 size);

    Receivers receivers;
    std::vector<Image> visibility;  // by light
    Image interior;
};

// Whether a triangle's edge passes within a pixel of this one, not behind the receiver that its ray
// meets. Rays see no edge between two facets of one plane, nor the rim of a face that another
// covers.
bool edgeAround(const Scene& scene, glm::ivec2 size, glm::ivec2 pixel, vec3 receiver);

// The picture that the visibilities give of a scene whose materials are all the first one, without
// texture, and whose vertex normals are its facets'.
Image colorTruth(const Scene& scene, const RayPicture& rays);

}  // namespace penumbra
