#include "core/truths.h"

#include "truth/visibility.h"

namespace penumbra {

TruthCache::Images toImages(const Image& image) { return {{"image", image}}; }

void fromImages(TruthCache::Images images, Image& image) { image = std::move(images.at("image")); }

TruthCache::Images toImages(const VolumeCount& count) {
    return {{"count", count.count}, {"decidable", count.decidable}};
}

void fromImages(TruthCache::Images images, VolumeCount& count) {
    count = {std::move(images.at("count")), std::move(images.at("decidable"))};
}

namespace {

// Four channels: three and whether there is a receiver.
Image toImage(const Receivers& receivers, const std::vector<glm::vec3>& vectors) {
    Image image(receivers.width, receivers.height, 4);
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        for (int c = 0; c < 3; ++c) image.pixels[4 * i + std::size_t(c)] = vectors[i][c];
        image.pixels[4 * i + 3] = receivers.hit[i];
    }
    return image;
}

}  // namespace

TruthCache::Images toImages(const Receivers& receivers) {
    return {{"positions", toImage(receivers, receivers.positions)},
            {"normals", toImage(receivers, receivers.facetNormals)}};
}

void fromImages(TruthCache::Images images, Receivers& receivers) {
    const Image &positions = images.at("positions"), &normals = images.at("normals");
    receivers = {};
    receivers.width = positions.width, receivers.height = positions.height;
    for (std::size_t i = 0; i < positions.pixels.size(); i += 4) {
        const float *p = &positions.pixels[i], *n = &normals.pixels[i];
        receivers.positions.emplace_back(p[0], p[1], p[2]);
        receivers.facetNormals.emplace_back(n[0], n[1], n[2]);
        receivers.hit.push_back(std::uint8_t(p[3]));
    }
}

TracedScene::TracedScene(Scene scene, glm::ivec2 size)
    : scene_(std::move(scene)), size_(size), sceneHash_(TruthKey("scene", scene_).text()) {}

const RayTracer& TracedScene::tracer() const {
    if (!tracer_) tracer_ = std::make_unique<RayTracer>(scene_);
    return *tracer_;
}

TruthKey TracedScene::key(std::string_view truth) const {
    return TruthKey(truth, sceneHash_, size_);
}

const Receivers& TracedScene::receivers() const {
    if (!receivers_)
        receivers_ = std::make_unique<Receivers>(
            cached(key("receivers"), [&] { return tracer().receivers(scene_.camera, size_); }));
    return *receivers_;
}

Image TracedScene::pointVisibility(std::size_t light) const {
    TruthKey all = key("pointVisibility");
    all.add(light);
    return cached(all, [&] {
        return penumbra::pointVisibility(tracer(), receivers(), scene_.lights[light]);
    });
}

Image TracedScene::areaVisibility(int samples, std::size_t light) const {
    TruthKey all = key("areaVisibility");
    all.add(samples), all.add(light);
    return cached(all, [&] {
        return penumbra::areaVisibility(tracer(), receivers(), scene_.lights[light], samples);
    });
}

Image TracedScene::edgeBand(const glm::mat4& lightClipFromWorld, int mapSize, float texels,
                            std::size_t light) const {
    TruthKey all = key("edgeBand");
    all.add(lightClipFromWorld), all.add(mapSize), all.add(texels), all.add(light);
    return cached(all, [&] {
        return penumbra::edgeBand(tracer(), receivers(), scene_.lights[light], lightClipFromWorld,
                                  mapSize, texels);
    });
}

Image TracedScene::depth(const glm::mat4& clipFromWorld, glm::ivec2 mapSize) const {
    TruthKey all = key("depth");
    all.add(clipFromWorld), all.add(mapSize);
    return cached(all, [&] { return tracer().depth(clipFromWorld, mapSize); });
}

VolumeCount TracedScene::volumeCount(std::size_t light) const {
    TruthKey all = key("volumeCount");
    all.add(light);
    return cached(all, [&] {
        return penumbra::volumeCount(scene_, scene_.camera, receivers(), scene_.lights[light]);
    });
}

}  // namespace penumbra
