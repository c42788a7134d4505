// Scenes for shadows that are projected onto one known receiver. It comes first, an open sheet
// named "ground" or "receiver"; casters are closed solids.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/gallery_parts.h"
#include "scene/gallery_scenes.h"
#include "scene/shapes.h"

namespace penumbra {

namespace {

// A sheet over the square [0, 1]²; `point` gives its place.
template <class Point>
Mesh sheet(int columns, int rows, int material, Point point) {
    Mesh mesh;
    mesh.material = material;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const float u = float(column) / float(columns), v = float(row) / float(rows);
            constexpr float kStep = 1e-2f;
            const glm::vec3 along = point(u + kStep, v) - point(u - kStep, v);
            const glm::vec3 across = point(u, v + kStep) - point(u, v - kStep);
            mesh.positions.push_back(point(u, v));
            mesh.normals.push_back(glm::normalize(glm::cross(across, along)));
            mesh.uvs.emplace_back(u, v);
        }
    const auto index = [&](int row, int column) { return unsigned(row * (columns + 1) + column); };
    for (int row = 0; row < rows; ++row)
        for (int c = 0; c < columns; ++c) {
            mesh.triangles.emplace_back(index(row, c), index(row + 1, c), index(row + 1, c + 1));
            mesh.triangles.emplace_back(index(row, c), index(row + 1, c + 1), index(row, c + 1));
        }
    return mesh;
}

}  // namespace

// A board of 7 x 6 around (0, 1, 0), tilted about the x axis towards the viewer, and what floats
// over it, all turned with it:
//
//         light           w, off the board    The plate reaches past the board's edge: shadows are
//                |        |   / v, uphill     cut off there. Ring and sphere stand in one line with
//         ring   |        |  /                the light: dark once, not twice.
//      sphere plate       | /
//   box                   +------ u = x
//  ---------------- board
Scene boardScene(double tiltDegrees) {
    Scene scene;
    const int slate = addMaterial(scene, "board", {0.58f, 0.56f, 0.52f});
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const int glaze = addMaterial(scene, "glaze", {0.18f, 0.38f, 0.62f});
    const int brass = addMaterial(scene, "brass", {0.62f, 0.48f, 0.18f});
    const auto c = float(std::cos(glm::radians(tiltDegrees)));
    const auto s = float(std::sin(glm::radians(tiltDegrees)));
    // Columns: where x (u), y (w) and z (-v) of the untilted board go.
    const glm::mat3 worldFromBoard(1, 0, 0, 0, c, s, 0, -s, c);
    const glm::vec3 origin(0, 1, 0);
    const auto addTilted = [&](const char* name, Mesh mesh) {
        for (glm::vec3& p : mesh.positions) p = origin + worldFromBoard * p;
        for (glm::vec3& n : mesh.normals) n = glm::normalize(worldFromBoard * n);
        add(scene, name, std::move(mesh));
    };
    addTilted("receiver", quad({-3.5f, 0, 3}, {3.5f, 0, 3}, {3.5f, 0, -3}, {-3.5f, 0, -3}, slate));
    addTilted("box", turned(box({-2.4f, 0.35f, 0.4f}, {-1.4f, 1.05f, 1.4f}, clay), {-1.9f, 0, 0.9f},
                            0.5f));
    addTilted("sphere", sphere({0.1f, 1.2f, 0.2f}, 0.6f, 24, glaze));
    addTilted("ring", torus({-0.25f, 2.4f, -0.15f}, 0.75f, 0.14f, 40, 12, brass));
    addTilted("plate", box({1.7f, 1.5f, -1.9f}, {3.1f, 1.6f, -0.3f}, clay));
    addTilted("pole", cylinder({-2.2f, 0.2f, -1.5f}, 0.12f, 2.0f, 16, brass));
    scene.lights = {
        Light::lookingAt(origin + worldFromBoard * glm::vec3(-1.4f, 6.5f, -1.2f), origin, 0.8f)};
    scene.camera = {.eye = {1.8f, 7.6f, 9.4f}, .target = {0.2f, 1.1f, 0.0f}, .verticalFov = 0.62f};
    fitDepthRange(scene);
    return scene;
}

// One curved receiver under a low light: a bowl beneath the casters and a wall that the ground
// rises to behind the light. The pole's top is higher than the light, so that its mirror image, on
// the other side of the light, would fall on the wall: what projects the casters must not paint
// there.
//
//        |                      /
//        |    light            |
//        |      o              |
//   o    |                    /
//  ~~\       /~~~~~~~~~~~~~~~'
//     \_____/
Scene hollowScene(std::uint64_t seed) {
    Variation vary(seed);
    Scene scene = emptyScene();
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const int glaze = addMaterial(scene, "glaze", {0.18f, 0.38f, 0.62f});
    const int brass = addMaterial(scene, "brass", {0.62f, 0.48f, 0.18f});
    const glm::vec2 bowl(vary(-1.3f, 0.3f), vary(0.6f, 0.3f));
    const float wave = vary(1.3f, 0.2f);
    // From the left edge the sheet runs over the ground to x = kBend, then up a quarter of a pipe.
    constexpr float kBend = 2.9f, kRadius = 3.0f, kGroundShare = 0.7f;
    const auto point = [&](float u, float v) {
        const float z = kGroundSize * (v - 0.5f);
        const float onWall = std::max(0.0f, (u - kGroundShare) / (1.0f - kGroundShare));
        const float angle = glm::half_pi<float>() * onWall;
        const float left = -0.5f * kGroundSize;
        const float flat = left + (kBend - left) * std::min(u / kGroundShare, 1.0f);
        const float far = glm::distance(glm::vec2(flat, z), bowl);
        const float dip = -1.5f * std::exp(-0.22f * far * far);
        const float calm = glm::smoothstep(0.0f, 2.0f, kBend - flat);  // no waves at the wall
        return glm::vec3(flat + kRadius * std::sin(angle),
                         dip + 0.12f * calm * std::sin(wave * flat + 0.4f) * std::cos(1.1f * z) +
                             1.4f * kRadius * (1.0f - std::cos(angle)),
                         z);
    };
    add(scene, "ground", sheet(60, 48, 0, point));
    const glm::vec3 over(bowl.x, 0, bowl.y);
    add(scene, "sphere", sphere(over + glm::vec3(0.6f, 0.7f, 0.9f), 0.5f, 24, glaze));
    add(scene, "ring",
        torus(over + glm::vec3(-0.9f, vary(0.9f, 0.2f), 0.3f), 0.7f, 0.15f, 40, 12, brass));
    const glm::vec3 at = over + glm::vec3(0.2f, 0.4f, -1.1f);
    add(scene, "box", turned(box(at - 0.4f, at + 0.4f, clay), at, vary(0.6f, 0.4f)));
    add(scene, "pole", cylinder(over + glm::vec3(-1.7f, 0.1f, -1.0f), 0.1f, 4.5f, 16, clay));
    const glm::vec3 light(vary(1.0f, 0.2f), 3.2f, 0.4f);
    scene.lights = {Light::lookingAt(light, {light.x, 0, light.z}, 0.8f)};
    scene.camera = {
        .eye = {-2.0f, 7.6f, 10.8f}, .target = {0.7f, 0.9f, 0.0f}, .verticalFov = 0.86f};
    fitDepthRange(scene);
    return scene;
}

// What a projection to the ground gets wrong: above the light (the mast's upper part, the yard as a
// whole) it draws antishadows, below the ground (the buoy's lower half, the block under the edge)
// false shadows.
Scene mastScene(std::uint64_t seed) {
    Variation vary(seed);
    Scene scene = emptyScene();
    add(scene, "ground", ground(7.0f, 1, 0));
    const int wood = addMaterial(scene, "wood", {0.45f, 0.28f, 0.15f});
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const int glaze = addMaterial(scene, "glaze", {0.18f, 0.38f, 0.62f});
    const glm::vec3 mast(vary(-1.1f, 0.2f), kStandingGap, vary(-0.9f, 0.2f));
    add(scene, "mast", cylinder(mast, 0.12f, 3.6f, 20, wood));
    add(scene, "yard",
        turned(
            box(mast + glm::vec3(-1.2f, 2.8f, -0.3f), mast + glm::vec3(1.2f, 2.95f, -0.15f), wood),
            mast, vary(0.3f, 0.2f)));
    add(scene, "buoy", sphere({vary(1.9f, 0.2f), 0.1f, vary(-0.9f, 0.3f)}, 0.6f, 24, glaze));
    add(scene, "box",
        turned(box({-2.4f, kStandingGap, 1.0f}, {-1.6f, 0.9f, 1.8f}, clay), {-2, 0, 1.4f},
               vary(0.4f, 0.3f)));
    add(scene, "block below", box({2.4f, -1.1f, 1.4f}, {4.4f, -0.4f, 2.6f}, clay));
    const glm::vec3 light(vary(0.3f, 0.15f), vary(2.4f, 0.1f), vary(0.3f, 0.15f));
    scene.lights = {Light::lookingAt(light, {light.x, 0, light.z}, 0.5f)};
    scene.camera = {.eye = {2.6f, 6.8f, 8.8f}, .target = {0.2f, 0.7f, 0.1f}, .verticalFov = 0.72f};
    fitDepthRange(scene);
    return scene;
}

}  // namespace penumbra
