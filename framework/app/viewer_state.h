// What the parts of the window tell each other: the panel and the picture's area write wishes, the
// viewer (viewer.cpp) fulfils them before the next frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session.h"
#include "app/viewer_log.h"
#include "app/viewer_pictures.h"
#include "core/metrics.h"

namespace penumbra {

constexpr float kPanelWidth = 340, kStatusHeight = 30;  // window units

struct ViewerState {
    Session& session;
    ViewerLog& log;

    // Wishes.
    PictureView view = PictureView::picture;
    float divider = 0.5f;    // of the picture's width, between mine and truth
    std::string inset = {};  // the frame's image in the corner, "" = none
    bool insetEnlarged = false;
    bool traceTruth = true;
    bool learnNames = true;        // draw every image once, to know what there is
    std::string wantedScene = {};  // to open before the next frame
    int seed = 1;
    bool entered = false;  // Enter was pressed since the last frame
    bool typing = false;   // a text field takes the keys
    char path[1024] = "";  // as typed
    bool screenshot = false;
    bool playing = false;  // settings that play advance with the clock

    // What there is to see.
    std::string sceneName = {}, sceneError = {};
    std::size_t triangles = 0;
    std::vector<std::string> imageNames = {};
    glm::ivec2 size{0};  // of the picture, pixels
    double redrawMilliseconds = 0;
    std::vector<std::pair<std::string, double>> passes = {};  // milliseconds
    std::vector<std::string> notes = {};                      // of the frame
    std::shared_ptr<const Progress> unfinished = nullptr;     // of the frame
    std::optional<Metrics> metrics = {};
    std::string truthNote = {};  // what the truth is, or why there is none
    double truthFraction = 0;
    bool truthBusy = false;
    std::string overlay = {};  // an error to read over the last good picture
    std::string renderer = {}, notice = {};
    std::shared_ptr<const Scene> scene = nullptr;  // as loaded; the ray tracer keeps it too
    Box box = {};                                  // of the scene
    float cameraFar = 100;                         // of the scene as loaded
};

const char* viewName(PictureView view);

// viewer_panel.cpp. Everything right of the picture, and the line below it.
void drawPanel(ViewerState& state);
void drawStatus(const ViewerState& state);

}  // namespace penumbra
