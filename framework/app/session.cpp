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
    if (!assignment_->takesDirectionalLights())
        for (Light& l : scene.lights) l.directional = false;
    auto gpuScene = std::make_unique<GpuScene>(scene);  // if it throws, the old scene stays
    opened_ = std::move(scene);
    scene_ = opened_;
    gpuScene_ = std::move(gpuScene);
    camera = scene_.camera;
    light = scene_.lights[0];
    arrangedWith_.clear();
    ++revision_;
    arrange();
}

// Camera and light stay where the viewer has dragged them unless the settings move them.
void Session::arrange() {
    std::vector<double> values;
    for (const Setting& s : settings_.all()) values.push_back(s.value);
    if (values == arrangedWith_) return;
    arrangedWith_ = std::move(values);
    Scene arranged = opened_;
    assignment_->arrange(settings_, arranged);
    EXPECTS(!arranged.lights.empty());
    const bool sameSurfaces = arranged.meshes == scene_.meshes &&
                              arranged.materials == scene_.materials &&
                              arranged.textures == scene_.textures;
    if (sameSurfaces && arranged.lights == scene_.lights && arranged.camera == scene_.camera)
        return;
    if (!sameSurfaces) gpuScene_ = std::make_unique<GpuScene>(arranged);
    if (arranged.camera != scene_.camera) camera = arranged.camera;
    if (arranged.lights[0] != scene_.lights[0]) light = arranged.lights[0];
    scene_ = std::move(arranged);
    ++revision_;
}

View Session::view(glm::ivec2 size) const {
    EXPECTS(gpuScene_);
    return {scene_, *gpuScene_, camera, light, size, settings_, shaders_, revision_, interactive};
}

Frame Session::render(glm::ivec2 size, std::optional<std::set<std::string>> wanted) {
    arrange();
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
