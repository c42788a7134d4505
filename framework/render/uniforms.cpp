#include "render/uniforms.h"

namespace penumbra {

CameraBlock cameraBlock(const Camera& camera, glm::ivec2 size) {
    const glm::mat4 view = camera.viewFromWorld();
    return {.clipFromWorld = camera.clipFromView(float(size.x) / float(size.y)) * view,
            .viewFromWorld = view,
            .eye = camera.eye};
}

LightBlock lightBlock(const Light& light) {
    return {.viewFromWorld = light.viewFromWorld(),
            .center = light.center,
            .width = light.width,
            .right = light.right,
            .up = light.up,
            .forward = light.forward(),
            .color = light.color,
            .inverseRange = light.directional ? 0.0f : 1.0f / light.range,
            .position = light.position()};
}

}  // namespace penumbra
