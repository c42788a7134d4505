#include "truth/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "core/error.h"
#include "truth/embree.h"

namespace penumbra {

namespace {
std::atomic<int> wantedThreads = 0;
}  // namespace

void setThreadCount(int count) {
    EXPECTS(count >= 0);
    wantedThreads = count;
}

int threadCount() {
    const int wanted = wantedThreads;
    return wanted > 0 ? wanted : std::max(1, int(std::thread::hardware_concurrency()));
}

void parallelFor(int count, const std::function<void(int)>& body) {
    std::atomic<int> next = 0;
    const auto work = [&] {
        const embree::FlushDenormals flush;
        for (int i = next++; i < count; i = next++) body(i);
    };
    std::vector<std::thread> helpers;  // std::jthread is still missing in Apple's library
    for (int i = 1; i < std::min(threadCount(), count); ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
}

}  // namespace penumbra
