#include "app/viewer_ui.h"

#include <glad/gl.h>
// GLFW after glad: both want to be the one that declares OpenGL.
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <filesystem>
#include <initializer_list>

namespace penumbra {

namespace {

constexpr float kTextSize = 15.0f, kCodeSize = 14.0f;  // window units

// The first of the system's fonts that is there, else ImGui's own.
ImFont* loadFont(std::initializer_list<const char*> files, float size) {
    // Latin, Greek (angles), punctuation, arrows, mathematics: what help texts are written with.
    static const ImWchar ranges[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x2030,
                                     0x2190, 0x21FF, 0x2200, 0x22FF, 0};
    ImFontAtlas* fonts = ImGui::GetIO().Fonts;
    for (const char* file : files) {
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored)) continue;
        if (ImFont* font = fonts->AddFontFromFileTTF(file, size, nullptr, ranges)) return font;
    }
    return fonts->AddFontDefault();
}

void setColors() {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.WindowBorderSize = 0;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
    style.WindowPadding = {12, 10};
    style.ItemSpacing = {8, 6};
    style.FramePadding = {6, 3};
    const auto set = [&](ImGuiCol color, float r, float g, float b, float a = 1) {
        style.Colors[color] = {r, g, b, a};
    };
    set(ImGuiCol_WindowBg, 0.115f, 0.12f, 0.13f);
    set(ImGuiCol_PopupBg, 0.15f, 0.155f, 0.17f);
    set(ImGuiCol_FrameBg, 0.19f, 0.20f, 0.22f);
    set(ImGuiCol_FrameBgHovered, 0.24f, 0.26f, 0.29f);
    set(ImGuiCol_FrameBgActive, 0.27f, 0.30f, 0.34f);
    set(ImGuiCol_SliderGrab, 0.85f, 0.66f, 0.32f);
    set(ImGuiCol_SliderGrabActive, 0.98f, 0.78f, 0.40f);
    set(ImGuiCol_CheckMark, 0.98f, 0.78f, 0.40f);
    set(ImGuiCol_PlotHistogram, 0.85f, 0.66f, 0.32f);
    set(ImGuiCol_Button, 0.21f, 0.23f, 0.26f);
    set(ImGuiCol_ButtonHovered, 0.29f, 0.32f, 0.36f);
    set(ImGuiCol_ButtonActive, 0.36f, 0.40f, 0.45f);
    set(ImGuiCol_Header, 0.26f, 0.29f, 0.33f);
    set(ImGuiCol_HeaderHovered, 0.31f, 0.35f, 0.40f);
    set(ImGuiCol_HeaderActive, 0.36f, 0.40f, 0.45f);
    set(ImGuiCol_Separator, 0.24f, 0.25f, 0.27f);
}

}  // namespace

Ui::Ui(GLFWwindow* window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // nothing is written into the folder it was started in
    ImGui::GetIO().LogFilename = nullptr;
    setColors();
    int windowWidth = 1, pixelWidth = 1, height = 1;
    glfwGetWindowSize(window, &windowWidth, &height);
    glfwGetFramebufferSize(window, &pixelWidth, &height);
    loadFonts(windowWidth > 0 ? float(pixelWidth) / float(windowWidth) : 1.0f);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 410 core");
}

Ui::~Ui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Ui::loadFonts(float scale) {
#if IMGUI_VERSION_NUM < 19200
    ImGui::GetIO().FontGlobalScale =
        1.0f / scale;  // rasterised for the screen's pixels, laid out in window units
#else
    scale = 1.0f;  // since 1.92 fonts are rasterised as the screen asks
#endif
    text_ = loadFont(
        {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
         "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
         "/System/Library/Fonts/Supplemental/Arial Unicode.ttf", "C:/Windows/Fonts/segoeui.ttf"},
        kTextSize * scale);
    code_ = loadFont({"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
                      "/usr/share/fonts/TTF/DejaVuSansMono.ttf", "/System/Library/Fonts/Menlo.ttc",
                      "C:/Windows/Fonts/consola.ttf"},
                     kCodeSize * scale);
}

void Ui::begin() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Ui::end() {
    ImGui::Render();
    const ImGuiIO& io = ImGui::GetIO();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, int(io.DisplaySize.x * io.DisplayFramebufferScale.x),
               int(io.DisplaySize.y * io.DisplayFramebufferScale.y));
    glClearColor(0.115f, 0.12f, 0.13f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace penumbra
