// How a check is written: a GoogleTest in autograder/NN-name/checks.cpp, named by its task.
//
//   TEST(Task3DepthBias, NoAcneOnAPlaneUpTo89Degrees) {
//       const Rendered frame = render({.scene = "tilted@85", .settings = {"map_size=512"},
//                                      .images = {"visibility", {"shadow_map", {512, 512}}}});
//       EXPECT_IMAGE_NEAR(frame.at("visibility"), truth, {.mean = 0.004, .cause = "256 rays: …"},
//       mask); EXPECT_VALUE(acneShare, LessOrEqual, 0.001, "texels cut by the silhouette");
//   }
//
// A frame that does not come fails the check with the runner's reason. Any other exception is the
// grader's own error and costs no points. Every number goes to the report with its cause.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <span>

#include "core/grading_session.h"

namespace penumbra {

// A verified frame: the images that were asked for, finite and of the right size.
class Rendered {
public:
    explicit Rendered(std::shared_ptr<const FrameFile> frame) : frame_(std::move(frame)) {}
    const Image& at(const std::string& image) const;  // must have been asked for
    const FrameFile& file() const { return *frame_; }

private:
    std::shared_ptr<const FrameFile> frame_;
};

Rendered render(const RenderRequest& request);
std::vector<glm::vec4> evaluate(const EvaluateRequest& request);
std::string sceneFile(const Scene& scene);  // for RenderRequest::scene

struct ImageTolerance {
    double mean = std::numeric_limits<double>::infinity();     // of |mine - truth|
    double maximum = std::numeric_limits<double>::infinity();  // of |mine - truth|
    double outliers =
        std::numeric_limits<double>::infinity();  // share of pixels beyond outlierDistance
    double outlierDistance = 0.1;
    std::string cause;  // mandatory: why these numbers and no others
};

struct RowTolerance {
    double absolute = 1e-6;  // |mine - truth| <= absolute + relative |truth|
    double relative = 1e-5;
    int components = 1;  // of each vec4, from x
    std::string cause;   // mandatory
};

enum class Relation { Less, LessOrEqual, Greater, GreaterOrEqual, Equal };

// The comparisons behind the macros. Each is recorded and fails the check without stopping it.
void expectImageNear(const char* subject, const Image& mine, const Image& truth,
                     const ImageTolerance& tolerance, const Image& mask = {});
void expectValue(const char* subject, double measured, Relation relation, double bound,
                 const std::string& cause);
void expectRowsNear(const char* subject, std::span<const glm::vec4> mine,
                    std::span<const glm::vec4> truth, const RowTolerance& tolerance);

}  // namespace penumbra

// (mine, truth, {.mean = …, .cause = "…"} [, mask]): pixels where the mask is 0 are left out.
#define EXPECT_IMAGE_NEAR(mine, ...) ::penumbra::expectImageNear(#mine, mine, __VA_ARGS__)
// (measured, LessOrEqual, bound, "cause")
#define EXPECT_VALUE(measured, relation, bound, cause)                                   \
    ::penumbra::expectValue(#measured, double(measured), ::penumbra::Relation::relation, \
                            double(bound), cause)
// (mine, truth, {.absolute = …, .relative = …, .components = 2, .cause = "…"})
#define EXPECT_ROWS_NEAR(mine, ...) ::penumbra::expectRowsNear(#mine, mine, __VA_ARGS__)
