// The distance field of what can block, in a texture; the dials as the shaders read them, and the
// chunks that they choose.
#pragma once

#include <cstddef>
#include <future>
#include <memory>
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
// disk where it holds the field. A fine field of a large model takes a minute or two: in the window
// it is made beside, and nothing casts a shadow until it is done.
class BlockerField {
public:
    ~BlockerField();

    void prepare(const View& view, int voxels);
    const DistanceGrid& grid() const { return field_.grid; }
    const Box& box() const { return field_.box; }  // of the blockers, with their skin
    const VolumeTexture& texture() const { return texture_; }
    // How far open meshes are blown up at their outlines, since they have no inside; 0: there are
    // none.
    float skin() const { return field_.skin; }
    // What a person who looks at the picture should know of it.
    const std::vector<std::string>& notes() const { return field_.notes; }
    // How far the field is that is being made; null: none is.
    const std::shared_ptr<Progress>& work() const { return work_; }

    struct Field {
        DistanceGrid grid;
        Box box;
        float skin = 0;
        std::vector<float> values;  // of the grid's voxels; empty once it is in the texture
        std::vector<std::string> notes;
    };

private:
    void start(std::vector<Mesh> blockers, bool interactive);
    void cancel();
    void take(Field field);

    long revision_ = -1;
    Light light_;
    int voxels_ = 0;
    std::vector<std::string> blockers_;  // names
    Field field_;
    VolumeTexture texture_;
    std::shared_ptr<Progress> work_;
    std::future<Field> made_;  // valid while work_ is not null
};

FieldBlock fieldBlock(const Settings& settings, const BlockerField& field);

// One form of every function that the given chunks declare.
std::vector<std::string> chunksFor(const Settings& settings);

}  // namespace penumbra
