// Fails: Task4ZFail.TheProjectionHasNoFarPlane · -n stands where -2n belongs
#include <cmath>

#include "shadow_volumes.h"

namespace penumbra {

glm::mat4 infiniteProjection(float verticalFov, float aspect, float nearPlane) {
    const float scale = 1.0f / std::tan(0.5f * verticalFov);
    glm::mat4 clipFromView(0.0f);  // [column][row]
    clipFromView[0][0] = scale / aspect;
    clipFromView[1][1] = scale;
    clipFromView[2][2] = -1.0f;
    clipFromView[2][3] = -1.0f;
    clipFromView[3][2] = -nearPlane;
    return clipFromView;
}

}  // namespace penumbra
