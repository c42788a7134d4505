// Scenes that break shadow volumes one at a time. The eye's and the near plane's place is worked
// out in the comments; gallery_test.cpp and volume_count_test.cpp hold it.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/gallery_parts.h"
#include "scene/gallery_scenes.h"
#include "scene/shapes.h"

namespace penumbra {

namespace {

Mesh slab(glm::vec3 center, glm::vec3 size, int material) {
    return box(center - 0.5f * size, center + 0.5f * size, material);
}

// Three corners each, on their own vertices; normals along the first triangle with area.
Mesh loose(const std::vector<glm::vec3>& corners, int material) {
    Mesh mesh;
    mesh.material = material;
    mesh.positions = corners;
    glm::vec3 normal(0, 1, 0);
    for (unsigned i = 0; i + 2 < corners.size(); i += 3) {
        mesh.triangles.emplace_back(i, i + 1, i + 2);
        const glm::vec3 n = glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
        if (glm::length(n) > 0.0f) normal = glm::normalize(n);
        mesh.normals.insert(mesh.normals.end(), 3, normal);
    }
    return mesh;
}

}  // namespace

// The eye stands under a roof, in its shadow, and looks out to where the sun lies on the ground.
Scene eyeInsideScene(std::uint64_t seed) {
    Variation vary(seed);
    Scene scene = emptyScene();
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int wood = addMaterial(scene, "wood", {0.45f, 0.28f, 0.15f});
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const int glaze = addMaterial(scene, "glaze", {0.18f, 0.38f, 0.62f});
    const glm::vec3 roof(vary(0.0f, 0.3f), vary(3.0f, 0.2f), vary(2.6f, 0.3f));
    add(scene, "roof", slab(roof, {4.4f, 0.2f, 3.2f}, wood));
    const float x = vary(-1.7f, 0.2f), z = vary(0.5f, 0.3f);
    for (const float side : {-1.0f, 1.0f})
        add(scene, "post",
            box({roof.x + 1.9f * side - 0.07f, kStandingGap, roof.z - 1.4f},
                {roof.x + 1.9f * side + 0.07f, roof.y - 0.1f - kStandingGap, roof.z - 1.26f},
                wood));
    add(scene, "box",
        turned(box({x - 0.5f, kStandingGap, z - 2.0f}, {x + 0.5f, 1.1f, z - 1.0f}, clay),
               {x, 0, z - 1.5f}, vary(0.5f, 0.4f)));
    add(scene, "sphere", sphere({vary(1.3f, 0.2f), 0.9f, vary(-1.2f, 0.3f)}, 0.6f, 24, glaze));
    // High above: at the eye's height the roof's shadow still reaches a unit and more around it.
    scene.lights = {
        Light::lookingAt({roof.x + vary(-0.8f, 0.3f), 11.0f, roof.z + 0.8f}, {0, 0, 0}, 1.5f)};
    scene.camera = {.eye = {roof.x, 1.6f, roof.z}, .target = {0, 0.5f, -1.0f}, .verticalFov = 1.0f};
    fitDepthRange(scene);
    return scene;
}

// Seen from above, the light overhead at L and the eye looking along -z:
//
//            near rectangle
//           +-------|---+       The screen's shadow begins at the plane | that holds L and the
//            \      |  /        screen's edge. It passes the eye on the right, but cuts the near
//             \     | /         rectangle: z-pass begins to count inside the volume there and
//              eye  |           outside it on the left.
Scene nearCutScene(std::uint64_t seed) {
    constexpr float kNear = 0.5f, kFov = 0.8f;
    Variation vary(seed);
    Scene scene = emptyScene();
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int cloth = addMaterial(scene, "cloth", {0.60f, 0.57f, 0.50f});
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const glm::vec3 eye(vary(-0.4f, 0.3f), vary(1.8f, 0.2f), vary(4.0f, 0.3f));
    const glm::vec3 light(vary(-2.0f, 0.5f), 9.0f, vary(1.0f, 0.5f));
    // At the eye's height the shadow begins a quarter of the near rectangle's half width beside it.
    const float beside = 0.25f * kNear * std::tan(0.5f * kFov);
    const float height = vary(4.2f, 0.2f);
    const float edge =
        light.x + (eye.x + beside - light.x) * (light.y - height) / (light.y - eye.y);
    add(scene, "awning", box({edge, height, -1.0f}, {edge + 1.2f, height + 0.1f, 4.6f}, cloth));
    add(scene, "box", box({-1.9f, kStandingGap, -1.4f}, {-0.8f, 1.0f, -0.4f}, clay));
    add(scene, "sphere", sphere({1.6f, 0.9f, -1.2f}, 0.7f, 24, clay));
    scene.lights = {Light::lookingAt(light, {0, 0, 0}, 1.5f)};
    scene.camera = {.eye = eye,
                    .target = eye + glm::vec3(0, -0.32f, -1.0f),
                    .verticalFov = kFov,
                    .nearPlane = kNear,
                    .farPlane = 20.0f};
    return scene;
}

// N closed sheets in a stack, so that a receiver beneath lies in N volumes. Around that, where the
// light passes some sheets by, every count from 0 to N occurs.
Scene nestedScene(double sheets) {
    Scene scene = emptyScene();
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int paper = addMaterial(scene, "paper", {0.75f, 0.70f, 0.55f});
    const int count = int(sheets);
    Mesh stack;
    for (int i = 0; i < count; ++i) {
        const float low = 1.2f + 2.4f * float(i) / float(count);
        const float thickness = 0.75f * 2.4f / float(count);
        append(stack, box({-1.3f, low, -1.3f}, {1.3f, low + thickness, 1.3f}, paper));
    }
    stack.material = paper;
    if (count > 0) add(scene, "sheets", turned(std::move(stack), glm::vec3(0.0f), 0.3f));
    scene.lights = {standardLight(2.5f)};
    fitDepthRange(scene);
    return scene;
}

// Parallel light: w = 0, volumes without an apex, shadows of equal width at every distance.
Scene sunScene(std::uint64_t seed) {
    Variation vary(seed);
    Scene scene = emptyScene();
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const int glaze = addMaterial(scene, "glaze", {0.18f, 0.38f, 0.62f});
    const int stone = addMaterial(scene, "stone", {0.60f, 0.57f, 0.50f});
    for (int i = 0; i < 4; ++i)
        add(scene, "column",
            cylinder({-3.6f + 1.5f * float(i), kStandingGap, vary(-1.8f, 0.3f)}, 0.22f,
                     vary(2.2f, 0.5f), 24, stone));
    const glm::vec3 center(vary(-1.4f, 0.4f), 0.55f, vary(1.2f, 0.3f));
    add(scene, "box",
        turned(slab(center, {1.2f, 1.1f - 2.0f * kStandingGap, 1.0f}, clay), center,
               vary(0.5f, 0.4f)));
    add(scene, "sphere", sphere({vary(1.4f, 0.3f), 1.5f, vary(1.0f, 0.4f)}, 0.7f, 32, glaze));
    add(scene, "ring",
        torus({vary(2.6f, 0.3f), vary(1.0f, 0.3f), -1.0f}, 0.8f, 0.18f, 48, 16, clay));
    Light sun = standardLight(vary(2.4f, 0.5f), vary(0.75f, 0.1f));
    sun.directional = true;
    scene.lights = {sun};
    fitDepthRange(scene);
    return scene;
}

// A lantern hangs over the ground: floor, roof and bars, one closed mesh around the light, which
// lies in the hollow and not in the solid. The bulb sits just above the light's plane.
Scene lampScene(std::uint64_t seed) {
    Variation vary(seed);
    Scene scene = emptyScene();
    scene.materials[0].baseColor = {0.60f, 0.57f, 0.52f};
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int iron = addMaterial(scene, "iron", {0.20f, 0.21f, 0.24f});
    const int glow = addMaterial(scene, "bulb", {0.9f, 0.8f, 0.6f}, {1.0f, 0.85f, 0.55f});
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const glm::vec3 light(vary(-0.3f, 0.3f), vary(2.6f, 0.2f), vary(0.2f, 0.3f));
    constexpr float kRadius = 0.55f;
    Mesh cage = torus(light - glm::vec3(0, 0.75f, 0), kRadius, 0.05f, 32, 8, iron);
    append(cage, torus(light + glm::vec3(0, 0.35f, 0), kRadius, 0.05f, 32, 8, iron));
    constexpr int kBars = 8;
    for (int i = 0; i < kBars; ++i) {
        const float angle = glm::two_pi<float>() * (float(i) + 0.5f) / float(kBars);
        const glm::vec3 at = light + kRadius * glm::vec3(std::cos(angle), 0, std::sin(angle));
        append(cage, turned(box(at - glm::vec3(0.025f, 0.75f, 0.025f),
                                at + glm::vec3(0.025f, 0.35f, 0.025f), iron),
                            at, -angle));
    }
    add(scene, "cage", std::move(cage));
    add(scene, "roof",
        lathe(light + glm::vec3(0, 0.42f, 0), {{0, 0}, {0.75f, 0}, {0.75f, 0.04f}, {0, 0.4f}}, 32,
              iron));
    add(scene, "bulb", sphere(light + glm::vec3(0, 0.16f, 0), 0.14f, 12, glow));
    for (int i = 0; i < 3; ++i) {
        const float angle = vary(2.1f * float(i) + 0.4f, 0.4f), far = vary(2.6f, 0.4f);
        const glm::vec3 at(far * std::cos(angle), 0, far * std::sin(angle));
        add(scene, "box",
            turned(box(at + glm::vec3(-0.35f, kStandingGap, -0.35f),
                       at + glm::vec3(0.35f, vary(0.7f, 0.2f), 0.35f), clay),
                   at, angle));
    }
    scene.lights = {Light::lookingAt(light, {light.x, 0, light.z}, 0.2f)};
    fitDepthRange(scene);
    return scene;
}

// The key light is shut in a globe without an opening, so that nothing else sees it: no triangle of
// the globe faces it, and whoever extrudes facing triangles alone lets all of its light out. A
// second light shows the scene.
Scene shutLampScene(std::uint64_t seed) {
    Variation vary(seed);
    Scene scene = emptyScene();
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int glow = addMaterial(scene, "globe", {0.8f, 0.75f, 0.6f}, {0.55f, 0.45f, 0.25f});
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const glm::vec3 light(vary(-1.2f, 0.4f), vary(2.2f, 0.3f), vary(0.2f, 0.4f));
    add(scene, "globe", sphere(light, 0.5f, 16, glow));
    const float x = vary(1.2f, 0.4f);
    add(scene, "box", box({x, kStandingGap, -0.6f}, {x + 1.2f, vary(1.2f, 0.3f), 0.6f}, clay));
    Light second = standardLight(vary(2.5f, 0.4f));
    second.color = glm::vec3(0.8f);
    scene.lights = {Light::lookingAt(light, {light.x, 0, light.z}, 0.2f), second};
    fitDepthRange(scene);
    return scene;
}

// Meshes that are no solids, each a mesh of its own: only volumes of single triangles, or edges
// counted with their multiplicity, are right about them. The light stands at x = 2 exactly.
Scene openMeshScene(std::uint64_t seed) {
    Variation vary(seed);
    Scene scene = emptyScene();
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int leaf = addMaterial(scene, "leaf", {0.30f, 0.45f, 0.16f});
    const int sail = addMaterial(scene, "sail", {0.75f, 0.70f, 0.55f});
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const int slate = addMaterial(scene, "slate", {0.28f, 0.33f, 0.40f});
    const auto at = [&](float x, float y, float z) { return glm::vec3(x, y, z); };

    const float y = vary(1.4f, 0.2f), z = vary(1.6f, 0.2f);
    add(scene, "one triangle",
        loose({at(-2.5f, y, z), at(-1.0f, y + 0.4f, z + 0.5f), at(-2.0f, y + 0.2f, z - 1.2f)},
              leaf));

    // Three sails on one mast.
    const float mast = vary(-0.2f, 0.2f), low = vary(0.6f, 0.1f), high = low + 1.5f;
    const glm::vec3 foot = at(mast, low, 1.0f), top = at(mast, high, 1.1f);
    add(scene, "three faces on an edge",
        loose({foot, top, at(mast + 1.2f, low + 0.1f, 1.4f), foot, top,
               at(mast - 0.7f, low + 0.3f, 1.9f), foot, top, at(mast - 0.6f, low, 0.1f)},
              sail));

    // A kite whose middle edge the left side splits and the right side does not.
    const float kite = vary(1.7f, 0.2f);
    const glm::vec3 south = at(2.2f, kite, 2.4f), north = at(2.2f, kite + 0.5f, 0.8f);
    const glm::vec3 middle = 0.5f * (south + north);
    const glm::vec3 west = at(1.4f, kite + 0.1f, 1.5f), east = at(3.1f, kite + 0.1f, 1.7f);
    add(scene, "T-junction",
        loose({south, east, north, middle, west, south, north, west, middle}, clay));

    // A box that lost its lid; its walls have no thickness.
    Mesh crate = box({-3.2f, kStandingGap, -2.6f}, {-1.8f, vary(1.0f, 0.2f), -1.4f}, clay);
    crate.triangles.erase(crate.triangles.begin() + 4, crate.triangles.begin() + 6);
    add(scene, "open box", std::move(crate));

    // Its plane x = 2 holds the light: it casts no shadow.
    add(scene, "light in its plane",
        loose({at(2, 0.4f, -2.4f), at(2, 1.9f, -1.7f), at(2, 0.5f, -0.9f)}, slate));

    // A sound triangle amid some without area: a point, a needle, three corners on a line.
    const float d = vary(-0.6f, 0.2f);
    const glm::vec3 a = at(d, 1, -2), b = at(d + 1, 1.25f, -2), c = at(d + 0.5f, 1.5f, -1);
    add(scene, "degenerate",
        loose({a, b, c, a, a, a, b, b, c, a, 0.5f * (a + b), b, c, c, a}, leaf));
    scene.lights = {Light::lookingAt({2, 8, -1.5f}, {0, 0, 0}, 1.5f)};
    fitDepthRange(scene);
    return scene;
}

}  // namespace penumbra
