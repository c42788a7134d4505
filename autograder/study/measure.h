// Runs the plan: every program on every scene, in rounds, against truth traced in the same run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/plan.h"
#include "study/results.h"

namespace penumbra {

struct StudyRequest {
    std::vector<StudyProgram> programs;
    std::vector<std::string> scenes;
    bool quick = false;
    glm::ivec2 size{512};
    int rounds = 3;              // over all programs and scenes, so that slow minutes hit all alike
    int repetitions = 3;         // of each point in a round
    int truthSamples = 1024;     // rays to a pixel
    std::filesystem::path kept;  // answers already measured; every new one is kept there at once
};

// A program that cannot be measured is a point with an error, never the end of the study. Throws
// Error for a scene that cannot be opened.
StudyResults measure(const StudyRequest& request);

}  // namespace penumbra
