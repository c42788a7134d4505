// Soft shadows of a square light from one shadow map. [Reeves 1987, Fernando 2005]
//
//   light      depth from the light's centre
//   min        pyramid=on: the smallest depth around each place in the map, at low resolution
//   surfaces   what the camera sees, its light without shadow, and its place in the light's map
//   shadow     one triangle over the picture: visibility of each pixel's receiver
//
// Surfaces come before shadow so that softVisibility() runs once a pixel, whatever lies over what.
#include <algorithm>
#include <cstddef>

#include "app/assignment.h"
#include "min_depth.h"
#include "render/light_frustum.h"
#include "render/matrix_image.h"
#include "render/passes.h"
#include "scene/gallery.h"
#include "soft_shadow.h"

namespace penumbra {

namespace {

struct ShadowMap {
    explicit ShadowMap(int size)
        : depth({.size = glm::ivec2(size), .format = GL_DEPTH_COMPONENT32F, .label = "shadow map"}),
          framebuffer({.depth = &depth}) {}
    Texture depth;
    Framebuffer framebuffer;
};

Texture target(glm::ivec2 size, GLenum format, const char* label) {
    return Texture({.size = size, .format = format, .label = label});
}

// One value a receiver: where it lies in the light's map, and what it is lit by.
struct Surfaces {
    explicit Surfaces(glm::ivec2 imageSize)
        : unlit(target(imageSize, GL_RGBA16F, "unlit color")),
          direct(target(imageSize, GL_RGBA16F, "direct color")),
          position(target(imageSize, GL_RGBA32F, "receiver position")),
          height(target(imageSize, GL_RGBA32F, "receiver plane")),
          depth(target(imageSize, GL_DEPTH_COMPONENT32F, "camera depth")),
          framebuffer({.colors = {&unlit, &direct, &position, &height}, .depth = &depth}) {}

    void clear() const {
        framebuffer.clear(glm::vec4(0), 1.0f);
        framebuffer.clearColor(0, kBackground);
        framebuffer.clearColor(2, {0, 0, 0, -1});  // receiver.glsl: no surface
    }

    Texture unlit, direct, position, height, depth;
    Framebuffer framebuffer;
};

struct Picture {
    explicit Picture(glm::ivec2 size)
        : color(target(size, GL_RGBA16F, "color")),
          visibility(target(size, GL_R32F, "visibility")),
          framebuffer({.colors = {&color, &visibility}}) {}
    Texture color, visibility;
    Framebuffer framebuffer;
};

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

    ~Pcss() override {
        if (sampler_) glDeleteSamplers(1, &sampler_);
        if (emptyVertexArray_) glDeleteVertexArrays(1, &emptyVertexArray_);
    }

private:
    struct Gl {  // made when a context is current
        UniformBuffer<CameraBlock> camera;
        UniformBuffer<LightBlock> light;
        UniformBuffer<SoftShadowBlock> map;
    };

    void prepare(const View& view);
    void bindBlocks(const Program& program) const;
    void lightPass(const View& view);
    void surfacePass(const View& view);
    void screenPass(const Program& program, const Framebuffer& framebuffer) const;

    std::unique_ptr<Gl> gl_;
    std::unique_ptr<ShadowMap> map_;
    std::unique_ptr<Surfaces> surfaces_;
    std::unique_ptr<Picture> picture_;
    std::unique_ptr<Inspection> inspection_;
    MinDepth minDepth_;
    SoftShadowBlock block_{};
    GLuint sampler_ = 0, emptyVertexArray_ = 0;
};

void Pcss::settings(Settings& s) {
    s.choice({.name = "method",
              .help = "PCSS; one filter width everywhere; depths averaged first; bonus",
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
    if (!gl_) {
        gl_ = std::make_unique<Gl>();
        glGenVertexArrays(1, &emptyVertexArray_);
        sampler_ = mapSampler();
    }
    const int size = 256 << view.settings.index("map_size");
    if (!map_ || map_->depth.size().x != size) map_ = std::make_unique<ShadowMap>(size);
    if (!surfaces_ || surfaces_->depth.size() != view.size) {
        surfaces_ = std::make_unique<Surfaces>(view.size);
        picture_ = std::make_unique<Picture>(view.size);
        inspection_.reset();
    }
    block_ = softShadowBlock(view, areaLightFrustum(view), size);
    if (view.settings.on("pyramid"))
        block_.minTexelUv = minDepth_.prepare(size, block_.widthScaleUv);
    gl_->map.upload(block_);
    gl_->camera.upload(cameraBlock(view.camera, view.size));
    gl_->light.upload(lightBlock(view.light));
}

void Pcss::bindBlocks(const Program& program) const {
    gl_->camera.bind(program, "Camera", 0);
    gl_->light.bind(program, "Light", 1);
    gl_->map.bind(program, "SoftShadow", 2);
}

void Pcss::lightPass(const View& view) {
    const Program& opaque = view.shaders.program("light_pass.vert", "depth.frag");
    const Program& masked = view.shaders.program("light_pass.vert", "depth_masked.frag");
    bindBlocks(opaque);
    bindBlocks(masked);
    beginOpaquePass();
    map_->framebuffer.clear(glm::vec4(0), 1.0f);
    view.gpuScene.drawDepth(opaque, masked);
}

void Pcss::surfacePass(const View& view) {
    const Program& program = view.shaders.program("lit_surface.vert", "surface_pass.frag");
    bindBlocks(program);
    beginOpaquePass();
    surfaces_->clear();
    view.gpuScene.draw(program);
}

void Pcss::screenPass(const Program& program, const Framebuffer& framebuffer) const {
    bindBlocks(program);
    program.use();
    program.texture("shadowMap", 0, map_->depth);
    program.texture("receiverPosition", 1, surfaces_->position);
    program.texture("receiverPlaneAt", 2, surfaces_->height);
    program.texture("unlitColor", 3, surfaces_->unlit);
    program.texture("directColor", 4, surfaces_->direct);
    if (minDepth_.image()) program.texture("minDepth", 5, *minDepth_.image());
    glBindSampler(0, sampler_);
    framebuffer.bind();
    glBindVertexArray(emptyVertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindSampler(0, 0);
}

void Pcss::render(const View& view, Frame& frame) {
    prepare(view);
    const auto timed = [&](const char* name, auto&& pass) {
        auto timing = frame.time(name);
        pass();
    };
    timed("light", [&] { lightPass(view); });
    // From here on every pass covers its target: nothing is tested, nothing is mixed.
    const bool pyramid = view.settings.on("pyramid");
    if (pyramid)
        timed("min", [&] {
            glDisable(GL_DEPTH_TEST);
            glBindVertexArray(emptyVertexArray_);
            minDepth_.render(view.shaders, map_->depth, gl_->map);
        });
    timed("surfaces", [&] { surfacePass(view); });
    glDisable(GL_DEPTH_TEST);
    const std::vector<std::string> chunks = chunksFor(view.settings);
    if (frame.wants("color") || frame.wants("visibility"))
        timed("shadow", [&] {
            screenPass(view.shaders.program("screen.vert", "shadow_pass.frag", chunks),
                       picture_->framebuffer);
        });
    if (frame.wants("blocker_depth") || frame.wants("penumbra_width") || frame.wants("search")) {
        if (!inspection_) inspection_ = std::make_unique<Inspection>(view.size);
        screenPass(view.shaders.program("screen.vert", "inspect.frag", chunks),
                   inspection_->framebuffer);
        frame.output("blocker_depth", inspection_->blockerDepth);
        frame.output("penumbra_width", inspection_->penumbraWidth);
        frame.output("search", inspection_->search);
    }
    frame.output("color", picture_->color);
    frame.output("visibility", picture_->visibility);
    frame.output("depth", surfaces_->depth);
    frame.output("shadow_map", map_->depth);
    frame.output("receiver", surfaces_->position);
    frame.output("light_height", surfaces_->height);
    if (frame.wants("min_depth") && pyramid) frame.output("min_depth", *minDepth_.image());
    frame.output("light_clip_from_world", matrixImage(block_.clipFromWorld));
}

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<Pcss>(); }

}  // namespace penumbra
