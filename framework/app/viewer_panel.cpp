// Everything beside and below the picture: views, scene, settings, error, time.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/viewer_settings.h"
#include "app/viewer_state.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;
const ImVec4 kDim{0.62f, 0.65f, 0.69f, 1}, kWarning{1.0f, 0.62f, 0.42f, 1};

void text(const std::string& line) { ImGui::TextUnformatted(line.c_str()); }

void wrapped(const ImVec4& color, const std::string& line) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(0.0f);
    text(line);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void heading(const char* title) {
    ImGui::Dummy({0, 2});
    ImGui::Separator();
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4{0.98f, 0.78f, 0.40f, 1});
    text(title);
    ImGui::PopStyleColor();
}

void logItem(ViewerState& state, const std::string& name) {
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    state.log.item(name, lower.x, lower.y, upper.x, upper.y);
}

void drawViews(ViewerState& state) {
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * spacing) / 3;
    for (int i = 0; i < 5; ++i) {
        const auto view = PictureView(i);
        if (i % 3 != 0) ImGui::SameLine();
        const bool chosen = view == state.view;
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4{0.45f, 0.36f, 0.18f, 1});
        if (ImGui::Button(fmt::format("{} {}", i + 1, viewName(view)).c_str(), {width, 0}))
            state.view = view;
        if (chosen) ImGui::PopStyleColor();
        logItem(state, fmt::format("view.{}", viewName(view)));
    }
}

bool isBuiltIn(const std::string& name) {
    const auto names = builtInSceneNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

void sceneCombo(ViewerState& state, const std::string& current) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 104);
    const bool open = ImGui::BeginCombo("##scene", current.c_str(), ImGuiComboFlags_HeightLarge);
    logItem(state, "scene");
    if (!open) return;
    for (const std::string& name : builtInSceneNames())
        if (ImGui::Selectable(name.c_str(), name == current)) state.wantedScene = name;
    const auto models = installedModelNames();
    if (!models.empty()) ImGui::Separator();
    for (const std::string& name : models)
        if (ImGui::Selectable(name.c_str(), name == current)) state.wantedScene = name;
    ImGui::EndCombo();
}

void drawScene(ViewerState& state) {
    const auto at = state.sceneName.find('@');
    const std::string base = state.sceneName.substr(0, at);
    sceneCombo(state, base);
    ImGui::SameLine();
    if (isBuiltIn(base)) {
        ImGui::SetNextItemWidth(96);
        const bool entered =
            ImGui::InputInt("##seed", &state.seed, 1, 10, ImGuiInputTextFlags_EnterReturnsTrue);
        if (entered || ImGui::IsItemDeactivatedAfterEdit())
            state.wantedScene = fmt::format("{}@{}", base, std::max(state.seed, 0));
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip(
                "seed of a built-in scene; of tilted, the light's angle of incidence in degrees");
    } else {
        ImGui::Dummy({96, 0});
    }
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##path", "path to a .glb or .gltf, then Enter", state.path,
                             sizeof state.path);
    // Asked of the keyboard itself: ImGui 1.86 misses a key that is let go within a slow frame.
    if (state.entered && (ImGui::IsItemActive() || ImGui::IsItemDeactivated()) && state.path[0])
        state.wantedScene = state.path;
    logItem(state, "path");
    if (!state.sceneError.empty()) wrapped(kWarning, state.sceneError);
    for (const std::string& note : state.notes) wrapped(kDim, note);
}

void row(const char* name, const std::string& value, const char* help) {
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    text(name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
    ImGui::SameLine(right - ImGui::CalcTextSize(value.c_str()).x);
    text(value);
}

void drawError(ViewerState& state) {
    ImGui::Checkbox("trace the truth", &state.traceTruth);
    if (state.metrics) {
        const Metrics& m = *state.metrics;
        row("rmse", fmt::format("{:.4f}", m.rmse), "root mean square of visibility minus truth");
        row("mismatch", fmt::format("{:.2f} %", 100 * m.meanAbsolute),
            "mean absolute difference; for hard shadows the share of wrong pixels");
        row("light leak", fmt::format("{:.2f} %", 100 * m.lightLeakRate),
            "share of the umbra (truth < 0.02) that got more than 0.1");
        row("false shadow", fmt::format("{:.2f} %", 100 * m.falseShadowRate),
            "share of the lit (truth > 0.98) that got less than 0.9");
    }
    if (state.truthBusy) ImGui::ProgressBar(float(state.truthFraction), {-1, 6}, "");
    wrapped(kDim, state.truthNote);
}

void drawTime(const ViewerState& state) {
    for (const auto& [pass, milliseconds] : state.passes)
        row(pass.c_str(), fmt::format("{:.2f} ms", milliseconds), "this pass, in the last redraw");
    row("whole redraw", fmt::format("{:.1f} ms", state.redrawMilliseconds),
        "all passes and what is between them");
}

void drawInsetChoice(ViewerState& state) {
    ImGui::SetNextItemWidth(-1);
    const bool open =
        ImGui::BeginCombo("##inset", state.inset.empty() ? "none" : state.inset.c_str());
    logItem(state, "inset");
    if (!open) return;
    if (ImGui::IsWindowAppearing()) state.learnNames = true;
    if (ImGui::Selectable("none", state.inset.empty())) state.inset.clear();
    for (const std::string& name : state.imageNames)
        if (ImGui::Selectable(name.c_str(), name == state.inset)) state.inset = name;
    ImGui::EndCombo();
}

}  // namespace

const char* viewName(PictureView view) {
    constexpr const char* kNames[] = {"picture", "mine", "truth", "difference", "split"};
    return kNames[int(view)];
}

void drawPanel(ViewerState& state) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x - kPanelWidth, 0});
    ImGui::SetNextWindowSize({kPanelWidth, window.y - kStatusHeight});
    ImGui::Begin("panel", nullptr, kFixed);
    drawViews(state);
    heading("Scene");
    drawScene(state);
    heading("Settings");
    drawSettings(state);
    heading("Error against ray-traced truth");
    drawError(state);
    heading("Time");
    drawTime(state);
    heading("Image in the corner");
    drawInsetChoice(state);
    state.typing = ImGui::GetIO().WantTextInput;
    ImGui::End();
}

void drawStatus(const ViewerState& state) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, window.y - kStatusHeight});
    ImGui::SetNextWindowSize({window.x, kStatusHeight});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12, 6));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4{0.085f, 0.09f, 0.10f, 1});
    ImGui::Begin("status", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar);
    ImGui::PushStyleColor(ImGuiCol_Text, kDim);
    const double fps = state.redrawMilliseconds > 0 ? 1000 / state.redrawMilliseconds : 0;
    const std::string facts =
        fmt::format("{}   {} triangles   {}x{}   {:.0f} fps   {}", state.sceneName, state.triangles,
                    state.size.x, state.size.y, std::min(fps, 60.0), state.renderer);
    text(state.notice.empty() ? facts : state.notice);
    const char* keys = "drag: orbit   right drag: pan   L + drag: light   R: reset   P: screenshot";
    const float width = ImGui::CalcTextSize(keys).x;
    if (ImGui::CalcTextSize(facts.c_str()).x + width + 60 < window.x) {
        ImGui::SameLine(window.x - width - 12);
        text(keys);
    }
    ImGui::PopStyleColor();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

}  // namespace penumbra
