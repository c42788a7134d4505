#include "app/viewer_area.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "app/viewer_camera.h"

namespace penumbra {

namespace {

constexpr float kInsetSide = 220, kMargin = 14, kDividerReach = 8;  // window units
constexpr float kRadiansPerHeight = 3.6f;                           // a drag over the whole height

struct Rect {
    ImVec2 lower, upper;
    bool holds(ImVec2 p) const {
        return p.x >= lower.x && p.x < upper.x && p.y >= lower.y && p.y < upper.y;
    }
};

Rect areaRect() {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    return {{0, 0}, {window.x - kPanelWidth, window.y - kStatusHeight}};
}

// In the lower left corner, or as large as fits; the image's aspect is kept.
Rect insetRect(const Rect& area, glm::ivec2 size, bool enlarged) {
    const float width = area.upper.x - area.lower.x - 2 * kMargin,
                height = area.upper.y - area.lower.y - 2 * kMargin - 24;
    const float side = kInsetSide / float(std::max(size.x, size.y));
    const float scale = enlarged ? std::min(width / float(size.x), height / float(size.y)) : side;
    const ImVec2 lower(area.lower.x + kMargin, area.upper.y - kMargin - scale * float(size.y));
    return {lower, {lower.x + scale * float(size.x), area.upper.y - kMargin}};
}

// OpenGL's row 0 is at the bottom.
void addImage(ImDrawList* list, const Texture& texture, const Rect& at) {
    list->AddImage((ImTextureID)std::intptr_t(texture.id()), at.lower, at.upper, {0, 1}, {1, 0});
}

void label(ImDrawList* list, ImVec2 at, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list->AddRectFilled({at.x - 5, at.y - 2}, {at.x + size.x + 5, at.y + size.y + 2},
                        IM_COL32(20, 22, 25, 200), 3);
    list->AddText(at, IM_COL32(230, 232, 235, 255), text.c_str());
}

void drawInset(ImDrawList* list, ViewerState& state, const Pictures& pictures, const Rect& area) {
    if (pictures.inset().id() == 0) return;
    const Rect at = insetRect(area, pictures.inset().size(), state.insetEnlarged);
    addImage(list, pictures.inset(), at);
    list->AddRect({at.lower.x - 1, at.lower.y - 1}, {at.upper.x + 1, at.upper.y + 1},
                  IM_COL32(20, 22, 25, 220));
    const glm::vec2 range = pictures.insetRange();
    const bool stretched = range != glm::vec2(0, 1);
    label(list, {at.lower.x + 4, at.lower.y - 22},
          stretched ? fmt::format("{}  {:.4g} to {:.4g}", state.inset, range.x, range.y)
                    : state.inset);
    state.log.item("inset.image", at.lower.x, at.lower.y, at.upper.x, at.upper.y);
}

void drawDivider(ImDrawList* list, ViewerState& state, const Rect& area) {
    const float x = area.lower.x + state.divider * (area.upper.x - area.lower.x);
    const float middle = 0.5f * (area.lower.y + area.upper.y);
    list->AddLine({x, area.lower.y}, {x, area.upper.y}, IM_COL32(250, 200, 100, 255), 2);
    list->AddCircleFilled({x, middle}, 7, IM_COL32(250, 200, 100, 255));
    const float mine = ImGui::CalcTextSize("mine").x;
    label(list, {x - mine - 14, area.lower.y + 12}, "mine");
    label(list, {x + 14, area.lower.y + 12}, "truth");
    state.log.item("divider", x - kDividerReach, area.lower.y, x + kDividerReach, area.upper.y);
}

// At the top, in the middle; a line below the divider's labels.
void drawUnfinished(ImDrawList* list, const Progress& work, const Rect& area) {
    const std::string text = fmt::format("{}: {:.0f} %; this picture is without it", work.label(),
                                         100 * work.fraction());
    const float middle = 0.5f * (area.lower.x + area.upper.x);
    label(list, {middle - 0.5f * ImGui::CalcTextSize(text.c_str()).x, area.lower.y + 42}, text);
}

// An Error's "what: where; what to do": a heading, the log in one-width letters, a hint.
struct Message {
    std::string what, where, toDo;
};

Message parts(const std::string& text) {
    const auto colon = text.find(": "), semicolon = text.rfind("; ");
    if (colon == std::string::npos || semicolon == std::string::npos || semicolon < colon)
        return {text, "", ""};
    return {text.substr(0, colon), text.substr(colon + 2, semicolon - colon - 2),
            text.substr(semicolon + 2)};
}

void drawOverlay(ImDrawList* list, const ViewerState& state, const Ui& ui, const Rect& area) {
    const Message message = parts(state.overlay);
    const float width = area.upper.x - area.lower.x - 2 * kMargin - 28;
    const ImVec2 at(area.lower.x + kMargin, area.lower.y + kMargin);
    ImGui::PushFont(ui.code());
    const float size = ImGui::GetFontSize();
    const float logHeight = ImGui::CalcTextSize(message.where.c_str(), nullptr, false, width).y;
    ImGui::PopFont();
    const float height = 40 + logHeight + 40;
    list->AddRectFilled(at, {area.upper.x - kMargin, at.y + height}, IM_COL32(26, 20, 20, 238), 4);
    list->AddRectFilled(at, {at.x + 5, at.y + height}, IM_COL32(235, 90, 70, 255), 2);
    list->AddText({at.x + 18, at.y + 12}, IM_COL32(255, 140, 115, 255), message.what.c_str());
    list->AddText(ui.code(), size, {at.x + 18, at.y + 40}, IM_COL32(240, 236, 230, 255),
                  message.where.c_str(), nullptr, width);
    list->AddText({at.x + 18, at.y + 40 + logHeight + 10}, IM_COL32(170, 165, 160, 255),
                  message.toDo.c_str());
}

}  // namespace

PictureArea::Drag PictureArea::beginDrag(ViewerState& state, const Pictures& pictures) {
    const ImGuiIO& io = ImGui::GetIO();
    const Rect area = areaRect();
    const bool left = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (!left) return Drag::pan;
    if (pictures.inset().id() &&
        insetRect(area, pictures.inset().size(), state.insetEnlarged).holds(io.MousePos)) {
        state.insetEnlarged = !state.insetEnlarged;
        return Drag::none;
    }
    const float divider = area.lower.x + state.divider * (area.upper.x - area.lower.x);
    if (state.view == PictureView::split && std::abs(io.MousePos.x - divider) <= kDividerReach)
        return Drag::divider;
    if (io.KeyCtrl || glfwGetKey(window_, GLFW_KEY_L) == GLFW_PRESS) return Drag::light;
    return io.KeyShift ? Drag::pan : Drag::orbit;
}

void PictureArea::drag(ViewerState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    const Rect area = areaRect();
    const float height = area.upper.y - area.lower.y;
    const glm::vec2 moved = glm::vec2(io.MouseDelta.x, -io.MouseDelta.y) / height;
    if (drag_ == Drag::divider)
        state.divider =
            std::clamp((io.MousePos.x - area.lower.x) / (area.upper.x - area.lower.x), 0.0f, 1.0f);
    if (moved == glm::vec2(0)) return;
    Session& session = state.session;
    if (drag_ == Drag::orbit)
        orbit(session.camera, kRadiansPerHeight * glm::vec2(moved.x, -moved.y));
    if (drag_ == Drag::pan) pan(session.camera, {moved.x, -moved.y});
    if (drag_ == Drag::light)
        orbitLight(session.light, session.camera, bounds(session.scene()).center(),
                   kRadiansPerHeight * moved);
}

void PictureArea::draw(ViewerState& state, const Ui& ui, const Pictures& pictures,
                       const Texture& shown) {
    const Rect area = areaRect();
    ImGui::SetNextWindowPos(area.lower);
    ImGui::SetNextWindowSize({area.upper.x - area.lower.x, area.upper.y - area.lower.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::Begin("picture", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(area.lower, area.upper, IM_COL32(60, 62, 66, 255));
    if (shown.id()) addImage(list, shown, area);

    ImGui::InvisibleButton("area", {area.upper.x - area.lower.x, area.upper.y - area.lower.y},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    state.log.item("picture", area.lower.x, area.lower.y, area.upper.x, area.upper.y);
    if (ImGui::IsItemActivated()) drag_ = beginDrag(state, pictures);
    // Not in the frame of the press: the mouse may have jumped to where it is.
    if (ImGui::IsItemActive() && !ImGui::IsItemActivated()) drag(state);
    if (ImGui::IsItemHovered() && ImGui::GetIO().MouseWheel != 0)
        dolly(state.session.camera, ImGui::GetIO().MouseWheel);

    if (state.view == PictureView::split && pictures.hasTruth()) drawDivider(list, state, area);
    const bool needsTruth =
        state.view != PictureView::picture && state.view != PictureView::visibility;
    if (needsTruth && !pictures.hasTruth())
        label(list, {area.lower.x + kMargin, area.lower.y + 12}, state.truthNote);
    if (state.view == PictureView::difference && pictures.hasTruth())
        label(list, {area.lower.x + kMargin, area.lower.y + 12},
              "mine minus truth: red too light, blue too dark");
    drawInset(list, state, pictures, area);
    if (state.unfinished) drawUnfinished(list, *state.unfinished, area);
    if (!state.overlay.empty()) drawOverlay(list, state, ui, area);
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace penumbra
