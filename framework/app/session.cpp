#include "app/session.h"

#include "core/error.h"
#include "gl/context.h"
#include "scene/gallery.h"

namespace penumbra {

namespace fs = std::filesystem;

Session::Session(std::unique_ptr<Assignment> assignment, Layers layers)
    : assignment_(std::move(assignment)), shaders_(std::move(layers)) {
    assignment_->settings(settings_);
}

void Session::open(Scene scene) {
    EXPECTS(!scene.lights.empty());
    auto gpuScene = std::make_unique<GpuScene>(scene);  // if it throws, the old scene stays
    scene_ = std::move(scene);
    gpuScene_ = std::move(gpuScene);
    camera = scene_.camera;
    light = scene_.lights[0];
}

View Session::view(glm::ivec2 size) const {
    EXPECTS(gpuScene_);
    return {scene_, *gpuScene_, camera, light, size, settings_, shaders_};
}

Frame Session::render(glm::ivec2 size, std::optional<std::set<std::string>> wanted) {
    Frame frame(std::move(wanted));
    assignment_->render(view(size), frame);
    throwOnGlErrors();
    return frame;
}

Layers shaderLayers(const std::vector<fs::path>& variant) {
    EXPECTS(!variant.empty());
    std::vector<fs::path> folders = {repositoryRoot() / "framework/shaders"};
    folders.insert(folders.end(), variant.begin(), variant.end());
    folders.push_back(variant.front() / "given");
    return Layers(folders);
}

}  // namespace penumbra
