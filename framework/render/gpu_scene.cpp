#include "render/gpu_scene.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "core/error.h"

namespace penumbra {

namespace {

constexpr int kMaterialBinding = 7;
constexpr int kBaseColorUnit = 7;

struct MaterialBlock {  // material.glsl
    glm::vec3 baseColor;
    float alphaCutoff;
    glm::vec3 emissive;
    float padding = 0;
};
static_assert(offsetof(MaterialBlock, alphaCutoff) == 12 &&
              offsetof(MaterialBlock, emissive) == 16 && sizeof(MaterialBlock) == 32);

template <typename T>
void uploadAttribute(GLuint buffer, GLuint index, const std::vector<T>& data) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, T::length(), GL_FLOAT, GL_FALSE, 0, nullptr);
}

}  // namespace

GpuScene::GpuScene(const Scene& scene) {
    std::vector<const Mesh*> meshes;
    for (const Mesh& mesh : scene.meshes) meshes.push_back(&mesh);
    const auto masked = [&](const Mesh* m) {
        return scene.materials[std::size_t(m->material)].alphaCutoff > 0;
    };
    std::stable_sort(meshes.begin(), meshes.end(), [&](const Mesh* a, const Mesh* b) {
        return std::pair(masked(a), a->material) < std::pair(masked(b), b->material);
    });

    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uvs;
    std::vector<glm::uvec3> triangles;
    for (const Mesh* mesh : meshes) {
        const auto base = unsigned(positions.size());
        const std::size_t first = triangles.size() * sizeof(glm::uvec3);
        positions.insert(positions.end(), mesh->positions.begin(), mesh->positions.end());
        normals.insert(normals.end(), mesh->normals.begin(), mesh->normals.end());
        uvs.insert(uvs.end(), mesh->uvs.begin(), mesh->uvs.end());
        normals.resize(positions.size());
        uvs.resize(positions.size());
        for (const glm::uvec3 t : mesh->triangles) triangles.push_back(t + base);
        const auto count = GLsizei(3 * mesh->triangles.size());
        if (!ranges_.empty() && ranges_.back().material == mesh->material)
            ranges_.back().count += count;
        else
            ranges_.push_back({mesh->material, count, first});
    }
    opaqueRanges_ = std::size_t(std::count_if(ranges_.begin(), ranges_.end(), [&](const Range& r) {
        return scene.materials[std::size_t(r.material)].alphaCutoff <= 0;
    }));

    glGenVertexArrays(1, &vertexArray_);
    glBindVertexArray(vertexArray_);
    glGenBuffers(4, buffers_);
    uploadAttribute(buffers_[0], 0, positions);
    uploadAttribute(buffers_[1], 1, normals);
    uploadAttribute(buffers_[2], 2, uvs);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[3]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(triangles.size() * sizeof(glm::uvec3)),
                 triangles.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);

    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &materialStride_);
    materialStride_ = std::max(materialStride_, GLint(sizeof(MaterialBlock)));
    std::vector<std::byte> blocks(scene.materials.size() * std::size_t(materialStride_));
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const MaterialBlock block{scene.materials[i].baseColor, scene.materials[i].alphaCutoff,
                                  scene.materials[i].emissive};
        std::memcpy(blocks.data() + i * std::size_t(materialStride_), &block, sizeof block);
        materialTextures_.push_back(scene.materials[i].texture + 1);
    }
    glGenBuffers(1, &materialBlock_);
    glBindBuffer(GL_UNIFORM_BUFFER, materialBlock_);
    glBufferData(GL_UNIFORM_BUFFER, GLsizeiptr(blocks.size()), blocks.data(), GL_STATIC_DRAW);

    const unsigned char white[4] = {255, 255, 255, 255};
    textures_.emplace_back(
        TextureDescription{.size = {1, 1}, .format = GL_SRGB8_ALPHA8, .label = "white"});
    textures_.back().uploadBytes(white);
    for (const Texture2D& t : scene.textures) {
        // Level 0 only, bilinear, repeated: what the ray tracer's alpha test reads too.
        textures_.emplace_back(TextureDescription{.size = {t.width, t.height},
                                                  .format = GL_SRGB8_ALPHA8,
                                                  .filter = GL_LINEAR,
                                                  .wrap = GL_REPEAT,
                                                  .label = "base colour"});
        textures_.back().uploadBytes(t.rgba.data());
    }
}

GpuScene::~GpuScene() {
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteBuffers(4, buffers_);
    glDeleteBuffers(1, &materialBlock_);
}

void GpuScene::drawRange(const Program& program, const Range& range) const {
    const auto material = std::size_t(range.material);
    glBindBufferRange(GL_UNIFORM_BUFFER, kMaterialBinding, materialBlock_,
                      GLintptr(material) * materialStride_, sizeof(MaterialBlock));
    program.texture("baseColorTexture", kBaseColorUnit,
                    textures_[std::size_t(materialTextures_[material])]);
    glDrawElements(GL_TRIANGLES, range.count, GL_UNSIGNED_INT,
                   reinterpret_cast<void*>(range.firstByte));
}

void GpuScene::draw(const Program& program) const {
    program.use();
    program.block("Material", kMaterialBinding);
    glBindVertexArray(vertexArray_);
    for (const Range& range : ranges_) drawRange(program, range);
}

void GpuScene::drawDepth(const Program& opaque, const Program& masked) const {
    glBindVertexArray(vertexArray_);
    GLsizei opaqueIndices = 0;
    for (std::size_t i = 0; i < opaqueRanges_; ++i) opaqueIndices += ranges_[i].count;
    opaque.use();
    if (opaqueIndices > 0) glDrawElements(GL_TRIANGLES, opaqueIndices, GL_UNSIGNED_INT, nullptr);
    if (opaqueRanges_ == ranges_.size()) return;
    masked.use();
    masked.block("Material", kMaterialBinding);
    for (std::size_t i = opaqueRanges_; i < ranges_.size(); ++i) drawRange(masked, ranges_[i]);
}

}  // namespace penumbra
