#include "app/viewer_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace penumbra {

ViewerLog::ViewerLog() {
    if (const char* name = std::getenv("PENUMBRA_UI_LOG"); name && *name)
        file_.open(name, std::ios::app);
}

void ViewerLog::line(const std::string& text) {
    if (!on()) return;
    std::string flat = text;
    std::replace(flat.begin(), flat.end(), '\n', '|');
    file_ << flat << std::endl;  // a test waits for the line
}

void ViewerLog::item(const std::string& name, float x0, float y0, float x1, float y1) {
    if (!on()) return;
    const std::string text =
        fmt::format("item {} {:.0f} {:.0f} {:.0f} {:.0f}", name, x0, y0, x1, y1);
    std::string& last = items_[name];
    if (last == text) return;
    last = text;
    line(text);
}

}  // namespace penumbra
