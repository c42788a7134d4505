// The ray-traced truth of what the window shows, traced in the background, coarse first.
//
//   TruthTracer tracer;
//   tracer.request({.scene = scene, .camera = camera, .light = light, .size = size});
//   if (auto pass = tracer.take()) …   // newest finished pass; never waits
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/assignment.h"
#include "core/image.h"
#include "core/progress.h"
#include "truth/ray_tracer.h"

namespace penumbra {

struct TruthRequest {
    std::shared_ptr<const Scene> scene;  // the ray tracer is rebuilt when it is another one
    Camera camera;
    Light light;
    glm::ivec2 size{0};  // pixels
    LightModel model = LightModel::point;
};

struct TruthPass {
    Image visibility = {};  // of the whole size; with stride > 1, blocks of pixels repeat one
    int stride = 1;         // every stride-th pixel was traced, through its own centre
    int samples = 1;        // per traced pixel
    bool last = false;
};

// The pixels that a pass of that stride traces, as an image of their own.
Image everyNth(const Image& image, int stride);

class TruthTracer {
public:
    TruthTracer();
    ~TruthTracer();  // cancels and waits for the row at work

    void request(TruthRequest request);  // what runs is cancelled
    void cancel();
    std::optional<TruthPass> take();

    bool busy() const;
    double fraction() const;  // of all passes of the request
    std::string error() const;

private:
    struct Plan {
        int stride, samples;
    };
    struct Accumulated {
        Image mean;
        int samples = 0;
    };
    void work();
    void trace(const TruthRequest& request, long generation);
    bool tracePass(const TruthRequest& request, const Receivers& all, const Plan& plan,
                   Accumulated& full, long generation, bool last);
    std::shared_ptr<Progress> begin(const Plan& plan, int rows, long generation);

    mutable std::mutex mutex_;  // everything down to `thread_`, but for what only the worker uses
    std::condition_variable wake_;
    std::optional<TruthRequest> next_;
    std::optional<TruthPass> finished_;
    std::shared_ptr<Progress> progress_;  // of the pass at work
    double workDone_ = 0, workNow_ = 0, workTotal_ = 1;
    std::string error_;
    long generation_ = 0;  // counts requests and cancellations: a pass of an older one is dropped
    bool working_ = false, stop_ = false;

    std::shared_ptr<const Scene> tracedScene_;  // worker only
    std::optional<RayTracer> tracer_;           // worker only
    std::thread thread_;                        // std::jthread is still missing in Apple's library
};

}  // namespace penumbra
