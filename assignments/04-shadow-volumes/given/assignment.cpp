// Crow's shadow volumes, counted in the stencil buffer, for any number of lights.
// [Crow 1977], [Heidmann 1991], [Everitt & Kilgard 2002]
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "app/assignment.h"
#include "core/error.h"
#include "count_colors.h"
#include "render/matrix_image.h"
#include "scene/gallery.h"
#include "value_rows.h"
#include "volume_pass.h"

namespace penumbra {

namespace {

constexpr int kMostLights = 16;

glm::mat4 checkedProjection(const Camera& camera, glm::ivec2 size) {
    const glm::mat4 m =
        infiniteProjection(camera.verticalFov, float(size.x) / float(size.y), camera.nearPlane);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(m[column][row]))
                throw Error("infiniteProjection() is not finite", "projection.cpp",
                            "look for a division by zero");
    return m;
}

class ShadowVolumes final : public Assignment {
public:
    Scene scene() const override { return loadScene("courtyard"); }
    void settings(Settings& settings) override;
    void arrange(const Settings& settings, Scene& scene) const override;
    void render(const View& view, Frame& frame) override;
    bool takesDirectionalLights() const override { return true; }

private:
    struct Gl {  // made when a context is current
        UniformBuffer<CameraBlock> camera;
        UniformBuffer<LightBlock> light;
        VolumePass volumes;
    };

    void prepare(const View& view, const Frame& frame);
    void firstPass(const View& view);
    void oneLight(const View& view, Frame& frame, std::size_t index);
    void lightPass(const View& view, std::size_t index);
    void showCounts(const View& view);
    void bindBlocks(const Program& program) const;
    VolumePass::BindBlocks binder() const {
        return [this](const Program& program) { bindBlocks(program); };
    }

    std::unique_ptr<Gl> gl_;
    std::unique_ptr<CameraTargets> targets_;
    Texture countColors_;
    glm::mat4 clipFromView_{1.0f};
    std::vector<Light> lights_;  // that shine in this frame
    LightPass addLight_;
    Image counts_;  // of light 0, if someone asks
};

void ShadowVolumes::settings(Settings& s) {
    s.choice({.name = "method",
              .help = "count what lies behind the surface, or what lies before it",
              .choices = {"zfail", "zpass"}});
    s.choice({.name = "volumes",
              .help = "one volume for each mesh, or one for each triangle",
              .choices = {"silhouette", "per_triangle"}});
    s.choice({.name = "counter",
              .help = "8 bits that wrap, or a float target",
              .choices = {"stencil", "float"}});
    s.choice({.name = "show",
              .help = "the picture; over it the key light's silhouettes, volumes or counts",
              .choices = {"picture", "silhouettes", "volumes", "counts"}});
    s.toggle({.name = "shadows", .help = "off: the same lights without shadows", .value = 1});
    s.integer({.name = "lights",
               .help = "how many of the scene's lights shine",
               .minimum = 1,
               .maximum = kMostLights,
               .value = kMostLights});
    Setting time{.name = "time",
                 .help = "moves the lights on small circles",
                 .unit = "seconds",
                 .minimum = 0,
                 .maximum = 60,
                 .value = 0};
    time.plays = true;
    s.number(time);
    s.toggle(
        {.name = "cull_range", .help = "skip casters that the light does not reach", .value = 1});
    s.toggle({.name = "cull_view", .help = "skip volumes that the view cannot hold", .value = 1});
    s.toggle({.name = "cull_empty", .help = "skip volumes that hold no receiver", .value = 1});
    s.toggle({.name = "scissor",
              .help = "draw only where the light's range reaches on the screen",
              .value = 1});
    s.toggle(
        {.name = "cache", .help = "keep silhouettes while light and casters rest", .value = 1});
}

// Circles through where each light stands, so that time 0 leaves the scene as it is; after a minute
// all have come round.
void ShadowVolumes::arrange(const Settings& settings, Scene& scene) const {
    const float time = settings["time"];
    if (time == 0) return;
    const float radius = 0.04f * bounds(scene).diagonal();
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        Light& light = scene.lights[i];
        const float turns = float(5 + i % 5) / 60.0f, start = 2.4f * float(i);  // golden angle
        const float angle = start + glm::two_pi<float>() * turns * time;
        light.center += radius * glm::vec3(std::cos(angle) - std::cos(start), 0.0f,
                                           std::sin(angle) - std::sin(start));
    }
}

void ShadowVolumes::prepare(const View& view, const Frame& frame) {
    if (!gl_) gl_ = std::make_unique<Gl>();
    if (!targets_ || !targets_->fits(view.size, frame))
        targets_ = std::make_unique<CameraTargets>(view.size, frame, GL_DEPTH24_STENCIL8);
    lights_ = view.scene.lights;
    lights_[0] = view.light;
    lights_.resize(std::min(lights_.size(), std::size_t(view.settings.index("lights"))));
    addLight_ = checkedLightPass(addLight());
    clipFromView_ = checkedProjection(view.camera, view.size);
    CameraBlock camera = cameraBlock(view.camera, view.size);
    camera.clipFromWorld = clipFromView_ * camera.viewFromWorld;
    gl_->camera.upload(camera);
    gl_->volumes.prepare(view, camera.clipFromWorld);
}

void ShadowVolumes::bindBlocks(const Program& program) const {
    gl_->camera.bind(program, "Camera", 0);
    gl_->light.bind(program, "Light", 1);
}

void ShadowVolumes::firstPass(const View& view) {
    const Program& program = view.shaders.program("lit_surface.vert", "first_pass.frag");
    gl_->light.upload(lightBlock(lights_[0]));
    bindBlocks(program);
    beginOpaquePass();
    targets_->clear();
    view.gpuScene.draw(program);
}

void ShadowVolumes::lightPass(const View& view, std::size_t index) {
    const Program& program = view.shaders.program("lit_surface.vert", "light_pass.frag");
    bindBlocks(program);
    LightPass pass = addLight_;
    if (!view.settings.on("shadows")) pass.stencilTest = GL_ALWAYS;
    beginLightPass(pass);
    if (index > 0) glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);  // light 0's visibility
    view.gpuScene.draw(program);
}

void ShadowVolumes::oneLight(const View& view, Frame& frame, std::size_t index) {
    const Light& light = lights_[index];
    const PixelRectangle reach = gl_->volumes.reach(light);
    if (reach.size.x == 0 || reach.size.y == 0) return;
    gl_->light.upload(lightBlock(light));
    targets_->framebuffer.bind();
    glEnable(GL_SCISSOR_TEST);
    glScissor(reach.lower.x, reach.lower.y, reach.size.x, reach.size.y);
    if (view.settings.on("shadows")) {
        auto timing = frame.time("volumes");
        if (addLight_.clearsStencil) targets_->framebuffer.clearStencil();
        gl_->volumes.count(view, index, light, *targets_, binder());
        const bool shown = view.settings.chosen("show") == "counts" && frame.wants("color");
        if (index == 0 && (frame.wants("stencil_count") || shown))
            counts_ = gl_->volumes.counts(view, *targets_);
    }
    if (frame.wants("color") || frame.wants("visibility")) {
        auto timing = frame.time("light");
        lightPass(view, index);
    }
    endStencilPasses();
}

void ShadowVolumes::showCounts(const View& view) {
    const bool wraps = view.settings.chosen("counter") == "stencil";
    countColors_ = Texture({.size = view.size, .format = GL_RGBA32F, .label = "counts in colour"});
    countColors_.upload(countColors(targets_->color.read(), counts_, wraps));
}

void ShadowVolumes::render(const View& view, Frame& frame) {
    prepare(view, frame);
    const std::string& show = view.settings.chosen("show");
    const bool color = frame.wants("color");
    counts_ = Image(view.size.x, view.size.y, 1);
    if (color || frame.wants("visibility") || frame.wants("depth") ||
        frame.wants("stencil_count")) {
        auto timing = frame.time("first");
        firstPass(view);
    }
    if (color || frame.wants("visibility") || frame.wants("stencil_count"))
        for (std::size_t i = 0; i < (color ? lights_.size() : 1); ++i) oneLight(view, frame, i);
    gl_->light.upload(lightBlock(lights_[0]));
    if (color && show == "volumes")
        gl_->volumes.showVolumes(view, 0, lights_[0], *targets_, binder());
    if (color && show == "silhouettes")
        gl_->volumes.showSilhouettes(view, 0, lights_[0], *targets_, binder());
    if (color && show == "counts") showCounts(view);

    if (color) frame.output("color", show == "counts" ? countColors_ : targets_->color);
    if (frame.wants("visibility")) frame.output("visibility", targets_->visibility);
    frame.output("depth", targets_->depth);
    frame.output("stencil_count", counts_);
    gl_->volumes.handOverLists(view, frame);
    if (view.settings.on("shadows")) gl_->volumes.addNotes(view, frame);
    frame.output("clip_from_view", matrixImage(clipFromView_));
    frame.output("counting_state", countingRows(checkedCounting(zPassCounting(), "z_pass.cpp"),
                                                checkedCounting(zFailCounting(), "z_fail.cpp")));
    frame.output("light_pass_state", lightPassRow(addLight_));
}

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<ShadowVolumes>(); }

}  // namespace penumbra
