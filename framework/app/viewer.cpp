#include "app/viewer.h"

#include <glad/gl.h>
// GLFW after glad: both want to be the one that declares OpenGL.
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "app/viewer_area.h"
#include "app/viewer_camera.h"
#include "app/viewer_comparison.h"
#include "app/viewer_keys.h"
#include "app/viewer_screenshot.h"
#include "core/error.h"
#include "scene/gallery.h"
#include "truth/parallel.h"

namespace penumbra {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Key = std::vector<double>;  // what a picture depends on: redrawn when it differs

constexpr auto kFrame = 16667us;     // 60 a second at most
constexpr auto kShaderPoll = 250ms;  // between looks at the shader files
constexpr int kSettlingFrames = 3;   // the interface needs some frames to follow an event

void append(Key& key, glm::vec3 v) { key.insert(key.end(), {v.x, v.y, v.z}); }

// Of the window; on some screens it is larger than the window's size.
glm::ivec2 pixelSize(GLFWwindow* window) {
    glm::ivec2 pixels(1);
    glfwGetFramebufferSize(window, &pixels.x, &pixels.y);
    return pixels;
}

class Viewer {
public:
    Viewer(Session& session, Context& context);
    void run();

private:
    void waitForWork();
    void obeyKeys();
    void learnScene();
    void play();
    void openWantedScene();
    void sceneChanged(const std::string& name);
    void pollShaders();
    void showOverlay();
    glm::ivec2 pictureSize() const;
    Key viewKey() const;
    Key pictureKey() const;
    void redrawIfChanged();
    void redraw();
    void learnUnfinished(const Frame& frame);
    void learnNames(const Frame& frame);
    void drawWindow();
    void takeScreenshot();

    Session& session_;
    GLFWwindow* window_;
    ViewerLog log_;
    ViewerState state_{session_, log_};
    ViewerKeys keys_;  // before ui_, which chains to its callback
    Ui ui_;
    Pictures pictures_;
    PictureArea area_;
    Comparison comparison_;

    Key drawn_, seen_;  // as last redrawn; the view of the last frame
    std::string renderError_;
    long frames_ = 0, reloads_ = 0, revision_ = -1;
    int lively_ = kSettlingFrames;  // frames still to be drawn without waiting for an event
    Clock::time_point movedAt_{}, polledAt_{}, noticeUntil_{}, frameStart_{}, playedAt_{};
};

Viewer::Viewer(Session& session, Context& context)
    : session_(session),
      window_(context.window()),
      keys_(window_),
      ui_(window_),
      pictures_(session.shaders().layers()),
      area_(window_) {
    state_.renderer = context.renderer();
    session_.interactive = true;
    // One core stays with the interface.
    setThreadCount(std::max(1, int(std::thread::hardware_concurrency()) - 1));
    glfwSwapInterval(1);
    sceneChanged(session.scene().name);
}

void Viewer::sceneChanged(const std::string& name) {
    learnScene();
    state_.sceneName = name;
    state_.sceneError.clear();
    state_.triangles = triangleCount(*state_.scene);
    state_.cameraFar = session_.camera.farPlane;
    state_.learnNames = true;
    log_.line("scene " + name);
}

// A copy for the ray tracer's thread; anew whenever the settings arrange the scene otherwise.
void Viewer::learnScene() {
    if (revision_ == session_.revision()) return;
    revision_ = session_.revision();
    state_.scene = std::make_shared<Scene>(session_.scene());
    state_.box = bounds(*state_.scene);
}

void Viewer::play() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> passed = now - std::exchange(playedAt_, now);
    if (!state_.playing) return;
    state_.playing = session_.settings().advance(passed.count());
    lively_ = kSettlingFrames;
}

void Viewer::openWantedScene() {
    if (state_.wantedScene.empty()) return;
    const std::string name = std::exchange(state_.wantedScene, {});
    try {
        session_.open(loadScene(name));
        sceneChanged(name);
    } catch (const std::exception& e) {
        state_.sceneError = e.what();
        log_.line("scene-error " + state_.sceneError);
    }
    lively_ = kSettlingFrames;
}

void Viewer::obeyKeys() {
    state_.entered = false;
    for (const int key : keys_.take()) {
        if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) state_.entered = true;
        if (state_.typing) continue;
        if (key >= GLFW_KEY_1 && key <= GLFW_KEY_5) state_.view = PictureView(key - GLFW_KEY_1);
        if (key == GLFW_KEY_P || key == GLFW_KEY_F12) state_.screenshot = true;
        if (key == GLFW_KEY_ESCAPE) state_.insetEnlarged = false;
        if (key == GLFW_KEY_R) {
            session_.camera = state_.scene->camera;
            session_.light = state_.scene->lights[0];
        }
    }
}

void Viewer::pollShaders() {
    if (Clock::now() - polledAt_ < kShaderPoll) return;
    polledAt_ = Clock::now();
    if (session_.shaders().reload()) ++reloads_;
}

// The last good picture stays under it.
void Viewer::showOverlay() {
    std::string overlay = session_.shaders().error();
    if (overlay.empty()) overlay = renderError_;
    if (overlay == state_.overlay) return;
    state_.overlay = overlay;
    log_.line(overlay.empty() ? "overlay gone" : "overlay " + overlay);
    lively_ = kSettlingFrames;
}

glm::ivec2 Viewer::pictureSize() const {
    glm::ivec2 window(1);
    glfwGetWindowSize(window_, &window.x, &window.y);
    const glm::vec2 scale =
        glm::vec2(pixelSize(window_)) / glm::vec2(glm::max(window, glm::ivec2(1)));
    const glm::vec2 area = (glm::vec2(window) - glm::vec2(kPanelWidth, kStatusHeight)) * scale;
    return glm::max(glm::ivec2(area), glm::ivec2(16));
}

// What the truth depends on, but for the scene.
Key Viewer::viewKey() const {
    const Camera& c = session_.camera;
    const Light& l = session_.light;
    const glm::ivec2 size = pictureSize();
    Key key{double(size.x), double(size.y), c.verticalFov, c.nearPlane,
            c.farPlane,     l.width,        l.range,       double(session_.revision())};
    for (const glm::vec3 v : {c.eye, c.target, c.up, l.center, l.right, l.up, l.color})
        append(key, v);
    return key;
}

Key Viewer::pictureKey() const {
    Key key = viewKey();
    for (const Setting& s : session_.settings().all()) key.push_back(s.value);
    key.push_back(double(reloads_));
    key.push_back(double(std::hash<std::string>()(state_.inset)));
    return key;
}

void Viewer::redrawIfChanged() {
    keepInRange(session_.camera, state_.box, state_.cameraFar);
    Key key = pictureKey();
    const bool nowFinished = state_.unfinished && state_.unfinished->fraction() >= 1;
    if (key == drawn_ && !state_.learnNames && !nowFinished) return;
    try {
        redraw();
        renderError_.clear();
    } catch (const std::exception& e) {
        renderError_ = e.what();
        state_.unfinished = nullptr;
    }
    drawn_ = std::move(key);
    lively_ = kSettlingFrames;
    // After the redraw, which may have arranged the scene anew and may have taken longer than a
    // rest.
    if (Key view = viewKey(); view != seen_) {
        seen_ = std::move(view);
        movedAt_ = Clock::now();
    }
}

void Viewer::redraw() {
    std::optional<std::set<std::string>> wanted;
    const bool all = std::exchange(state_.learnNames, false) || state_.imageNames.empty();
    if (!all) wanted = {"color", "visibility", state_.inset};
    const glm::ivec2 size = pictureSize();
    const auto start = Clock::now();
    const Frame frame = session_.render(size, wanted);
    learnScene();
    const std::chrono::duration<double, std::milli> elapsed = Clock::now() - start;
    if (all) learnNames(frame);
    pictures_.take(frame, state_.inset);
    state_.size = size;
    state_.redrawMilliseconds = elapsed.count();
    state_.passes.assign(frame.milliseconds().begin(), frame.milliseconds().end());
    state_.notes = frame.notes();
    learnUnfinished(frame);
    comparison_.mineChanged();
    ++frames_;
    if (!log_.on()) return;
    const Image visibility = pictures_.visibility();
    double sum = 0;
    for (const float v : visibility.pixels) sum += v;
    log_.line(fmt::format("frame {} {:.9f}", frames_, sum / double(visibility.pixels.size())));
}

void Viewer::learnUnfinished(const Frame& frame) {
    if (bool(state_.unfinished) != bool(frame.unfinished()))
        log_.line(frame.unfinished() ? "unfinished " + frame.unfinished()->label() : "finished");
    state_.unfinished = frame.unfinished();
}

void Viewer::learnNames(const Frame& frame) {
    std::set<std::string> names;
    for (const auto& [name, texture] : frame.textures()) names.insert(name);
    for (const auto& [name, image] : frame.images()) names.insert(name);
    const bool first = state_.imageNames.empty();
    state_.imageNames.assign(names.begin(), names.end());
    if (!first) return;
    for (const char* usual : {"color", "visibility", "depth"}) names.erase(usual);
    for (const auto& [name, image] : frame.images())  // lists and matrices say little to the eye
        if (image.width < 64 || image.height < 64) names.erase(name);
    if (names.count("shadow_map"))
        state_.inset = "shadow_map";
    else if (!names.empty())
        state_.inset = *names.begin();
}

void Viewer::drawWindow() {
    const Texture& shown = pictures_.compose(state_.view, state_.divider);
    ui_.begin();
    area_.draw(state_, ui_, pictures_, shown);
    drawPanel(state_);
    drawStatus(state_);
    ui_.end();
    takeScreenshot();
    glfwSwapBuffers(window_);
}

void Viewer::takeScreenshot() {
    if (!std::exchange(state_.screenshot, false)) return;
    try {
        const auto path = saveScreenshot(pixelSize(window_), state_.sceneName);
        state_.notice = "saved " + path.generic_string();
        log_.line("screenshot " + path.generic_string());
    } catch (const std::exception& e) {
        state_.notice = e.what();
    }
    noticeUntil_ = Clock::now() + 4s;
    lively_ = kSettlingFrames;
}

// Sleeps until an event comes; wakes for what runs beside: shader files, the truth's progress.
void Viewer::waitForWork() {
    if (lively_ > 0) {
        --lively_;
        std::this_thread::sleep_until(frameStart_ + kFrame);
        glfwPollEvents();
    } else {
        const double seconds = comparison_.pending(state_) ? 0.05 : 0.25;
        const auto before = Clock::now();
        glfwWaitEventsTimeout(seconds);
        const std::chrono::duration<double> waited = Clock::now() - before;
        if (waited.count() < 0.95 * seconds) lively_ = kSettlingFrames;
        std::this_thread::sleep_until(frameStart_ + kFrame);
    }
    frameStart_ = Clock::now();
}

void Viewer::run() {
    PictureView logged = state_.view;
    while (!glfwWindowShouldClose(window_)) {
        waitForWork();
        obeyKeys();
        openWantedScene();
        play();
        pollShaders();
        redrawIfChanged();
        showOverlay();
        if (comparison_.update(state_, pictures_, seen_, Clock::now() - movedAt_))
            lively_ = kSettlingFrames;
        if (Clock::now() > noticeUntil_) state_.notice.clear();
        drawWindow();
        if (logged != state_.view)
            log_.line(fmt::format("view {}", viewName(logged = state_.view)));
    }
}

}  // namespace

void runViewer(Session& session, Context& context) { Viewer(session, context).run(); }

}  // namespace penumbra
