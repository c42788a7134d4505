// What a technique must beat to be worth its trouble: shadow rays from what the rasteriser saw, on
// the CPU. With `more`, pixels whose first rays disagree, and their neighbours, get more of them.
#include <algorithm>

#include "app/assignment.h"
#include "render/deferred.h"
#include "render/uniforms.h"
#include "scene/gallery.h"
#include "truth/visibility.h"

namespace penumbra {

namespace {

// Not the truth's: its own rays would agree with it by construction.
constexpr std::uint32_t kSeed = 20;

// Pixels with a value strictly between 0 and 1 within one step, and those beside a jump.
Receivers mixedOnly(const Receivers& receivers, const Image& visibility) {
    Receivers result = receivers;
    for (int y = 0; y < receivers.height; ++y)
        for (int x = 0; x < receivers.width; ++x) {
            float low = 1, high = 0;
            for (int j = std::max(0, y - 1); j <= std::min(receivers.height - 1, y + 1); ++j)
                for (int i = std::max(0, x - 1); i <= std::min(receivers.width - 1, x + 1); ++i) {
                    low = std::min(low, visibility.at(i, j));
                    high = std::max(high, visibility.at(i, j));
                }
            if (low == high) result.hit[std::size_t(y * receivers.width + x)] = 0;
        }
    return result;
}

class Rays final : public Assignment {
public:
    Scene scene() const override { return loadScene("boxes"); }
    LightModel lightModel() const override { return LightModel::square; }

    void settings(Settings& s) override {
        s.integer({.name = "rays",
                   .help = "to each pixel, stratified on the light",
                   .minimum = 1,
                   .maximum = 1024,
                   .value = 16});
        s.integer({.name = "more",
                   .help = "to pixels whose first rays, or their neighbours', disagree",
                   .minimum = 0,
                   .maximum = 1024,
                   .value = 0});
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
            auto timing = frame.time("rays");
            visibility_->upload(trace(view));
        }
        if (frame.wants("color")) {
            auto timing = frame.time("shade");
            const Program& program = view.shaders.program("screen.vert", "apply_visibility.frag");
            deferred_->receivers().bind(program, 0);
            program.texture("visibilityImage", 4, *visibility_);
            deferred_->screen().draw(program, deferred_->shaded().framebuffer);
        }
        frame.output("color", deferred_->shaded().color);
        frame.output("visibility", *visibility_);
        frame.output("depth", deferred_->receivers().depth);
    }

private:
    void prepare(const View& view) {
        if (!deferred_) deferred_ = std::make_unique<DeferredFrame>();
        if (!tracer_ || revision_ != view.revision) {
            tracer_ = std::make_unique<RayTracer>(view.scene);
            revision_ = view.revision;
        }
        if (deferred_->prepare(view))
            visibility_ = std::make_unique<Texture>(
                TextureDescription{.size = view.size, .format = GL_R32F, .label = "visibility"});
    }

    Receivers seen() const {
        const Image position = deferred_->receivers().position.read(),
                    normal = deferred_->receivers().lightHeight.read();
        Receivers result;
        result.width = position.width, result.height = position.height;
        for (std::size_t i = 0; i < position.pixelCount(); ++i) {
            const float* p = &position.pixels[4 * i];
            const float* n = &normal.pixels[4 * i];
            result.positions.emplace_back(p[0], p[1], p[2]);
            result.facetNormals.emplace_back(n[0], n[1], n[2]);
            result.hit.push_back(p[3] >= 0 ? 1 : 0);
        }
        return result;
    }

    Image trace(const View& view) const {
        const Receivers all = seen();
        const int first = view.settings.index("rays"), more = view.settings.index("more");
        Image visibility = areaVisibility(*tracer_, all, view.light, first, nullptr, kSeed);
        if (more == 0) return visibility;
        const Receivers mixed = mixedOnly(all, visibility);
        const Image again = areaVisibility(*tracer_, mixed, view.light, more, nullptr, kSeed + 1);
        const float weight = float(more) / float(first + more);
        for (std::size_t i = 0; i < mixed.hit.size(); ++i)
            if (mixed.hit[i])
                visibility.pixels[i] += weight * (again.pixels[i] - visibility.pixels[i]);
        return visibility;
    }

    std::unique_ptr<DeferredFrame> deferred_;
    std::unique_ptr<RayTracer> tracer_;
    long revision_ = 0;
    std::unique_ptr<Texture> visibility_;
};

}  // namespace

std::unique_ptr<Assignment> makeAssignment() { return std::make_unique<Rays>(); }

}  // namespace penumbra
