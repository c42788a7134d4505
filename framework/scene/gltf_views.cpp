#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/gltf.h"
#include "scene/gltf_parts.h"

namespace penumbra {

namespace {

constexpr float kLightWidthOverDiagonal = 0.1f;
constexpr float kFov = 0.6f;

struct Axes {
    glm::dvec3 right, up, backward;  // orthonormal, right-handed; a node looks along -backward
};

// The node's axes without scale, shear or mirroring; -Z is kept first, then +Y.
Axes orthonormalAxes(const GltfValue& node, const glm::dmat4& worldFromNode) {
    const glm::dvec3 z(worldFromNode[2]), y(worldFromNode[1]);
    const glm::dvec3 right = glm::cross(y, z);
    if (!(glm::length(right) > 1e-12 * glm::length(y) * glm::length(z)) ||
        glm::length(right) == 0.0)
        node.fail("carries a camera or light, but its transform is flat");
    Axes axes;
    axes.backward = glm::normalize(z);
    axes.right = glm::normalize(right);
    axes.up = glm::cross(axes.backward, axes.right);
    return axes;
}

// Axes of a node that was saved from floats come back bit for bit.
glm::vec3 kept(glm::dvec3 stored, glm::dvec3 computed) {
    return glm::distance(stored, computed) < 1e-6 ? glm::vec3(stored) : glm::vec3(computed);
}

struct DepthRange {
    double nearest = 1e30, farthest = -1e30;
};

DepthRange depthRange(const Box& box, glm::dvec3 eye, glm::dvec3 forward) {
    DepthRange range;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? box.upper.x : box.lower.x,
                           corner & 2 ? box.upper.y : box.lower.y,
                           corner & 4 ? box.upper.z : box.lower.z);
        const double depth = glm::dot(p - eye, forward);
        range.nearest = std::min(range.nearest, depth);
        range.farthest = std::max(range.farthest, depth);
    }
    return range;
}

// Planes just outside the scene, near at least a 1000th of far.
void fitPlanes(Camera& camera, const Box& box) {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    const DepthRange range = depthRange(box, camera.eye, forward);
    const double smallest = 1e-3 * std::max(1e-3, double(box.diagonal()));
    camera.farPlane = float(std::max(1.05 * range.farthest, 2.0 * smallest));
    camera.nearPlane = float(std::max({0.9 * range.nearest, smallest, 1e-3 * camera.farPlane}));
    camera.nearPlane = std::min(camera.nearPlane, 0.5f * camera.farPlane);
}

void readPerspective(const GltfValue& perspective, Camera& camera, const Box& box) {
    const GltfValue fov = perspective.at("yfov");
    if (!(fov.number() > 1e-3 && fov.number() < 3.14)) fov.fail("is no angle between 0 and pi");
    camera.verticalFov = float(fov.number());
    const GltfValue near = perspective.at("znear");
    if (!(near.number() > 1e-9 && near.number() < 1e9)) near.fail("is not a distance above 0");
    fitPlanes(camera, box);  // for far, which a file may leave infinite
    camera.nearPlane = float(near.number());
    if (const auto far = perspective.find("zfar")) {
        if (!(far->number() > near.number() && far->number() < 1e12))
            far->fail("is not a distance beyond znear");
        camera.farPlane = float(far->number());
    }
    if (camera.farPlane <= camera.nearPlane) camera.farPlane = 1e3f * camera.nearPlane;
}

// A pinhole camera cannot see in parallel: one far off with a narrow angle comes near, and shows
// the same extent at the middle of the scene.
void readOrthographic(const GltfValue& orthographic, Camera& camera, const Box& box) {
    const GltfValue height = orthographic.at("ymag");
    const double half = std::abs(height.number());
    if (!(half > 1e-6 && half < 1e9)) height.fail("is not a size above 0");
    camera.verticalFov = 0.2f;
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const float middle = glm::dot(box.center() - camera.eye, forward);
    const float distance = float(half / std::tan(0.5 * double(camera.verticalFov)));
    camera.eye += (middle - distance) * forward;
    camera.target = camera.eye + distance * forward;
    fitPlanes(camera, box);
}

// All of the box lies in front of the light's plane, on the side that it shines to.
bool facesAllOf(const Light& light, const Box& box) {
    return depthRange(box, light.center, light.forward()).nearest > 0.0;
}

}  // namespace

std::optional<Camera> readCamera(const GltfFile& file, const GltfNode& node, const Box& box) {
    const GltfValue value = file.item("nodes", node.index);
    const auto reference = value.find("camera");
    if (!reference) return std::nullopt;
    const GltfValue cameras = file.list("cameras");
    const GltfValue source = cameras.item(reference->index(cameras.size()));

    const Axes axes = orthonormalAxes(value, node.worldFromNode);
    Camera camera;
    camera.eye = glm::vec3(node.worldFromNode[3]);
    camera.up = glm::vec3(axes.up);
    // glTF has no target: the point of the view axis beside the middle of the scene.
    const double beside = glm::dot(glm::dvec3(box.center() - camera.eye), -axes.backward);
    const double distance = std::max(beside, 0.1 * std::max(double(box.diagonal()), 1e-3));
    camera.target = glm::vec3(glm::dvec3(camera.eye) - distance * axes.backward);
    if (!(glm::length(camera.target - camera.eye) > 0.0f) || !(glm::length(camera.eye) < 1e9f))
        value.fail("places its camera too far away");

    const std::string type = source.at("type").text();
    if (type == "perspective")
        readPerspective(source.at("perspective"), camera, box);
    else if (type == "orthographic")
        readOrthographic(source.at("orthographic"), camera, box);
    else
        source.fail("has type " + type + ", neither perspective nor orthographic");
    return camera;
}

std::optional<Light> readLight(const GltfFile& file, const GltfNode& node, const Box& box) {
    const GltfValue value = file.item("nodes", node.index);
    const auto extensions = value.find("extensions");
    const auto reference = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
    if (!reference) return std::nullopt;
    const GltfValue lights = file.root().at("extensions").at("KHR_lights_punctual").at("lights");
    const GltfValue source = lights.item(reference->at("light").index(lights.size()));

    const std::string type = source.at("type").text();
    if (type != "point" && type != "spot" && type != "directional")
        source.fail("has type " + type + ", not point, spot or directional");
    std::optional<double> width;
    if (const auto extras = source.find("extras"); extras && extras->isObject())
        if (const auto given = extras->find("width")) {
            width = given->number();
            if (!(*width > 1e-6 && *width < 1e9)) given->fail("is not a width above 0");
        }

    const Axes axes = orthonormalAxes(value, node.worldFromNode);
    const float diagonal = std::max(box.diagonal(), 1e-3f);
    Light light;
    light.center = glm::vec3(node.worldFromNode[3]);
    light.width = width ? float(*width) : kLightWidthOverDiagonal * diagonal;
    light.right = kept(glm::dvec3(node.worldFromNode[0]), axes.right);
    light.up = kept(glm::dvec3(node.worldFromNode[1]), axes.up);
    if (!(glm::length(light.center) < 1e9f)) value.fail("places its light too far away");
    light.directional = type == "directional";
    // A directional light's node may stand anywhere. Techniques that know no parallel rays need it
    // far beyond the scene; a file that speaks our convention may have chosen the place itself.
    if (light.directional && !(width && facesAllOf(light, box)))
        light.center = box.center() + 2.0f * diagonal * glm::vec3(axes.backward);
    if (type == "point" && !width && glm::distance(light.center, box.center()) > 1e-3f * diagonal)
        light = Light::lookingAt(light.center, box.center(), light.width);  // a point faces nowhere

    if (const auto range = source.find("range"); range && !light.directional) {
        light.range = float(range->number());
        if (!(light.range > 0.0f)) range->fail("is not a range above 0");
    }

    double color[3] = {1, 1, 1};
    if (const auto given = source.find("color")) given->numbers(color, 3);
    // Shading here ignores distance, so candela of other programs would only overexpose. A file
    // with a width speaks our convention: radiance = colour x intensity.
    const double scale = width ? source.numberOr("intensity", 1.0) : 1.0;
    light.color = glm::vec3(color[0] * scale, color[1] * scale, color[2] * scale);
    for (int k = 0; k < 3; ++k)
        if (!(light.color[k] >= 0.0f && light.color[k] < 1e9f)) source.fail("has a bad color");
    return light;
}

Camera sensibleCamera(const Box& box) {
    Camera camera;
    camera.verticalFov = kFov;
    const float radius = std::max(0.5f * box.diagonal(), 1e-3f);
    const glm::vec3 towards = glm::normalize(glm::vec3(0.45f, 0.55f, 0.75f));
    camera.target = box.center();
    camera.eye = camera.target + radius / std::sin(0.5f * kFov) * towards;
    fitPlanes(camera, box);
    return camera;
}

Light sensibleLight(const Box& box) {
    const float diagonal = std::max(box.diagonal(), 1e-3f);
    const glm::vec3 towards = glm::normalize(glm::vec3(-0.5f, 1.0f, 0.25f));
    return Light::lookingAt(box.center() + 1.5f * diagonal * towards, box.center(),
                            kLightWidthOverDiagonal * diagonal);
}

}  // namespace penumbra
