#include "core/grading_session.h"

#include <fmt/format.h>

#include <fstream>

#include "core/error.h"
#include "core/handout_hash.h"
#include "scene/gltf.h"

namespace penumbra {

namespace {

GradingSession* currentSession = nullptr;

// A grader may hold 700 MB in all; frames of 256² are 1 MB and less.
constexpr std::size_t kCacheBytes = std::size_t(128) << 20;

std::size_t bytesOf(const RunOutcome& outcome) {
    std::size_t sum = 0;
    if (outcome.frame)
        for (const auto& [name, image] : outcome.frame->images)
            sum += sizeof(float) * image.pixels.size();
    return sum;
}

std::string keyOf(const RenderRequest& request) {
    std::string key = inWords(request) + fmt::format(" limit {}", request.limits.wallSeconds);
    for (const auto& image : request.images)
        key += fmt::format(" {}x{}", image.size.x, image.size.y);
    return key;
}

}  // namespace

GradingSession::GradingSession(VariantProgram program, SessionOptions options)
    : program_(std::move(program)), options_(std::move(options)) {
    EXPECTS(!currentSession);
    currentSession = this;
}

GradingSession::~GradingSession() { currentSession = nullptr; }

GradingSession& GradingSession::current() {
    EXPECTS(currentSession);
    return *currentSession;
}

void GradingSession::begin(const std::string& suite, const std::string& name) {
    check_ = {};
    stopped_ = false;
    check_.suite = suite, check_.name = name;
    check_.sentence = sentence(suite, name);
    start_ = std::chrono::steady_clock::now();
}

CheckRecord GradingSession::end() {
    check_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return std::move(check_);
}

void GradingSession::fail(const std::string& reason, bool graderFault) {
    if (graderFault)
        throw Error("the program did not run", reason, "repair the machine or the build");
    stopped_ = true;
    check_.reasons.push_back(reason);
    throw NoFrame(reason);
}

void GradingSession::account(const RunOutcome& outcome) {
    if (program_.broken.empty()) ++runs_;
    peakBytes_ = std::max(peakBytes_, outcome.peakBytes);
}

std::shared_ptr<const FrameFile> GradingSession::render(const RenderRequest& request) {
    const std::string key = keyOf(request);
    check_.frames.push_back(inWords(request));
    auto it = frames_.find(key);
    if (it == frames_.end()) {
        const RunOutcome outcome = runRender(program_, request, scratch_.path());
        account(outcome);
        cachedBytes_ += bytesOf(outcome);
        while (cachedBytes_ > kCacheBytes && !oldestFirst_.empty()) {
            cachedBytes_ -= bytesOf(frames_.at(oldestFirst_.front()));
            frames_.erase(oldestFirst_.front());
            oldestFirst_.pop_front();
        }
        it = frames_.emplace(key, outcome).first;
        oldestFirst_.push_back(key);
    }
    if (!it->second.frame) fail(it->second.reason, it->second.graderFault);
    return it->second.frame;
}

std::vector<glm::vec4> GradingSession::evaluate(const EvaluateRequest& request) {
    check_.frames.push_back(fmt::format("{}: {}", request.chunk, request.expression));
    const RunOutcome outcome = runEvaluate(program_, request, scratch_.path());
    account(outcome);
    if (!outcome.frame) fail(outcome.reason, outcome.graderFault);
    const Image& image = outcome.frame->images.at("result");
    std::vector<glm::vec4> rows;
    for (int i = 0; i < image.width; ++i)
        rows.push_back(
            {image.at(i, 0, 0), image.at(i, 0, 1), image.at(i, 0, 2), image.at(i, 0, 3)});
    return rows;
}

std::string GradingSession::sceneFile(const Scene& scene) {
    const auto part = scratch_.path() / fmt::format("scene-{}.part.glb", ++scenes_);
    saveGlb(part, scene);
    std::ifstream stream(part, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    const auto path = scratch_.path() / fmt::format("scene-{}.glb", hashOf(bytes));
    std::filesystem::rename(part, path);
    return path.string();
}

}  // namespace penumbra
