// An assignment's program at work: its variant's folders, its settings, one scene on the GPU.
//
//   Session session(makeAssignment(), layers);       // needs a current GL context
//   session.open(loadScene("fence"));
//   session.settings().assign("map_size=512");
//   Frame frame = session.render({512, 512}, {{"visibility"}});
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "app/assignment.h"
#include "core/layers.h"

namespace penumbra {

class Session {
public:
    Session(std::unique_ptr<Assignment> assignment, Layers layers);

    void open(Scene scene);  // camera and light become the scene's, as the settings arrange it
    void openDefault() { open(assignment_->scene()); }

    // Throws Error when a shader has no good form yet. The frame's textures live until the next
    // call.
    Frame render(glm::ivec2 size, std::optional<std::set<std::string>> wanted = std::nullopt);
    // The floor of the same view (render/passes.h).
    View view(glm::ivec2 size) const;

    Assignment& assignment() { return *assignment_; }
    Settings& settings() { return settings_; }
    ShaderLibrary& shaders() { return shaders_; }
    const Scene& scene() const { return scene_; }  // as last rendered
    long revision() const { return revision_; }    // of the scene: grows when it changes

    Camera camera;
    Light light;
    bool interactive = false;  // View::interactive

private:
    void arrange();

    std::unique_ptr<Assignment> assignment_;
    Settings settings_;
    mutable ShaderLibrary shaders_;
    Scene opened_, scene_;              // as opened, and as the settings arrange it
    std::vector<double> arrangedWith_;  // the settings' values
    long revision_ = 0;
    std::unique_ptr<GpuScene> gpuScene_;
};

// framework/shaders, the variant's folders in order, and given/ of the first of them on top: what
// is given is never replaced.
Layers shaderLayers(const std::vector<std::filesystem::path>& variant);

}  // namespace penumbra
