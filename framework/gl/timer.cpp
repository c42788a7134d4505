#include "gl/timer.h"

#include <cstring>

namespace penumbra {

bool usesTimerQueries() {
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return renderer && !std::strstr(renderer, "llvmpipe") && !std::strstr(renderer, "softpipe") &&
           !std::strstr(renderer, "swrast");
}

PassTimer::PassTimer(double& milliseconds) : milliseconds_(milliseconds) {
    if (usesTimerQueries()) {
        glGenQueries(1, &query_);
        glBeginQuery(GL_TIME_ELAPSED, query_);
    } else {
        glFinish();
        start_ = std::chrono::steady_clock::now();
    }
}

PassTimer::~PassTimer() {
    if (query_) {
        glEndQuery(GL_TIME_ELAPSED);
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
        glDeleteQueries(1, &query_);
        milliseconds_ += 1e-6 * double(nanoseconds);
    } else {
        glFinish();
        const auto elapsed = std::chrono::steady_clock::now() - start_;
        milliseconds_ += std::chrono::duration<double, std::milli>(elapsed).count();
    }
}

}  // namespace penumbra
