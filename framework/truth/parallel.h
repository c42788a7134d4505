// A loop over rows on all cores. Which thread takes which row is left to chance, so a body must
// write only what belongs to its index: then results do not depend on the number of threads.
//
//   parallelFor(height, [&](int y) { … });
#pragma once

#include <functional>

namespace penumbra {

// Calls body(0) … body(count - 1), each once, in denormal-flushing mode (embree.h). `body` must not
// throw.
void parallelFor(int count, const std::function<void(int)>& body);

// Threads that parallelFor uses; 0 = one for each core, the default.
void setThreadCount(int count);
int threadCount();

}  // namespace penumbra
