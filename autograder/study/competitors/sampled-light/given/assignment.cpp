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
            gl_->camera.bind(program, "Camera", 0);
            gl_->light.bind(program, "Light", 1);
            receivers_->render(view, program);
        }
        {
            auto timing = frame.time("maps");
            light_->render(view, *receivers_);
        }
        if (frame.wants("color")) {
            auto timing = frame.time("shade");
            const Program& program = view.shaders.program("screen.vert", "apply_visibility.frag");
            receivers_->bind(program, 0);
            program.texture("visibilityImage", 4, light_->visibility());
            gl_->screen.draw(program, shaded_->framebuffer);
        }
        frame.output("color", shaded_->color);
        frame.output("visibility", light_->visibility());
        frame.output("depth", receivers_->depth);
    }

private:
    struct Gl {  // made when a context is current
        UniformBuffer<CameraBlock> camera;
        UniformBuffer<LightBlock> light;
        ScreenTriangle screen;
    };

    void prepare(const View& view) {
        if (!gl_) gl_ = std::make_unique<Gl>();
        const SampledLightDescription wanted = {.maps = kMaps[view.settings.index("maps")],
                                                .mapSize = 256 << view.settings.index("map_size"),
                                                .biasTexels = view.settings["constant_bias"]};
        if (!light_ || wanted != made_) light_ = std::make_unique<SampledLight>(wanted);
        made_ = wanted;
        if (!receivers_ || receivers_->depth.size() != view.size) {
            receivers_ = std::make_unique<ReceiverImages>(view.size);
            shaded_ = std::make_unique<ShadedImages>(view.size);
        }
        gl_->camera.upload(cameraBlock(view.camera, view.size));
        gl_->light.upload(lightBlock(view.light));
    }

    std::unique_ptr<Gl> gl_;
    SampledLightDescription made_;
    std::unique_ptr<SampledLight> light_;
    std::unique_ptr<ReceiverImages> receivers_;
    std::unique_ptr<ShadedImages> shaded_;
};

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<SampledLightShadows>(); }

}  // namespace penumbra
