#include "scene/obj_import.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.h"
#include "scene/scratch_folder.h"
#include "scene/texture_file.h"

namespace penumbra {
namespace {

const ScratchFolder& scratch() {
    static const ScratchFolder folder;
    return folder;
}

void write(const std::string& name, const std::string& text) {
    std::ofstream(scratch() / name, std::ios::binary) << text;
}

Scene imported(const std::string& materials, const std::string& rest) {
    write("m.mtl", materials);
    write("m.obj",
          "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" +
              rest);
    return importObj(scratch() / "m.obj");
}

void writePng(const std::string& name, std::uint8_t alpha) {
    const auto png = encodeTexture({1, 1, {10, 20, 30, alpha}});
    write(name, std::string(png.begin(), png.end()));
}

TEST(ObjImport, QuadsBecomeTrianglesWithTextureUpsideDown) {
    writePng("color.png", 255);
    const Scene scene =
        imported("newmtl a\nKd .5 .5 .5\nmap_Kd color.png\n", "usemtl a\nf 1/1 2/2 3/3 4/4\n");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].triangles.size(), 2u);
    EXPECT_EQ(scene.meshes[0].normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.meshes[0].uvs[0], glm::vec2(0, 1));
    EXPECT_EQ(scene.textures.at(0).rgba[2], 30);
    EXPECT_EQ(scene.materials[0].alphaCutoff, 0.0f);
}

TEST(ObjImport, HolesComeFromThePicturesAlphaOrFromMapD) {
    writePng("holes.png", 0);
    writePng("color.png", 255);
    const char* face = "usemtl a\nf 1/1 2/2 3/3\n";
    EXPECT_EQ(imported("newmtl a\nmap_Kd holes.png\n", face).materials[0].alphaCutoff, 0.5f);
    EXPECT_EQ(
        imported("newmtl a\nmap_Kd color.png\nmap_d holes.png\n", face).materials[0].alphaCutoff,
        0.5f);
}

TEST(ObjImport, ClearGlassIsLeftOut) {
    const Scene scene = imported("newmtl glass\nd 0.2\nnewmtl iron\nd 1\n",
                                 "usemtl glass\nf 1 2 3\nusemtl iron\nf 1 3 4\n");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].name, "iron");
    EXPECT_EQ(scene.meshes[0].triangles.size(), 1u);
}

TEST(ObjImport, MissingFilesAndEmptyModelsAreErrors) {
    EXPECT_THROW(importObj(scratch() / "gone.obj"), Error);
    EXPECT_THROW(imported("newmtl a\nmap_Kd gone.png\n", "usemtl a\nf 1/1 2/2 3/3\n"), Error);
    EXPECT_THROW(imported("", "f 1 1 2\n"), Error);
}

}  // namespace
}  // namespace penumbra
