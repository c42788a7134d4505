#include "planar_shadow.h"

namespace penumbra {

// The stencil buffer is all 0 and the casters are drawn, with their depth, when these two take
// their turn. `DrawState` and what its fields do: given/planar_shadow.h.

// Task 3a · how the receiver is drawn.                                                 README §3
// Leaves a mark in the stencil buffer at every pixel where the receiver is what the camera sees,
// and nowhere else.
DrawState receiverDrawing() {
    return {};  // yours
}

// Task 3b · how the flattened casters are drawn. Every fragment that passes multiplies the
// visibility of its pixel by 1 - alpha.                                                README §3
// Lets pass exactly one fragment of every pixel that bears the receiver's mark, whichever it is,
// and none of any other pixel. The flattened casters lie in the receiver's plane: which of the two
// has the smaller depth is a matter of rounding.
DrawState shadowDrawing() {
    return {};  // yours
}

}  // namespace penumbra
