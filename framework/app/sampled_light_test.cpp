#include "render/sampled_light.h"

#include "app/session.h"
#include "core/metrics.h"
#include "gl/test_context.h"
#include "scene/gallery.h"
#include "truth/visibility.h"

namespace penumbra {

using namespace testing;

namespace {

struct SampledLightOnly final : Assignment {
    explicit SampledLightOnly(int maps) : maps(maps) {}
    Scene scene() const override { return loadScene("boxes"); }
    LightModel lightModel() const override { return LightModel::square; }
    void settings(Settings&) override {}
    void render(const View& view, Frame& frame) override {
        if (!sampled) {
            camera = std::make_unique<UniformBuffer<CameraBlock>>();
            light = std::make_unique<UniformBuffer<LightBlock>>();
            sampled = std::make_unique<SampledLight>(SampledLightDescription{.maps = maps});
            receivers = std::make_unique<ReceiverImages>(view.size);
        }
        camera->upload(cameraBlock(view.camera, view.size));
        light->upload(lightBlock(view.light));
        const Program& program = view.shaders.program("surface.vert", "world_receivers.frag");
        camera->bind(program, "Camera", 0);
        light->bind(program, "Light", 1);
        receivers->render(view, program);
        sampled->render(view, *receivers);
        frame.output("visibility", sampled->visibility());
    }

    int maps;
    std::unique_ptr<UniformBuffer<CameraBlock>> camera;
    std::unique_ptr<UniformBuffer<LightBlock>> light;
    std::unique_ptr<SampledLight> sampled;
    std::unique_ptr<ReceiverImages> receivers;
};

}  // namespace

class SampledLightTest : public GlTest {
protected:
    static double rmseAgainstRays(const char* scene, int maps) {
        const glm::ivec2 size(128);
        Session session(std::make_unique<SampledLightOnly>(maps),
                        Layers({repositoryRoot() / "framework/shaders"}));
        session.open(loadScene(scene));
        const Image mine = session.render(size, {{"visibility"}}).read().at("visibility");
        const RayTracer tracer(session.scene());
        const Image truth =
            areaVisibility(tracer, tracer.receivers(session.camera, size), session.light, 1024);
        return compareVisibility(mine, truth).rmse;
    }
};

// Two truths that share no code: texels and bias here, rays there. What is left between them is
// the step of 1/64 and, at the contact of surfaces, a texel.
TEST_F(SampledLightTest, AgreesWithRays) {
    EXPECT_LT(rmseAgainstRays("boxes", 64), 0.012);
    EXPECT_LT(rmseAgainstRays("stairs", 64), 0.012);
}

TEST_F(SampledLightTest, MorePointsComeCloser) {
    EXPECT_LT(rmseAgainstRays("halfplane", 64), 0.5 * rmseAgainstRays("halfplane", 4));
}

TEST_F(SampledLightTest, EveryRowAndColumnOfTheLightHoldsOnePoint) {
    std::vector<int> rows(16), columns(16);
    for (int i = 0; i < 16; ++i) {
        const glm::vec2 p = lightPoint(i, 4) + 0.5f;
        ++columns.at(std::size_t(p.x * 16));
        ++rows.at(std::size_t(p.y * 16));
    }
    EXPECT_EQ(rows, std::vector<int>(16, 1));
    EXPECT_EQ(columns, std::vector<int>(16, 1));
}

}  // namespace penumbra
