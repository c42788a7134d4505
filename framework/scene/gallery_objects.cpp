#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/gallery_parts.h"
#include "scene/gallery_scenes.h"
#include "scene/random.h"
#include "scene/shapes.h"

namespace penumbra {

namespace {

Mesh blockOnGround(glm::vec3 center, glm::vec3 size, int material) {
    const glm::vec3 half = 0.5f * size;
    return box(center - half, center + half, material);
}

// Height of the foliage scene's ground: three waves, at most 0.35 from zero.
struct Bumps {
    explicit Bumps(Random& random) {
        for (glm::vec3& wave : waves) {
            const float angle = random.between(0.0f, glm::two_pi<float>());
            const float number = random.between(0.8f, 2.2f);
            wave = {number * std::cos(angle), number * std::sin(angle),
                    random.between(0.0f, glm::two_pi<float>())};
        }
    }
    float height(float x, float z) const {
        float sum = 0.0f;
        for (const glm::vec3 w : waves) sum += std::sin(w.x * x + w.y * z + w.z);
        return 0.35f / 3.0f * sum;
    }
    glm::vec3 normal(float x, float z) const {
        float dx = 0.0f, dz = 0.0f;
        for (const glm::vec3 w : waves) {
            const float slope = 0.35f / 3.0f * std::cos(w.x * x + w.y * z + w.z);
            dx += w.x * slope, dz += w.y * slope;
        }
        return glm::normalize(glm::vec3(-dx, 1.0f, -dz));
    }
    glm::vec3 waves[3];  // wave numbers along x and z, phase
};

glm::vec3 randomDirection(Random& random) {
    const float y = random.between(-1.0f, 1.0f);
    const float angle = random.between(0.0f, glm::two_pi<float>());
    const float r = std::sqrt(std::max(0.0f, 1.0f - y * y));
    return {r * std::cos(angle), y, r * std::sin(angle)};
}

Mesh leaf(glm::vec3 center, Random& random, int material) {
    const glm::vec3 normal = randomDirection(random);
    const glm::vec3 helper = std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 along = glm::normalize(glm::cross(helper, normal));
    const glm::vec3 across = glm::cross(normal, along);
    const glm::vec3 a = random.between(0.08f, 0.15f) * along;
    const glm::vec3 b = random.between(0.05f, 0.10f) * across;
    return quad(center - a - b, center + a - b, center + a + b, center - a + b, material);
}

}  // namespace

Light standardLight(float azimuth, float tilt) {
    const glm::vec3 towards(std::sin(tilt) * std::cos(azimuth), std::cos(tilt),
                            std::sin(tilt) * std::sin(azimuth));
    return Light::lookingAt(kStandardLightDistance * towards, glm::vec3(0.0f), kStandardLightWidth);
}

void fitDepthRange(Scene& scene) {
    const Box box = bounds(scene);
    const glm::vec3 forward = glm::normalize(scene.camera.target - scene.camera.eye);
    float nearest = 1e30f, farthest = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p(corner & 1 ? box.upper.x : box.lower.x,
                          corner & 2 ? box.upper.y : box.lower.y,
                          corner & 4 ? box.upper.z : box.lower.z);
        const float depth = glm::dot(p - scene.camera.eye, forward);
        nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
    }
    scene.camera.farPlane = 1.05f * farthest;
    scene.camera.nearPlane = std::max(0.9f * nearest, scene.camera.farPlane / 25.0f);
}

Scene boxesScene(std::uint64_t seed) {
    Variation vary(seed);
    Scene scene = emptyScene();
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int clay = addMaterial(scene, "clay", {0.70f, 0.32f, 0.20f});
    const int glaze = addMaterial(scene, "glaze", {0.18f, 0.38f, 0.62f});

    const glm::vec3 size(vary(1.6f, 0.4f), vary(1.8f, 0.5f), vary(1.4f, 0.4f));
    const glm::vec3 center(vary(-1.5f, 0.5f), 0.5f * size.y, vary(-0.2f, 0.7f));
    add(scene, "box", turned(blockOnGround(center, size, clay), center, vary(0.4f, 0.4f)));

    const float radius = vary(0.85f, 0.2f);
    const float gap = vary(0.9f, 0.5f);  // between ground and sphere: > 0
    add(scene, "sphere",
        sphere({vary(1.7f, 0.5f), gap + radius, vary(0.5f, 0.7f)}, radius, 32, glaze));
    scene.lights = {standardLight(vary(2.5f, 0.6f))};
    fitDepthRange(scene);
    return scene;
}

Scene fenceScene(std::uint64_t seed) {
    constexpr int kPosts = 24;
    constexpr float kPostWidth = 0.07f;
    Variation vary(seed);
    Scene scene = emptyScene();
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int wood = addMaterial(scene, "wood", {0.45f, 0.28f, 0.15f});

    const float half = 0.5f * kPostWidth;
    Mesh posts;
    posts.material = wood;
    for (int row = 0; row < 2; ++row) {
        const float z = vary(row == 0 ? -1.6f : 1.2f, 0.4f);
        for (int post = 0; post < kPosts; ++post) {
            const float along = float(post) / float(kPosts - 1);
            const float x = -3.8f + 7.6f * along + vary(0.0f, 0.06f);
            const float height = 0.5f + 2.3f * along;
            append(posts, box({x - half, 0.0f, z - half}, {x + half, height, z + half}, wood));
        }
    }
    add(scene, "posts", turned(std::move(posts), glm::vec3(0.0f), vary(0.0f, 0.2f)));
    scene.lights = {standardLight(vary(-2.0f, 0.35f))};
    fitDepthRange(scene);
    return scene;
}

Scene foliageScene(std::uint64_t seed) {
    constexpr int kLeaves = 2000, kCrowns = 9;
    Random random(seed ^ 0xf011a9eull);
    const Bumps bumps(random);
    Scene scene = emptyScene();
    Mesh earth = ground(kGroundSize, 48, 0);
    for (std::size_t i = 0; i < earth.positions.size(); ++i) {
        glm::vec3& p = earth.positions[i];
        p.y = bumps.height(p.x, p.z);
        earth.normals[i] = bumps.normal(p.x, p.z);
    }
    add(scene, "ground", std::move(earth));

    const int green = addMaterial(scene, "leaf", {0.22f, 0.42f, 0.12f});
    glm::vec2 crowns[kCrowns];
    for (glm::vec2& crown : crowns)
        crown = {random.between(-4.6f, 4.6f), random.between(-4.6f, 4.2f)};
    Mesh leaves;
    leaves.material = green;
    for (int i = 0; i < kLeaves; ++i) {
        // Trees with clearings between them: lit ground, umbra and penumbra all have their share.
        const glm::vec2 crown = crowns[i % kCrowns];
        const float angle = random.between(0.0f, glm::two_pi<float>());
        const float r = 1.7f * std::sqrt(random.unit());
        const float x = crown.x + r * std::cos(angle), z = crown.y + r * std::sin(angle);
        const float above = random.between(0.3f, 1.9f - 0.7f * r);
        append(leaves, leaf({x, bumps.height(x, z) + above, z}, random, green));
    }
    add(scene, "leaves", std::move(leaves));
    scene.lights = {standardLight(random.between(1.9f, 3.1f))};
    fitDepthRange(scene);
    return scene;
}

Scene stairsScene(std::uint64_t seed) {
    constexpr int kSteps = 6;
    Variation vary(seed);
    Scene scene = emptyScene();
    add(scene, "ground", ground(kGroundSize, 1, 0));
    const int stone = addMaterial(scene, "stone", {0.60f, 0.57f, 0.50f});
    const int slate = addMaterial(scene, "slate", {0.28f, 0.33f, 0.40f});
    const int brick = addMaterial(scene, "brick", {0.55f, 0.22f, 0.15f});

    const float rise = vary(0.32f, 0.06f), tread = vary(0.55f, 0.06f), front = vary(0.2f, 0.3f);
    for (int step = 0; step < kSteps; ++step) {  // climbing towards -z on the left
        const float z = front - float(step) * tread;
        add(scene, "step",
            box({-4.2f, 0.0f, z - tread}, {-1.4f, rise * float(step + 1), z}, stone));
    }
    // Blocks on the ground, slabs that float over them and more slabs over those: a receiver under
    // two layers of blockers, far from one and close to the other.
    for (int column = 0; column < 3; ++column) {
        const float x = 0.3f + 1.5f * float(column) + vary(0.0f, 0.15f);
        const float z = (column - 1) * 1.2f + vary(0.0f, 0.3f);
        const float low = vary(0.5f, 0.12f);
        const float middle = low + vary(0.55f, 0.12f), high = middle + vary(0.9f, 0.2f);
        add(scene, "block", blockOnGround({x, 0.5f * low, z}, {1.0f, low, 1.3f}, brick));
        add(scene, "slab", blockOnGround({x + 0.1f, middle, z}, {1.5f, 0.10f, 1.5f}, slate));
        add(scene, "slab", blockOnGround({x - 0.25f, high, z + 0.2f}, {1.1f, 0.10f, 1.8f}, slate));
    }
    add(scene, "slab",
        blockOnGround({-2.8f, rise * kSteps + 0.6f, -1.2f + vary(0.0f, 0.3f)}, {1.6f, 0.12f, 1.6f},
                      slate));
    scene.lights = {standardLight(vary(0.9f, 0.6f))};
    fitDepthRange(scene);
    return scene;
}

}  // namespace penumbra
