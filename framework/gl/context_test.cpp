#include "gl/context.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <optional>

#include "core/error.h"
#include "core/test_folder.h"
#include "gl/framebuffer.h"
#include "gl/program.h"

namespace penumbra {
namespace {

#ifdef __SANITIZE_ADDRESS__
// Drivers stay loaded to the end, so that LeakSanitizer can name them: framework/cmake/lsan.supp.
const bool kDriversStay = [] {
    for (const char* name :
         {"libEGL_mesa.so.0", "libGLX_mesa.so.0", "libGLdispatch.so.0", "libX11.so.6",
          "libgbm.so.1", "/usr/lib/x86_64-linux-gnu/dri/swrast_dri.so"})
        dlopen(name, RTLD_LAZY | RTLD_NODELETE);
    return true;
}();
#endif

using testing::TestFolder;

std::unique_ptr<Context> contextIfThere(Backend backend) {
    const char* display = std::getenv("DISPLAY");
    if (backend == Backend::window && (!display || !*display)) return nullptr;
    try {
        return createContext(backend);
    } catch (const Error&) {
        return nullptr;
    }
}

// 300 triangles in the unit cube, the same ones everywhere.
std::vector<glm::vec3> triangles() {
    std::uint32_t state = 1;
    const auto random = [&] {
        state = 1664525u * state + 1013904223u;
        return float(state >> 8) / 16777216.0f - 0.5f;
    };
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 center(random(), random(), random());
        for (int k = 0; k < 3; ++k)
            corners.push_back(center + 0.3f * glm::vec3(random(), random(), random()));
    }
    return corners;
}

void writeShaders(const TestFolder& folder) {
    folder.write(
        "a.vert",
        "layout(location = 0) in vec3 position;\n"
        "uniform mat4 clipFromWorld;\n"
        "out vec3 world;\n"
        "void main() { world = position; gl_Position = clipFromWorld * vec4(position, 1.0); }\n");
    folder.write("depth.frag", "void main() {}\n");
    folder.write(
        "shade.frag",
        "in vec3 world;\n"
        "uniform mat4 lightFromWorld;\n"
        "uniform sampler2D shadowMap;\n"
        "layout(location = 0) out vec4 color;\n"
        "void main() {\n"
        "    vec4 clip = lightFromWorld * vec4(world, 1.0);\n"
        "    vec3 uvDepth = 0.5 * clip.xyz / clip.w + 0.5;\n"
        "    float lit = uvDepth.z - 0.001 <= texture(shadowMap, uvDepth.xy).r ? 1.0 : 0.2;\n"
        "    color = vec4(lit * normalize(world + 0.7), exp(world.x) + sin(9.0 * world.y));\n"
        "}\n");
}

struct Pictures {
    Image shadowMap, color, depth;
};

// A light pass and a camera pass, as every technique has them.
Pictures draw(const TestFolder& folder) {
    ShaderLibrary shaders(Layers({folder.path()}));
    const auto corners = triangles();
    GLuint vertexArray = 0, buffer = 0;
    glGenVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(corners.size() * sizeof corners[0]), corners.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);

    const glm::mat4 light = glm::perspective(0.8f, 1.0f, 0.5f, 5.0f) *
                            glm::lookAt(glm::vec3(1, 2, 1), glm::vec3(0), glm::vec3(0, 0, 1));
    const glm::mat4 camera = glm::perspective(0.7f, 4.0f / 3, 0.5f, 5.0f) *
                             glm::lookAt(glm::vec3(-1, 1, 2), glm::vec3(0), glm::vec3(0, 1, 0));
    const Texture map({.size = {128, 128}, .format = GL_DEPTH_COMPONENT32F, .label = "map"});
    const Texture color({.size = {160, 120}, .format = GL_RGBA32F, .label = "colour"});
    const Texture depth({.size = {160, 120}, .format = GL_DEPTH_COMPONENT24, .label = "depth"});
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);

    const Program& lightPass = shaders.program("a.vert", "depth.frag");
    const Framebuffer lightTarget({.depth = &map});
    lightTarget.clear(glm::vec4(0));
    lightPass.use();
    lightPass.set("clipFromWorld", light);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));

    const Program& cameraPass = shaders.program("a.vert", "shade.frag");
    const Framebuffer cameraTarget({.colors = {&color}, .depth = &depth});
    cameraTarget.clear(glm::vec4(0.1f, 0.2f, 0.3f, 1.0f));
    cameraPass.use();
    cameraPass.set("clipFromWorld", camera);
    cameraPass.set("lightFromWorld", light);
    cameraPass.texture("shadowMap", 0, map);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));

    Pictures pictures{map.read(), color.read(), depth.read()};
    glDeleteBuffers(1, &buffer);
    glDeleteVertexArrays(1, &vertexArray);
    throwOnGlErrors();
    return pictures;
}

TEST(Context, EveryBackEndDrawsTheSameBits) {
    const TestFolder folder;
    writeShaders(folder);
    std::optional<Pictures> first;
    int count = 0;
    for (const Backend backend :
         {Backend::osmesa, Backend::eglSurfaceless, Backend::window, Backend::osmesa}) {
        const auto context = contextIfThere(backend);
        if (!context || !context->software()) continue;  // a GPU rounds in its own way
        const Pictures pictures = draw(folder);
        ++count;
        if (!first) first = pictures;
        EXPECT_EQ(pictures.shadowMap.pixels, first->shadowMap.pixels) << backendName(backend);
        EXPECT_EQ(pictures.color.pixels, first->color.pixels) << backendName(backend);
        EXPECT_EQ(pictures.depth.pixels, first->depth.pixels) << backendName(backend);
    }
    if (count < 2) GTEST_SKIP() << "fewer than two software back ends";
}

TEST(Context, IsCoreProfileFourPointOneOrLater) {
    for (const Backend backend :
         {Backend::osmesa, Backend::eglSurfaceless, Backend::eglDevice, Backend::window}) {
        const auto context = contextIfThere(backend);
        if (!context) continue;
        EXPECT_EQ(context->backend(), backendName(backend));
        EXPECT_GE(context->version(), "4.1");
        GLint profile = 0;
        glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
        EXPECT_TRUE(profile & GL_CONTEXT_CORE_PROFILE_BIT);
    }
}

TEST(Context, AGlErrorBecomesAnErrorOnce) {
    const auto context = contextIfThere(Backend::osmesa);
    if (!context) GTEST_SKIP() << "no OSMesa";
    glEnable(GL_TEXTURE_2D_ARRAY);  // not a capability
    EXPECT_THROW(throwOnGlErrors(), Error);
    EXPECT_NO_THROW(throwOnGlErrors());
}

TEST(Context, AnUnknownBackEndIsNamed) {
    setenv("PENUMBRA_CONTEXT", "vulkan", 1);
    try {
        createHeadlessContext();
        FAIL();
    } catch (const Error& e) {
        EXPECT_STREQ(
            e.what(),
            "no such OpenGL back end 'vulkan': PENUMBRA_CONTEXT; use osmesa, egl or window");
    }
    unsetenv("PENUMBRA_CONTEXT");
}

}  // namespace
}  // namespace penumbra
