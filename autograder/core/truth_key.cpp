#include "core/truth_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace penumbra {

namespace {

// A product spreads a difference upwards alone; the shift brings it down again.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t word, std::uint64_t prime) {
    hash = (hash ^ word) * prime;
    return hash ^ (hash >> 32);
}

}  // namespace

void TruthKey::addBytes(const void* bytes, std::size_t count) {
    const auto* from = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < count; i += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, from + i, std::min(sizeof word, count - i));
        first_ = mixed(first_, word, 0x9e3779b97f4a7c15u);
        second_ = mixed(second_, word, 0xc2b2ae3d27d4eb4fu);
    }
}

void TruthKey::add(std::string_view text) {
    add(text.size());
    addBytes(text.data(), text.size());
}

// Below, structured bindings name every member: a new one does not compile until it is added here.

void TruthKey::add(const Image& image) {
    const auto& [width, height, channels, pixels] = image;
    add(width), add(height), add(channels), add(pixels);
}

void TruthKey::add(const Mesh& mesh) {
    const auto& [name, positions, normals, uvs, triangles, material] = mesh;
    add(name), add(positions), add(normals), add(uvs), add(triangles), add(material);
}

void TruthKey::add(const Material& material) {
    const auto& [name, baseColor, texture, alphaCutoff, emissive] = material;
    add(name), add(baseColor), add(texture), add(alphaCutoff), add(emissive);
}

void TruthKey::add(const Texture2D& texture) {
    const auto& [width, height, rgba] = texture;
    add(width), add(height), add(rgba);
}

void TruthKey::add(const Camera& camera) {
    const auto& [eye, target, up, verticalFov, nearPlane, farPlane] = camera;
    add(eye), add(target), add(up), add(verticalFov), add(nearPlane), add(farPlane);
}

void TruthKey::add(const Light& light) {
    const auto& [center, right, up, width, color, directional, range] = light;
    add(center), add(right), add(up), add(width), add(color), add(directional), add(range);
}

void TruthKey::add(const Scene& scene) {
    const auto& [name, meshes, materials, textures, camera, lights] = scene;
    add(name), add(meshes), add(materials), add(textures), add(camera), add(lights);
}

std::string TruthKey::text() const { return fmt::format("{:016x}{:016x}", first_, second_); }

}  // namespace penumbra
