// Soft shadows from mean and variance of a shadow map's depths over boxes of any size.
// [Donnelly 2006, Lauritzen 2007, Yang 2010]
//
//   light      depth from the light's centre
//   moments    of each texel: the depth and its square; for exponential estimates, warped
//   sat        what makes means over boxes cheap: a summed-area table, or mip levels
//   surfaces   what the camera sees, its light without shadow, and its place in the light's map
//   shadow     one triangle over the picture: visibility of each pixel's receiver
#include "app/assignment.h"
#include "moment_maps.h"
#include "render/matrix_image.h"
#include "render/passes.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

struct Inspection {
    explicit Inspection(glm::ivec2 size)
        : blockerDepth({.size = size, .format = GL_R32F, .label = "blocker depth"}),
          penumbraWidth({.size = size, .format = GL_R32F, .label = "penumbra width"}),
          framebuffer({.colors = {&blockerDepth, &penumbraWidth}}) {}
    Texture blockerDepth, penumbraWidth;
    Framebuffer framebuffer;
};

struct MeanVariance {
    explicit MeanVariance(int size)
        : texture({.size = glm::ivec2(size), .format = GL_RG32F, .label = "mean and variance"}),
          framebuffer({.colors = {&texture}}) {}
    Texture texture;
    Framebuffer framebuffer;
};

Image oneNumber(float value) {
    Image image(1, 1, 1);
    image.at(0, 0) = value;
    return image;
}

class Vssm final : public Assignment {
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
        UniformBuffer<VarianceShadowBlock> dials;
    };

    void prepare(const View& view);
    void bindBlocks(const Program& program) const;
    void momentPasses(const View& view, Frame& frame);
    void surfacePass(const View& view);
    void screenPass(const Program& program, const Framebuffer& framebuffer) const;
    void inspect(const View& view, Frame& frame);

    std::unique_ptr<Gl> gl_;
    std::unique_ptr<AreaShadowMap> map_;
    std::unique_ptr<MomentMaps> moments_;
    std::unique_ptr<Inspection> inspection_;
    std::unique_ptr<MeanVariance> meanVariance_;
    VarianceShadowBlock dials_{};
};

void Vssm::settings(Settings& s) {
    s.choice({.name = "width",
              .help = "of the filter: the penumbra's, or filter_width for all receivers",
              .value = 0,
              .choices = {"penumbra", "fixed"}});
    s.choice({.name = "estimate",
              .help = "of the share of a box that is farther than the receiver",
              .value = 0,
              .choices = {"chebyshev", "normal", "esm", "evsm"}});
    s.choice({.name = "prefilter",
              .help = "where means over boxes come from; sat_gpu is yours",
              .value = 0,
              .choices = {"sat_cpu", "sat_cpu_integer", "sat_gpu", "mipmap"}});
    s.choice({.name = "map_size",
              .help = "texels along each side of the shadow map",
              .unit = "texels",
              .value = 3,
              .choices = {"64", "128", "256", "512", "1024", "2048", "4096"}});
    s.number({.name = "light_size",
              .help = "the light's width, times this; truth follows",
              .minimum = 0.001,
              .maximum = 4,
              .value = 1});
    s.number({.name = "filter_width",
              .help = "width=fixed, image mean_variance: full width of the box",
              .unit = "texels",
              .minimum = 1,
              .maximum = 128,
              .value = 8});
    s.integer({.name = "filter_cells",
               .help = "the filter is cut into n x n boxes: n",
               .minimum = 1,
               .maximum = 4,
               .value = 2});
    s.integer({.name = "search_cells",
               .help = "the search for blockers likewise",
               .minimum = 1,
               .maximum = 4,
               .value = 1});
    s.integer({.name = "queries",
               .help = "of the search for blockers, each in a narrower window",
               .minimum = 1,
               .maximum = 4,
               .value = 2});
    s.choice({.name = "center",
              .help = "depth subtracted before squaring: the map's mean, 1/2, 0",
              .value = 0,
              .choices = {"mean", "half", "zero"}});
    s.number({.name = "min_variance",
              .help = "no box varies less",
              .unit = "depth²",
              .minimum = 0,
              .maximum = 0.001,
              .value = 1e-6});
    s.number({.name = "light_bleeding",
              .help = "share of Chebyshev's bound that is cut off",
              .minimum = 0,
              .maximum = 0.9,
              .value = 0.05});
    s.number({.name = "least_width",
              .help = "no penumbra is filtered more narrowly",
              .unit = "texels",
              .minimum = 0.5,
              .maximum = 16,
              .value = 4});
    s.number({.name = "constant_bias",
              .help = "a blocker is nearer than the receiver by at least so much",
              .unit = "texels",
              .minimum = 0,
              .maximum = 16,
              .value = 1});
    s.number({.name = "exponent",
              .help = "estimate=esm, evsm: c of exp(c depth); your limit holds",
              .minimum = 0,
              .maximum = 100,
              .value = 20});
}

void Vssm::prepare(const View& view) {
    if (!gl_) gl_ = std::make_unique<Gl>();
    const int size = 64 << view.settings.index("map_size");
    if (!map_ || map_->size() != size) {
        map_ = std::make_unique<AreaShadowMap>(size);
        moments_ = std::make_unique<MomentMaps>(size);
        meanVariance_.reset();
    }
    if (gl_->deferred.prepare(view)) inspection_.reset();
    map_->fit(view, view.settings["constant_bias"]);
    dials_ = varianceShadowBlock(view.settings, *map_);
}

void Vssm::bindBlocks(const Program& program) const {
    gl_->deferred.bindBlocks(program);
    map_->bindBlock(program);
    gl_->dials.bind(program, "VarianceShadow", 3);
}

void Vssm::momentPasses(const View& view, Frame& frame) {
    {
        auto timing = frame.time("moments");
        dials_.center = moments_->center(view, *map_, gl_->deferred.screen());
        gl_->dials.upload(dials_);
        moments_->renderMoments(view, *map_, gl_->deferred.screen(), gl_->dials);
        if (isExponential(view.settings))
            moments_->renderWarped(view, *map_, gl_->deferred.screen(), gl_->dials);
    }
    auto timing = frame.time("sat");
    moments_->prefilter(view, gl_->deferred.screen(), gl_->dials, dials_.integersPerUnit);
}

void Vssm::surfacePass(const View& view) {
    const Program& program = view.shaders.program("receivers.vert", "receivers.frag");
    bindBlocks(program);
    gl_->deferred.receivers().render(view, program);
}

void Vssm::screenPass(const Program& program, const Framebuffer& framebuffer) const {
    bindBlocks(program);
    gl_->deferred.receivers().bind(program, 1);
    moments_->bind(program, 5);
    gl_->deferred.screen().draw(program, framebuffer);
}

// Images that nobody needs for the picture.
void Vssm::inspect(const View& view, Frame& frame) {
    const std::vector<std::string> chunks = chunksFor(view.settings);
    if (frame.wants("blocker_depth") || frame.wants("penumbra_width")) {
        if (!inspection_) inspection_ = std::make_unique<Inspection>(view.size);
        screenPass(view.shaders.program("screen.vert", "inspect.frag", chunks),
                   inspection_->framebuffer);
        frame.output("blocker_depth", inspection_->blockerDepth);
        frame.output("penumbra_width", inspection_->penumbraWidth);
    }
    if (frame.wants("mean_variance")) {
        if (!meanVariance_) meanVariance_ = std::make_unique<MeanVariance>(map_->size());
        screenPass(view.shaders.program("screen.vert", "mean_variance.frag", {chunks.back()}),
                   meanVariance_->framebuffer);
        frame.output("mean_variance", meanVariance_->texture);
    }
    if (frame.wants("sat") && hasIntegers(view.settings))
        frame.output("sat", moments_->integers(view, gl_->deferred.screen()));
    if (isExponential(view.settings)) frame.output("warped", moments_->warped());
    frame.output("moments", moments_->moments());
    frame.output("center", oneNumber(dials_.center));
    frame.output("integers_per_unit", oneNumber(dials_.integersPerUnit));
}

void Vssm::render(const View& view, Frame& frame) {
    prepare(view);
    {
        auto timing = frame.time("light");
        map_->render(view);
    }
    momentPasses(view, frame);
    {
        auto timing = frame.time("surfaces");
        surfacePass(view);
    }
    if (frame.wants("color") || frame.wants("visibility")) {
        auto timing = frame.time("shadow");
        screenPass(
            view.shaders.program("screen.vert", "shadow_pass.frag", chunksFor(view.settings)),
            gl_->deferred.shaded().framebuffer);
    }
    inspect(view, frame);
    frame.output("shadow_map", map_->depth());
    gl_->deferred.output(frame);
    frame.output("light_clip_from_world", matrixImage(map_->values().clipFromWorld));
}

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<Vssm>(); }

}  // namespace penumbra
