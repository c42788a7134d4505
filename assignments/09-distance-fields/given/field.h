// The distance field of what can block, in a texture; the dials as the shaders read them, and the
// chunks that they choose.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "gl/volume_texture.h"
#include "render/frame.h"
#include "truth/distance_field.h"

namespace penumbra {

struct FieldBlock {  // field.glsl
    glm::vec3 lower;
    float cell;
    glm::vec3 upper;
    float normalOffset;
    float k, stepCap, smallestStep;
    int maxSteps;
    glm::vec3 blockersLower;
    float sliceY;
    glm::vec3 blockersUpper;
    float padding = 0;
};
static_assert(offsetof(FieldBlock, upper) == 16 && offsetof(FieldBlock, k) == 32 &&
              offsetof(FieldBlock, blockersLower) == 48 &&
              offsetof(FieldBlock, blockersUpper) == 64);

// Made when the scene changes, or the light moves so that other meshes can block; from the cache on
// disk where it holds the field.
class BlockerField {
public:
    void prepare(const View& view, int voxels);
    const DistanceGrid& grid() const { return grid_; }
    const Box& box() const { return box_; }  // of the blockers, with their skin
    const VolumeTexture& texture() const { return texture_; }
    // How far open meshes are blown up at their outlines, since they have no inside; 0: there are
    // none.
    float skin() const { return skin_; }
    // What a person who looks at the picture should know of it.
    const std::vector<std::string>& notes() const { return notes_; }

private:
    void make(std::span<const Mesh> closedMeshes, std::span<const Mesh> openMeshes);
    void makeEmpty(const Scene& scene);

    long revision_ = -1;
    Light light_;
    int voxels_ = 0;
    std::vector<std::string> blockers_;  // names
    DistanceGrid grid_;
    Box box_;
    float skin_ = 0;
    VolumeTexture texture_;
    std::vector<std::string> notes_;
};

FieldBlock fieldBlock(const Settings& settings, const BlockerField& field);

// One form of every function that the given chunks declare.
std::vector<std::string> chunksFor(const Settings& settings);

}  // namespace penumbra
