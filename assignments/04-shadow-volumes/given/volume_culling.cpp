#include "volume_culling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/stage.h"

namespace penumbra {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// All points beyond one of the view's planes. Points at infinity count like others, since a plane's
// test is linear in homogeneous coordinates. There is no far plane.
bool outside(const glm::mat4& clipFromWorld, const std::vector<glm::vec4>& points) {
    std::array<bool, 5> beyond;
    beyond.fill(true);
    for (const glm::vec4 point : points) {
        const glm::vec4 p = clipFromWorld * point;
        const float inside[] = {p.w + p.x, p.w - p.x, p.w + p.y, p.w - p.y, p.w + p.z};
        for (std::size_t i = 0; i < beyond.size(); ++i) beyond[i] = beyond[i] && inside[i] < 0;
    }
    return std::any_of(beyond.begin(), beyond.end(), [](bool all) { return all; });
}

float distanceTo(const Box& box, glm::vec3 p) {
    return glm::length(p - glm::clamp(p, box.lower, box.upper));
}

// The light shines to one side of its plane, and no farther than its range.
bool beyondReach(const Box& box, const Light& light) {
    if (light.directional || box.empty()) return box.empty();
    if (distanceTo(box, light.center) >= light.range) return true;
    const std::vector<glm::vec3> points = corners(box);
    return std::all_of(points.begin(), points.end(), [&](glm::vec3 p) {
        return glm::dot(p - light.center, light.forward()) < 0;
    });
}

// What a box's volume can fill: along each axis the box, and without end where the light can push
// its points that way.
Box volumeBox(const Box& box, glm::vec4 light) {
    Box volume = box;
    for (int axis = 0; axis < 3; ++axis) {
        if (light.w * box.lower[axis] - light[axis] < 0) volume.lower[axis] = -kInfinity;
        if (light.w * box.upper[axis] - light[axis] > 0) volume.upper[axis] = kInfinity;
    }
    return volume;
}

Box withinRange(const Box& box, const Light& light) {
    return {glm::max(box.lower, light.center - light.range),
            glm::min(box.upper, light.center + light.range)};
}

// More than touch: a flat ground does not lie in the volume that it throws downwards.
bool overlap(const Box& a, const Box& b) {
    return glm::all(glm::lessThan(a.lower, b.upper)) && glm::all(glm::lessThan(b.lower, a.upper));
}

}  // namespace

VolumeCulling::VolumeCulling(const View& view, const glm::mat4& clipFromWorld)
    : view_(view), clipFromWorld_(clipFromWorld) {
    for (std::size_t i = 0; i < view.scene.meshes.size(); ++i) {
        boxes_.push_back(bounds(view.scene.meshes[i]));
        std::vector<glm::vec4> points;
        for (const glm::vec3 p : corners(boxes_[i])) points.emplace_back(p, 1.0f);
        if (!boxes_[i].empty() && !outside(clipFromWorld_, points)) receivers_.push_back(i);
    }
}

bool VolumeCulling::skips(std::size_t mesh, const Light& light) const {
    const Settings& s = view_.settings;
    const Box& box = boxes_[mesh];
    const glm::vec4 position = light.position();
    if (s.on("cull_range") && beyondReach(box, light)) return true;
    if (s.on("cull_view") && !box.empty()) {
        std::vector<glm::vec4> hull;
        for (const glm::vec3 p : corners(box)) {
            hull.emplace_back(p, 1.0f);
            hull.emplace_back(position.w * p - glm::vec3(position), 0.0f);
        }
        if (outside(clipFromWorld_, hull)) return true;
    }
    if (s.on("cull_empty")) {
        const Box volume = volumeBox(box, position);
        return std::none_of(receivers_.begin(), receivers_.end(), [&](std::size_t receiver) {
            Box lit = boxes_[receiver];
            if (s.on("cull_range") && beyondReach(lit, light)) return false;
            if (s.on("cull_range") && !light.directional) lit = withinRange(lit, light);
            return overlap(volume, lit);
        });
    }
    return false;
}

PixelRectangle VolumeCulling::reach(const Light& light) const {
    const PixelRectangle everything{{0, 0}, view_.size};
    if (!view_.settings.on("scissor") || light.directional || std::isinf(light.range))
        return everything;
    Box lit;  // by this light, at most
    for (const std::size_t receiver : receivers_) {
        const Box part = withinRange(boxes_[receiver], light);
        if (!glm::all(glm::lessThanEqual(part.lower, part.upper))) continue;
        lit.include(part.lower), lit.include(part.upper);
    }
    if (lit.empty()) return {};
    glm::vec2 lower(1.0f), upper(-1.0f);
    for (const glm::vec3 p : corners(lit)) {
        const glm::vec4 clip = clipFromWorld_ * glm::vec4(p, 1.0f);
        if (clip.w <= 0) return everything;  // reaches behind the eye
        lower = glm::min(lower, glm::vec2(clip) / clip.w);
        upper = glm::max(upper, glm::vec2(clip) / clip.w);
    }
    // One pixel of room for rounding.
    const glm::vec2 size(view_.size);
    const glm::vec2 first = glm::floor((0.5f * lower + 0.5f) * size) - 1.0f;
    const glm::vec2 last = glm::ceil((0.5f * upper + 0.5f) * size) + 1.0f;
    const glm::ivec2 from(glm::clamp(first, glm::vec2(0), size));
    const glm::ivec2 to(glm::clamp(last, glm::vec2(0), size));
    return {from, glm::max(to - from, glm::ivec2(0))};
}

}  // namespace penumbra
