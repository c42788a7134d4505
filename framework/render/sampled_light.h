// Brute force: a hard shadow map from each of many points of the light, averaged. [Heckbert and
// Herf 1997] Converges to the square's visibility without tracing a ray: a second truth, whose
// errors (texels, bias) have nothing in common with the first one's.
//
//   SampledLight light({.maps = 64, .mapSize = 1024});
//   receivers.render(view, view.shaders.program("surface.vert", "world_receivers.frag"));
//   light.render(view, receivers);
//   frame.output("visibility", light.visibility());
#pragma once

#include "render/area_shadow_map.h"
#include "render/deferred.h"

namespace penumbra {

struct SampledLightDescription {
    int maps = 64;            // light points; rounded to a square number
    int mapSize = 1024;       // texels along each side
    float biasTexels = 1.0f;  // constant bias, widths of a texel
    bool operator==(const SampledLightDescription&) const = default;
};

class SampledLight {
public:
    explicit SampledLight(const SampledLightDescription& description);

    // `receivers` as world_receivers.frag has drawn them.
    void render(const View& view, const ReceiverImages& receivers);
    // One channel, the receivers' size; lives until the next render().
    const Texture& visibility() const { return visibility_; }

private:
    SampledLightDescription description_;
    AreaShadowMap map_;
    Texture visibility_;
    Framebuffer framebuffer_;
    UniformBuffer<LightBlock> light_;
    ScreenTriangle screen_;
};

// Point i of n x n in [-1/2, 1/2]²: each of the n² rows and columns holds one. [Shirley 1991]
glm::vec2 lightPoint(int i, int n);

}  // namespace penumbra
