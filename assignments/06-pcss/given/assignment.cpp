// Soft shadows of a square light from one shadow map. [Reeves 1987, Fernando 2005]
//
//   light      depth from the light's centre
//   min        pyramid=on: the smallest depth around each place in the map, at low resolution
//   surfaces   what the camera sees, its light without shadow, and its place in the light's map
//   shadow     one triangle over the picture: visibility of each pixel's receiver
//
// Surfaces come before shadow so that softVisibility() runs once a pixel, whatever lies over what.
#include "app/assignment.h"
#include "min_depth.h"
#include "render/area_shadow_map.h"
#include "render/deferred.h"
#include "render/matrix_image.h"
#include "render/passes.h"
#include "scene/gallery.h"
#include "soft_shadow.h"

namespace penumbra {

namespace {

Texture target(glm::ivec2 size, GLenum format, const char* label) {
    return Texture({.size = size, .format = format, .label = label});
}

struct Inspection {
    explicit Inspection(glm::ivec2 size)
        : blockerDepth(target(size, GL_R32F, "blocker depth")),
          penumbraWidth(target(size, GL_R32F, "penumbra width")),
          search(target(size, GL_RGBA32F, "search")),
          framebuffer({.colors = {&blockerDepth, &penumbraWidth, &search}}) {}
    Texture blockerDepth, penumbraWidth, search;
    Framebuffer framebuffer;
};

class Pcss final : public Assignment {
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
        UniformBuffer<SoftShadowBlock> dials;
    };

    void prepare(const View& view);
    void bindBlocks(const Program& program) const;
    void surfacePass(const View& view);
    void screenPass(const Program& program, const Framebuffer& framebuffer) const;

    std::unique_ptr<Gl> gl_;
    std::unique_ptr<AreaShadowMap> map_;
    std::unique_ptr<Inspection> inspection_;
    MinDepth minDepth_;
};

void Pcss::settings(Settings& s) {
    s.choice({.name = "method",
              .help = "PCSS; one filter width everywhere; depths averaged first; Task 9",
              .value = 0,
              .choices = {"pcss", "pcf", "filtered_depth", "backprojection"}});
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
    s.integer({.name = "search_samples",
               .help = "of the blocker search, along each side",
               .minimum = 1,
               .maximum = 32,
               .value = 4});
    s.integer({.name = "filter_samples",
               .help = "of the filter, along each side",
               .minimum = 1,
               .maximum = 64,
               .value = 8});
    s.choice({.name = "kernel",
              .help = "samples in rows and columns, your sheared grid, your disk",
              .value = 1,
              .choices = {"grid", "sheared", "disk"}});
    s.number({.name = "pcf_radius",
              .help = "method=pcf, filtered_depth: half the filter's width",
              .unit = "texels",
              .minimum = 0.5,
              .maximum = 64,
              .value = 4});
    s.number({.name = "constant_bias",
              .help = "a blocker is nearer than the receiver by at least so much",
              .unit = "texels",
              .minimum = 0,
              .maximum = 16,
              .value = 1});
    s.toggle({.name = "receiver_plane",
              .help = "compare with the receiver's plane at each texel's centre",
              .value = 1});
    s.toggle({.name = "horizon",
              .help = "light points below the receiver's plane are dark",
              .value = 1});
    s.toggle(
        {.name = "pyramid", .help = "nearest depth around narrows the blocker search", .value = 1});
}

void Pcss::prepare(const View& view) {
    if (!gl_) gl_ = std::make_unique<Gl>();
    const int size = 256 << view.settings.index("map_size");
    if (!map_ || map_->size() != size) map_ = std::make_unique<AreaShadowMap>(size);
    if (gl_->deferred.prepare(view)) inspection_.reset();
    map_->fit(view, view.settings["constant_bias"]);
    SoftShadowBlock dials = softShadowBlock(view.settings, size);
    if (view.settings.on("pyramid"))
        dials.minTexelUv = minDepth_.prepare(size, map_->values().widthScaleUv);
    gl_->dials.upload(dials);
}

void Pcss::bindBlocks(const Program& program) const {
    gl_->deferred.bindBlocks(program);
    map_->bindBlock(program);
    gl_->dials.bind(program, "SoftShadow", 3);
}

void Pcss::surfacePass(const View& view) {
    const Program& program = view.shaders.program("receivers.vert", "receivers.frag");
    bindBlocks(program);
    gl_->deferred.receivers().render(view, program);
}

void Pcss::screenPass(const Program& program, const Framebuffer& framebuffer) const {
    bindBlocks(program);
    map_->bind(program, 0);
    gl_->deferred.receivers().bind(program, 1);
    if (minDepth_.image()) program.texture("minDepth", 5, *minDepth_.image());
    gl_->deferred.screen().draw(program, framebuffer);
    map_->release(0);
}

void Pcss::render(const View& view, Frame& frame) {
    prepare(view);
    const auto timed = [&](const char* name, auto&& pass) {
        auto timing = frame.time(name);
        pass();
    };
    timed("light", [&] { map_->render(view); });
    const bool pyramid = view.settings.on("pyramid");
    if (pyramid)
        timed("min",
              [&] { minDepth_.render(view.shaders, *map_, gl_->deferred.screen(), gl_->dials); });
    timed("surfaces", [&] { surfacePass(view); });
    const std::vector<std::string> chunks = chunksFor(view.settings);
    if (frame.wants("color") || frame.wants("visibility"))
        timed("shadow", [&] {
            screenPass(view.shaders.program("screen.vert", "shadow_pass.frag", chunks),
                       gl_->deferred.shaded().framebuffer);
        });
    if (frame.wants("blocker_depth") || frame.wants("penumbra_width") || frame.wants("search")) {
        if (!inspection_) inspection_ = std::make_unique<Inspection>(view.size);
        screenPass(view.shaders.program("screen.vert", "inspect.frag", chunks),
                   inspection_->framebuffer);
        frame.output("blocker_depth", inspection_->blockerDepth);
        frame.output("penumbra_width", inspection_->penumbraWidth);
        frame.output("search", inspection_->search);
    }
    frame.output("shadow_map", map_->depth());
    gl_->deferred.output(frame);
    if (frame.wants("min_depth") && pyramid) frame.output("min_depth", *minDepth_.image());
    frame.output("light_clip_from_world", matrixImage(map_->values().clipFromWorld));
}

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<Pcss>(); }

}  // namespace penumbra
