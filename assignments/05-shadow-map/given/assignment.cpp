// Williams' shadow map in two passes: depth from the light, then a comparison. [Williams 1978]
#include <algorithm>
#include <cstddef>

#include "app/assignment.h"
#include "light_view.h"
#include "render/matrix_image.h"
#include "render/passes.h"
#include "scene/gallery.h"
#include "shadow_map.h"

namespace penumbra {

namespace {

struct ShadowMapBlock {  // shadow_map.glsl
    glm::mat4 clipFromWorld;
    glm::vec4 lightCenterClip;
    glm::vec2 texelSizeUv;
    float texelTangent;
    float depthResolution;
    float constantBias, slopeBias, normalOffset;
    int receiverPlane;
};
static_assert(offsetof(ShadowMapBlock, lightCenterClip) == 64 &&
              offsetof(ShadowMapBlock, texelSizeUv) == 80 &&
              offsetof(ShadowMapBlock, texelTangent) == 88 &&
              offsetof(ShadowMapBlock, constantBias) == 96 &&
              offsetof(ShadowMapBlock, receiverPlane) == 108);

struct DepthFormat {
    GLenum format;
    float resolution;  // step at depth 1
};
constexpr DepthFormat kDepthFormats[] = {{GL_DEPTH_COMPONENT16, 1.0f / 65535.0f},
                                         {GL_DEPTH_COMPONENT24, 1.0f / 16777215.0f},
                                         {GL_DEPTH_COMPONENT32F, 0.0f}};

class ShadowMap final : public Assignment {
public:
    Scene scene() const override { return loadScene("boxes"); }
    void settings(Settings& settings) override;
    void render(const View& view, Frame& frame) override;

    ~ShadowMap() override {
        if (samplers_[0]) glDeleteSamplers(2, samplers_);
        if (emptyVertexArray_) glDeleteVertexArrays(1, &emptyVertexArray_);
    }

private:
    struct Map {
        Map(int size, GLenum format)
            : depth({.size = glm::ivec2(size), .format = format, .label = "shadow map"}),
              framebuffer({.depth = &depth}) {}
        Texture depth;
        Framebuffer framebuffer;
    };
    struct Gl {  // made when a context is current
        UniformBuffer<CameraBlock> camera;
        UniformBuffer<LightBlock> light;
        UniformBuffer<ShadowMapBlock> map;
    };

    void makeSamplers();
    void prepare(const View& view, const Frame& frame);
    void lightPass(const View& view);
    void secondDepthPass(const View& view);
    void cameraPass(const View& view);
    void inspect(const View& view);
    void bindBlocks(const Program& program) const;
    void bindMap(const Program& program) const;
    void unbindMap() const;
    const Map& finalMap(const View& view) const {
        return view.settings.on("second_depth") ? *midpoint_ : *first_;
    }

    std::unique_ptr<Gl> gl_;
    std::unique_ptr<Map> first_, second_, midpoint_;
    std::unique_ptr<CameraTargets> targets_;
    Texture coordinates_;
    Framebuffer coordinatesFramebuffer_;
    GLuint samplers_[2] = {};  // of the map: nearest depths; linear comparisons
    GLuint emptyVertexArray_ = 0;
    const Map* current_ = nullptr;  // the map that is compared with
    glm::mat4 lightClipFromWorld_{1.0f};
};

void ShadowMap::settings(Settings& s) {
    s.choice({.name = "map_size",
              .help = "texels along each side of the shadow map",
              .unit = "texels",
              .value = 2,
              .choices = {"256", "512", "1024", "2048", "4096"}});
    s.choice({.name = "filter",
              .help = "nearest texel, your 2x2, the hardware's 2x2",
              .value = 1,
              .choices = {"off", "2x2", "hardware"}});
    s.number({.name = "constant_bias",
              .help = "receiver moved towards the light",
              .unit = "texels",
              .minimum = 0,
              .maximum = 16,
              .value = 0});
    s.number({.name = "slope_bias",
              .help = "receiver moved towards the light, times tan of the incidence angle",
              .unit = "texels",
              .minimum = 0,
              .maximum = 8,
              .value = 0});
    s.number({.name = "normal_offset",
              .help = "receiver moved along its normal, times sin of the incidence angle",
              .unit = "texels",
              .minimum = 0,
              .maximum = 8,
              .value = 0});
    s.toggle({.name = "receiver_plane",
              .help = "compare with the receiver's plane at each texel's centre",
              .value = 1});
    s.choice({.name = "depth_format",
              .help = "bits of the shadow map",
              .value = 2,
              .choices = {"16", "24", "32f"}});
    s.toggle({.name = "second_depth",
              .help = "threshold midway between first and second surface",
              .value = 0});
    s.toggle(
        {.name = "fit_window", .help = "light's view fitted to what the camera sees", .value = 1});
    s.toggle({.name = "fit_depth", .help = "light's near and far planes fitted", .value = 1});
}

// Beyond the map's border the depth is 1, nothing blocks: a kernel that reaches over the border
// must not compare a plane with the border texel's copy.
void ShadowMap::makeSamplers() {
    const float nothing[] = {1.0f, 1.0f, 1.0f, 1.0f};
    glGenSamplers(2, samplers_);
    for (const GLuint sampler : samplers_) {
        for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glSamplerParameteri(sampler, wrap, GL_CLAMP_TO_BORDER);
        glSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, nothing);
        const GLint filter = sampler == samplers_[0] ? GL_NEAREST : GL_LINEAR;
        for (const GLenum which : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glSamplerParameteri(sampler, which, filter);
    }
    glSamplerParameteri(samplers_[1], GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(samplers_[1], GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void ShadowMap::prepare(const View& view, const Frame& frame) {
    if (!gl_) {
        gl_ = std::make_unique<Gl>();
        glGenVertexArrays(1, &emptyVertexArray_);
        makeSamplers();
    }
    const int size = 256 << view.settings.index("map_size");
    const DepthFormat format = kDepthFormats[view.settings.index("depth_format")];
    const auto fits = [&](const std::unique_ptr<Map>& map) {
        return map && map->depth.size().x == size && map->depth.format() == format.format;
    };
    if (!fits(first_)) first_ = std::make_unique<Map>(size, format.format);
    if (view.settings.on("second_depth")) {
        if (!fits(second_)) second_ = std::make_unique<Map>(size, format.format);
        if (!fits(midpoint_)) midpoint_ = std::make_unique<Map>(size, format.format);
    }
    if (!targets_ || !targets_->fits(view.size, frame))
        targets_ = std::make_unique<CameraTargets>(view.size, frame);
    current_ = &finalMap(view);

    const LightFrustum frustum = lightFrustum(view);
    const LightWindow& w = frustum.window;
    const glm::mat4 clipFromWorld = clipFromView(frustum) * view.light.viewFromWorld();
    gl_->map.upload({.clipFromWorld = clipFromWorld,
                     .lightCenterClip = clipFromWorld * glm::vec4(view.light.center, 1.0f),
                     .texelSizeUv = glm::vec2(1.0f / float(size)),
                     .texelTangent = std::max(w.right - w.left, w.top - w.bottom) / float(size),
                     .depthResolution = format.resolution,
                     .constantBias = view.settings["constant_bias"],
                     .slopeBias = view.settings["slope_bias"],
                     .normalOffset = view.settings["normal_offset"],
                     .receiverPlane = view.settings.index("receiver_plane")});
    gl_->camera.upload(cameraBlock(view.camera, view.size));
    gl_->light.upload(lightBlock(view.light));
    lightClipFromWorld_ = clipFromWorld;
}

void ShadowMap::bindBlocks(const Program& program) const {
    gl_->camera.bind(program, "Camera", 0);
    gl_->light.bind(program, "Light", 1);
    gl_->map.bind(program, "ShadowMap", 2);
}

void ShadowMap::bindMap(const Program& program) const {
    program.use();
    program.texture("shadowMap", 0, current_->depth);
    program.texture("shadowMapCompare", 1, current_->depth);
    for (const GLuint unit : {0u, 1u}) glBindSampler(unit, samplers_[unit]);
}

void ShadowMap::unbindMap() const {
    for (const GLuint unit : {0u, 1u}) glBindSampler(unit, 0);
}

void ShadowMap::lightPass(const View& view) {
    const Program& opaque = view.shaders.program("light_pass.vert", "depth.frag");
    const Program& masked = view.shaders.program("light_pass.vert", "depth_masked.frag");
    bindBlocks(opaque);
    bindBlocks(masked);
    beginOpaquePass();
    first_->framebuffer.clear(glm::vec4(0), 1.0f);
    view.gpuScene.drawDepth(opaque, masked);
}

void ShadowMap::secondDepthPass(const View& view) {
    const Program& peel = view.shaders.program("light_pass.vert", "second_pass.frag");
    bindBlocks(peel);
    peel.use();
    peel.texture("firstDepth", 0, first_->depth);
    beginOpaquePass();
    second_->framebuffer.clear(glm::vec4(0), 1.0f);
    view.gpuScene.draw(peel);

    const Program& midpoint = view.shaders.program("midpoint.vert", "midpoint.frag");
    midpoint.use();
    midpoint.texture("firstDepth", 0, first_->depth);
    midpoint.texture("secondDepth", 1, second_->depth);
    glDepthFunc(GL_ALWAYS);
    midpoint_->framebuffer.bind();
    glBindVertexArray(emptyVertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ShadowMap::cameraPass(const View& view) {
    // A bias that is switched off costs nothing: another chunk behind the same signature.
    const Settings& s = view.settings;
    const bool biased = s["constant_bias"] > 0 || s["slope_bias"] > 0 || s["normal_offset"] > 0;
    const Program& shade = view.shaders.program(
        "lit_surface.vert", "camera_pass.frag",
        {"filter_" + s.chosen("filter") + ".glsl", biased ? "bias_on.glsl" : "bias_off.glsl"});
    bindBlocks(shade);
    bindMap(shade);
    beginOpaquePass();
    targets_->clear();
    view.gpuScene.draw(shade);
    unbindMap();
}

void ShadowMap::inspect(const View& view) {
    const Program& program = view.shaders.program("lit_surface.vert", "inspect.frag");
    if (coordinates_.id() == 0 || coordinates_.size() != view.size) {
        coordinates_ =
            Texture({.size = view.size, .format = GL_RGBA32F, .label = "shadow coordinates"});
    }
    // The camera pass left its depth: the same surfaces pass again.
    coordinatesFramebuffer_ = Framebuffer({.colors = {&coordinates_}, .depth = &targets_->depth});
    bindBlocks(program);
    bindMap(program);
    coordinatesFramebuffer_.clearColor(0, glm::vec4(0));
    beginOpaquePass();
    glDepthFunc(GL_LEQUAL);
    view.gpuScene.draw(program);
    unbindMap();
}

void ShadowMap::render(const View& view, Frame& frame) {
    prepare(view, frame);
    {
        auto timing = frame.time("light");
        lightPass(view);
    }
    if (view.settings.on("second_depth")) {
        auto timing = frame.time("second depth");
        secondDepthPass(view);
    }
    if (frame.wants("color") || frame.wants("visibility") || frame.wants("depth") ||
        frame.wants("shadow_coordinates")) {
        auto timing = frame.time("camera");
        cameraPass(view);
    }
    if (frame.wants("shadow_coordinates")) {
        inspect(view);
        frame.output("shadow_coordinates", coordinates_);
    }
    if (frame.wants("color")) frame.output("color", targets_->color);
    if (frame.wants("visibility")) frame.output("visibility", targets_->visibility);
    frame.output("depth", targets_->depth);
    frame.output("shadow_map", current_->depth);
    frame.output("light_clip_from_world", matrixImage(lightClipFromWorld_));
}

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<ShadowMap>(); }

}  // namespace penumbra
