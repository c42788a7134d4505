// The light's view: your two functions fed with what the camera sees and what can stand in the
// light's way.
#pragma once

#include "render/frame.h"
#include "shadow_map.h"

namespace penumbra {

struct LightFrustum {
    LightWindow window;
    DepthRange depth;
};

// As the settings fit_window and fit_depth ask; what is not fitted sees the whole scene.
LightFrustum lightFrustum(const View& view);

glm::mat4 clipFromView(const LightFrustum& frustum);

}  // namespace penumbra
