// Broken files end in one clear line, never in a crash or in memory without bounds.
#include <functional>

#include "scene/gltf_broken.h"

namespace penumbra {
namespace {

using json = nlohmann::json;

struct BrokenModel {
    const char* name;
    std::function<void(TestModel&)> breakIt;
    const char* error;
};

json nested(int depth) {
    json value = 1;
    for (int i = 0; i < depth; ++i) value = json::array({std::move(value)});
    return value;
}

const std::vector<BrokenModel>& brokenModels() {
    static const std::vector<BrokenModel> models = {
        // the tree
        {"version 1", [](auto& m) { m.root["asset"]["version"] = "1.0"; }, "asset has version 1.0"},
        {"no asset", [](auto& m) { m.root.erase("asset"); }, "has no asset"},
        {"nodes is a number", [](auto& m) { m.root["nodes"] = 3; }, "nodes is not an array"},
        {"node is a text", [](auto& m) { m.root["nodes"][0] = "x"; }, "nodes[0] is not an object"},
        {"root node out of range", [](auto& m) { m.root["scenes"][0]["nodes"] = {9}; },
         "scenes[0].nodes[0] is 9, but the file has 3"},
        {"scene out of range", [](auto& m) { m.root["scene"] = 1; },
         "scene is 1, but the file has 1"},
        {"child out of range", [](auto& m) { m.root["nodes"][0]["children"] = {-1}; },
         "nodes[0].children[0] is -1"},
        {"node is its own child", [](auto& m) { m.root["nodes"][0]["children"] = {0}; }, "cycle"},
        {"cycle of two",
         [](auto& m) {
             m.root["nodes"][0]["children"] = {1};
             m.root["nodes"][1]["children"] = {0};
         },
         "cycle"},
        {"node with two parents",
         [](auto& m) {
             m.root["nodes"][0]["children"] = {2};
             m.root["nodes"][1]["children"] = {2};
         },
         "child twice"},
        {"child is a root too", [](auto& m) { m.root["nodes"][0]["children"] = {2}; },
         "used twice"},
        {"root listed twice",
         [](auto& m) {
             m.root["scenes"][0]["nodes"] = {0, 0};
         },
         "used twice"},
        {"deep JSON", [](auto& m) { m.root["extras"] = nested(500); }, "nested too deep"},
        // transforms
        {"short matrix",
         [](auto& m) {
             m.root["nodes"][0]["matrix"] = {1, 2, 3};
         },
         "nodes[0].matrix has 3 values instead of 16"},
        {"projective matrix",
         [](auto& m) {
             m.root["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
         },
         "nodes[0].matrix is not affine"},
        {"null in translation",
         [](auto& m) {
             m.root["nodes"][0]["translation"] = {0, nullptr, 0};
         },
         "nodes[0].translation[1] is not a number"},
        {"zero rotation",
         [](auto& m) {
             m.root["nodes"][0]["rotation"] = {0, 0, 0, 0};
         },
         "rotation is not a unit quaternion"},
        {"scales beyond range",
         [](auto& m) {
             m.root["nodes"][0]["scale"] = {1e300, 1, 1};
             m.root["nodes"][0]["children"] = {3};
             m.root["nodes"].push_back({{"scale", {1e300, 1, 1}}});
         },
         "nodes[3] has a transform that is not finite"},
        {"moved out of the world",
         [](auto& m) {
             m.root["nodes"][0]["translation"] = {1e12, 0, 0};
         },
         "farther than 1e9"},
        {"flat light node",
         [](auto& m) {
             m.root["nodes"][2]["scale"] = {1, 1, 0};
         },
         "nodes[2] carries a camera or light, but its transform is flat"},
        // meshes
        {"mesh out of range", [](auto& m) { m.root["nodes"][0]["mesh"] = 7; },
         "nodes[0].mesh is 7, but the file has 1"},
        {"mesh is a fraction", [](auto& m) { m.root["nodes"][0]["mesh"] = 0.5; },
         "nodes[0].mesh is 0.5"},
        {"no primitives", [](auto& m) { m.root["meshes"][0].erase("primitives"); },
         "meshes[0] has no primitives"},
        {"no positions", [](auto& m) { m.primitive()["attributes"].erase("POSITION"); },
         "attributes has no POSITION"},
        {"no triangles at all", [](auto& m) { m.root["nodes"][0].erase("mesh"); },
         "has no triangles"},
        {"points only", [](auto& m) { m.primitive()["mode"] = 0; }, "has no triangles"},
        {"unknown mode", [](auto& m) { m.primitive()["mode"] = 7; }, "has mode 7"},
        {"material out of range", [](auto& m) { m.primitive()["material"] = 1; },
         "primitives[0].material is 1, but the file has 1"},
        {"accessor out of range", [](auto& m) { m.primitive()["indices"] = 4; },
         "primitives[0].indices is 4, but the file has 4"},
        {"index out of range", [](auto& m) { m.binary[96 + 32 + 10] = 4; },
         "holds index 4, but there are 4"},
        {"five indices", [](auto& m) { m.root["accessors"][3]["count"] = 5; },
         "no whole triangles"},
        {"other number of normals", [](auto& m) { m.root["accessors"][1]["count"] = 3; },
         "NORMAL has 3 vertices, POSITION 4"},
        {"infinite position", [](auto& m) { std::memcpy(m.binary.data() + 4, "\0\0\x80\x7f", 4); },
         "accessors[0] holds a value that is not finite"},
        {"NaN normal", [](auto& m) { std::memcpy(m.binary.data() + 52, "\0\0\xc0\x7f", 4); },
         "accessors[1] holds a value that is not finite"},
        // accessors, views and buffers
        {"unknown component type", [](auto& m) { m.root["accessors"][0]["componentType"] = 5124; },
         "accessors[0].componentType is 5124"},
        {"float indices", [](auto& m) { m.primitive()["indices"] = 0; }, "no SCALAR"},
        {"signed indices", [](auto& m) { m.root["accessors"][3]["componentType"] = 5122; },
         "indices are unsigned"},
        {"positions of two components", [](auto& m) { m.root["accessors"][0]["type"] = "VEC2"; },
         "has 2 components, 3 are needed"},
        {"unknown type", [](auto& m) { m.root["accessors"][0]["type"] = "VEC9"; }, "is VEC9"},
        {"count of zero", [](auto& m) { m.root["accessors"][0]["count"] = 0; }, "count is 0"},
        {"count too large", [](auto& m) { m.root["accessors"][0]["count"] = 5; },
         "needs 5 elements"},
        {"count that overflows", [](auto& m) { m.root["accessors"][0]["count"] = 1e15; }, "needs "},
        {"count beyond all numbers", [](auto& m) { m.root["accessors"][0]["count"] = 1e300; },
         "not a whole number"},
        {"accessor offset past the view", [](auto& m) { m.root["accessors"][0]["byteOffset"] = 4; },
         "needs 4 elements"},
        {"stride below the element", [](auto& m) { m.root["bufferViews"][0]["byteStride"] = 4; },
         "byteStride of 4"},
        {"stride past the view", [](auto& m) { m.root["bufferViews"][0]["byteStride"] = 252; },
         "needs 4 elements"},
        {"zero-filled without end",
         [](auto& m) {
             m.root["accessors"][0].erase("bufferView");
             m.root["accessors"][0]["count"] = 1e12;
             m.root["accessors"][0]["sparse"] = {{"count", 1}};
         },
         "has a count of 1000000000000"},
        {"accessor without bytes", [](auto& m) { m.root["accessors"][0].erase("bufferView"); },
         "has no bufferView"},
        {"view out of range", [](auto& m) { m.root["accessors"][0]["bufferView"] = 5; },
         "bufferView is 5, but the file has 5"},
        {"view past its buffer", [](auto& m) { m.root["bufferViews"][0]["byteOffset"] = 100000; },
         "bufferViews[0] spans bytes 100000"},
        {"view length that overflows",
         [](auto& m) { m.root["bufferViews"][0]["byteLength"] = 9007199254740992.0; },
         "spans bytes"},
        {"buffer out of range", [](auto& m) { m.root["bufferViews"][0]["buffer"] = 1; },
         "buffer is 1, but the file has 1"},
        {"buffer larger than its bytes", [](auto& m) { m.root["buffers"][0]["byteLength"] = 1e9; },
         "buffers[0] declares 1000000000 bytes"},
        {"second buffer without bytes",
         [](auto& m) {
             m.root["buffers"].push_back({{"byteLength", 4}});
         },
         "neither a uri nor a binary chunk"},
        {"bad base64", [](auto& m) { m.root["buffers"][0]["uri"] = "data:x;base64,A*"; },
         "not base64"},
        // materials and pictures
        {"texture out of range",
         [](auto& m) {
             m.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 3;
         },
         "baseColorTexture.index is 3"},
        {"image out of range", [](auto& m) { m.root["textures"][0]["source"] = 2; },
         "textures[0].source is 2"},
        {"sampler out of range", [](auto& m) { m.root["textures"][0]["sampler"] = 1; },
         "textures[0].sampler is 1"},
        {"picture that is none", [](auto& m) { m.root["images"][0]["bufferView"] = 0; },
         "not a PNG or JPEG picture"},
        {"picture cut short", [](auto& m) { m.root["bufferViews"][4]["byteLength"] = 45; },
         "images[0] of"},
        {"picture of 2^31 pixels",
         [](auto& m) {
             const std::size_t png = m.root["bufferViews"][4]["byteOffset"];
             m.binary[png + 16] = m.binary[png + 20] = 0x7f;  // IHDR's width and height
         },
         "images[0] of"},
        {"color of two",
         [](auto& m) {
             m.root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 2};
         },
         "baseColorFactor has 2 values"},
        {"negative color",
         [](auto& m) {
             m.root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {-1, 0, 0, 1};
         },
         "baseColorFactor out of range"},
        {"emission of two",
         [](auto& m) {
             m.root["materials"][0]["emissiveFactor"] = {1, 2};
         },
         "emissiveFactor has 2 values"},
        {"negative emission",
         [](auto& m) {
             m.root["materials"][0]["emissiveFactor"] = {0, -1, 0};
         },
         "emissiveFactor out of range"},
        {"emission without bound",
         [](auto& m) {
             auto& material = m.root["materials"][0];
             material["emissiveFactor"] = {1, 1, 1};
             material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 1e300;
         },
         "emissiveFactor out of range"},
        {"alpha mode", [](auto& m) { m.root["materials"][0]["alphaMode"] = "HOLES"; },
         "alphaMode HOLES"},
        // cameras and lights
        {"camera out of range", [](auto& m) { m.root["nodes"][1]["camera"] = 1; },
         "nodes[1].camera is 1"},
        {"camera type", [](auto& m) { m.root["cameras"][0]["type"] = "fisheye"; },
         "has type fisheye"},
        {"flat field of view", [](auto& m) { m.root["cameras"][0]["perspective"]["yfov"] = 3.2; },
         "yfov"},
        {"near plane at zero", [](auto& m) { m.root["cameras"][0]["perspective"]["znear"] = 0; },
         "znear"},
        {"far before near", [](auto& m) { m.root["cameras"][0]["perspective"]["zfar"] = 0.05; },
         "zfar"},
        {"light out of range",
         [](auto& m) { m.root["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = 1; },
         "light is 1, but the file has 1"},
        {"no lights", [](auto& m) { m.root.erase("extensions"); }, "has no extensions"},
        {"light type",
         [](auto& m) { m.root["extensions"]["KHR_lights_punctual"]["lights"][0]["type"] = "neon"; },
         "has type neon"},
        {"light without width",
         [](auto& m) {
             m.root["extensions"]["KHR_lights_punctual"]["lights"][0]["extras"]["width"] = 0;
         },
         "width is not a width above 0"},
        {"light without range",
         [](auto& m) { m.root["extensions"]["KHR_lights_punctual"]["lights"][0]["range"] = 0; },
         "range is not a range above 0"},
        {"range that is a text",
         [](auto& m) { m.root["extensions"]["KHR_lights_punctual"]["lights"][0]["range"] = "far"; },
         "range is not a number"},
        // what is not supported says so
        {"Draco", [](auto& m) { m.root["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "KHR_draco_mesh_compression, which is not supported"},
        {"meshopt", [](auto& m) { m.root["extensionsRequired"] = {"EXT_meshopt_compression"}; },
         "EXT_meshopt_compression, which is not supported"},
        // files that are not the model's own
        {"web address",
         [](auto& m) {
             m.root["images"][0] = {{"uri", "https://x.org/a.png"}};
         },
         "outside the model's folder"},
        {"file address",
         [](auto& m) {
             m.root["images"][0] = {{"uri", "file:///etc/passwd"}};
         },
         "outside the model's folder"},
        {"absolute path", [](auto& m) { m.root["buffers"][0]["uri"] = "/etc/passwd"; },
         "outside the model's folder"},
        {"way up", [](auto& m) { m.root["buffers"][0]["uri"] = "../../../../etc/passwd"; },
         "outside the model's folder"},
        {"way up in disguise",
         [](auto& m) { m.root["buffers"][0]["uri"] = "a/%2e%2e/%2E%2E/x.bin"; },
         "outside the model's folder"},
        {"folder as file", [](auto& m) { m.root["buffers"][0]["uri"] = "."; }, "not a file"},
        {"missing buffer file", [](auto& m) { m.root["buffers"][0]["uri"] = "gone.bin"; },
         "no such file"},
    };
    return models;
}

TEST(BrokenGltf, TheModelThatIsBrokenHereIsGoodItself) {
    EXPECT_EQ(errorOf(TestModel().glb()), "no error");
}

TEST(BrokenGltf, EveryBreakIsNamedInOneLine) {
    for (const BrokenModel& broken : brokenModels()) {
        TestModel model;
        broken.breakIt(model);
        expectError(errorOf(model.glb()), broken.error, broken.name);
    }
}

}  // namespace
}  // namespace penumbra
