// One frame without a window: to files for a person, to one file for the grader.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/session.h"
#include "gl/context.h"

namespace penumbra {

// One .exr and .png per named image and frame.json, all of them or none.
void renderToFolder(Session& session, const Context& context, glm::ivec2 size,
                    const std::optional<std::set<std::string>>& wanted,
                    const std::filesystem::path& out);

// The wanted images in one core/frame_file.h file.
void renderToFrameFile(Session& session, const Context& context, glm::ivec2 size,
                       const std::optional<std::set<std::string>>& wanted,
                       const std::filesystem::path& file);

struct BenchmarkRequest {
    std::vector<std::string> scenes;
    glm::ivec2 size{512};
    int repetitions = 15;
    std::vector<std::string> varied = {};  // name=value: a row of its own, with that one changed
    bool play = false;                     // settings that play advance 1/60 from frame to frame
};

// Speed against error: cost in floors and RMSE against rays of each scene, printed as a table:
// frame and floor interleaved, medians and spread of process CPU time on a software rasteriser, of
// the wall clock on a GPU.
void printBenchmark(Session& session, const Context& context, const BenchmarkRequest& request);

}  // namespace penumbra
