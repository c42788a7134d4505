#include <glad/gl.h>
// GLFW after glad: both want to be the one that declares OpenGL.
#include <GLFW/glfw3.h>

#include "core/error.h"
#include "gl/context.h"

namespace penumbra {

namespace {

std::string glfwReason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "GLFW";
}

class WindowContext final : public Context {
public:
    explicit WindowContext(const WindowOptions& options) {
        if (!glfwInit())
            throw Error("no window system", glfwReason(),
                        "start it in a desktop session, or use ./course render");
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS asks for it
        glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
        window_ = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr,
                                   nullptr);
        if (!window_) {
            const std::string reason = glfwReason();
            glfwTerminate();
            throw Error("no window with OpenGL 4.1", reason, "update the graphics driver");
        }
        glfwMakeContextCurrent(window_);
        load(glfwGetProcAddress);
    }
    ~WindowContext() override {
        glfwMakeContextCurrent(nullptr);
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    std::string backend() const override { return "window"; }
    GLFWwindow* window() const override { return window_; }

private:
    GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> createWindowContext(const WindowOptions& options) {
    return std::make_unique<WindowContext>(options);
}

}  // namespace penumbra
