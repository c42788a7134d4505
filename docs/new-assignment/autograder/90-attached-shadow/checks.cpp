// Truth: a formula for the function alone, rays for the picture. A lone convex solid casts no
// shadow on itself: what is dark there is attached shadow.
#include "core/checks.h"
#include "core/truths.h"
#include "scene/shapes.h"

namespace penumbra {

namespace {

TEST(Task1AttachedShadow, TheSideOfThePlaneDecides) {
    std::vector<glm::vec4> facets, toLights, truth;
    for (const float height : {-3.0f, -0.25f, 0.0f, 0.25f, 3.0f}) {  // over the plane y = 0
        facets.push_back({0, 1, 0, 0});
        toLights.push_back({1, height, 2, 0});
        truth.push_back(glm::vec4(height > 0 ? 1 : 0));
    }
    const auto mine = evaluate({.chunk = "facing.glsl",
                                .expression = "vec4(facingVisibility(a.xyz, b.xyz))",
                                .inputs = {{"a", facets}, {"b", toLights}}});
    EXPECT_ROWS_NEAR(mine, truth, {.cause = "0 and 1 are exact in every float format"});
}

TEST(Task1AttachedShadow, ALoneBoxIsDarkWhereItFacesAway) {
    Scene scene;
    scene.materials.resize(1);
    scene.meshes = {box({-1, 0, -1}, {1, 2, 1}, 0)};
    scene.camera = {.eye = {4, 5, 6}, .target = {0, 1, 0}};
    scene.lights = {Light::lookingAt({-3, 6, 4}, {0, 1, 0}, 1.0f)};
    const glm::ivec2 size(256);
    const Image truth = TracedScene(scene, size).pointVisibility();
    const Rendered frame = render({.scene = sceneFile(scene), .size = size});
    EXPECT_IMAGE_NEAR(frame.at("visibility"), truth,
                      {.outliers = 0.005,
                       .cause = "pixels cut by the box's edges, about 300 of 65536, may show "
                                "the facet beside"});
}

}  // namespace

}  // namespace penumbra
