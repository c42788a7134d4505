#include "app/viewer_truth.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "truth/visibility.h"

namespace penumbra {

namespace {

int traced(int i, int stride, int size) { return std::min(i * stride + stride / 2, size - 1); }

Receivers everyNth(const Receivers& all, int stride) {
    Receivers few;
    few.width = (all.width + stride - 1) / stride;
    few.height = (all.height + stride - 1) / stride;
    for (int y = 0; y < few.height; ++y)
        for (int x = 0; x < few.width; ++x) {
            const auto i = std::size_t(traced(y, stride, all.height)) * std::size_t(all.width) +
                           std::size_t(traced(x, stride, all.width));
            few.positions.push_back(all.positions[i]);
            few.facetNormals.push_back(all.facetNormals[i]);
            few.hit.push_back(all.hit[i]);
        }
    return few;
}

Image repeated(const Image& few, int stride, glm::ivec2 size) {
    if (stride == 1) return few;
    Image all(size.x, size.y, 1);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) all.at(x, y) = few.at(x / stride, y / stride);
    return all;
}

}  // namespace

Image everyNth(const Image& image, int stride) {
    if (stride == 1) return image;
    Image few((image.width + stride - 1) / stride, (image.height + stride - 1) / stride, 1);
    for (int y = 0; y < few.height; ++y)
        for (int x = 0; x < few.width; ++x)
            few.at(x, y) =
                image.at(traced(x, stride, image.width), traced(y, stride, image.height));
    return few;
}

TruthTracer::TruthTracer() : thread_([this] { work(); }) {}

TruthTracer::~TruthTracer() {
    cancel();
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void TruthTracer::cancel() {
    const std::lock_guard lock(mutex_);
    ++generation_;
    next_.reset();
    finished_.reset();
    if (progress_) progress_->cancelled = true;
}

void TruthTracer::request(TruthRequest request) {
    cancel();
    const std::lock_guard lock(mutex_);
    next_ = std::move(request);
    workDone_ = workNow_ = 0;
    workTotal_ = 1;
    error_.clear();
    wake_.notify_all();
}

std::optional<TruthPass> TruthTracer::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(finished_, std::nullopt);
}

bool TruthTracer::busy() const {
    const std::lock_guard lock(mutex_);
    return working_ || next_;
}

double TruthTracer::fraction() const {
    const std::lock_guard lock(mutex_);
    return (workDone_ + (progress_ ? workNow_ * progress_->fraction() : 0)) / workTotal_;
}

std::string TruthTracer::error() const {
    const std::lock_guard lock(mutex_);
    return error_;
}

void TruthTracer::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        wake_.wait(lock, [&] { return stop_ || next_; });
        if (stop_) return;
        const TruthRequest request = std::move(*next_);
        next_.reset();
        working_ = true;
        const long generation = generation_;
        lock.unlock();
        std::string error;
        try {
            trace(request, generation);
        } catch (const std::exception& e) {
            error = e.what();
        }
        lock.lock();
        progress_.reset();
        working_ = false;
        if (generation == generation_) error_ = error;
    }
}

void TruthTracer::trace(const TruthRequest& request, long generation) {
    if (tracedScene_ != request.scene) {
        tracer_.emplace(*request.scene);
        tracedScene_ = request.scene;
    }
    // A light that is a point needs one ray; a square's noise halves with every later pass.
    const std::vector<Plan> plans = request.model == LightModel::point
                                        ? std::vector<Plan>{{4, 1}, {1, 1}}
                                        : std::vector<Plan>{{4, 16}, {1, 16}, {1, 48}, {1, 192}};
    {
        const std::lock_guard lock(mutex_);
        if (generation != generation_) return;
        workTotal_ = 0;
        for (const Plan& plan : plans)
            workTotal_ += double(plan.samples) / (plan.stride * plan.stride);
    }
    const Receivers all = tracer_->receivers(request.camera, request.size);
    Accumulated full;
    for (std::size_t i = 0; i < plans.size(); ++i)
        if (!tracePass(request, all, plans[i], full, generation, i + 1 == plans.size())) return;
}

// Null when nobody wants the pass any more.
std::shared_ptr<Progress> TruthTracer::begin(const Plan& plan, int rows, long generation) {
    const std::lock_guard lock(mutex_);
    if (generation != generation_) return nullptr;
    progress_ = std::make_shared<Progress>("truth", rows, true);
    workNow_ = double(plan.samples) / (plan.stride * plan.stride);
    return progress_;
}

bool TruthTracer::tracePass(const TruthRequest& request, const Receivers& all, const Plan& plan,
                            Accumulated& full, long generation, bool last) {
    const Receivers few = plan.stride > 1 ? everyNth(all, plan.stride) : Receivers{};
    const Receivers& receivers = plan.stride > 1 ? few : all;
    const auto progress = begin(plan, receivers.height, generation);
    if (!progress) return false;
    TruthPass pass{.stride = plan.stride, .samples = plan.samples, .last = last};
    // Another seed for each pass, so that their average is that of all samples.
    Image image = request.model == LightModel::point
                      ? pointVisibility(*tracer_, receivers, request.light)
                      : areaVisibility(*tracer_, receivers, request.light, plan.samples,
                                       progress.get(), std::uint32_t(1 + full.samples));
    if (plan.stride == 1 && full.samples > 0) {
        const float share = float(plan.samples) / float(plan.samples + full.samples);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = full.mean.pixels[i] + share * (image.pixels[i] - full.mean.pixels[i]);
    }
    if (plan.stride == 1) {
        full.samples += plan.samples;
        full.mean = image;
        pass.samples = full.samples;
    }
    pass.visibility = repeated(image, plan.stride, request.size);
    const std::lock_guard lock(mutex_);
    if (generation != generation_) return false;
    finished_ = std::move(pass);
    workDone_ += workNow_;
    progress_.reset();
    return true;
}

}  // namespace penumbra
