#include "app/viewer_keys.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

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

std::vector<int> ViewerKeys::take() {
    auto keys = std::exchange(pressed_, {});
    if (ImGui::GetIO().WantTextInput) keys.clear();
    return keys;
}

}  // namespace penumbra
