#include "scene/blockers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/gallery.h"
#include "scene/shapes.h"

namespace penumbra {
namespace {

Scene sceneOf(std::vector<Mesh> meshes) {
    Scene scene;
    scene.meshes = std::move(meshes);
    return scene;
}

std::vector<std::string> names(const std::vector<Mesh>& meshes) {
    std::vector<std::string> result;
    for (const Mesh& mesh : meshes) result.push_back(mesh.name);
    return result;
}

Mesh named(Mesh mesh, const char* name) {
    mesh.name = name;
    return mesh;
}

using Names = std::vector<std::string>;
const Light kLamp = Light::lookingAt({2, 6, 1}, {0, 0, 0}, 1.5f);

TEST(PossibleBlockers, AreNotTheGroundThatTheyStandOn) {
    const Scene scene =
        sceneOf({named(ground(12, 4, 0), "ground"), named(box({-1, 0, -1}, {1, 2, 1}, 0), "box")});
    EXPECT_EQ(names(possibleBlockers(scene, kLamp)), Names{"box"});
}

TEST(PossibleBlockers, AreNotASlabOfGround) {
    Scene scene = sceneOf({named(box({-9, -1, -9}, {9, 0, 9}, 0), "ground"),
                           named(box({-1, 0, -1}, {1, 2, 1}, 0), "box")});
    EXPECT_EQ(names(possibleBlockers(scene, kLamp)), Names{"box"});
    // A slab inside out counts as an open mesh: it may be seen from inside.
    for (glm::uvec3& t : scene.meshes[0].triangles) std::swap(t.y, t.z);
    EXPECT_EQ(names(possibleBlockers(scene, kLamp)), (Names{"ground", "box"}));
}

// The panel stands between the light and nothing but the room's wall.
TEST(PossibleBlockers, InARoomAroundTheLightAreThoseBeforeItsWalls) {
    for (const bool insideOut : {false, true}) {
        Mesh room = named(box({-5, 0, -5}, {5, 8, 5}, 0), "room");
        if (insideOut)
            for (glm::uvec3& t : room.triangles) std::swap(t.y, t.z);
        const Mesh panel = quad({-4, 1, -1}, {-4, 1, 1}, {-4, 3, 1}, {-4, 3, -1}, 0);
        EXPECT_EQ(names(possibleBlockers(sceneOf({room, named(panel, "panel")}), kLamp)),
                  Names{"panel"});
    }
}

TEST(PossibleBlockers, AreTheGroundWhereSomethingLiesBelow) {
    const Scene scene = sceneOf(
        {named(ground(12, 1, 0), "ground"), named(box({-1, -0.5f, -1}, {1, 2, 1}, 0), "box")});
    // The box's bottom is averted from the light, but its sides reach below the ground.
    EXPECT_EQ(names(possibleBlockers(scene, kLamp)), (Names{"ground", "box"}));
}

TEST(PossibleBlockers, AreTheGroundWhereTheLightIsBelowOrInIt) {
    const Scene scene =
        sceneOf({named(ground(12, 1, 0), "ground"), named(box({-1, 0, -1}, {1, 2, 1}, 0), "box")});
    const Light below = Light::lookingAt({2, -6, 1}, {0, 0, 0}, 1.5f);
    EXPECT_EQ(names(possibleBlockers(scene, below)), (Names{"ground", "box"}));
    const Light across = Light::lookingAt({7, 0, 1}, {0, 0, 0}, 1.5f);  // stands half below
    EXPECT_EQ(names(possibleBlockers(scene, across)), (Names{"ground", "box"}));
}

TEST(PossibleBlockers, AreNotBehindTheLight) {
    const Scene scene =
        sceneOf({named(ground(12, 1, 0), "ground"), named(box({-1, 0, -1}, {1, 2, 1}, 0), "box"),
                 named(box({0, 20, 0}, {1, 21, 1}, 0), "cloud")});
    EXPECT_EQ(names(possibleBlockers(scene, kLamp)), Names{"box"});
}

TEST(PossibleBlockers, OfParallelLightAreTheSame) {
    const Scene scene =
        sceneOf({named(ground(12, 1, 0), "ground"), named(box({-1, 0, -1}, {1, 2, 1}, 0), "box")});
    Light sun = kLamp;
    sun.directional = true;
    EXPECT_EQ(names(possibleBlockers(scene, sun)), Names{"box"});
}

// A turned floor of many facets: their planes differ by rounding.
TEST(PossibleBlockers, AreNotATurnedGround) {
    Scene scene =
        sceneOf({named(ground(12, 6, 0), "ground"), named(box({-1, 0, -1}, {1, 2, 1}, 0), "box")});
    const float c = std::cos(0.7f), s = std::sin(0.7f);
    const glm::mat3 turn(c, s, 0, -s, c, 0, 0, 0, 1);
    for (Mesh& mesh : scene.meshes)
        for (glm::vec3& p : mesh.positions) p = turn * p;
    const Light light = Light::lookingAt(turn * glm::vec3(2, 6, 1), {0, 0, 0}, 1.5f);
    EXPECT_EQ(names(possibleBlockers(scene, light)), Names{"box"});
}

TEST(PossibleBlockers, LeaveOutTheGroundOfTheGallery) {
    for (const char* name : {"boxes", "fence", "stairs"}) {
        const Scene scene = loadScene(name);
        const auto blockers = possibleBlockers(scene, scene.lights[0]);
        EXPECT_EQ(blockers.size() + 1, scene.meshes.size()) << name;
        for (const Mesh& mesh : blockers) EXPECT_NE(mesh.name, "ground");
    }
}

TEST(PossibleBlockers, OfBareGroundAreNone) {
    EXPECT_TRUE(possibleBlockers(sceneOf({ground(12, 1, 0)}), kLamp).empty());
    EXPECT_TRUE(possibleBlockers(sceneOf({}), kLamp).empty());
}

}  // namespace
}  // namespace penumbra
