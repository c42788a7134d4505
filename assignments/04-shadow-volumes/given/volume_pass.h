// Draws a light's shadow volumes: into the stencil buffer, into a float target and from there into
// the stencil buffer, or translucent over the picture.
//
//   volumes.prepare(view, clipFromWorld);            // once a frame
//   volumes.count(view, 0, light, targets);          // stencil: not 0 where the light is blocked
//   Image counts = volumes.counts(view, targets);    // of the last light counted
#pragma once

#include "passes_as_data.h"
#include "render/passes.h"
#include "scene_volumes.h"
#include "volume_culling.h"

namespace penumbra {

class VolumePass {
public:
    VolumePass();
    ~VolumePass();
    VolumePass(const VolumePass&) = delete;
    VolumePass& operator=(const VolumePass&) = delete;

    void prepare(const View& view, const glm::mat4& clipFromWorld);
    // The blocks Camera and Light are uploaded; `bindBlocks` binds them to a program.
    using BindBlocks = std::function<void(const Program&)>;
    void count(const View& view, std::size_t index, const Light& light,
               const CameraTargets& targets, const BindBlocks& bindBlocks);
    // Over the picture: the volumes, translucent; the edges whose sum is not 0.
    void showVolumes(const View& view, std::size_t index, const Light& light,
                     const CameraTargets& targets, const BindBlocks& bindBlocks);
    void showSilhouettes(const View& view, std::size_t index, const Light& light,
                         const CameraTargets& targets, const BindBlocks& bindBlocks);
    Image counts(const View& view, const CameraTargets& targets) const;

    // What is worth knowing about the key light's casters, if anything.
    void addNotes(const View& view, Frame& frame) const;
    // The lists of image names that start with the light's volumes; see the handout's table.
    void handOverLists(const View& view, Frame& frame);

    PixelRectangle reach(const Light& light) const { return culling_->reach(light); }

private:
    std::vector<LightVolumes::Part> parts(const View& view, const Light& light) const;
    LightVolumes& volumesOf(const View& view, std::size_t index, const Light& light);
    void countInFloat(const View& view, const StencilCounting& counting, LightVolumes& volumes,
                      const std::vector<LightVolumes::Part>& parts, const CameraTargets& targets,
                      const BindBlocks& bindBlocks);

    std::unique_ptr<SceneVolumes> volumes_;
    std::unique_ptr<VolumeCulling> culling_;
    long revision_ = -1;  // of the scene that volumes_ were made for
    Texture floatCounts_;
    GLuint emptyVertexArray_ = 0;
};

}  // namespace penumbra
