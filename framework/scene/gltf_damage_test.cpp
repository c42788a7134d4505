// Damaged files: cut, flipped, filled with strange numbers. They load or throw Error, nothing else.
#include "scene/gltf_broken.h"
#include "scene/random.h"

namespace penumbra {
namespace {

using json = nlohmann::json;

TEST(BrokenGltf, ContainersAreCheckedBeforeTheirContent) {
    const std::string good = TestModel().glb();
    const auto patched = [&](std::size_t offset, std::size_t value) {
        std::string bytes = good;
        return bytes.replace(offset, 4, TestModel::word(value));
    };
    expectError(errorOf(""), "not a glTF model", "empty file");
    expectError(errorOf("solid cube\nfacet"), "not a glTF model", "STL");
    expectError(errorOf("[1, 2]"), "not a glTF model", "other JSON");
    expectError(errorOf("{\"asset\": {\"version\": \"2.0\"}"), "not a glTF model", "cut JSON");
    expectError(errorOf(R"({"asset": {"version": "2.0"}})"), "has no triangles", "empty glTF");
    expectError(errorOf("glTF"), "cut short", "four bytes");
    expectError(errorOf(good.substr(0, good.size() - 1)), "cut short", "last byte gone");
    expectError(errorOf(patched(4, 1)), "GLB version 1", "version");
    expectError(errorOf(patched(8, 0xffffffffu)), "cut short", "length too large");
    expectError(errorOf(patched(12, 0xfffffff0u)), "GLB chunk 0", "chunk too large");
    expectError(errorOf(patched(16, 0x12345678)), "first GLB chunk is not JSON", "chunk kind");
    expectError(errorOfFile(scratch() / "gone.glb"), "no such file", "missing");
    expectError(errorOfFile(scratch() / ""), "not a file", "folder");
}

TEST(BrokenGltf, LinksDoNotLeadOutOfTheFolder) {
    const ScratchFolder outside;
    TestModel model;
    writeBytes(outside / "secret.bin", model.binary);
    std::error_code error;
    std::filesystem::create_symlink(outside / "secret.bin", scratch() / "link.bin", error);
    if (error) GTEST_SKIP() << "no symbolic links here";
    model.root["buffers"][0]["uri"] = "link.bin";
    expectError(errorOf(model.glb()), "outside the model's folder", "link");
}

TEST(BrokenGltf, AHundredThousandNodesInARowAreNoTrouble) {
    TestModel model;
    json& nodes = model.root["nodes"];
    for (int i = 3; i < 100000; ++i) nodes.push_back({{"children", {i + 1}}});
    nodes.push_back(json::object());
    model.root["scenes"][0]["nodes"].push_back(3);
    EXPECT_EQ(errorOf(model.glb()), "no error");
}

TEST(BrokenGltf, FlippedBytesAndCutsLoadOrThrow) {
    const std::string good = TestModel().glb();
    Random random(20);
    int loaded = 0, refused = 0;
    for (int i = 0; i < 600; ++i) {
        std::string bytes = good;
        const std::size_t flips = 1 + random.bits() % 4;
        for (std::size_t k = 0; k < flips; ++k)
            bytes[random.bits() % bytes.size()] ^= char(1 + random.bits() % 255);
        if (i % 3 == 0) bytes.resize(random.bits() % bytes.size());
        // Anything but Error fails this test.
        errorOf(bytes) == "no error" ? ++loaded : ++refused;
    }
    EXPECT_GT(loaded, 10);  // else the flips test the header alone
    EXPECT_GT(refused, 100);
}

TEST(BrokenGltf, ChangedNumbersLoadOrThrow) {
    // Byte flips mostly end in the JSON parser; here every number of the tree gets strange values.
    const TestModel good;
    const json flat = good.root.flatten();
    const json strange[] = {
        -1,           0,    1,     2,    3,       7,   255,           65536,          2147483647,
        4294967296.0, 1e18, 1e308, -0.5, nullptr, "x", json::array(), json::object(), true};
    int tried = 0;
    for (const auto& [pointer, value] : flat.items())
        for (const json& replacement : strange) {
            TestModel model;
            model.root[json::json_pointer(pointer)] = replacement;
            errorOf(model.glb());
            ++tried;
        }
    EXPECT_GT(tried, 1000);
}

}  // namespace
}  // namespace penumbra
