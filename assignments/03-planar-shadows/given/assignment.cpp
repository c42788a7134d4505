// Shadows on one receiver, without a search: casters flattened onto its plane by a projection, or
// drawn once from the light into a texture that is thrown over a curved receiver.
#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "app/assignment.h"
#include "core/error.h"
#include "planar_shadow.h"
#include "receiver.h"
#include "render/matrix_image.h"
#include "render/passes.h"
#include "scene/gallery.h"
#include "texture_view.h"

namespace penumbra {

namespace {

struct PlanarBlock {  // planar.glsl
    glm::mat4 shadowMatrix;
    glm::mat4 textureClipFromWorld;
    glm::vec4 plane;
    float shadowVisibility;
    int rayForm, clip, divide;
};
static_assert(offsetof(PlanarBlock, textureClipFromWorld) == 64 &&
              offsetof(PlanarBlock, plane) == 128 &&
              offsetof(PlanarBlock, shadowVisibility) == 144 &&
              offsetof(PlanarBlock, divide) == 156);

// A student's states may hold anything; GL would only say "invalid enumerant".
void check(const DrawState& state, const std::string& function) {
    if (state.stencilFunction < GL_NEVER || state.stencilFunction > GL_ALWAYS)
        throw Error("stencilFunction is no comparison", function,
                    "choose one of GL_NEVER, GL_LESS, GL_LEQUAL, GL_GREATER, GL_GEQUAL, GL_EQUAL, "
                    "GL_NOTEQUAL, GL_ALWAYS");
    for (const GLenum operation : {state.stencilFails, state.depthFails, state.passes})
        if (operation != GL_ZERO && operation != GL_INVERT && operation != GL_INCR_WRAP &&
            operation != GL_DECR_WRAP && (operation < GL_KEEP || operation > GL_DECR))
            throw Error("stencilFails, depthFails or passes is no stencil operation", function,
                        "choose one of GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_INCR_WRAP, "
                        "GL_DECR, GL_DECR_WRAP, GL_INVERT");
}

void apply(const DrawState& state) {
    glEnable(GL_STENCIL_TEST);
    glStencilMask(0xff);
    glStencilFunc(state.stencilFunction, state.stencilReference, 0xff);
    glStencilOp(state.stencilFails, state.depthFails, state.passes);
    if (state.depthTest)
        glEnable(GL_DEPTH_TEST);
    else
        glDisable(GL_DEPTH_TEST);
}

class PlanarShadow final : public Assignment {
public:
    Scene scene() const override { return loadScene("boxes"); }
    void settings(Settings& settings) override;
    void arrange(const Settings& settings, Scene& scene) const override;
    void render(const View& view, Frame& frame) override;
    bool takesDirectionalLights() const override { return true; }

private:
    struct Parts {  // of one scene
        explicit Parts(const Scene& scene);
        std::string receiverName;
        std::optional<glm::vec4> plane;
        Scene casters;
        GpuScene gpuReceiver, gpuCasters;
        long revision = 0;
    };
    struct Targets {  // of one size
        explicit Targets(glm::ivec2 size);
        Texture visibility, receiver, color, depth;
        Framebuffer visibilityPass, shadowPass, colorPass;
    };
    struct ShadowTexture {
        explicit ShadowTexture(int size)
            : texels({.size = glm::ivec2(size),
                      .format = GL_R8,
                      .filter = GL_LINEAR,
                      .label = "shadow texture"}),
              framebuffer({.colors = {&texels}}) {}
        Texture texels;
        Framebuffer framebuffer;
    };
    struct Blocks {
        UniformBuffer<CameraBlock> camera;
        UniformBuffer<LightBlock> light;
        UniformBuffer<PlanarBlock> planar;
    };

    void prepare(const View& view, const Frame& frame);
    const Program& program(const View& view, const char* vertex, const char* fragment,
                           std::vector<std::string> chunks = {}) const;
    void drawCasters(const View& view, const char* vertex, const char* fragment) const;
    void texturePass(const View& view) const;
    void visibilityPass(const View& view) const;
    void shadowPass(const View& view) const;
    void colorPass(const View& view) const;

    std::unique_ptr<Blocks> blocks_;
    std::unique_ptr<Parts> parts_;
    std::unique_ptr<Targets> targets_;
    std::unique_ptr<ShadowTexture> shadowTexture_;
    bool useTexture_ = false;  // else the planar method
    glm::vec4 plane_{0.0f};    // on the light's side; zeros: none
    glm::mat4 groundMatrix_{0.0f}, planeMatrix_{0.0f}, textureClipFromWorld_{0.0f};
};

PlanarShadow::Parts::Parts(const Scene& scene)
    : receiverName(scene.meshes.at(receiverOf(scene)).name),
      plane(planeOf(scene.meshes.at(receiverOf(scene)))),
      casters([&] {
          auto meshes = scene.meshes;
          meshes.erase(meshes.begin() + std::ptrdiff_t(receiverOf(scene)));
          return withoutColor(scene, std::move(meshes));
      }()),
      gpuReceiver(withoutColor(scene, {scene.meshes[receiverOf(scene)]})),
      gpuCasters(casters) {}

PlanarShadow::Targets::Targets(glm::ivec2 size)
    : visibility({.size = size, .format = GL_R32F, .label = "visibility"}),
      receiver({.size = size, .format = GL_R8, .label = "receiver"}),
      color({.size = size, .format = GL_RGBA16F, .label = "color"}),
      depth({.size = size, .format = GL_DEPTH32F_STENCIL8, .label = "camera depth"}),
      visibilityPass({.colors = {&visibility, &receiver}, .depth = &depth}),
      shadowPass({.colors = {&visibility}, .depth = &depth}),
      colorPass({.colors = {&color}, .depth = &depth}) {}

void PlanarShadow::settings(Settings& s) {
    s.choice({.name = "method",
              .help = "flattened casters, or a shadow texture; auto: flattened where the receiver "
                      "is flat",
              .value = 0,
              .choices = {"auto", "planar", "texture"}});
    s.choice({.name = "form",
              .help = "how casters are flattened: your matrix for y = 0, for any plane, your rays",
              .value = 2,
              .choices = {"ground", "matrix", "ray"}});
    s.toggle({.name = "clip",
              .help = "only what stands between receiver and light casts a shadow",
              .value = 1});
    s.toggle({.name = "divide",
              .help = "divide by w at the vertices, as if they were points, and see what happens",
              .value = 0});
    s.toggle({.name = "stencil",
              .help = "your marks; off: depth test with an offset instead",
              .value = 1});
    s.number({.name = "light_height",
              .help = "light raised or lowered",
              .unit = "world units",
              .minimum = -6,
              .maximum = 12,
              .value = 0});
    s.number({.name = "plane_tilt",
              .help = "receiver turned about its middle",
              .unit = "degrees",
              .minimum = -60,
              .maximum = 60,
              .value = 0});
    s.number({.name = "alpha",
              .help = "darkness of cast shadow: visibility there is 1 - alpha",
              .minimum = 0,
              .maximum = 1,
              .value = 1});
    s.number({.name = "depth_offset",
              .help = "with stencil=off: flattened casters drawn nearer to the eye",
              .unit = "depth steps",
              .minimum = 0,
              .maximum = 16,
              .value = 2});
    s.choice({.name = "texture_size",
              .help = "texels along each side of the shadow texture",
              .unit = "texels",
              .value = 2,
              .choices = {"256", "512", "1024", "2048", "4096"}});
    s.toggle({.name = "onto_casters",
              .help = "throw the shadow texture over the casters, too",
              .value = 0});
}

void PlanarShadow::arrange(const Settings& settings, Scene& scene) const {
    for (Light& light : scene.lights) light.center.y += settings["light_height"];
    if (const float degrees = settings["plane_tilt"]; degrees != 0.0f)
        tilt(scene.meshes.at(receiverOf(scene)), glm::radians(degrees));
}

void PlanarShadow::prepare(const View& view, const Frame& frame) {
    if (!blocks_) blocks_ = std::make_unique<Blocks>();
    if (!parts_ || parts_->revision != view.revision) {
        parts_ = std::make_unique<Parts>(view.scene);
        parts_->revision = view.revision;
    }
    const Settings& s = view.settings;
    if (s.chosen("method") == "planar" && !parts_->plane)
        throw Error("the receiver is not flat", "method=planar on scene " + view.scene.name,
                    "set method=texture, or auto");
    useTexture_ = s.chosen("method") == "texture" || !parts_->plane;
    if (!targets_ || targets_->color.size() != view.size)
        targets_ = std::make_unique<Targets>(view.size);
    const int textureSize = 256 << s.index("texture_size");
    if ((useTexture_ || frame.wants("shadow_texture")) &&
        (!shadowTexture_ || shadowTexture_->texels.size().x != textureSize))
        shadowTexture_ = std::make_unique<ShadowTexture>(textureSize);

    const glm::vec4 light = view.light.position();
    plane_ = parts_->plane.value_or(glm::vec4(0.0f));
    if (glm::dot(plane_, light) < 0.0f) plane_ = -plane_;
    groundMatrix_ = groundShadowMatrix(light);
    planeMatrix_ = parts_->plane ? planeShadowMatrix(plane_, light) : glm::mat4(0.0f);
    textureClipFromWorld_ = shadowTextureView(parts_->casters, view.light);
    blocks_->camera.upload(cameraBlock(view.camera, view.size));
    blocks_->light.upload(lightBlock(view.light));
    blocks_->planar.upload(
        {.shadowMatrix = s.chosen("form") == "ground" ? groundMatrix_ : planeMatrix_,
         .textureClipFromWorld = textureClipFromWorld_,
         .plane = plane_,
         .shadowVisibility = 1.0f - s["alpha"],
         .rayForm = s.chosen("form") == "ray",
         .clip = s.on("clip"),
         .divide = s.on("divide")});
}

const Program& PlanarShadow::program(const View& view, const char* vertex, const char* fragment,
                                     std::vector<std::string> chunks) const {
    const Program& program = view.shaders.program(vertex, fragment, chunks);
    blocks_->camera.bind(program, "Camera", 0);
    blocks_->light.bind(program, "Light", 1);
    blocks_->planar.bind(program, "Planar", 2);
    return program;
}

void PlanarShadow::drawCasters(const View& view, const char* vertex, const char* fragment) const {
    parts_->gpuCasters.drawDepth(program(view, vertex, fragment, {"opaque.glsl"}),
                                 program(view, vertex, fragment, {"masked.glsl"}));
}

// Black on white, without depth: it does not matter which caster is in front.
void PlanarShadow::texturePass(const View& view) const {
    beginOpaquePass();
    glDisable(GL_DEPTH_TEST);
    shadowTexture_->framebuffer.clear(glm::vec4(1.0f));
    drawCasters(view, "texture_pass.vert", "texture_pass.frag");
}

// Casters first, so that the receiver's marks are made where it is seen.
void PlanarShadow::visibilityPass(const View& view) const {
    const auto draw = [&](const GpuScene& part, bool isReceiver, bool useTexture) {
        const auto variant = [&](const char* holes) -> const Program& {
            const Program& p =
                program(view, "scene_surface.vert", "visibility_pass.frag",
                        {holes, useTexture ? "texture_on.glsl" : "texture_off.glsl"});
            p.use();
            p.set("isReceiver", isReceiver ? 1.0f : 0.0f);
            if (useTexture) p.texture("shadowTexture", 0, shadowTexture_->texels);
            return p;
        };
        part.drawDepth(variant("opaque.glsl"), variant("masked.glsl"));
    };
    const Settings& s = view.settings;
    beginOpaquePass();
    targets_->visibilityPass.clear(glm::vec4(0.0f));
    targets_->visibilityPass.clearColor(0, glm::vec4(1.0f));
    draw(parts_->gpuCasters, false, useTexture_ && s.on("onto_casters"));
    if (!useTexture_ && s.on("stencil")) {
        const DrawState state = receiverDrawing();
        check(state, "receiverDrawing()");
        apply(state);
    }
    draw(parts_->gpuReceiver, true, useTexture_);
}

void PlanarShadow::shadowPass(const View& view) const {
    const Settings& s = view.settings;
    beginOpaquePass();
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);  // visibility times what is drawn
    if (s.on("stencil")) {
        const DrawState state = shadowDrawing();
        check(state, "shadowDrawing()");
        apply(state);
    } else {
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(-s["depth_offset"], -s["depth_offset"]);
    }
    for (const GLenum plane : {GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE1}) glEnable(plane);
    targets_->shadowPass.bind();
    drawCasters(view, "flatten.vert", "flatten.frag");
    for (const GLenum plane : {GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE1}) glDisable(plane);
    beginOpaquePass();
}

// Over the depth that the visibility pass has left: each pixel is shaded once.
void PlanarShadow::colorPass(const View& view) const {
    const Program& shade = program(view, "scene_surface.vert", "color_pass.frag");
    shade.use();
    shade.texture("visibilityImage", 0, targets_->visibility);
    beginOpaquePass();
    glDepthFunc(GL_EQUAL);
    targets_->colorPass.clearColor(0, kBackground);
    view.gpuScene.draw(shade);
}

void PlanarShadow::render(const View& view, Frame& frame) {
    prepare(view, frame);
    frame.note(fmt::format("cast shadow on mesh '{}' alone, by {}", parts_->receiverName,
                           useTexture_ ? "a shadow texture" : "flattened casters"));
    if (useTexture_ || frame.wants("shadow_texture")) {
        auto timing = frame.time("shadow texture");
        texturePass(view);
        frame.output("shadow_texture", shadowTexture_->texels);
    }
    {
        auto timing = frame.time("visibility");
        visibilityPass(view);
    }
    // Where the light lies in the plane, attached shadow has darkened the whole receiver.
    if (!useTexture_ && glm::dot(plane_, view.light.position()) > 0.0f) {
        auto timing = frame.time("flattened casters");
        shadowPass(view);
    }
    if (frame.wants("color")) {
        auto timing = frame.time("color");
        colorPass(view);
        frame.output("color", targets_->color);
    }
    frame.output("visibility", targets_->visibility);
    frame.output("depth", targets_->depth);
    frame.output("receiver", targets_->receiver);
    if (frame.wants("stencil")) frame.output("stencil", targets_->visibilityPass.readStencil());
    Image plane(4, 1, 1);
    for (int i = 0; i < 4; ++i) plane.at(i, 0) = plane_[i];
    frame.output("plane", std::move(plane));
    frame.output("ground_matrix", matrixImage(groundMatrix_));
    frame.output("shadow_matrix", matrixImage(planeMatrix_));
    frame.output("texture_clip_from_world", matrixImage(textureClipFromWorld_));
}

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<PlanarShadow>(); }

}  // namespace penumbra
