#include "map_checks.h"

namespace penumbra {

Rows makeRows(int count, const std::function<dvec4()>& row) {
    Rows rows;
    for (int i = 0; i < count; ++i) rows.emplace_back(row());
    return rows;
}

glm::dmat4 matrixFrom(const Image& image) {
    glm::dmat4 m;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) m[column][row] = image.at(column, row);
    return m;
}

Image interior(const TracedScene& truth, const Image& lightClipFromWorld, int mapSize,
               float texels) {
    Image mask = truth.edgeBand(glm::mat4(matrixFrom(lightClipFromWorld)), mapSize, texels);
    for (float& v : mask.pixels) v = 1.0f - v;
    return mask;
}

Scene lowLight() {
    Scene scene;
    scene.name = "low light";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(8.0f, 1, 0), box({1.5f, 0.0f, -0.5f}, {2.0f, 0.8f, 0.5f}, 0)};
    scene.lights = {Light::lookingAt({0.0f, 1.5f, 0.0f}, {2.0f, 0.9f, 0.0f}, 0.2f)};
    scene.camera = {.eye = {0.0f, 7.0f, 6.0f},
                    .target = {0.0f, 0.0f, 0.0f},
                    .verticalFov = 0.9f,
                    .nearPlane = 1.0f,
                    .farPlane = 30.0f};
    return scene;
}

Scene thinWall() {
    Scene scene;
    scene.name = "thin wall";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(6.0f, 1, 0), quad({-1.5f, 0.0f, 0.0f}, {1.5f, 0.0f, 0.0f},
                                             {1.5f, 1.2f, 0.0f}, {-1.5f, 1.2f, 0.0f}, 0)};
    scene.lights = {Light::lookingAt({1.0f, 6.0f, -5.0f}, {0.0f, 0.0f, 0.0f}, 0.5f)};
    scene.camera = {.eye = {0.5f, 3.0f, 4.5f},
                    .target = {0.0f, 0.2f, 0.0f},
                    .verticalFov = 0.7f,
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    return scene;
}

}  // namespace penumbra
