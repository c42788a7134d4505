#include "app/viewer.h"

namespace penumbra {

void runViewer(Session&, Context&) {}

}  // namespace penumbra
