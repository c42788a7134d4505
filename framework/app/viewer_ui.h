// Dear ImGui on a GLFW window: one frame between begin() and end(). Only API that 1.86 and 1.92
// share.
#pragma once

struct GLFWwindow;
struct ImFont;

namespace penumbra {

class Ui {
public:
    explicit Ui(GLFWwindow* window);  // install own GLFW callbacks before: they are chained
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    void begin();
    void end();  // draws into the window's back buffer

    ImFont* text() const { return text_; }
    ImFont* code() const { return code_; }  // for shader errors: one width

private:
    void loadFonts(float scale);

    ImFont* text_ = nullptr;
    ImFont* code_ = nullptr;
};

}  // namespace penumbra
