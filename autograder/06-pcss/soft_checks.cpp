#include "soft_checks.h"

#include "truth/closed_form.h"

namespace penumbra {

void expectHorizonOnly(const Scene& scene, const std::vector<std::string>& settings) {
    const Receivers receivers = TracedScene(scene, kSmall).receivers();
    Image truth(kSmall.x, kSmall.y, 1, 1.0f);
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        if (receivers.hit[i])
            truth.pixels[i] = float(horizonVisibility(receivers.positions[i],
                                                      receivers.facetNormals[i], scene.lights[0]));
    const Rendered frame =
        render({.scene = sceneFile(scene), .size = kSmall, .settings = settings});
    EXPECT_IMAGE_NEAR(
        frame.at("visibility"), truth,
        {.outliers = 0,
         .outlierDistance = 0.1,
         .cause = scene.name + ": nothing stands before this plane; 8 x 8 samples cut by "
                               "its horizon are good to 1/16"});
}

Scene settingLight() {
    Scene scene;
    scene.name = "setting light";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(6.0f, 1, 0)};
    scene.lights = {Light::lookingAt({1.0f, 0.5f, -6.0f}, {0.0f, -0.5f, 0.0f}, 3.0f)};
    scene.camera = {.eye = {0.0f, 4.0f, 6.0f},
                    .target = {0.0f, -0.2f, 0.0f},
                    .verticalFov = 0.8f,
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    return scene;
}

double halfPlaneError(int searchSamples, int filterSamples, std::vector<std::string> settings) {
    const Receivers receivers = TracedScene(loadScene("halfplane"), kSmall).receivers();
    settings.push_back("search_samples=" + std::to_string(searchSamples));
    settings.push_back("filter_samples=" + std::to_string(filterSamples));
    const Rendered frame = render({.scene = "halfplane", .size = kSmall, .settings = settings});
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < receivers.positions.size(); ++i) {
        const vec3 p = receivers.positions[i];
        if (!receivers.hit[i] || p.y > 0.01f) continue;
        const double error = frame.at("visibility").pixels[i] -
                             halfPlaneVisibility(p.x, kHalfPlaneBlockerHeight,
                                                 kHalfPlaneLightHeight, kHalfPlaneLightWidth);
        sum += error * error, count += 1;
    }
    return std::sqrt(sum / count);
}

}  // namespace penumbra
