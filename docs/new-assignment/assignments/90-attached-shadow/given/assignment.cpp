// Attached shadow alone: one forward pass.
#include "app/assignment.h"
#include "render/passes.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

class AttachedShadow final : public Assignment {
public:
    Scene scene() const override { return loadScene("boxes"); }

    void settings(Settings&) override {}  // no dials

    void render(const View& view, Frame& frame) override {
        if (!gl_) gl_ = std::make_unique<Gl>();
        if (!targets_ || !targets_->fits(view.size, frame))
            targets_ = std::make_unique<CameraTargets>(view.size, frame);
        gl_->camera.upload(cameraBlock(view.camera, view.size));
        gl_->light.upload(lightBlock(view.light));
        {
            auto timing = frame.time("camera");
            const Program& shade = view.shaders.program("surface.vert", "camera_pass.frag");
            gl_->camera.bind(shade, "Camera", 0);
            gl_->light.bind(shade, "Light", 1);
            beginOpaquePass();
            targets_->clear();
            view.gpuScene.draw(shade);
        }
        if (frame.wants("color")) frame.output("color", targets_->color);
        if (frame.wants("visibility")) frame.output("visibility", targets_->visibility);
        frame.output("depth", targets_->depth);
    }

private:
    struct Gl {  // made when a context is current
        UniformBuffer<CameraBlock> camera;
        UniformBuffer<LightBlock> light;
    };
    std::unique_ptr<Gl> gl_;
    std::unique_ptr<CameraTargets> targets_;
};

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<AttachedShadow>(); }

}  // namespace penumbra
