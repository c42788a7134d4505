#include "field_checks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/metrics.h"
#include "truth/closed_form.h"

namespace penumbra {

dvec3 Dice::direction() {
    for (;;) {
        const dvec3 p = point(-1, 1);
        const double length = glm::length(p);
        if (length > 0.1 && length <= 1) return p / length;
    }
}

double RoundedBox::distance(dvec3 p) const {
    const dvec3 beyond = glm::abs(p - center) - halfSize;
    return glm::length(glm::max(beyond, 0.0)) +
           std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0) - radius;
}

double leastRatio(const std::function<double(double)>& distance, double first, double reach) {
    const auto ratio = [&](double t) { return distance(t) / t; };
    constexpr int kSamples = 200;
    const double step = (reach - first) / kSamples;
    int least = 0;
    for (int i = 1; i <= kSamples; ++i)
        if (ratio(first + i * step) < ratio(first + least * step)) least = i;
    double low = first + std::max(least - 1, 0) * step;
    double high = first + std::min(least + 1, kSamples) * step;
    const double golden = 0.5 * (std::sqrt(5.0) - 1);
    while (high - low > 1e-6 * reach) {
        const double part = golden * (high - low);
        if (ratio(high - part) < ratio(low + part))
            high = low + part;
        else
            low = high - part;
    }
    return ratio(0.5 * (low + high));
}

namespace {

const vec3 kGridCenter{0, 4, 0}, kGridHalf{4.5f, 3.0f, 4.5f};
constexpr float kHalfSlab = 4;  // across the edge it is so wide, along it twice

dvec3 turned(dvec3 p, double radians) {
    const double c = std::cos(radians), s = std::sin(radians);
    return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

}  // namespace

Light SlabStage::light() {
    return Light::lookingAt({0, kLightHeight, 0}, {0, 0, 0}, float(kLightWidth));
}

Scene SlabStage::scene() const {
    Scene scene;
    scene.name = "slab";
    scene.materials = {{.name = "grey"}};
    Mesh slab =
        box({-kHalfSlab, float(kTop - thickness), -kHalfSlab}, {0.0f, float(kTop), kHalfSlab}, 0);
    for (vec3& p : slab.positions) p = vec3(turned(p, turnRadians));
    for (vec3& n : slab.normals) n = vec3(turned(n, turnRadians));
    // Crumbs at the corners of a larger box: all rays from pixels to light run inside the grid.
    // Their shadows fall beside the ground.
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 at = kGridCenter + kGridHalf * vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                                       corner & 4 ? 1 : -1);
        append(slab, box(at - 0.01f, at + 0.01f, 0));
    }
    scene.meshes = {ground(8.0f, 1, 0), slab};
    scene.lights = {light()};
    scene.camera = {.eye = {0.5f, 2.4f, 3.2f},
                    .target = {0.0f, 0.0f, 0.3f},
                    .verticalFov = 0.8f,
                    .nearPlane = 0.5f,
                    .farPlane = 20.0f};
    return scene;
}

std::vector<dvec3> SlabStage::face(double height) const {
    std::vector<dvec3> corners{{-kHalfSlab, height, -kHalfSlab},
                               {0, height, -kHalfSlab},
                               {0, height, kHalfSlab},
                               {-kHalfSlab, height, kHalfSlab}};
    for (dvec3& p : corners) p = turned(p, turnRadians);
    return corners;
}

RoundedBox SlabStage::shape() const {
    return {{-0.5 * kHalfSlab, kTop - 0.5 * thickness, 0},
            {0.5 * kHalfSlab, 0.5 * thickness, kHalfSlab}};
}

double SlabStage::visibility(dvec3 receiver) const {
    return std::min(polygonVisibility(receiver, face(kTop), light()),
                    polygonVisibility(receiver, face(kTop - thickness), light()));
}

GroundPixels::GroundPixels(const Scene& scene, glm::ivec2 size) : mask(size.x, size.y, 1) {
    const Receivers receivers = TracedScene(scene, size).receivers();
    for (std::size_t i = 0; i < receivers.positions.size(); ++i) {
        positions.emplace_back(receivers.positions[i]);
        mask.pixels[i] = receivers.hit[i] && receivers.positions[i].y < 1e-3f ? 1.0f : 0.0f;
    }
}

double errorAgainstRays(const std::string& scene, const SettingList& settings) {
    constexpr glm::ivec2 kSize{256, 256};
    const Rendered frame = render({.scene = scene, .size = kSize, .settings = settings});
    static std::map<std::string, Image> truths;  // several methods are held against one
    Image& truth = truths[scene];
    if (truth.empty()) truth = TracedScene(loadScene(scene), kSize).areaVisibility(144);
    return compareVisibility(frame.at("visibility"), truth).rmse;
}

double errorUnderSlab(const SlabStage& stage, const SettingList& settings) {
    const Scene scene = stage.scene();
    const Rendered frame =
        render({.scene = sceneFile(scene), .size = kSmall, .settings = settings});
    const GroundPixels pixels(scene, kSmall);
    const Image truth = pixels.image([&](dvec3 p) { return stage.visibility(p); });
    return compareVisibility(frame.at("visibility"), truth, &pixels.mask).rmse;
}

}  // namespace penumbra
