#include "app/viewer_keys.h"

#include <GLFW/glfw3.h>

#include <utility>

namespace penumbra {

namespace {

void onKey(GLFWwindow* window, int key, int, int action, int) {
    auto* pressed = static_cast<std::vector<int>*>(glfwGetWindowUserPointer(window));
    if (action == GLFW_PRESS && pressed) pressed->push_back(key);
}

}  // namespace

ViewerKeys::ViewerKeys(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, &pressed_);
    glfwSetKeyCallback(window, onKey);
}

std::vector<int> ViewerKeys::take() { return std::exchange(pressed_, {}); }

}  // namespace penumbra
