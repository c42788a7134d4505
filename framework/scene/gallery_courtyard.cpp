// Ten lanterns and 48 casters in close proximity: the demonstration of many shadow volumes. Every
// caster is a mesh of its own, so that it can be left out where its shadow reaches nothing.
//
//   wall ----------------------------------- wall        o  lantern
//    | o A-----A-----A-----A-----A-----A o |             A  column; arches from one to the next
//    | A     urns        o        urns     A |
//    | A  bench       fountain     bench  A |
//    | A  crates  o      o      o balls   A |
//    ...               camera
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/error.h"
#include "scene/gallery.h"
#include "scene/gallery_parts.h"
#include "scene/gallery_scenes.h"
#include "scene/shapes.h"

namespace penumbra {

namespace {

constexpr float kCourtSize = 16.0f;
constexpr float kColumnHeight = 2.2f;
constexpr int kColumnsAside = 6;

// Paving stones, each of its own grey, mortar between them, every other row shifted by half a
// stone.
Texture2D pavingTexture(Random& random) {
    constexpr int kStones = 8, kTexels = 32;  // across; texels of one stone
    constexpr int kSize = kStones * kTexels;
    Texture2D texture{kSize, kSize, std::vector<std::uint8_t>(std::size_t(4 * kSize * kSize), 255)};
    std::vector<float> shade(std::size_t(kStones * kStones));
    for (float& grey : shade) grey = random.between(0.86f, 1.0f);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const int row = y / kTexels, shifted = x + (row % 2) * kTexels / 2;
            const int column = (shifted / kTexels) % kStones;
            const int inX = shifted % kTexels, inY = y % kTexels;
            const bool mortar = inX < 2 || inY < 2;
            const float speckle = random.between(0.96f, 1.0f);
            const float grey =
                mortar ? 0.62f : speckle * shade[std::size_t(row * kStones + column)];
            for (int channel = 0; channel < 3; ++channel)
                texture.rgba[std::size_t(4 * (y * kSize + x) + channel)] =
                    std::uint8_t(std::lround(255.0f * grey));
        }
    return texture;
}

struct Court {
    Scene scene = emptyScene();
    int stone, marble, clay, wood, leaf, iron;

    Court() {
        scene.materials[0].baseColor = {0.50f, 0.47f, 0.44f};
        stone = addMaterial(scene, "stone", {0.62f, 0.56f, 0.46f});
        marble = addMaterial(scene, "marble", {0.74f, 0.72f, 0.68f});
        clay = addMaterial(scene, "clay", {0.68f, 0.34f, 0.22f});
        wood = addMaterial(scene, "wood", {0.45f, 0.28f, 0.15f});
        leaf = addMaterial(scene, "leaf", {0.20f, 0.38f, 0.14f});
        iron = addMaterial(scene, "iron", {0.20f, 0.21f, 0.24f});
    }

    // A caster; the gap to what carries it is in its foot.
    void put(const char* name, Mesh mesh) {
        add(scene, name, std::move(mesh));
        ++casters;
    }
    int casters = 0;
};

void addGroundAndWalls(Court& court, Random& random) {
    court.scene.textures.push_back(pavingTexture(random));
    court.scene.materials[0].texture = 0;
    Mesh paving = ground(kCourtSize, 1, 0);
    for (glm::vec2& uv : paving.uvs) uv *= 2.0f;  // a stone is a unit wide
    add(court.scene, "paving", std::move(paving));
    constexpr float kHalf = 0.5f * kCourtSize, kThick = 0.3f, kHeight = 3.4f, y = kStandingGap;
    const auto wall = [&](glm::vec3 lower, glm::vec3 upper) {
        add(court.scene, "wall", box(lower, upper, court.stone));
    };
    wall({-kHalf, y, -kHalf}, {kHalf, kHeight, -kHalf + kThick});
    wall({-kHalf, y, -kHalf + kThick + kStandingGap}, {-kHalf + kThick, kHeight, kHalf});
    wall({kHalf - kThick, y, -kHalf + kThick + kStandingGap}, {kHalf, kHeight, kHalf});
}

// Two colonnades along the sides and a row at the back: 6 + 6 columns, 5 + 5 arches.
void addColonnades(Court& court) {
    const std::vector<glm::vec2> outline = {
        {0, 0},         {0.34f, 0},     {0.34f, 0.16f}, {0.25f, 0.24f},         {0.20f, 0.34f},
        {0.17f, 1.85f}, {0.24f, 1.95f}, {0.32f, 2.04f}, {0.32f, kColumnHeight}, {0, kColumnHeight}};
    for (const float side : {-1.0f, 1.0f})
        for (int i = 0; i < kColumnsAside; ++i) {
            const float x = 5.2f * side, z = -5.6f + 2.0f * float(i);
            court.put("column", lathe({x, kStandingGap, z}, outline, 20, court.marble));
            if (i + 1 == kColumnsAside) continue;
            const glm::vec3 middle(x, kColumnHeight + 2.0f * kStandingGap, z + 1.0f);
            const Mesh bow = arch(middle, 0.72f, 0.98f, 0.4f, 12, court.stone);
            court.put("arch", turned(bow, middle, glm::half_pi<float>()));
        }
}

// Basin, shaft, bowl and ball, one above the other: 4 casters.
void addFountain(Court& court, glm::vec3 foot) {
    court.put(
        "basin",
        lathe(foot, {{0, 0}, {1.5f, 0}, {1.6f, 0.45f}, {1.4f, 0.45f}, {1.3f, 0.15f}, {0, 0.12f}},
              32, court.stone));
    court.put("shaft",
              lathe(foot + glm::vec3(0, 0.12f + kStandingGap, 0),
                    {{0, 0}, {0.3f, 0}, {0.18f, 0.2f}, {0.14f, 0.9f}, {0.22f, 1.0f}, {0, 1.0f}}, 20,
                    court.marble));
    court.put("bowl",
              lathe(foot + glm::vec3(0, 1.12f + 2.0f * kStandingGap, 0),
                    {{0, 0}, {0.3f, 0}, {0.75f, 0.26f}, {0.67f, 0.28f}, {0.28f, 0.1f}, {0, 0.08f}},
                    28, court.marble));
    court.put("ball", sphere(foot + glm::vec3(0, 1.55f, 0), 0.26f, 12, court.clay));
}

// 4 urns, 2 trees in their pots, 4 benches, 6 crates, 4 balls: 22 casters.
void addFurniture(Court& court, Variation& vary) {
    const std::vector<glm::vec2> urn = {{0, 0},         {0.2f, 0},      {0.14f, 0.08f},
                                        {0.3f, 0.4f},   {0.26f, 0.66f}, {0.15f, 0.76f},
                                        {0.24f, 0.86f}, {0, 0.84f}};
    for (int i = 0; i < 4; ++i) {
        const float x = -2.7f + 1.8f * float(i), z = -6.3f + vary(0.0f, 0.25f);
        court.put("urn", lathe({x, kStandingGap, z}, urn, 20, i % 2 ? court.clay : court.marble));
    }
    for (int i = 0; i < 2; ++i) {
        const glm::vec3 at(-1.8f + 3.6f * float(i), kStandingGap, -3.9f + vary(0.0f, 0.2f));
        court.put("pot", lathe(at, {{0, 0}, {0.26f, 0}, {0.36f, 0.42f}, {0.3f, 0.42f}, {0, 0.36f}},
                               20, court.clay));
        court.put("tree", sphere(at + glm::vec3(0, 0.98f, 0), 0.5f, 10, court.leaf));
    }
    for (int i = 0; i < 4; ++i) {
        const glm::vec3 at(i % 2 ? 3.6f : -3.6f, kStandingGap, i / 2 ? 1.6f : -1.4f);
        Mesh bench = box(at + glm::vec3(-0.25f, 0.4f, -0.75f), at + glm::vec3(0.25f, 0.5f, 0.75f),
                         court.wood);
        for (const float z : {-0.55f, 0.55f})  // the legs end within the seat
            append(bench, box(at + glm::vec3(-0.2f, 0, z - 0.06f),
                              at + glm::vec3(0.2f, 0.45f, z + 0.06f), court.wood));
        court.put("bench", turned(std::move(bench), at, vary(0.0f, 0.15f)));
    }
    for (int i = 0; i < 6; ++i) {  // three on the ground, two on these, one on top
        const int level = i < 3 ? 0 : i < 5 ? 1 : 2, place = i < 3 ? i : i < 5 ? i - 3 : 0;
        const float size = 0.62f, step = size + kStandingGap;
        const glm::vec3 at(-3.5f + 0.72f * (float(place) + 0.5f * float(level)),
                           kStandingGap + step * float(level), 4.0f);
        court.put("crate", turned(box(at - glm::vec3(size / 2, 0, size / 2),
                                      at + glm::vec3(size / 2, size, size / 2), court.wood),
                                  at, vary(i % 2 ? 0.12f : -0.08f, 0.06f)));
    }
    for (int i = 0; i < 4; ++i) {
        const float angle = vary(glm::two_pi<float>() * float(i) / 4.0f, 0.15f),
                    r = vary(0.24f, 0.04f);
        const glm::vec3 at(2.5f + 0.75f * std::cos(angle), kStandingGap + r,
                           4.1f + 0.7f * std::sin(angle));
        court.put("ball", sphere(at, r, 10, i % 2 ? court.marble : court.clay));
    }
}

// A lantern's bulb and hat lie above its light's plane, where it shines on nothing and so nothing
// of it casts a shadow.
void addLantern(Court& court, glm::vec3 at, glm::vec3 color, float range) {
    Light light = Light::lookingAt(at, {at.x, 0, at.z}, 0.25f);
    light.color = color;
    light.range = range;
    court.scene.lights.push_back(light);
    const int glow = addMaterial(court.scene, "bulb", glm::vec3(0.8f), 0.9f * color);
    add(court.scene, "bulb", sphere(at + glm::vec3(0, 0.13f, 0), 0.12f, 8, glow));
    add(court.scene, "hat",
        lathe(at + glm::vec3(0, 0.26f, 0), {{0, 0}, {0.22f, 0}, {0.05f, 0.14f}, {0, 0.14f}}, 16,
              court.iron));
}

}  // namespace

Scene courtyardScene(std::uint64_t seed) {
    Variation vary(seed);
    Random random(seed ^ 0xc0a27ull);
    Court court;
    addGroundAndWalls(court, random);
    addColonnades(court);
    addFountain(court, {0, kStandingGap, 0.2f});
    addFurniture(court, vary);
    EXPECTS(court.casters == kCourtyardCasters);

    const glm::vec3 amber(1.3f, 0.70f, 0.28f), gold(1.3f, 0.95f, 0.45f), rose(1.3f, 0.45f, 0.45f);
    const glm::vec3 sky(0.35f, 0.65f, 1.3f), mint(0.35f, 1.1f, 0.75f), violet(0.75f, 0.45f, 1.3f);
    addLantern(court, {vary(1.7f, 0.2f), 2.75f, vary(2.3f, 0.2f)}, amber, 6.5f);  // the key light
    addLantern(court, {-1.9f, 2.6f, -1.1f}, sky, 5.5f);
    addLantern(court, {1.5f, 2.4f, -2.6f}, gold, 5.0f);
    addLantern(court, {-2.2f, 2.3f, 2.6f}, rose, 5.0f);
    addLantern(court, {-4.0f, 2.1f, -4.9f}, gold, 4.5f);
    addLantern(court, {4.0f, 2.1f, -4.9f}, violet, 4.5f);
    addLantern(court, {-6.4f, 2.0f, -1.6f}, amber, 4.5f);
    addLantern(court, {6.4f, 2.0f, -0.6f}, mint, 4.5f);
    addLantern(court, {-6.4f, 2.0f, 2.4f}, sky, 4.5f);
    addLantern(court, {4.1f, 2.1f, 4.0f}, violet, 4.5f);
    EXPECTS(court.scene.lights.size() == std::size_t(kCourtyardLights));
    court.scene.camera = {
        .eye = {0.6f, 6.0f, 11.6f}, .target = {0.0f, 0.4f, -0.6f}, .verticalFov = 0.80f};
    fitDepthRange(court.scene);
    return court.scene;
}

}  // namespace penumbra
