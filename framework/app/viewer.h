// The window: the scene lit by your shader, sliders made from the settings, truth beside it.
#pragma once

#include <string>

#include "app/session.h"
#include "gl/context.h"

namespace penumbra {

// Runs until the window closes. `context` is a visible window's.
void runViewer(Session& session, Context& context);

}  // namespace penumbra
