// What planar shadows must be, in float64: flattened points, exact polygons, and the checks'
// scenes.
//
//   Scene scene = posed(triangleStage(light, triangle), 2);
//   PolygonTruth truth = polygonTruth(plane, light, triangle, scene.camera, size);
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <vector>

#include "core/image.h"
#include "scene/scene.h"
#include "scene/shapes.h"

namespace penumbra {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::vec3;
using glm::vec4;

struct Dice {
    std::mt19937 engine;
    double operator()(double low, double high) {
        return low + (high - low) * double(engine()) / 4294967295.0;
    }
    dvec3 point(double size) {
        return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
    }
    dvec3 direction() {
        dvec3 v;
        do v = point(1.0);
        while (glm::length(v) < 0.1 || glm::length(v) > 1.0);
        return glm::normalize(v);
    }
};

inline double heightOver(dvec4 plane, dvec3 p) { return glm::dot(plane, dvec4(p, 1.0)); }

// (p w, w): p in the plane on the ray from the light through `caster`, w = n·(l - l_w caster).
inline dvec4 flattened(dvec4 plane, dvec4 light, dvec3 caster) {
    const dvec3 towardsLight = dvec3(light) - light.w * caster;
    const double w = glm::dot(dvec3(plane), towardsLight);
    return {w * caster - heightOver(plane, caster) * towardsLight, w};
}

inline dmat4 shadowMatrixOf(dvec4 plane, dvec4 light) {
    return dmat4(glm::dot(plane, light)) - glm::outerProduct(light, plane);
}

// Where dot(side, corner) >= 0. Corners are homogeneous [Sutherland and Hodgman 1974].
using Corners = std::vector<dvec4>;
inline Corners clipped(const Corners& polygon, dvec4 side) {
    Corners kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec4 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const double a = glm::dot(side, p), b = glm::dot(side, q);
        if (a >= 0.0) kept.push_back(p);
        if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) kept.push_back(p + a / (a - b) * (q - p));
    }
    return kept;
}

// What of a convex caster stands between the plane and the light's height.
inline Corners between(dvec4 plane, dvec4 light, const std::vector<dvec3>& caster) {
    Corners polygon;
    for (const dvec3 v : caster) polygon.emplace_back(v, 1.0);
    polygon = clipped(polygon, plane);
    return clipped(polygon, dvec4(0, 0, 0, glm::dot(plane, light)) - light.w * plane);
}

// The shadow of one convex caster in the camera's image: 0 in the polygon. The mask leaves out
// pixels whose centre lies within `band` pixels of a line through one of its edges.
struct PolygonTruth {
    Image visibility, mask;
};

inline PolygonTruth polygonTruth(dvec4 plane, dvec4 light, const std::vector<dvec3>& caster,
                                 const Camera& camera, int size, double band) {
    const dmat4 clipFromWorld = dmat4(camera.clipFromView(1.0f)) * dmat4(camera.viewFromWorld());
    Corners corners = between(plane, light, caster);
    for (dvec4& c : corners) c = clipFromWorld * (shadowMatrixOf(plane, light) * c);
    corners = clipped(corners, {0, 0, 1, 1});  // the near plane
    std::vector<dvec2> pixels;
    for (const dvec4 c : corners)
        pixels.emplace_back(0.5 * size * (1.0 + c.x / c.w), 0.5 * size * (1.0 - c.y / c.w));
    double twiceArea = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const dvec2 p = pixels[i], q = pixels[(i + 1) % pixels.size()];
        twiceArea += p.x * q.y - p.y * q.x;
    }
    PolygonTruth truth{Image(size, size, 1, 1.0f), Image(size, size, 1, 1.0f)};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            double inside = pixels.empty() ? -1e9 : 1e9;  // distance to the nearest edge's line
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                const dvec2 p = pixels[i], along = pixels[(i + 1) % pixels.size()] - p;
                const dvec2 to = dvec2(x + 0.5, y + 0.5) - p;
                if (glm::length(along) > 0)
                    inside = std::min(inside, (along.x * to.y - along.y * to.x) /
                                                  glm::length(along) * (twiceArea > 0 ? 1 : -1));
            }
            truth.visibility.at(x, y) = inside > 0 ? 0.0f : 1.0f;
            truth.mask.at(x, y) = std::abs(inside) > band;
        }
    return truth;
}

// --- Scenes ---

// A square receiver of full width 8 in y = 0, a light that looks down at it, and a camera that sees
// it whole.
inline Scene stage(vec3 lightCenter, bool directional = false) {
    Scene scene;
    scene.name = "stage";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(8.0f, 1, 0)};
    scene.meshes[0].name = "receiver";
    scene.lights = {Light::lookingAt(lightCenter, {0.0f, 0.0f, 0.0f}, 0.5f)};
    scene.lights[0].directional = directional;
    scene.camera = {.eye = {1.0f, 9.0f, 7.0f},
                    .target = {0.0f, 0.0f, 0.2f},
                    .verticalFov = 0.85f,
                    .nearPlane = 1.0f,
                    .farPlane = 40.0f};
    return scene;
}

inline Mesh polygonMesh(const std::vector<dvec3>& corners) {
    Mesh mesh;
    mesh.name = "caster";
    const dvec3 normal =
        glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (const dvec3 c : corners) {
        mesh.positions.emplace_back(c);
        mesh.normals.emplace_back(normal);
    }
    for (unsigned i = 2; i < corners.size(); ++i) mesh.triangles.emplace_back(0, i - 1, i);
    return mesh;
}

// The same scene turned and moved as a whole; pose 0 leaves it in y = 0.
inline Scene posed(Scene scene, int pose) {
    if (pose == 0) return scene;
    Dice dice{std::mt19937(unsigned(900 + pose))};
    const glm::quat turn(glm::angleAxis(dice(0.5, 2.5), dice.direction()));
    const vec3 shift(dice.point(3.0));
    const auto moved = [&](vec3 p) { return turn * p + shift; };
    for (Mesh& mesh : scene.meshes) {
        for (vec3& p : mesh.positions) p = moved(p);
        for (vec3& n : mesh.normals) n = glm::normalize(turn * n);
    }
    for (Light& light : scene.lights) {
        light.center = moved(light.center);
        light.right = glm::normalize(turn * light.right);
        light.up = glm::normalize(turn * light.up);
    }
    scene.camera.eye = moved(scene.camera.eye);
    scene.camera.target = moved(scene.camera.target);
    scene.camera.up = turn * scene.camera.up;
    return scene;
}

inline std::vector<dvec3> cornersOf(const Mesh& convex) {
    return std::vector<dvec3>(convex.positions.begin(), convex.positions.end());
}

}  // namespace penumbra
