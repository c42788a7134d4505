// What goes into a technique's render() and what comes out of it.
//
//   void render(const View& view, Frame& frame) {
//       { auto timing = frame.time("light"); … draw the shadow map … }
//       frame.output("visibility", visibilityTexture);
//       if (frame.wants("shadow_map")) frame.output("shadow_map", shadowMap);
//   }
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/image.h"
#include "core/progress.h"
#include "core/settings.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/timer.h"
#include "render/gpu_scene.h"
#include "scene/scene.h"

namespace penumbra {

// All that a technique may look at. Everything lives at least until render() returns.
struct View {
    const Scene& scene;
    const GpuScene& gpuScene;  // the same triangles in buffers
    const Camera& camera;
    const Light& light;  // scene.lights[0], or where the viewer has dragged it
    glm::ivec2 size;     // of the camera's images, pixels
    const Settings& settings;
    ShaderLibrary& shaders;  // programs from the variant's folders, reloaded on save
    long revision;           // of the scene: grows when it changes; what was made of it can be kept
    // A person is waiting: render() should not take seconds, see Frame::unfinished().
    bool interactive = false;
};

// Named float images and named times.
class Frame {
public:
    // Nobody asked: every image is wanted. Otherwise only those named.
    explicit Frame(std::optional<std::set<std::string>> wanted = std::nullopt)
        : wanted_(std::move(wanted)) {}

    // A pass runs only if something reads its result: ask before drawing what nobody may look at.
    bool wants(const std::string& name) const { return !wanted_ || wanted_->count(name) > 0; }

    // `texture` must stay alive and unchanged until the frame is read.
    void output(const std::string& name, const Texture& texture) { textures_[name] = &texture; }
    // Results that were computed on the CPU: a matrix is a 4x4 image, row by row.
    void output(const std::string& name, Image image) { images_[name] = std::move(image); }

    // Times everything until the returned timer is destroyed; two timings of one name add up.
    Times::Span time(const std::string& pass) { return times_.time(pass); }

    // What a person who looks at this frame should know: "mesh net has an alpha mask: its holes
    // cast shadow, too". One line; shown beside the picture and in frame.json.
    void note(std::string line) { notes_.push_back(std::move(line)); }

    // Part of this frame is still being made on another thread: the window shows how far it is, and
    // asks for the frame again when it is done. Only where view.interactive.
    void unfinished(std::shared_ptr<const Progress> work) { unfinished_ = std::move(work); }

    const std::vector<std::string>& notes() const { return notes_; }
    const std::shared_ptr<const Progress>& unfinished() const { return unfinished_; }
    const std::map<std::string, const Texture*>& textures() const { return textures_; }
    const std::map<std::string, Image>& images() const { return images_; }
    // Waits for a GPU: after the frame.
    const std::map<std::string, double>& milliseconds() const { return times_.milliseconds(); }

    // Reads back every wanted image. Throws Error if a wanted name was not handed over.
    std::map<std::string, Image> read() const;

private:
    std::optional<std::set<std::string>> wanted_;
    std::map<std::string, const Texture*> textures_;
    std::map<std::string, Image> images_;
    Times times_;
    std::vector<std::string> notes_;
    std::shared_ptr<const Progress> unfinished_;
};

}  // namespace penumbra
