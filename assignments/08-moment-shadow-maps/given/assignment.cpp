// Soft shadows of a square light from four moments of its shadow map. [Peters and Klein 2015,
// Peters et al. 2016]
//
//   light      depth from the light's centre
//   moments    each texel's depth as four moments
//   sums       of the moments, so that four look-ups give their mean over any box
//   surfaces   what the camera sees, its light without shadow, and its place in the light's map
//   shadow     one triangle over the picture: visibility of each pixel's receiver
#include "app/assignment.h"
#include "moment_map.h"
#include "moment_shadow.h"
#include "render/area_shadow_map.h"
#include "render/deferred.h"
#include "render/matrix_image.h"
#include "render/passes.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

Texture target(glm::ivec2 size, GLenum format, const char* label) {
    return Texture({.size = size, .format = format, .label = label});
}

struct Inspection {
    explicit Inspection(glm::ivec2 size)
        : blockerDepth(target(size, GL_R32F, "blocker depth")),
          blockerShare(target(size, GL_R32F, "blocker share")),
          penumbraWidth(target(size, GL_R32F, "penumbra width")),
          boxMoments(target(size, GL_RGBA32F, "box moments")),
          framebuffer({.colors = {&blockerDepth, &blockerShare, &penumbraWidth, &boxMoments}}) {}
    Texture blockerDepth, blockerShare, penumbraWidth, boxMoments;
    Framebuffer framebuffer;
};

class MomentShadowMaps final : public Assignment {
public:
    Scene scene() const override { return loadScene("boxes"); }
    LightModel lightModel() const override { return LightModel::square; }
    void settings(Settings& settings) override;
    void arrange(const Settings& settings, Scene& scene) const override {
        for (Light& light : scene.lights) light.width *= settings["light_size"];
    }
    void render(const View& view, Frame& frame) override;

private:
    struct Gl {  // made when a context is current
        DeferredFrame deferred;
        UniformBuffer<MomentShadowBlock> dials;
    };

    void prepare(const View& view);
    void bindBlocks(const Program& program) const;
    void surfacePass(const View& view);
    void screenPass(const Program& program, const Framebuffer& framebuffer) const;
    void inspect(const View& view, Frame& frame);

    std::unique_ptr<Gl> gl_;
    std::unique_ptr<AreaShadowMap> map_;
    std::unique_ptr<Inspection> inspection_;
    MomentMap moments_;
};

void MomentShadowMaps::settings(Settings& s) {
    s.choice({.name = "method",
              .help = "depths may lie anywhere; or are known to lie in [0,1]",
              .value = 0,
              .choices = {"hamburger", "hausdorff"}});
    s.choice({.name = "filter",
              .help = "as wide as the penumbra, or equally wide everywhere",
              .value = 0,
              .choices = {"soft", "fixed"}});
    s.number({.name = "filter_radius",
              .help = "filter=fixed: half the box's width",
              .unit = "texels",
              .minimum = 0.5,
              .maximum = 64,
              .value = 4});
    s.integer({.name = "refinements",
               .help = "filter=soft: blocker searches in a smaller window, after the first",
               .minimum = 0,
               .maximum = 4,
               .value = 2});
    s.integer({.name = "cells",
               .help = "filter=soft: boxes along each side of the filter",
               .minimum = 1,
               .maximum = 8,
               .value = 1});
    s.choice({.name = "storage",
              .help = "of a moment: 32-bit float, 16 bits as you code them, 16 bits as it is",
              .value = 0,
              .choices = {"float32", "quantized16", "raw16"}});
    s.choice({.name = "prefilter",
              .help = "the table of sums: in float32, or in integers modulo 2^32",
              .value = 1,
              .choices = {"sat_cpu", "sat_cpu_integer"}});
    s.choice({.name = "map_size",
              .help = "texels along each side of the shadow map",
              .unit = "texels",
              .value = 1,
              .choices = {"256", "512", "1024", "2048"}});
    s.number({.name = "light_size",
              .help = "the light's width, times this; truth follows",
              .minimum = 0.001,
              .maximum = 4,
              .value = 1});
    s.choice({.name = "moment_bias",
              .help = "how far the moments move towards those of -1, 0, 1",
              .value = 3,
              .choices = {"0", "3e-7", "3e-6", "3e-5", "6e-5", "3e-4", "1e-3", "3e-3", "1e-2"}});
    s.number({.name = "constant_bias",
              .help = "a blocker is nearer than the receiver by at least so much",
              .unit = "texels",
              .minimum = 0,
              .maximum = 16,
              .value = 0.5});
    s.toggle({.name = "receiver_plane",
              .help = "compare with the nearest depth of the receiver's plane in the window",
              .value = 1});
    s.toggle({.name = "horizon",
              .help = "light points below the receiver's plane are dark",
              .value = 1});
}

void MomentShadowMaps::prepare(const View& view) {
    if (!gl_) gl_ = std::make_unique<Gl>();
    const int size = 256 << view.settings.index("map_size");
    if (!map_ || map_->size() != size) map_ = std::make_unique<AreaShadowMap>(size);
    if (gl_->deferred.prepare(view)) inspection_.reset();
    map_->fit(view, view.settings["constant_bias"]);
    MomentShadowBlock dials = momentShadowBlock(view.settings, size);
    dials.unitsPerInteger = moments_.prepare(view.settings, *map_);
    gl_->dials.upload(dials);
}

void MomentShadowMaps::bindBlocks(const Program& program) const {
    gl_->deferred.bindBlocks(program);
    map_->bindBlock(program);
    gl_->dials.bind(program, "MomentShadow", 3);
}

void MomentShadowMaps::surfacePass(const View& view) {
    const Program& program = view.shaders.program("receivers.vert", "receivers.frag");
    bindBlocks(program);
    gl_->deferred.receivers().render(view, program);
}

void MomentShadowMaps::screenPass(const Program& program, const Framebuffer& framebuffer) const {
    bindBlocks(program);
    program.use();
    program.texture("sums", 0, moments_.sums());
    gl_->deferred.receivers().bind(program, 1);
    gl_->deferred.screen().draw(program, framebuffer);
}

void MomentShadowMaps::inspect(const View& view, Frame& frame) {
    if (!inspection_) inspection_ = std::make_unique<Inspection>(view.size);
    screenPass(view.shaders.program("screen.vert", "inspect.frag", chunksFor(view.settings)),
               inspection_->framebuffer);
    frame.output("blocker_depth", inspection_->blockerDepth);
    frame.output("blocker_share", inspection_->blockerShare);
    frame.output("penumbra_width", inspection_->penumbraWidth);
    frame.output("box_moments", inspection_->boxMoments);
}

void MomentShadowMaps::render(const View& view, Frame& frame) {
    prepare(view);
    const auto timed = [&](const char* name, auto&& pass) {
        auto timing = frame.time(name);
        pass();
    };
    timed("light", [&] { map_->render(view); });
    timed("moments",
          [&] { moments_.render(view.shaders, view.settings, *map_, gl_->deferred.screen()); });
    timed("sums", [&] { moments_.sum(); });
    timed("surfaces", [&] { surfacePass(view); });
    if (frame.wants("color") || frame.wants("visibility"))
        timed("shadow", [&] {
            screenPass(
                view.shaders.program("screen.vert", "shadow_pass.frag", chunksFor(view.settings)),
                gl_->deferred.shaded().framebuffer);
        });
    if (frame.wants("blocker_depth") || frame.wants("blocker_share") ||
        frame.wants("penumbra_width") || frame.wants("box_moments"))
        inspect(view, frame);
    frame.output("shadow_map", map_->depth());
    frame.output("moments", moments_.stored());
    gl_->deferred.output(frame);
    frame.output("light_clip_from_world", matrixImage(map_->values().clipFromWorld));
}

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<MomentShadowMaps>(); }

}  // namespace penumbra
