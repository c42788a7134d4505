// The study's figures, and the files that hold them.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/image.h"
#include "core/metrics.h"

namespace penumbra {

struct Spread {
    double minimum = 0, median = 0, maximum = 0;
};
Spread spread(std::vector<double> values);  // not empty

// One program with one choice of settings on one scene.
struct StudyPoint {
    std::string program, curve, scene;
    std::string settings;    // those that differ from the defaults
    std::string light = "";  // point | square: the truth that it is compared with
    std::string error = "";  // no figures: why
    bool competitor = false;
    bool submission = false;
    Metrics metrics = {};
    Spread frame = {}, floor = {}, floors = {};  // milliseconds, milliseconds, frame / floor
    Spread wall = {};                            // milliseconds by the clock on the wall
    std::map<std::string, double> passes = {};   // median milliseconds
    double textureBytes = 0;
    std::string notes = "";
    bool front = false;        // nothing of this scene and light is both cheaper and closer
    std::string picture = "";  // key of StudyResults::pictures
};

struct StudyTruth {
    std::string scene, light;
    int samples = 0;           // rays to a pixel; 0: a closed form
    double standardError = 0;  // root mean square over the pixels, measured from two halves
    std::string picture;

    std::string text() const;  // "closed form", "one ray", "1024 rays, standard error 0.0006"
};

struct StudyResults {
    std::string date, commit, processor, renderer, version;
    std::string timer, totalsTimer;  // what passes are timed with; frames and floors
    glm::ivec2 size{0};
    bool quick = false;
    int repetitions = 0;
    std::vector<StudyPoint> points;
    std::vector<StudyTruth> truths;
    std::map<std::string, Image> pictures;  // visibility, at the page's size
    std::vector<std::string> warnings;
};

// Sets `front` of every point.
void findFronts(std::vector<StudyPoint>& points);

std::string studyJson(const StudyResults& results);
std::string studyCsv(const StudyResults& results);

}  // namespace penumbra
