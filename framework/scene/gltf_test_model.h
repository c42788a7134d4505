// For tests: a small good model to break or to change, written without the code under test.
//
//   TestModel model;                               // a unit square, textured, with camera and
//   light model.root["nodes"][0]["mesh"] = 7; writeBytes(path, model.glb());
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/texture_file.h"

namespace penumbra {

inline void writeBytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

struct TestModel {
    using json = nlohmann::json;

    // Accessors 0 POSITION, 1 NORMAL, 2 TEXCOORD_0 of four vertices, 3 six 16-bit indices; buffer
    // view 4 is a PNG of 2 x 2 texels. Nodes 0 mesh, 1 camera, 2 light.
    TestModel() {
        root = json::parse(R"({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
            "nodes": [{"mesh": 0, "name": "square"},
                      {"camera": 0, "translation": [0, 0, 5]},
                      {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0, 0, 3]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2},
                                        "indices": 3, "material": 0}]}],
            "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1],
                           "baseColorTexture": {"index": 0}}, "alphaMode": "MASK", "alphaCutoff": 0.25}],
            "textures": [{"source": 0, "sampler": 0}], "samplers": [{}],
            "images": [{"bufferView": 4, "mimeType": "image/png"}],
            "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1, "zfar": 20}}],
            "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "extras": {"width": 0.75}}]}}
        })");
        addAccessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 5126, "VEC3", 4);
        addAccessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3", 4);
        addAccessor<float>({0, 0, 1, 0, 1, 1, 0, 1}, 5126, "VEC2", 4);
        addAccessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 6);
        const auto png =
            encodeTexture({2, 2, {255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 64, 9, 8, 7, 0}});
        addView(png.data(), png.size());
    }

    std::size_t addView(const void* data, std::size_t size) {
        binary.resize((binary.size() + 3) / 4 * 4);
        const std::size_t offset = binary.size();
        binary.append(static_cast<const char*>(data), size);
        root["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
        root["buffers"] = {{{"byteLength", binary.size()}}};
        return root["bufferViews"].size() - 1;
    }

    template <typename T>
    std::size_t addAccessor(const std::vector<T>& values, int componentType, const char* type,
                            std::size_t count) {
        const std::size_t view = addView(values.data(), values.size() * sizeof(T));
        root["accessors"].push_back({{"bufferView", view},
                                     {"componentType", componentType},
                                     {"type", type},
                                     {"count", count}});
        return root["accessors"].size() - 1;
    }

    json& primitive() { return root["meshes"][0]["primitives"][0]; }

    static std::string word(std::size_t value) {
        std::string bytes;
        for (int shift = 0; shift < 32; shift += 8) bytes += char(value >> shift);
        return bytes;
    }

    std::string glb() const {
        std::string text = root.dump(), body = binary;
        text.resize((text.size() + 3) / 4 * 4, ' ');
        body.resize((body.size() + 3) / 4 * 4);
        return "glTF" + word(2) + word(28 + text.size() + body.size()) + word(text.size()) +
               "JSON" + text + word(body.size()) + std::string("BIN\0", 4) + body;
    }

    json root;
    std::string binary;
};

}  // namespace penumbra
