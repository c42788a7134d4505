// Truths as checks ask for them: computed once for all runs that share a cache (N.grade
// --truth-cache), else once a call.
//
//   const TracedScene traced(loadScene("boxes@5"), {512, 512});   // traces nothing yet
//   EXPECT_IMAGE_NEAR(frame.at("visibility"), traced.areaVisibility(144), …);
//
//   const Image widths = cached(TruthKey("penumbra widths", scene, size, samples),
//                               [&] { return widthsOf(scene, size, samples); });
//
// A key must hold everything that the function reads; the code itself need not be in it.
#pragma once

#include <memory>
#include <typeinfo>

#include "core/grading_session.h"
#include "truth/ray_tracer.h"
#include "truth/volume_count.h"

namespace penumbra {

// Kinds of truth as named images, and back. Another kind: another pair.
TruthCache::Images toImages(const Image& image);
TruthCache::Images toImages(const Receivers& receivers);
TruthCache::Images toImages(const VolumeCount& count);
void fromImages(TruthCache::Images images, Image& image);
void fromImages(TruthCache::Images images, Receivers& receivers);
void fromImages(TruthCache::Images images, VolumeCount& count);

template <typename Compute>
auto cached(TruthKey key, const Compute& compute) {
    decltype(compute()) truth;
    const TruthCache& cache = GradingSession::current().truths();
    key.add(typeid(truth).name());
    if (auto images = cache.load(key)) {
        fromImages(std::move(*images), truth);
    } else {
        truth = compute();
        cache.save(key, toImages(truth));
    }
    return truth;
}

// One scene as its camera sees it, and what rays find there. `light`: an index of scene.lights.
// Embree's tree is built when the first truth is not in the cache.
class TracedScene {
public:
    TracedScene(Scene scene, glm::ivec2 size);

    const Scene& scene() const { return scene_; }
    glm::ivec2 size() const { return size_; }
    const Receivers& receivers() const;

    Image pointVisibility(std::size_t light = 0) const;
    Image areaVisibility(int samples, std::size_t light = 0) const;
    Image edgeBand(const glm::mat4& lightClipFromWorld, int mapSize, float texels,
                   std::size_t light = 0) const;
    Image depth(const glm::mat4& clipFromWorld, glm::ivec2 mapSize) const;
    VolumeCount volumeCount(std::size_t light = 0) const;

private:
    const RayTracer& tracer() const;
    TruthKey key(std::string_view truth) const;

    Scene scene_;
    glm::ivec2 size_;
    std::string sceneHash_;
    mutable std::unique_ptr<RayTracer> tracer_;
    mutable std::unique_ptr<Receivers> receivers_;
};

}  // namespace penumbra
