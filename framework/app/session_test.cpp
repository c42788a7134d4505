#include "app/session.h"

#include "gl/test_context.h"
#include "scene/gallery.h"

namespace penumbra {

using namespace testing;

namespace {

// Draws nothing; keeps what it was asked to draw.
struct Witness final : Assignment {
    explicit Witness(bool takesDirections) : takesDirections(takesDirections) {}
    Scene scene() const override { return loadScene("boxes"); }
    void settings(Settings& settings) override {
        settings.number({.name = "height", .help = "added to the light's", .maximum = 5});
    }
    void arrange(const Settings& settings, Scene& scene) const override {
        scene.lights[0].center.y += settings["height"];
    }
    void render(const View& view, Frame&) override { light = view.light; }
    bool takesDirectionalLights() const override { return takesDirections; }

    bool takesDirections;
    Light light;
};

Scene sunny() {
    Scene scene = loadScene("boxes");
    scene.lights[0].directional = true;
    return scene;
}

}  // namespace

class SessionTest : public GlTest {
protected:
    // What a technique gets to draw of `scene`.
    static Light lightOf(bool takesDirections, const Scene& scene) {
        auto witness = std::make_unique<Witness>(takesDirections);
        Witness& seen = *witness;
        Session session(std::move(witness), Layers());
        session.open(scene);
        session.render({4, 4});
        return seen.light;
    }
};

TEST_F(SessionTest, ATechniqueThatTakesDirectionalLightsGetsThem) {
    EXPECT_EQ(lightOf(true, sunny()), sunny().lights[0]);
}

TEST_F(SessionTest, OthersGetASquareInTheSamePlaceInstead) {
    Light square = sunny().lights[0];
    square.directional = false;
    EXPECT_EQ(lightOf(false, sunny()), square);
}

TEST_F(SessionTest, ADraggedLightStaysUntilASettingMovesIt) {
    Session session(std::make_unique<Witness>(true), Layers());
    session.openDefault();
    const Light opened = session.light;
    session.light.center.x += 1.0f;
    session.render({4, 4});
    EXPECT_EQ(session.light.center.x, opened.center.x + 1.0f);
    session.settings().assign("height=2");
    session.render({4, 4});
    EXPECT_EQ(session.light.center, opened.center + glm::vec3(0, 2, 0));
}

}  // namespace penumbra
