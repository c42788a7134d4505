// A technique's dials. Each is declared once; slider, --set, the grader's cases, the study's sweep
// and the handout's table all read that one declaration.
//
//   settings.number({.name = "constant_bias", .help = "depth bias", .unit = "texels",
//                    .minimum = 0, .maximum = 16, .value = 1});
//   settings.choice({.name = "filter", .help = "…", .choices = {"off", "2x2"}, .value = 1});
//   float bias = settings["constant_bias"];
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

struct Setting {
    enum class Kind { number, integer, toggle, choice };

    std::string name;       // snake_case; the flag is --set name=value
    std::string help;       // one line
    std::string unit = "";  // texels, world units, degrees; "" = a pure number
    double minimum = 0.0;
    double maximum = 1.0;
    double value = 0.0;  // the default, then the current value; index for a choice
    std::vector<std::string> choices = {};
    bool plays = false;        // a number that the window can advance by itself, 1 a second
    Kind kind = Kind::number;  // set by the declaring call
    double initial = 0.0;      // likewise: the declared value, what a reset goes back to
};

class Settings {
public:
    void number(Setting setting);   // any value in [minimum, maximum]
    void integer(Setting setting);  // whole numbers in [minimum, maximum]
    void toggle(Setting setting);   // 0 off, 1 on
    void choice(Setting setting);   // one of `choices`

    // The current value. Asking for an undeclared name is our own mistake.
    float operator[](std::string_view name) const;
    bool on(std::string_view name) const { return (*this)[name] != 0.0f; }
    int index(std::string_view name) const { return int((*this)[name]); }
    const std::string& chosen(std::string_view name) const;

    // Reads "name=value" ("filter=2x2", "second_depth=on", "constant_bias=1.5"); throws Error for
    // an unknown name, a value that is no number, or one out of range.
    void assign(std::string_view nameEqualsValue);

    // Every setting that plays moves on by so much and starts anew at its end. False: none plays.
    bool advance(double amount);

    // The value as --set takes it.
    static std::string text(const Setting& setting);

    std::vector<Setting>& all() { return settings_; }
    const std::vector<Setting>& all() const { return settings_; }

private:
    void declare(Setting setting, Setting::Kind kind);
    const Setting& find(std::string_view name) const;

    std::vector<Setting> settings_;
};

}  // namespace penumbra
