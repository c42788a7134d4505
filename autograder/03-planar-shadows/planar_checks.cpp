#include "planar_checks.h"

#include <glm/gtc/matrix_access.hpp>

namespace penumbra {

// --- Matrices ---

dmat4 matrixFrom(const Image& image) {
    dmat4 m;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) m[column][row] = image.at(column, row);
    return m;
}

Matrices::Matrices(const Scene& scene) : light(scene.lights[0].position()) {
    const Rendered frame = render(
        {.scene = sceneFile(scene),
         .size = {16, 16},
         .images = {{"ground_matrix", {4, 4}}, {"shadow_matrix", {4, 4}}, {"plane", {4, 1}}}});
    ground = matrixFrom(frame.at("ground_matrix"));
    plane = matrixFrom(frame.at("shadow_matrix"));
    for (int i = 0; i < 4; ++i) planeVector[i] = frame.at("plane").at(i, 0);
}

// --- One caster's exact polygon ---

Scene oneCaster(const std::vector<dvec3>& caster, bool directional, int pose) {
    Scene scene = stage({0.7f, 5.0f, -0.9f}, directional);
    scene.meshes.push_back(polygonMesh(caster));
    return posed(scene, pose);
}

void expectExactPolygon(const std::vector<dvec3>& caster, bool directional, int pose,
                        const Settings& settings) {
    const Scene scene = oneCaster(caster, directional, pose);
    const Rendered frame = render({.scene = sceneFile(scene),
                                   .size = {kSize, kSize},
                                   .settings = settings,
                                   .images = {"visibility", "receiver", {"plane", {4, 1}}}});
    dvec4 plane;
    for (int i = 0; i < 4; ++i) plane[i] = frame.at("plane").at(i, 0);
    const PolygonTruth truth =
        polygonTruth(plane, scene.lights[0].position(), cornersOf(scene.meshes[1]), scene.camera,
                     kSize, 1.0 / 64);
    EXPECT_IMAGE_NEAR(frame.at("visibility"), truth.visibility,
                      {.maximum = 1e-6,
                       .cause = "corners are snapped to 1/256 pixel: beyond 1/64 pixel from the "
                                "polygon's edges every pixel is right"},
                      onReceiver(truth.mask, frame.at("receiver")));
}

double areaOf(const Corners& corners) {
    dvec3 twice(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const auto at = [&](std::size_t k) { return dvec3(corners[k]) / corners[k].w; };
        twice += glm::cross(at(i - 1) - at(0), at(i) - at(0));
    }
    return 0.5 * glm::length(twice);
}

// --- Rays beside frames ---

Image onReceiver(Image mask, const Image& receiver) {
    for (std::size_t i = 0; i < mask.pixels.size(); ++i)
        if (receiver.pixels[i] == 0.0f) mask.pixels[i] = 0.0f;
    return mask;
}

RayTruth::RayTruth(const Scene& scene, glm::ivec2 size) {
    const TracedScene traced(scene, size);
    receivers = traced.receivers();
    visibility = traced.pointVisibility();
    interior = Image(size.x, size.y, 1, 1.0f);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            for (int py = std::max(0, y - 1); py <= std::min(size.y - 1, y + 1); ++py)
                for (int px = std::max(0, x - 1); px <= std::min(size.x - 1, x + 1); ++px)
                    if (visibility.at(px, py) != visibility.at(x, y)) interior.at(x, y) = 0.0f;
}

double darkShare(const Rendered& frame, const Image& truth) {
    double blocked = 0, dark = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        if (truth.pixels[i] == 0.0f && frame.at("receiver").pixels[i] != 0.0f)
            blocked += 1, dark += frame.at("visibility").pixels[i] < 0.5f;
    return dark / blocked;
}

void expectLikeRays(const Scene& scene, const Settings& settings, const std::string& cause) {
    const RayTruth rays(scene, {kSize, kSize});
    const Rendered frame = render({.scene = sceneFile(scene),
                                   .size = {kSize, kSize},
                                   .settings = settings,
                                   .images = {"visibility", "receiver"}});
    EXPECT_IMAGE_NEAR(frame.at("visibility"), rays.visibility, {.maximum = 1e-6, .cause = cause},
                      onReceiver(rays.interior, frame.at("receiver")));
}

namespace {

// The texture's view with a depth, which the edge band needs.
glm::mat4 withDepth(dmat4 clipFromWorld, const Light& light) {
    const dvec4 distance = light.directional ? dvec4(1e-3 * dvec3(light.forward()), 0)
                                             : glm::row(clipFromWorld, 3) - dvec4(0, 0, 0, 0.01);
    return glm::mat4(glm::row(clipFromWorld, 2, distance));
}

}  // namespace

void expectTextureLikeRays(const Scene& scene, const std::string& file, const Settings& settings,
                           double share, const std::string& cause) {
    constexpr int kTexels = 1024;
    const Light& light = scene.lights[0];
    const TracedScene traced(scene, {kSize, kSize});
    const Rendered frame =
        render({.scene = file,
                .size = {kSize, kSize},
                .settings = settings,
                .images = {"visibility", "receiver", {"texture_clip_from_world", {4, 4}}}});
    const glm::mat4 clip = withDepth(matrixFrom(frame.at("texture_clip_from_world")), light);
    Image mask = traced.edgeBand(clip, kTexels, 1.5f);
    for (float& v : mask.pixels) v = 1.0f - v;
    EXPECT_IMAGE_NEAR(frame.at("visibility"), traced.pointVisibility(),
                      {.outliers = share, .outlierDistance = 0.01, .cause = cause},
                      onReceiver(mask, frame.at("receiver")));
}

Scene overlappingCasters() {
    Scene scene = stage({0.7f, 5.0f, -0.9f});
    for (int i = 0; i < 5; ++i) {
        const double x = 0.25 * i - 1.5, y = 0.6 + 0.45 * i, z = 0.2 * i - 0.8;
        scene.meshes.push_back(polygonMesh(
            {{x, y, z}, {x, y, z + 1.2}, {x + 1.2, y + 0.1, z + 1.2}, {x + 1.2, y + 0.1, z}}));
    }
    scene.meshes.push_back(box({1.2f, 0.4f, 0.5f}, {2.0f, 1.2f, 1.3f}, 0));
    return posed(scene, 3);
}

// --- Rows of inputs ---

namespace {

bool decided(dvec4 plane, dvec4 light, dvec3 caster) {
    const double height = heightOver(plane, caster);
    const double room = glm::dot(plane, light) - light.w * height;
    return std::abs(height) > 0.1 && std::abs(room) > 0.1;
}

}  // namespace

Casters::Casters(unsigned seed, Lights kinds) {
    Dice dice{std::mt19937(seed)};
    add(dice, false);
    if (kinds == pointsAndSuns) add(dice, true);
}

void Casters::add(Dice& dice, bool directional) {
    for (const std::size_t end = planes.size() + kRows; planes.size() < end;) {
        const dvec4 plane(vec4(vec3(dice.direction()), float(dice(-3, 3))));
        const dvec4 light(directional ? vec3(dice.direction()) : vec3(dice.point(8)),
                          directional ? 0 : 1);
        const dvec3 caster(vec3(dice.point(8))), other(vec3(dice.point(8)));
        const double most = glm::dot(plane, light);
        if (most < (directional ? 0.1 : 1.0)) continue;
        if (!decided(plane, light, caster) || !decided(plane, light, other)) continue;
        planes.emplace_back(plane), lights.emplace_back(light);
        casters.emplace_back(caster, 1), others.emplace_back(other, 1);
    }
}

Rows Casters::ask(const char* chunk, const char* expression) const {
    return evaluate({.chunk = chunk,
                     .expression = expression,
                     .inputs = {{"a", planes}, {"b", lights}, {"c", casters}, {"d", others}}});
}

}  // namespace penumbra
