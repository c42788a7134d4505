#include "app/viewer_truth.h"

#include <gtest/gtest.h>

#include <chrono>

#include "scene/gallery.h"
#include "truth/visibility.h"

namespace penumbra {
namespace {

using namespace std::chrono_literals;

TruthRequest request(LightModel model) {
    const auto scene = std::make_shared<const Scene>(loadScene("boxes"));
    return {scene, scene->camera, scene->lights[0], {61, 43}, model};
}

// The last pass of what was asked for; a minute at most.
TruthPass lastPass(TruthTracer& tracer) {
    for (int i = 0; i < 6000; ++i) {
        if (auto pass = tracer.take(); pass && pass->last) return std::move(*pass);
        std::this_thread::sleep_for(10ms);
    }
    return {};
}

TEST(TruthTracer, APointLightsLastPassIsPointVisibility) {
    const TruthRequest r = request(LightModel::point);
    TruthTracer tracer;
    tracer.request(r);
    const RayTracer rays(*r.scene);
    EXPECT_EQ(lastPass(tracer).visibility.pixels,
              pointVisibility(rays, rays.receivers(r.camera, r.size), r.light).pixels);
}

TEST(TruthTracer, ASquaresPassesAddUp) {
    TruthTracer tracer;
    tracer.request(request(LightModel::square));
    const TruthPass pass = lastPass(tracer);
    EXPECT_EQ(pass.samples, 256);
    EXPECT_EQ(pass.stride, 1);
    EXPECT_EQ(pass.visibility.width, 61);
}

TEST(TruthTracer, ACancelledRequestYieldsNothing) {
    TruthTracer tracer;
    tracer.request(request(LightModel::square));
    tracer.cancel();
    for (int i = 0; i < 3000 && tracer.busy(); ++i) std::this_thread::sleep_for(10ms);
    EXPECT_FALSE(tracer.busy());
    EXPECT_FALSE(tracer.take());
}

TEST(TruthTracer, TheLastOfManyRequestsIsAnswered) {
    TruthTracer tracer;
    for (int i = 0; i < 5; ++i) tracer.request(request(LightModel::square));
    TruthRequest small = request(LightModel::point);
    small.size = {8, 8};
    tracer.request(small);
    EXPECT_EQ(lastPass(tracer).visibility.width, 8);
}

TEST(EveryNth, TakesTheCentreOfEachBlock) {
    Image image(5, 4, 1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = float(i);
    EXPECT_EQ(everyNth(image, 4).pixels, (std::vector<float>{2 * 5 + 2, 2 * 5 + 4}));
}

}  // namespace
}  // namespace penumbra
