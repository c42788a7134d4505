// Soft shadows of a square light from a signed distance field. [Hart 1996, Quilez 2010, Aaltonen
// 2018]
//
//   field      distance to whatever can block, on a grid of voxels; made when the scene changes
//   surfaces   what the camera sees, its light without shadow, its place in the world
//   shadow     one triangle over the picture: each pixel's receiver marches to the light
#include "app/assignment.h"
#include "field.h"
#include "render/deferred.h"
#include "render/passes.h"
#include "render/uniforms.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

constexpr int kSlicePixels = 256;  // slice.frag

Texture target(glm::ivec2 size, const char* label) {
    return Texture({.size = size, .format = GL_R32F, .label = label});
}

struct Inspection {
    explicit Inspection(glm::ivec2 size)
        : ratio(target(size, "ratio")),
          approach(target(size, "approach")),
          steps(target(size, "steps")),
          framebuffer({.colors = {&ratio, &approach, &steps}}) {}
    Texture ratio, approach, steps;
    Framebuffer framebuffer;
};

struct Slice {
    Texture distance = target(glm::ivec2(kSlicePixels), "distance");
    Framebuffer framebuffer{{.colors = {&distance}}};
};

Image fieldImage(const DistanceGrid& grid) {
    Image image(2, 1, 4);
    const glm::vec3 size(grid.size);
    image.pixels = {grid.lower.x, grid.lower.y, grid.lower.z, grid.cell, size.x, size.y, size.z, 0};
    return image;
}

class DistanceFields final : public Assignment {
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
        UniformBuffer<FieldBlock> field;
        Slice slice;
    };

    void prepare(const View& view);
    void bindBlocks(const Program& program) const;
    void screenPass(const Program& program, const Framebuffer& framebuffer) const;
    void inspect(const View& view, Frame& frame, const std::vector<std::string>& chunks);

    std::unique_ptr<Gl> gl_;
    BlockerField field_;
    std::unique_ptr<Inspection> inspection_;
};

void DistanceFields::settings(Settings& s) {
    s.choice({.name = "method",
              .help = "how the march's result becomes visibility",
              .value = 4,
              .choices = {"lecture", "closest_approach", "signed", "edge", "quarters", "hard"}});
    s.choice({.name = "grid",
              .help = "voxels along the field's longest side",
              .unit = "voxels",
              .value = 1,
              .choices = {"64", "128", "256"}});
    s.number({.name = "k",
              .help = "method=lecture, closest_approach: sharpness, times 2 D / W",
              .minimum = 0.25,
              .maximum = 8,
              .value = 1.5});
    s.number({.name = "step_cap",
              .help = "where it may still get darker, steps shrink to this share of the distance",
              .minimum = 0.02,
              .maximum = 1,
              .value = 1});
    s.integer({.name = "max_steps",
               .help = "look-ups of one march",
               .minimum = 4,
               .maximum = 512,
               .value = 128});
    s.number({.name = "smallest_step",
              .help = "first and shortest step",
              .unit = "voxels",
              .minimum = 0.05,
              .maximum = 4,
              .value = 0.5});
    s.number({.name = "normal_offset",
              .help = "rays start so far over the surface",
              .unit = "voxels",
              .minimum = 0,
              .maximum = 4,
              .value = 0.25});
    s.number({.name = "light_size",
              .help = "the light's width, times this; truth follows",
              .minimum = 0.001,
              .maximum = 4,
              .value = 1});
    s.toggle({.name = "horizon",
              .help = "light points below the receiver's plane are dark",
              .value = 1});
    s.number({.name = "slice",
              .help = "height of the slice in image `distance`",
              .minimum = 0,
              .maximum = 1,
              .value = 0.5});
}

void DistanceFields::prepare(const View& view) {
    if (!gl_) gl_ = std::make_unique<Gl>();
    if (gl_->deferred.prepare(view)) inspection_.reset();
    field_.prepare(view, 64 << view.settings.index("grid"));
    gl_->field.upload(fieldBlock(view.settings, field_));
}

void DistanceFields::bindBlocks(const Program& program) const {
    gl_->deferred.bindBlocks(program);
    gl_->field.bind(program, "Field", 3);
}

void DistanceFields::screenPass(const Program& program, const Framebuffer& framebuffer) const {
    bindBlocks(program);
    gl_->deferred.receivers().bind(program, 1);
    program.texture("distanceField", 0, field_.texture());
    gl_->deferred.screen().draw(program, framebuffer);
}

void DistanceFields::inspect(const View& view, Frame& frame,
                             const std::vector<std::string>& chunks) {
    if (frame.wants("ratio") || frame.wants("approach") || frame.wants("steps")) {
        if (!inspection_) inspection_ = std::make_unique<Inspection>(view.size);
        screenPass(view.shaders.program("screen.vert", "inspect.frag", chunks),
                   inspection_->framebuffer);
        frame.output("ratio", inspection_->ratio);
        frame.output("approach", inspection_->approach);
        frame.output("steps", inspection_->steps);
    }
    if (frame.wants("distance")) {
        screenPass(view.shaders.program("screen.vert", "slice.frag", {"volume.glsl"}),
                   gl_->slice.framebuffer);
        frame.output("distance", gl_->slice.distance);
    }
}

void DistanceFields::render(const View& view, Frame& frame) {
    prepare(view);
    {
        auto timing = frame.time("surfaces");
        const Program& program =
            view.shaders.program("field_receivers.vert", "field_receivers.frag");
        bindBlocks(program);
        gl_->deferred.receivers().render(view, program);
    }
    const std::vector<std::string> chunks = chunksFor(view.settings);
    if (frame.wants("color") || frame.wants("visibility")) {
        auto timing = frame.time("shadow");
        screenPass(view.shaders.program("screen.vert", "shadow_pass.frag", chunks),
                   gl_->deferred.shaded().framebuffer);
    }
    inspect(view, frame, chunks);
    for (const std::string& note : field_.notes()) frame.note(note);
    if (field_.work()) frame.unfinished(field_.work());
    gl_->deferred.output(frame);
    frame.output("field", fieldImage(field_.grid()));
}

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<DistanceFields>(); }

}  // namespace penumbra
