// One control for each declared setting.
#pragma once

#include "app/viewer_state.h"

namespace penumbra {

void drawSettings(ViewerState& state);

}  // namespace penumbra
