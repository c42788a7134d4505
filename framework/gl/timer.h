// Milliseconds of one pass: timer queries on a GPU; on a software rasteriser, whose queries time
// one tile only (Mesa 22.3, measured), glFinish and a steady clock.
//
//   { PassTimer timing(milliseconds["light"]); … draw … }
#pragma once

#include <glad/gl.h>

#include <chrono>

namespace penumbra {

class PassTimer {
public:
    explicit PassTimer(double& milliseconds);  // adds to it at destruction
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

private:
    double& milliseconds_;
    GLuint query_ = 0;
    std::chrono::steady_clock::time_point start_;
};

// True when times come from timer queries; said in frame.json.
bool usesTimerQueries();

}  // namespace penumbra
