// The casters as the light sees them: the view that the shadow texture is drawn in.
//
//   mat4 textureClipFromWorld = shadowTextureView(casters, light);
#pragma once

#include "scene/scene.h"

namespace penumbra {

// From the light towards the middle of the casters, as narrow as they allow (tangents up to 6), so
// that they touch the border. Beside it nothing casts a shadow: receivers need not be inside. w is
// the distance along the axis, 1 for a directional light. There are no near and far planes: z is 0,
// since nothing compares depths.
glm::mat4 shadowTextureView(const Scene& casters, const Light& light);

}  // namespace penumbra
