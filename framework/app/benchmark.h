// What a technique costs: frames and floors (render/passes.h) side by side in one process.
//
//   printBenchmark(session, context, {.scenes = {"fence"}, .varied = {"map_size=1024"}});
//   sweepToFrameFile(session, context, {.varied = points, .repetitions = 3}, file);   // the study
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/session.h"
#include "gl/context.h"

namespace penumbra {

struct BenchmarkRequest {
    std::vector<std::string> scenes = {};
    glm::ivec2 size{512};
    int repetitions = 15;
    // One row each: what is changed of the session's settings, "name=value,name=value".
    std::vector<std::string> varied = {};
    bool play = false;  // settings that play advance 1/60 from frame to frame
};

// Cost in floors and RMSE against rays of each scene, printed as a table: the settings as they are,
// then each variation. Medians and spread of process CPU time on a software rasteriser, of timer
// queries on a GPU.
void printBenchmark(Session& session, const Context& context, const BenchmarkRequest& request);

// The same measurement of the open scene, every figure in one core/frame_file.h file, variation i
// and repetition r:
//
//   images        "visibility.i"
//   milliseconds  "frame.i.r", "floor.i.r", "wall.i.r", "pass.i.r.<name>"
//   info          infoStrings(), "totals_timer": what frames and floors are timed by, "bytes.i":
//   textures that the technique keeps, "notes.i"
//
// A variation whose frame fails is named in info "error.i"; the others go on.
void sweepToFrameFile(Session& session, const Context& context, const BenchmarkRequest& request,
                      const std::filesystem::path& file);

}  // namespace penumbra
