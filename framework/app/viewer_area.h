// The picture's part of the window: the image, what lies over it, and what the mouse does there.
#pragma once

#include "app/viewer_state.h"
#include "app/viewer_ui.h"

namespace penumbra {

class PictureArea {
public:
    explicit PictureArea(GLFWwindow* window) : window_(window) {}
    void draw(ViewerState& state, const Ui& ui, const Pictures& pictures, const Texture& shown);

private:
    enum class Drag { none, orbit, pan, light, divider };

    Drag beginDrag(ViewerState& state, const Pictures& pictures);
    void drag(ViewerState& state);

    GLFWwindow* window_;
    Drag drag_ = Drag::none;
};

}  // namespace penumbra
