#include "gl/program.h"

#include "core/test_folder.h"
#include "gl/framebuffer.h"
#include "gl/test_context.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using testing::TestFolder;

constexpr const char* kVertex =
    "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, "
    "1.0); }\n";

// What a program with that fragment shader draws: one float.
float drawn(const Program& program) {
    const Texture target({.size = {1, 1}, .format = GL_R32F, .label = "target"});
    const Framebuffer framebuffer({.colors = {&target}});
    GLuint vertexArray = 0;
    glGenVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);
    glDisable(GL_DEPTH_TEST);
    framebuffer.bind();
    program.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDeleteVertexArrays(1, &vertexArray);
    return target.read().at(0, 0);
}

// Saves as an editor does, with a time stamp that differs even where clocks are coarse.
void save(const TestFolder& folder, const std::string& name, const std::string& text) {
    static int saves = 0;
    const fs::path path = folder.write(name, text);
    fs::last_write_time(path, fs::last_write_time(path) + std::chrono::seconds(++saves));
}

std::string loadError(const Layers& layers, const std::string& name) {
    try {
        loadShader(layers, name);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(ShaderSource, TakesEachIncludeOnceAndInOrder) {
    const TestFolder folder;
    folder.write("base.glsl", "// base\n");
    folder.write("a.glsl", "#include \"base.glsl\"\n// a\n");
    folder.write("main.frag",
                 "#include \"a.glsl\"\n  # include \"base.glsl\"  // again\n// main\n");
    const ShaderSource source = loadShader(Layers({folder.path()}), "main.frag");
    EXPECT_EQ(source.text, "#version 410 core\n// base\n// a\n// main\n");
    ASSERT_EQ(source.lines.size(), 4u);
    EXPECT_EQ(source.lines[2].file, folder / "a.glsl");
    EXPECT_EQ(source.lines[2].line, 2);
    EXPECT_EQ(source.lines[3].line, 3);
}

TEST(ShaderSource, ALaterLayerReplacesAnIncludedChunk) {
    const TestFolder folder;
    folder.write("handout/bias.glsl", "// stub\n");
    folder.write("solution/bias.glsl", "// written\n");
    folder.write("handout/main.frag", "#include \"bias.glsl\"\n");
    const Layers layers({folder / "handout", folder / "solution"});
    EXPECT_EQ(loadShader(layers, "main.frag").text, "#version 410 core\n// written\n");
}

TEST(ShaderSource, AMissingIncludeIsNamedWithItsLine) {
    const TestFolder folder;
    folder.write("main.frag", "// one\n#include \"pcff.glsl\"\n");
    EXPECT_EQ(loadError(Layers({folder.path()}), "main.frag")
                  .find("no such shader file 'pcff.glsl': main.frag:2; "),
              0u);
}

TEST(ShaderSource, AnIncludeCannotLeaveTheFolders) {
    const TestFolder folder;
    folder.write("secret.glsl", "");
    folder.write("inner/main.frag", "#include \"../secret.glsl\"\n");
    EXPECT_NE(loadError(Layers({folder / "inner"}), "main.frag"), "");
}

TEST(ShaderSource, RefusesAVersionLine) {
    const TestFolder folder;
    folder.write("main.frag", "\n#version 450\n");
    EXPECT_EQ(loadError(Layers({folder.path()}), "main.frag"),
              "#version is not yours to write: main.frag:2; delete the line; the loader writes "
              "#version 410 core");
}

TEST(ShaderSource, AFileThatIncludesItselfEnds) {
    const TestFolder folder;
    folder.write("a.glsl", "#include \"a.glsl\"\n// a\n");
    EXPECT_EQ(loadShader(Layers({folder.path()}), "a.glsl").text, "#version 410 core\n// a\n");
}

TEST(ShaderSource, TranslatesTheLogOfEveryVendor) {
    const TestFolder folder;
    folder.write("bias.glsl", "// one\nfloat two;\n");
    folder.write("main.frag", "#include \"bias.glsl\"\nvoid main() {}\n");
    const ShaderSource source = loadShader(Layers({folder.path()}), "main.frag");
    EXPECT_EQ(source.translate("0:3(12): error: `blokcer' undeclared"),
              "bias.glsl:2: error: `blokcer' undeclared");
    EXPECT_EQ(source.translate("0(4) : error C1503: undefined variable"),
              "main.frag:2: error C1503: undefined variable");
    EXPECT_EQ(source.translate("ERROR: 0:2: 'x' : syntax error\n"),
              "bias.glsl:1: 'x' : syntax error");
    EXPECT_EQ(source.translate("too many errors"), "too many errors");
    EXPECT_EQ(source.translate("0:99(1): error: past the end"), "0:99(1): error: past the end");
}

class ShaderLibraryTest : public testing::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        save(folder_, "full.vert", kVertex);
        save(folder_, "main.frag",
             "#include \"chunk.glsl\"\nlayout(location = 0) out float result;\nvoid main() { "
             "result = value(); }\n");
        save(folder_, "chunk.glsl", "// a chunk\nfloat value() { return 1.0; }\n");
    }
    TestFolder folder_;
    ShaderLibrary shaders_{Layers({folder_.path()})};
};

TEST_F(ShaderLibraryTest, ReloadTakesASavedChunk) {
    const Program& program = shaders_.program("full.vert", "main.frag");
    EXPECT_EQ(drawn(program), 1.0f);
    EXPECT_FALSE(shaders_.reload());
    save(folder_, "chunk.glsl", "float value() { return 2.0; }\n");
    EXPECT_TRUE(shaders_.reload());
    EXPECT_EQ(drawn(program), 2.0f);
}

TEST_F(ShaderLibraryTest, AnErrorKeepsTheLastGoodProgramUntilItIsFixed) {
    const Program& program = shaders_.program("full.vert", "main.frag");
    save(folder_, "chunk.glsl", "// a chunk\nfloat value() {\n    return 2.0 * blokcer;\n}\n");
    EXPECT_FALSE(shaders_.reload());
    EXPECT_NE(shaders_.error().find("chunk.glsl:3: "), std::string::npos) << shaders_.error();
    EXPECT_NE(shaders_.error().find("blokcer"), std::string::npos) << shaders_.error();
    EXPECT_NO_THROW(throwOnGlErrors());  // not a GL error of the next frame as well
    EXPECT_EQ(drawn(program), 1.0f);
    EXPECT_EQ(drawn(shaders_.program("full.vert", "main.frag")), 1.0f);
    save(folder_, "chunk.glsl", "float value() { return 3.0; }\n");
    EXPECT_TRUE(shaders_.reload());
    EXPECT_EQ(shaders_.error(), "");
    EXPECT_EQ(drawn(program), 3.0f);
}

TEST_F(ShaderLibraryTest, AnErrorStaysWhileAnotherProgramCompiles) {
    save(folder_, "b.frag",
         "#include \"chunk.glsl\"\nlayout(location = 0) out float result;\nvoid main() { result = "
         "value() + other(); }\n");
    save(folder_, "chunk.glsl", "float value() { return 1.0; }\nfloat other() { return 1.0; }\n");
    shaders_.program("full.vert", "b.frag");
    shaders_.program("full.vert", "main.frag");
    save(folder_, "chunk.glsl", "float value() { return 2.0; }\n");
    EXPECT_TRUE(shaders_.reload());  // main.frag
    EXPECT_NE(shaders_.error().find("b.frag:3: "), std::string::npos) << shaders_.error();
}

TEST_F(ShaderLibraryTest, AFirstFailureIsRetriedOnSave) {
    save(folder_, "chunk.glsl", "float value() { return 1.0 }\n");
    EXPECT_THROW(shaders_.program("full.vert", "main.frag"), Error);
    EXPECT_THROW(shaders_.program("full.vert", "main.frag"), Error);
    EXPECT_FALSE(shaders_.reload());
    EXPECT_NE(shaders_.error(), "");
    save(folder_, "chunk.glsl", "float value() { return 4.0; }\n");
    EXPECT_TRUE(shaders_.reload());
    EXPECT_EQ(drawn(shaders_.program("full.vert", "main.frag")), 4.0f);
}

TEST_F(ShaderLibraryTest, AFileThatComesLaterIsSeen) {
    save(folder_, "main.frag",
         "#include \"late.glsl\"\nlayout(location = 0) out float result;\nvoid main() { result = "
         "value(); }\n");
    EXPECT_THROW(shaders_.program("full.vert", "main.frag"), Error);
    save(folder_, "late.glsl", "float value() { return 5.0; }\n");
    EXPECT_TRUE(shaders_.reload());
    EXPECT_EQ(drawn(shaders_.program("full.vert", "main.frag")), 5.0f);
}

TEST_F(ShaderLibraryTest, AFileThatAppearsInALaterLayerIsSeen) {
    fs::create_directories(folder_ / "solution");
    ShaderLibrary shaders(Layers({folder_.path(), folder_ / "solution"}));
    const Program& program = shaders.program("full.vert", "main.frag");
    save(folder_, "solution/chunk.glsl", "float value() { return 6.0; }\n");
    EXPECT_TRUE(shaders.reload());
    EXPECT_EQ(drawn(program), 6.0f);
}

TEST_F(ShaderLibraryTest, AnUnusedUniformIsNoError) {
    const Program& program = shaders_.program("full.vert", "main.frag");
    program.use();
    program.set("nothing", 1.0f);
    program.block("Nothing", 3);
    EXPECT_NO_THROW(throwOnGlErrors());
}

}  // namespace
}  // namespace penumbra
