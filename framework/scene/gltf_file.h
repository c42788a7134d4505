// The container of a glTF model: JSON plus buffers, read with distrust. Everything about sizes is
// settled here, so that nobody downstream touches a byte that is not there.
//
//   GltfFile file = openGltf("chair.glb");
//   GltfValue nodes = file.list("nodes");
//   std::vector<float> xyz = file.floats(accessorIndex, 3);
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "scene/gltf_value.h"

namespace penumbra {

class GltfFile {
public:
    GltfValue root() const { return GltfValue(json_, "", name_); }
    GltfValue list(const char* key) const;  // a top-level array; empty if missing
    GltfValue item(const char* key, std::size_t i) const { return list(key).item(i); }

    std::span<const std::uint8_t> bufferView(std::size_t index) const;
    // An image's encoded bytes (PNG or JPEG), from its buffer view, data URI or file.
    std::vector<std::uint8_t> imageBytes(std::size_t index) const;

    // An accessor's values; floats() converts (normalized) integers and applies sparse
    // replacements.
    std::size_t accessorCount(std::size_t accessor) const;
    std::vector<float> floats(std::size_t accessor, int components) const;
    std::vector<std::uint32_t> indices(std::size_t accessor) const;

    std::filesystem::path path;

private:
    friend GltfFile openGltf(const std::filesystem::path& path);
    std::vector<std::uint8_t> uriBytes(const GltfValue& uri) const;

    std::string name_;  // of the file, for messages
    nlohmann::json json_;
    std::vector<std::vector<std::uint8_t>> buffers_;
};

// Throws Error for a missing or cut file, bad JSON, an extension that is required and unknown, a
// buffer that is shorter than declared, a URI that leaves the model's folder.
GltfFile openGltf(const std::filesystem::path& path);

}  // namespace penumbra
