#include "scene/stage.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "scene/shapes.h"

namespace penumbra {

namespace {

constexpr float kGroundSize = 12.0f;

void place(Scene& scene, const Stage& stage) {
    const float c = std::cos(glm::radians(stage.turnDegrees));
    const float s = std::sin(glm::radians(stage.turnDegrees));
    const glm::mat3 rotation(c, 0, -s, 0, 1, 0, s, 0, c);
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions) p = rotation * p;
        for (glm::vec3& n : mesh.normals) n = glm::normalize(rotation * n);
    }
    const Box box = bounds(scene);
    const glm::vec3 side = box.upper - box.lower;
    const float scale = stage.size / std::max({side.x, side.y, side.z});
    const glm::vec3 foot(box.center().x, box.lower.y, box.center().z);
    for (Mesh& mesh : scene.meshes)
        for (glm::vec3& p : mesh.positions)
            p = scale * (p - foot) + glm::vec3(0.0f, stage.lift, 0.0f);
}

// Under the middle of model and shadow, larger than 12 x 12 only where those need it.
void addGround(Scene& scene, const Box& footprint) {
    const glm::vec3 side = footprint.upper - footprint.lower;
    const float size = std::max({kGroundSize, 1.2f * side.x, 1.2f * side.z});
    scene.materials.push_back({.name = "ground", .baseColor = {0.55f, 0.53f, 0.50f}});
    Mesh plane = ground(size, 1, int(scene.materials.size()) - 1);
    const glm::vec3 middle(footprint.center().x, 0.0f, footprint.center().z);
    for (glm::vec3& p : plane.positions) p += middle;
    scene.meshes.push_back(std::move(plane));
    scene.camera.farPlane = std::max(scene.camera.farPlane, 2.0f * size);
}

}  // namespace

std::vector<glm::vec3> corners(const Box& box) {
    std::vector<glm::vec3> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                            i & 4 ? box.upper.z : box.lower.z);
    return points;
}

std::vector<glm::vec3> vertices(const Scene& scene) {
    std::vector<glm::vec3> points;
    for (const Mesh& mesh : scene.meshes)
        points.insert(points.end(), mesh.positions.begin(), mesh.positions.end());
    return points;
}

std::vector<glm::vec3> shadowOnGround(const std::vector<glm::vec3>& blockers, const Light& light) {
    std::vector<glm::vec3> points;
    for (const glm::vec2 st :
         {glm::vec2(0, 0), {-0.5f, -0.5f}, {-0.5f, 0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}})
        for (const glm::vec3 blocker : blockers) {
            const glm::vec3 from = light.point(st.x, st.y);
            EXPECTS(from.y > blocker.y);
            points.push_back(from + (blocker - from) * (from.y / (from.y - blocker.y)));
        }
    return points;
}

Camera cameraShowing(const std::vector<glm::vec3>& points, glm::vec3 forward, float verticalFov) {
    constexpr float kUsed = 0.9f;  // of the view's half width
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
    const glm::vec3 up = glm::cross(right, forward);
    const float tangent = kUsed * std::tan(0.5f * verticalFov);
    // In axes (right, up, forward) a point is in view if |x - ex| <= (z - ez) tangent, likewise y:
    // four half spaces whose offsets give the eye of each plane pair, and its depth.
    float left = 1e30f, rightmost = -1e30f, low = 1e30f, high = -1e30f;
    for (const glm::vec3 p : points) {
        const float x = glm::dot(p, right), y = glm::dot(p, up), z = glm::dot(p, forward);
        left = std::min(left, x + z * tangent), rightmost = std::max(rightmost, x - z * tangent);
        low = std::min(low, y + z * tangent), high = std::max(high, y - z * tangent);
    }
    const float ez = std::min(left - rightmost, low - high) / (2.0f * tangent);
    const float ex = 0.5f * (left + rightmost), ey = 0.5f * (low + high);
    Camera camera;
    camera.verticalFov = verticalFov;
    camera.eye = ex * right + ey * up + ez * forward;
    float nearest = 1e30f, farthest = 0.0f;
    for (const glm::vec3 p : points) {
        const float depth = glm::dot(p - camera.eye, forward);
        nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
    }
    camera.target = camera.eye + 0.5f * (nearest + farthest) * forward;
    camera.nearPlane = 0.5f * nearest;
    camera.farPlane = 2.0f * farthest;
    return camera;
}

void stageModel(Scene& scene, const Stage& stage) {
    EXPECTS(triangleCount(scene) > 0 && stage.size > 0.0f && stage.lift >= 0.0f);
    place(scene, stage);
    const Box box = bounds(scene);
    // From the left, behind and above: the shadow falls towards the right front, where it is seen.
    const glm::vec3 towards = glm::normalize(glm::vec3(-0.55f, 1.0f, -0.35f));
    const Light light = Light::lookingAt(14.0f * towards, glm::vec3(0.0f), 1.4f);
    scene.lights = {light};

    std::vector<glm::vec3> seen = corners(box);
    for (const glm::vec3 p : shadowOnGround(vertices(scene), light)) seen.push_back(p);
    scene.camera = cameraShowing(seen, glm::normalize(glm::vec3(-0.25f, -0.6f, -0.8f)), 0.6f);
    Box footprint;
    for (const glm::vec3 p : seen) footprint.include(p);
    addGround(scene, footprint);
}

}  // namespace penumbra
