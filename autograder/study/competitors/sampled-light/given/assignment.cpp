// The brute force that every soft-shadow technique is measured against: a hard shadow map from
// each of many points of the light. [Heckbert and Herf 1997]
#include "app/assignment.h"
#include "render/sampled_light.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

constexpr int kMaps[] = {1, 4, 16, 64, 256};

class SampledLightShadows final : public Assignment {
public:
    Scene scene() const override { return loadScene("boxes"); }
    LightModel lightModel() const override { return LightModel::square; }

    void settings(Settings& s) override {
        s.choice({.name = "maps",
                  .help = "points of the light, each with its own map",
                  .value = 2,
                  .choices = {"1", "4", "16", "64", "256"}});
        s.choice({.name = "map_size",
                  .help = "texels along each side of a map",
                  .unit = "texels",
                  .value = 1,
                  .choices = {"256", "512", "1024", "2048"}});
        s.number({.name = "constant_bias",
                  .help = "a blocker is nearer than the receiver by at least so much",
                  .unit = "texels",
                  .minimum = 0,
                  .maximum = 16,
                  .value = 1});
    }

    void render(const View& view, Frame& frame) override {
        prepare(view);
        {
            auto timing = frame.time("surfaces");
            const Program& program = view.shaders.program("surface.vert", "world_receivers.frag");
            deferred_->bindBlocks(program);
            deferred_->receivers().render(view, program);
        }
        {
            auto timing = frame.time("maps");
            light_->render(view, deferred_->receivers());
        }
        if (frame.wants("color")) {
            auto timing = frame.time("shade");
            const Program& program = view.shaders.program("screen.vert", "apply_visibility.frag");
            deferred_->receivers().bind(program, 0);
            program.texture("visibilityImage", 4, light_->visibility());
            deferred_->screen().draw(program, deferred_->shaded().framebuffer);
        }
        frame.output("color", deferred_->shaded().color);
        frame.output("visibility", light_->visibility());
        frame.output("depth", deferred_->receivers().depth);
    }

private:
    void prepare(const View& view) {
        if (!deferred_) deferred_ = std::make_unique<DeferredFrame>();
        const SampledLightDescription wanted = {.maps = kMaps[view.settings.index("maps")],
                                                .mapSize = 256 << view.settings.index("map_size"),
                                                .biasTexels = view.settings["constant_bias"]};
        if (!light_ || wanted != made_) light_ = std::make_unique<SampledLight>(wanted);
        made_ = wanted;
        deferred_->prepare(view);
    }

    std::unique_ptr<DeferredFrame> deferred_;
    SampledLightDescription made_;
    std::unique_ptr<SampledLight> light_;
};

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<SampledLightShadows>(); }

}  // namespace penumbra
