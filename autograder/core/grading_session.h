// One grading run: the variant under test, its scratch folder, frames already rendered, and the
// record of the check that is running. checks.h speaks to the current session; tests make their
// own.
//
//   GradingSession session(program);            // current until it is destroyed
//   session.begin("Task1", "Fact"); … session.end();
#pragma once

#include <chrono>
#include <deque>
#include <stdexcept>
#include <unordered_map>

#include "core/record.h"
#include "core/runner.h"
#include "core/truth_cache.h"
#include "scene/scene.h"

namespace penumbra {

// Stops a check whose frame did not come. The check has already failed with the reason.
struct NoFrame : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct SessionOptions {
    TruthCache truths = {};
    bool picturesOfPassed = true;  // of comparisons that pass, too
};

class GradingSession {
public:
    explicit GradingSession(VariantProgram program, SessionOptions options = {});
    ~GradingSession();
    GradingSession(const GradingSession&) = delete;
    GradingSession& operator=(const GradingSession&) = delete;
    static GradingSession& current();

    void begin(const std::string& suite, const std::string& name);
    CheckRecord end();
    CheckRecord& check() { return check_; }
    bool stopped() const { return stopped_; }  // by NoFrame: the check has its reason

    // Renders, or gives the frame of an equal request made before. Throws NoFrame for the program's
    // fault, Error for the grader's own.
    std::shared_ptr<const FrameFile> render(const RenderRequest& request);
    std::vector<glm::vec4> evaluate(const EvaluateRequest& request);

    // The path of a .glb that holds `scene`; equal scenes share a file, hence frames.
    std::string sceneFile(const Scene& scene);

    const TruthCache& truths() const { return options_.truths; }  // checks ask truths.h
    bool picturesOfPassed() const { return options_.picturesOfPassed; }

    int runs() const { return runs_; }
    std::size_t peakBytes() const { return peakBytes_; }
    const std::filesystem::path& scratch() const { return scratch_.path(); }

private:
    void account(const RunOutcome& outcome);
    [[noreturn]] void fail(const std::string& reason, bool graderFault);

    VariantProgram program_;
    SessionOptions options_;
    ScratchFolder scratch_;
    std::unordered_map<std::string, RunOutcome> frames_;
    std::deque<std::string> oldestFirst_;
    std::size_t cachedBytes_ = 0;
    CheckRecord check_;
    bool stopped_ = false;
    std::chrono::steady_clock::time_point start_;
    int runs_ = 0;
    int scenes_ = 0;
    std::size_t peakBytes_ = 0;
};

}  // namespace penumbra
