#include "core/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.h"

namespace penumbra {

namespace {

std::string names(const std::vector<std::string>& list) {
    return fmt::format("{}", fmt::join(list, ", "));
}

double parse(const Setting& s, std::string_view text) {
    if (s.kind == Setting::Kind::choice) {
        const auto it = std::find(s.choices.begin(), s.choices.end(), text);
        if (it == s.choices.end())
            throw Error(fmt::format("no such choice '{}'", text), "setting " + s.name,
                        "choose one of " + names(s.choices));
        return double(it - s.choices.begin());
    }
    if (s.kind == Setting::Kind::toggle && (text == "on" || text == "off")) return text == "on";
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = s.kind == Setting::Kind::number || value == std::floor(value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) || !whole)
        throw Error(fmt::format("'{}' is not {}", text,
                                s.kind == Setting::Kind::number    ? "a number"
                                : s.kind == Setting::Kind::integer ? "a whole number"
                                                                   : "on or off"),
                    "setting " + s.name,
                    fmt::format("give a value from {} to {}", s.minimum, s.maximum));
    if (value < s.minimum || value > s.maximum)
        throw Error(fmt::format("{} is out of range", value), "setting " + s.name,
                    fmt::format("give a value from {} to {}{}{}", s.minimum, s.maximum,
                                s.unit.empty() ? "" : " ", s.unit));
    return value;
}

}  // namespace

void Settings::declare(Setting setting, Setting::Kind kind) {
    setting.kind = kind;
    setting.initial = setting.value;
    if (kind == Setting::Kind::toggle) setting.minimum = 0, setting.maximum = 1;
    if (kind == Setting::Kind::choice)
        setting.minimum = 0, setting.maximum = double(setting.choices.size()) - 1;
    EXPECTS(!setting.name.empty() && setting.minimum <= setting.value &&
            setting.value <= setting.maximum);
    for (const auto& other : settings_) EXPECTS(other.name != setting.name);
    settings_.push_back(std::move(setting));
}

bool Settings::advance(double amount) {
    bool any = false;
    for (Setting& s : settings_) {
        if (!s.plays) continue;
        any = true;
        s.value += amount;
        if (s.value > s.maximum) s.value = s.minimum;
    }
    return any;
}

void Settings::number(Setting setting) { declare(std::move(setting), Setting::Kind::number); }
void Settings::integer(Setting setting) { declare(std::move(setting), Setting::Kind::integer); }
void Settings::toggle(Setting setting) { declare(std::move(setting), Setting::Kind::toggle); }
void Settings::choice(Setting setting) { declare(std::move(setting), Setting::Kind::choice); }

const Setting& Settings::find(std::string_view name) const {
    const auto it = std::find_if(settings_.begin(), settings_.end(),
                                 [&](const Setting& s) { return s.name == name; });
    EXPECTS(it != settings_.end());
    return *it;
}

float Settings::operator[](std::string_view name) const { return float(find(name).value); }

const std::string& Settings::chosen(std::string_view name) const {
    const Setting& s = find(name);
    EXPECTS(s.kind == Setting::Kind::choice);
    return s.choices[std::size_t(s.value)];
}

void Settings::assign(std::string_view nameEqualsValue) {
    const auto equals = nameEqualsValue.find('=');
    if (equals == std::string_view::npos)
        throw Error(fmt::format("'{}' has no '='", nameEqualsValue), "--set", "write name=value");
    const auto name = nameEqualsValue.substr(0, equals);
    for (auto& s : settings_)
        if (s.name == name) {
            s.value = parse(s, nameEqualsValue.substr(equals + 1));
            return;
        }
    std::vector<std::string> known;
    for (const auto& s : settings_) known.push_back(s.name);
    throw Error(fmt::format("unknown setting '{}'", name), "--set",
                known.empty() ? "this assignment has none" : "choose one of " + names(known));
}

std::string Settings::text(const Setting& s) {
    if (s.kind == Setting::Kind::choice) return s.choices[std::size_t(s.value)];
    if (s.kind == Setting::Kind::toggle) return s.value != 0 ? "on" : "off";
    return fmt::format("{}", s.value);
}

}  // namespace penumbra
