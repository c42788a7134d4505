#include "app/viewer_comparison.h"

#include <fmt/format.h>

namespace penumbra {

using namespace std::chrono_literals;

namespace {
constexpr auto kRest = 200ms;   // of camera and light, before tracing starts
constexpr auto kPause = 200ms;  // between two comparisons while a slider moves
}  // namespace

bool Comparison::pending(const ViewerState& state) const {
    return state.truthBusy || state.unfinished || (state.traceTruth && traced_.empty()) ||
           (due_ && !truth_.visibility.empty());
}

void Comparison::drop(ViewerState& state, Pictures& pictures) {
    tracer_.cancel();
    traced_.clear();
    truth_ = {};
    pictures.dropTruth();
    state.metrics.reset();
}

bool Comparison::update(ViewerState& state, Pictures& pictures, const std::vector<double>& view,
                        Clock::duration restedFor) {
    if (!traced_.empty() && (traced_ != view || scene_ != state.scene || !state.traceTruth))
        drop(state, pictures);
    if (state.traceTruth && traced_.empty() && pictures.ready() && restedFor > kRest) {
        traced_ = view;
        scene_ = state.scene;
        tracer_.request({scene_, state.session.camera, state.session.light, state.size,
                         state.session.assignment().lightModel()});
    }
    bool news = false;
    if (auto pass = tracer_.take()) {
        truth_ = std::move(*pass);
        pictures.setTruth(truth_.visibility);
        due_ = news = true;
        comparedAt_ = {};
    }
    news |= compare(state, pictures);
    state.truthBusy = tracer_.busy() && !traced_.empty();
    state.truthFraction = tracer_.fraction();
    state.truthNote = note(state);
    return news;
}

bool Comparison::compare(ViewerState& state, const Pictures& pictures) {
    if (state.unfinished) state.metrics.reset();
    if (!due_ || state.unfinished || truth_.visibility.empty() ||
        Clock::now() - comparedAt_ < kPause)
        return false;
    due_ = false;
    comparedAt_ = Clock::now();
    state.metrics.reset();
    const Image mine = pictures.visibility();
    finite_ = nonFiniteCount(mine) == 0;
    if (!finite_ || !mine.sameShape(truth_.visibility)) return true;
    state.metrics = compareVisibility(everyNth(mine, truth_.stride),
                                      everyNth(truth_.visibility, truth_.stride));
    if (truth_.last) state.log.line(fmt::format("truth done rmse {:.6f}", state.metrics->rmse));
    return true;
}

std::string Comparison::note(const ViewerState& state) const {
    if (!state.traceTruth) return "not traced";
    if (const std::string error = tracer_.error(); !error.empty()) return error;
    if (!finite_) return "some of your visibility is not finite: no comparison";
    if (truth_.visibility.empty())
        return state.truthBusy ? "tracing" : "traced once camera and light rest";
    const std::string rays = state.session.assignment().lightModel() == LightModel::point
                                 ? "point light, one ray a pixel"
                                 : fmt::format("square light, {} rays a pixel", truth_.samples);
    return rays + (truth_.stride > 1 ? fmt::format(", every {}th pixel", truth_.stride) : "");
}

}  // namespace penumbra
