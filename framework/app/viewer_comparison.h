// Keeps the truth of the view and the error against it up to date.
//
//   if (comparison.update(state, pictures, view, restedFor)) …   // something to show is new
#pragma once

#include <chrono>
#include <vector>

#include "app/viewer_state.h"
#include "app/viewer_truth.h"

namespace penumbra {

class Comparison {
public:
    using Clock = std::chrono::steady_clock;

    // `view`: all that the truth depends on, as numbers. It is traced once they rest and dropped as
    // soon as they differ.
    bool update(ViewerState& state, Pictures& pictures, const std::vector<double>& view,
                Clock::duration restedFor);
    void mineChanged() { due_ = true; }
    // Whether update() has something to do soon, without any event.
    bool pending(const ViewerState& state) const;

private:
    void drop(ViewerState& state, Pictures& pictures);
    bool compare(ViewerState& state, const Pictures& pictures);
    std::string note(const ViewerState& state) const;

    TruthTracer tracer_;
    std::vector<double> traced_;          // the view being traced, or traced; empty = none
    std::shared_ptr<const Scene> scene_;  // likewise
    TruthPass truth_;                     // as shown; its image is empty while there is none
    Clock::time_point comparedAt_{};
    bool due_ = false;    // mine or truth is newer than the numbers
    bool finite_ = true;  // mine, when last compared
};

}  // namespace penumbra
