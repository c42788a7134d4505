#include "gl/context.h"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

#include "core/error.h"

namespace penumbra {

namespace {

std::string firstGlError;

void GLAD_API_PTR onDebugMessage(GLenum source, GLenum type, GLuint, GLenum, GLsizei,
                                 const GLchar* message, const void*) {
    // A shader that does not compile is the info log's matter and was thrown with the student's own
    // line.
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    if (type == GL_DEBUG_TYPE_ERROR && firstGlError.empty()) firstGlError = message;
}

std::string glString(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

}  // namespace

Context::~Context() = default;

std::string Context::renderer() const { return glString(GL_RENDERER); }
std::string Context::version() const { return glString(GL_VERSION); }
std::string Context::vendor() const { return glString(GL_VENDOR); }

bool Context::software() const {
    const std::string name = renderer();
    return name.find("llvmpipe") != std::string::npos ||
           name.find("softpipe") != std::string::npos || name.find("swrast") != std::string::npos;
}

Context::Function Context::extension(const std::string& name, const char* function) const {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i)
        if (name == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, GLuint(i))))
            return loader_(function);
    return nullptr;
}

void Context::load(Loader loader) {
    loader_ = loader;
    const int version = gladLoadGL(reinterpret_cast<GLADloadfunc>(loader));
    if (version < GLAD_MAKE_VERSION(4, 1))
        throw Error("OpenGL 4.1 is needed", backend(), "update the graphics driver");
    firstGlError.clear();
    if (GLAD_GL_KHR_debug && glDebugMessageCallback) {  // not on macOS
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(onDebugMessage, nullptr);
    }
}

void throwOnGlErrors() {
    std::string message = std::exchange(firstGlError, {});
    for (int i = 0; i < 16; ++i) {  // a lost context would answer for ever
        const GLenum code = glGetError();
        if (code == GL_NO_ERROR) break;
        if (message.empty()) message = fmt::format("error 0x{:04x}", code);
    }
    if (!message.empty())
        throw Error("OpenGL reports an error", message, "look at the call that the message names");
}

std::string backendName(Backend backend) {
    switch (backend) {
        case Backend::window:
            return "window";
        case Backend::osmesa:
            return "osmesa";
        case Backend::eglSurfaceless:
            return "egl-surfaceless";
        case Backend::eglDevice:
            return "egl-device";
    }
    return "";
}

std::unique_ptr<Context> createContext(Backend backend, const WindowOptions& options) {
    switch (backend) {
        case Backend::window:
            return createWindowContext(options);
        case Backend::osmesa:
            return createOsmesaContext();
        case Backend::eglSurfaceless:
            return createEglContext(false);
        case Backend::eglDevice:
            return createEglContext(true);
    }
    return nullptr;
}

std::unique_ptr<Context> createHeadlessContext() {
    std::vector<Backend> order = {Backend::osmesa, Backend::eglDevice, Backend::eglSurfaceless};
    if (const char* forced = std::getenv("PENUMBRA_CONTEXT"); forced && *forced) {
        const std::string name = forced;
        if (name == "egl") {
            order = {Backend::eglDevice, Backend::eglSurfaceless};
        } else {
            order.clear();
            for (const Backend b :
                 {Backend::window, Backend::osmesa, Backend::eglSurfaceless, Backend::eglDevice})
                if (backendName(b) == name) order = {b};
            if (order.empty())
                throw Error("no such OpenGL back end '" + name + "'", "PENUMBRA_CONTEXT",
                            "use osmesa, egl or window");
        }
    }
    std::string reasons;
    for (const Backend backend : order) try {
            return createContext(backend);
        } catch (const Error& e) {
            reasons += (reasons.empty() ? "" : " | ") + std::string(e.what());
        }
    throw Error("no OpenGL without a window", reasons,
                "install libosmesa6 or libegl1 with Mesa's drivers");
}

}  // namespace penumbra
