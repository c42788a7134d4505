#include "gl/volume_texture.h"

#include "core/test_folder.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/test_context.h"
#include "gl/texture.h"

namespace penumbra {
namespace {

std::vector<float> ramp(glm::ivec3 size) {
    std::vector<float> values(std::size_t(size.x * size.y * size.z));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i) - 7.0f;
    return values;
}

class VolumeTextureTest : public testing::GlTest {};

TEST_F(VolumeTextureTest, KeepsWhatItsFormatHolds) {
    const glm::ivec3 size(5, 3, 7);
    for (const GLenum format : {GL_R32F, GL_R16F}) {  // 16 bits hold these whole numbers
        VolumeTexture volume({.size = size, .format = format, .label = "ramp"});
        volume.upload(ramp(size));
        EXPECT_EQ(volume.read(), ramp(size));
    }
    VolumeTexture precise({.size = {1, 1, 1}, .label = "one"});
    precise.upload(std::vector{0.1f});
    EXPECT_EQ(precise.read(), std::vector{0.1f});
}

// What a shader sees at (u, v, w).
float seen(Program& program, const VolumeTexture& volume, glm::vec3 place) {
    const Texture target({.size = {1, 1}, .format = GL_R32F, .label = "target"});
    const Framebuffer framebuffer({.colors = {&target}});
    GLuint vertexArray = 0;
    glGenVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);
    framebuffer.bind();
    program.use();
    program.texture("volume", 3, volume);
    program.set("place", place);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDeleteVertexArrays(1, &vertexArray);
    return target.read().at(0, 0);
}

TEST_F(VolumeTextureTest, IsSeenByAShaderFromTexelCentreToTexelCentre) {
    const testing::TestFolder folder;
    folder.write("a.vert",
                 "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - "
                 "1.0, 0.0, 1.0); }\n");
    folder.write("a.frag",
                 "uniform sampler3D volume; uniform vec3 place; out float value;\n"
                 "void main() { value = textureLod(volume, place, 0.0).r; }\n");
    ShaderLibrary shaders(Layers({folder.path()}));
    Program& program = shaders.program("a.vert", "a.frag");
    const glm::ivec3 size(4, 2, 8);
    VolumeTexture volume({.size = size, .label = "ramp"});
    volume.upload(ramp(size));
    const auto at = [&](float x, float y, float z) {  // in texels
        return seen(program, volume, glm::vec3(x, y, z) / glm::vec3(size));
    };
    const auto value = [](float x, float y, float z) { return (z * 2 + y) * 4 + x - 7; };
    EXPECT_EQ(at(0.5f, 0.5f, 0.5f), value(0, 0, 0));
    EXPECT_EQ(at(3.5f, 0.5f, 0.5f), value(3, 0, 0));
    EXPECT_EQ(at(0.5f, 1.5f, 0.5f), value(0, 1, 0));
    EXPECT_EQ(at(0.5f, 0.5f, 7.5f), value(0, 0, 7));
    // Linear between centres; weights of 8 bits are what OpenGL asks of a texture unit.
    EXPECT_NEAR(at(2.25f, 1.0f, 4.0f), value(1.75f, 0.5f, 3.5f), 13.0f / 256);
    EXPECT_EQ(at(-3.0f, -1.0f, 99.0f), value(0, 0, 7)) << "clamped to the outermost centres";
}

TEST_F(VolumeTextureTest, ASizeThatCannotBeIsAnError) {
    EXPECT_THROW(VolumeTexture({.size = {4, 0, 4}, .label = "flat"}), Error);
    EXPECT_THROW(VolumeTexture({.size = {1, 1, 1 << 30}, .label = "long"}), Error);
}

TEST_F(VolumeTextureTest, IsCountedAmongTheLiveBytes) {
    const std::size_t before = Texture::liveBytes();
    {
        VolumeTexture half({.size = {4, 2, 8}, .format = GL_R16F, .label = "half"});
        const VolumeTexture moved = std::move(half);
        EXPECT_EQ(Texture::liveBytes(), before + 4 * 2 * 8 * 2);
    }
    EXPECT_EQ(Texture::liveBytes(), before);
}

TEST_F(VolumeTextureTest, IsMovedNotCopied) {
    VolumeTexture a({.size = {1, 1, 1}, .label = "a"});
    const GLuint id = a.id();
    const VolumeTexture b = std::move(a);
    EXPECT_EQ(b.id(), id);
    EXPECT_TRUE(glIsTexture(id));
}

}  // namespace
}  // namespace penumbra
