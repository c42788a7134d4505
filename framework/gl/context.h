// An OpenGL 4.1 core context from a window (GLFW), OSMesa or EGL, behind one interface.
//
//   auto context = createHeadlessContext();            // OSMesa, else EGL; never touches DISPLAY
//   auto context = createContext(Backend::window);     // hidden until shown by the viewer
//   fmt::print("{}\n", context->renderer());
//
// One context per process is the simple scheme. A test that switches destroys the old one first.
#pragma once

#include <glad/gl.h>

#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace penumbra {

enum class Backend { window, osmesa, eglSurfaceless, eglDevice };

class Context {
public:
    virtual ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    virtual std::string backend() const = 0;  // window, osmesa, egl-surfaceless, egl-device
    virtual GLFWwindow* window() const { return nullptr; }

    std::string renderer() const;  // GL_RENDERER
    std::string version() const;   // GL_VERSION
    std::string vendor() const;
    // llvmpipe, softpipe, swrast: no GPU, so timer queries do not tell the time.
    bool software() const;

    // A function of an extension past OpenGL 4.1, null where the driver does not list it.
    using Function = void (*)();
    Function extension(const std::string& name, const char* function) const;

protected:
    using Loader = Function (*)(const char*);
    Context() = default;
    void load(Loader loader);  // reads entry points, checks the version, turns debug output on

private:
    Loader loader_ = nullptr;
};

// Throws Error when that back end is not there. `glfwVisible` sizes and shows a window.
struct WindowOptions {
    int width = 64;
    int height = 64;
    bool visible = false;
    std::string title = "Penumbra";
};
std::unique_ptr<Context> createContext(Backend backend, const WindowOptions& options = {});

// OSMesa, else EGL (a GPU's device, else surfaceless). PENUMBRA_CONTEXT=osmesa|egl|egl-device|
// egl-surfaceless|window forces one. Throws Error when none is there.
std::unique_ptr<Context> createHeadlessContext();

std::string backendName(Backend backend);

// Errors that the driver reported through debug output or glGetError since the last call; the first
// message becomes an Error. Called at the end of every frame, so that no GL error passes unseen.
void throwOnGlErrors();

// The back ends, one file each.
std::unique_ptr<Context> createWindowContext(const WindowOptions& options);
std::unique_ptr<Context> createOsmesaContext();
std::unique_ptr<Context> createEglContext(bool device);

}  // namespace penumbra
