// What the window did, one line each, so that a test need not guess: PENUMBRA_UI_LOG=FILE.
//
//   item <name> x0 y0 x1 y1     where a control is, window coordinates; again when it moves
//   setting <name> <value>      the user changed it
//   frame <n> <mean visibility> after each redraw of the scene
//   view <name> · scene <name> · truth done rmse <x> · overlay <message> · overlay gone ·
//   screenshot <file>
#pragma once

#include <fstream>
#include <map>
#include <string>

namespace penumbra {

class ViewerLog {
public:
    ViewerLog();

    bool on() const { return file_.is_open(); }
    void line(const std::string& text);
    void item(const std::string& name, float x0, float y0, float x1, float y1);

private:
    std::ofstream file_;
    std::map<std::string, std::string> items_;  // as last written
};

}  // namespace penumbra
