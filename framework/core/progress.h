// A progress bar on stderr for work that a person waits for: a live bar on a terminal, a line for
// every tenth part in a log file, nothing for work that ends within half a second. A quiet one
// draws nothing: the viewer shows fraction() itself.
//
//   Progress progress("tracing", rows);
//   … progress.advance();   // from any thread
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

namespace penumbra {

class Progress {
public:
    Progress(std::string label, long total, bool quiet = false);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void advance(long steps = 1);
    double fraction() const;
    const std::string& label() const { return label_; }

    // The work should stop soon: set by the viewer when the camera moves, read by the worker.
    std::atomic<bool> cancelled = false;

private:
    void draw(bool last);

    std::string label_;
    long total_;
    std::atomic<long> done_ = 0;
    std::mutex drawing_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point lastDraw_;
    int lastTenth_ = 0;
    bool quiet_ = false;
    bool terminal_ = false;
    bool drawn_ = false;
};

}  // namespace penumbra
