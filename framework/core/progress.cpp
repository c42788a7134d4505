#include "core/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#ifdef _WIN32
#include <io.h>
#define isatty _isatty
#define fileno _fileno
#else
#include <unistd.h>
#endif

namespace penumbra {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

Progress::Progress(std::string label, long total, bool quiet)
    : label_(std::move(label)),
      total_(std::max(total, 1L)),
      start_(Clock::now()),
      lastDraw_(start_),
      quiet_(quiet),
      terminal_(isatty(fileno(stderr)) != 0) {}

Progress::~Progress() {
    if (drawn_ && terminal_) draw(true);
}

double Progress::fraction() const { return std::min(1.0, double(done_) / double(total_)); }

void Progress::advance(long steps) {
    done_ += steps;
    if (quiet_) return;
    const std::unique_lock lock(drawing_, std::try_to_lock);
    const auto now = Clock::now();
    if (!lock.owns_lock() || now - start_ < 500ms || now - lastDraw_ < 100ms) return;
    lastDraw_ = now;
    draw(false);
}

void Progress::draw(bool last) {
    const double part = last && !cancelled ? 1.0 : fraction();
    if (terminal_) {
        constexpr int kWidth = 40;
        const int full = int(part * kWidth);
        const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
        const double left = part > 0 ? elapsed * (1 - part) / part : 0;
        fmt::print(stderr, "\r{:<28} [{}{}] {:3.0f} %  {:.0f} s left \033[K", label_,
                   std::string(std::size_t(full), '#'),
                   std::string(std::size_t(kWidth - full), '.'), 100 * part, left);
        if (last) fmt::print(stderr, "\n");
    } else if (const int tenth = int(10 * part); tenth > lastTenth_) {
        lastTenth_ = tenth;
        fmt::print(stderr, "{}: {} %\n", label_, 10 * tenth);
    }
    std::fflush(stderr);
    drawn_ = true;
}

}  // namespace penumbra
