// The casters as the light sees them: the view that the shadow texture is drawn in.
//
//   mat4 textureClipFromWorld = shadowTextureView(casters, light, 1024);
#pragma once

#include "scene/scene.h"

namespace penumbra {

// From the light towards the middle of the casters, as narrow as they allow (tangents up to 6) and
// one texel of background around them. Beside the window nothing casts a shadow, so receivers need
// not be inside. w is the distance along the axis, 1 for a directional light. There are no near and
// far planes: z is 0, since nothing compares depths.
glm::mat4 shadowTextureView(const Scene& casters, const Light& light, int textureSize);

}  // namespace penumbra
