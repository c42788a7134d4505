// The moments of a shadow map, and their sums.
//
//   moments.prepare(settings, map);        // sizes; returns what an integer of the table stands
//   for moments.render(shaders, settings, map, screen); moments.sum(); program.texture("sums", 5,
//   moments.sums());
#pragma once

#include <memory>

#include "gl/framebuffer.h"
#include "render/area_shadow_map.h"
#include "render/deferred.h"
#include "render/summed_area_table.h"

namespace penumbra {

class MomentMap {
public:
    // Returns what 1 in the table stands for.
    float prepare(const Settings& settings, const AreaShadowMap& map);
    void render(ShaderLibrary& shaders, const Settings& settings, const AreaShadowMap& map,
                const ScreenTriangle& screen) const;
    void sum() { table_->sum(image_->texture); }

    const Texture& stored() const { return image_->texture; }
    const Texture& sums() const { return table_->texture(); }

private:
    struct Image {
        Image(int size, GLenum format)
            : texture({.size = glm::ivec2(size), .format = format, .label = "moments"}),
              framebuffer({.colors = {&texture}}) {}
        Texture texture;
        Framebuffer framebuffer;
    };
    std::unique_ptr<Image> image_;
    std::unique_ptr<SummedAreaTable> table_;
    float integersPerUnit_ = -1;
};

}  // namespace penumbra
