#include "variance_checks.h"

namespace penumbra {

void BoxSums::add(int x, int y, double value) {
    const double sum = value + at(x, y + 1) + at(x + 1, y) - at(x, y);
    sums_.push_back(sum);
    largest_ = std::max(largest_, std::abs(sum));
}

double BoxSums::at(int x, int y) const {
    return x > 0 && y > 0 ? sums_[std::size_t(y - 1) * std::size_t(width_) + std::size_t(x - 1)]
                          : 0;
}

double BoxSums::at(dvec2 corner) const {
    corner = glm::clamp(corner, dvec2(0), dvec2(width_, height_));
    const int x = std::min(int(corner.x), width_ - 1), y = std::min(int(corner.y), height_ - 1);
    return glm::mix(glm::mix(at(x, y), at(x + 1, y), corner.x - x),
                    glm::mix(at(x, y + 1), at(x + 1, y + 1), corner.x - x), corner.y - y);
}

double BoxSums::operator()(dvec2 low, dvec2 high) const {
    return at(high) - at(dvec2(low.x, high.y)) - at(dvec2(high.x, low.y)) + at(low);
}

dvec2 DepthBoxes::meanVariance(dvec2 centerUv, dvec2 widthUv) const {
    const dvec2 low = (centerUv - 0.5 * widthUv) * double(size),
                high = low + widthUv * double(size);
    const dvec2 inside = glm::clamp(high, 0.0, double(size)) - glm::clamp(low, 0.0, double(size));
    const double area = (high.x - low.x) * (high.y - low.y);
    const double beyond = area - inside.x * inside.y;
    const double mean = (depths(low, high) + beyond) / area;
    return {mean, std::max((squares(low, high) + beyond) / area - mean * mean, 0.0)};
}

namespace {

Mesh plate(vec2 low, vec2 high, float height, float slope = 0.0f) {
    const float left = height + slope * low.x, right = height + slope * high.x;
    return quad({low.x, left, low.y}, {low.x, left, high.y}, {high.x, right, high.y},
                {high.x, right, low.y}, 0);
}

}  // namespace

Scene platesScene(float groundSlope) {
    Scene scene;
    scene.name = "plates";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {plate({-6, -6}, {6, 6}, 0.0f, groundSlope), plate({-12, -12}, {0, 12}, 4.0f),
                    plate({0.2f, -12}, {2, 0}, 2.0f)};
    Light light;
    light.center = {0.0f, 8.0f, 0.0f};
    light.width = 1.5f;
    scene.lights = {light};
    scene.camera = {.eye = {3.5f, 3.4f, 2.5f},
                    .target = {0.4f, 0.0f, 0.0f},
                    .verticalFov = 0.8f,
                    .nearPlane = 0.5f,
                    .farPlane = 30.0f};
    return scene;
}

LightView::LightView(const Image& lightClipFromWorld, const Light& light) {
    glm::dmat4 m;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            m[column][row] = lightClipFromWorld.at(column, row);
    const glm::dmat4 p = m * glm::inverse(glm::dmat4(light.viewFromWorld()));
    nearPlane = p[3][2] / (p[2][2] - 1), farPlane = p[3][2] / (p[2][2] + 1);
    tangents = {2 / p[0][0], 2 / p[1][1]};
    scaleUv = double(light.width) * (1 / nearPlane - 1 / farPlane) / tangents;
}

double LightView::bias(double depth, double texels, int mapSize) const {
    const double range = 1 / nearPlane - 1 / farPlane, inverse = 1 / nearPlane - depth * range;
    return texels * std::max(tangents.x, tangents.y) / mapSize * inverse / range;
}

}  // namespace penumbra
