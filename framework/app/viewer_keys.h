// Keys pressed between two frames, even those that were let go before the next one began.
#pragma once

#include <vector>

struct GLFWwindow;

namespace penumbra {

class ViewerKeys {
public:
    explicit ViewerKeys(GLFWwindow* window);  // before Ui: its callback calls this one
    ViewerKeys(const ViewerKeys&) = delete;
    ViewerKeys& operator=(const ViewerKeys&) = delete;

    std::vector<int> take();  // GLFW_KEY_…, pressed since the last call

private:
    std::vector<int> pressed_;
};

}  // namespace penumbra
