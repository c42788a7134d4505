#include "app/viewer_settings.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace penumbra {

namespace {

constexpr float kLabelWidth = 122, kResetWidth = 24, kPlayWidth = 44;

std::string words(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

// '%' is ImGui's.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '%' ? std::string("%%") : std::string(1, c);
    return result;
}

bool numberSlider(Setting& s) {
    const std::string format = (s.maximum - s.minimum >= 100 ? "%.1f " : "%.3f ") + escaped(s.unit);
    return ImGui::SliderScalar("##value", ImGuiDataType_Double, &s.value, &s.minimum, &s.maximum,
                               format.c_str(), ImGuiSliderFlags_AlwaysClamp);
}

bool integerSlider(Setting& s) {
    int value = int(s.value);
    const std::string format = "%d " + escaped(s.unit);
    const bool changed = ImGui::SliderInt("##value", &value, int(s.minimum), int(s.maximum),
                                          format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    s.value = value;
    return changed;
}

bool toggle(Setting& s) {
    bool on = s.value != 0;
    const bool changed = ImGui::Checkbox("##value", &on);
    s.value = on;
    return changed;
}

bool choice(Setting& s) {
    bool changed = false;
    const auto label = [&](std::size_t i) {
        return s.choices[i] + (s.unit.empty() ? "" : " " + s.unit);
    };
    if (!ImGui::BeginCombo("##value", label(std::size_t(s.value)).c_str())) return false;
    for (std::size_t i = 0; i < s.choices.size(); ++i)
        if (ImGui::Selectable(label(i).c_str(), double(i) == s.value)) {
            changed = double(i) != s.value;
            s.value = double(i);
        }
    ImGui::EndCombo();
    return changed;
}

bool control(Setting& s) {
    switch (s.kind) {
        case Setting::Kind::number:
            return numberSlider(s);
        case Setting::Kind::integer:
            return integerSlider(s);
        case Setting::Kind::toggle:
            return toggle(s);
        case Setting::Kind::choice:
            return choice(s);
    }
    return false;
}

void tooltip(const Setting& s) {
    if (!ImGui::IsItemHovered()) return;
    std::string text = s.help;
    if (s.kind == Setting::Kind::number || s.kind == Setting::Kind::integer)
        text +=
            fmt::format("\n{} to {}{}", s.minimum, s.maximum, s.unit.empty() ? "" : " " + s.unit);
    Setting initial = s;
    initial.value = s.initial;
    text += fmt::format("\n--set {}={}   (default {})", s.name, Settings::text(s),
                        Settings::text(initial));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(360);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool resetButton(Setting& s, float right) {
    if (s.value == s.initial) return false;
    ImGui::SameLine(right - kResetWidth + 4);
    const bool pressed = ImGui::Button("x", {kResetWidth - 4, 0});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("back to the default");
    if (pressed) s.value = s.initial;
    return pressed;
}

void playButton(ViewerState& state) {
    ImGui::SameLine();
    if (ImGui::Button(state.playing ? "stop" : "play", {kPlayWidth, 0})) {
        state.playing = !state.playing;
        state.log.line(state.playing ? "play" : "stop");
    }
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    state.log.item("play", lower.x, lower.y, upper.x, upper.y);
}

void drawSetting(Setting& s, ViewerState& state) {
    ImGui::PushID(s.name.c_str());
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words(s.name).c_str());
    tooltip(s);
    ImGui::SameLine(kLabelWidth + ImGui::GetStyle().WindowPadding.x);
    const float play = s.plays ? kPlayWidth + ImGui::GetStyle().ItemSpacing.x : 0.0f;
    ImGui::SetNextItemWidth(right - ImGui::GetCursorPosX() - kResetWidth - play);
    bool changed = control(s);
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    state.log.item(s.name, lower.x, lower.y, upper.x, upper.y);
    tooltip(s);
    if (s.plays) playButton(state);
    changed |= resetButton(s, right);
    if (changed) state.log.line(fmt::format("setting {} {}", s.name, Settings::text(s)));
    ImGui::PopID();
}

}  // namespace

void drawSettings(ViewerState& state) {
    for (Setting& s : state.session.settings().all()) drawSetting(s, state);
}

}  // namespace penumbra
