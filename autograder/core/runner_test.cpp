#include "core/runner.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace penumbra {
namespace {

class Runner : public testing::Test {
protected:
    RunOutcome render(const std::string& scene, ProcessLimits limits = {}) {
        return runRender({.executable = PENUMBRA_FAKE_PROGRAM},
                         {.scene = scene, .size = {64, 32}, .limits = limits}, scratch.path());
    }
    std::string reason(const std::string& scene, ProcessLimits limits = {}) {
        const RunOutcome outcome = render(scene, limits);
        EXPECT_EQ(outcome.frame == nullptr, !outcome.reason.empty());
        EXPECT_FALSE(outcome.graderFault);
        return outcome.reason;
    }
    ScratchFolder scratch;
};

TEST_F(Runner, HandsOverAVerifiedFrame) {
    const RunOutcome outcome = render("fine");
    ASSERT_TRUE(outcome.frame) << outcome.reason;
    EXPECT_EQ(outcome.frame->images.at("visibility").at(32, 5), 0.5f);
    EXPECT_GT(outcome.peakBytes, 1u << 20);
    EXPECT_LT(outcome.peakBytes, 300u << 20);
}

TEST_F(Runner, NamesACrash) {
#ifndef __SANITIZE_ADDRESS__  // a sanitised program reports the same signal in its own words
    EXPECT_EQ(reason("crash"), "crashed (segmentation fault)");
    EXPECT_EQ(reason("crash-after"), "crashed (segmentation fault)");
#endif
    EXPECT_EQ(reason("abort"), "crashed (aborted)");
}

TEST_F(Runner, StopsWhatRunsForEver) {
    EXPECT_EQ(reason("hang", {.wallSeconds = 0.5}), "ran past its limit of 0.5 s");
    EXPECT_EQ(reason("ignore-signals", {.wallSeconds = 0.5}), "ran past its limit of 0.5 s");
    EXPECT_EQ(reason("spin", {.cpuSeconds = 1}), "ran past its limit of 1 s of processor time");
}

TEST_F(Runner, BoundsMemoryFilesAndText) {
    EXPECT_EQ(reason("eat-memory", {.memoryBytes = 200 << 20}), "needs more than 200 MB of memory");
    EXPECT_EQ(reason("fill-disk", {.fileBytes = 4 << 20}), "writes a file of more than 4 MB");
    EXPECT_EQ(reason("chatter"), "");
}

TEST_F(Runner, TakesNoFrameFromAProgramThatFailed) {
    EXPECT_EQ(reason("exit-early"), "ended without a frame (exit 0)");
    EXPECT_EQ(reason("fail-after"), "ended with exit code 1 and no message");
    EXPECT_EQ(reason("silent-failure"), "ended with exit code 3 and no message");
    EXPECT_EQ(reason("shader"),
              "shader does not compile: depth_bias.glsl:12: 'blokcer' undeclared");
}

TEST_F(Runner, VerifiesEveryValueAndShape) {
    EXPECT_EQ(reason("nan"), "writes NaN: 37 of 2048 values of visibility, first at pixel (3, 2)");
    EXPECT_EQ(reason("infinity"),
              "writes infinity: 1 of 2048 values of visibility, first at pixel (1, 1)");
    EXPECT_EQ(reason("wrong-size"), "wrong size: asked 64x32 of 'visibility', got 32x32");
    EXPECT_EQ(reason("wrong-channels"), "wrong channels: 'visibility' has 2, needs 1");
    EXPECT_EQ(reason("missing"), "image 'visibility' missing");
    EXPECT_EQ(reason("extra"), "image 'secret' was not asked for");
}

TEST_F(Runner, ReadsNothingButARegularFrameFile) {
    for (const char* scene : {"garbage", "pipe-as-frame", "folder-as-frame", "link-as-frame"})
        EXPECT_EQ(reason(scene).rfind("not a frame file", 0), 0u) << scene;
    EXPECT_EQ(reason("fine"), "");  // the next run is not harmed by what the last one left
}

TEST_F(Runner, LeavesNoDaemonBehind) {
    const auto pidFile = scratch.path() / "pid";
    EXPECT_EQ(reason("daemon:" + pidFile.string()), "");
    pid_t pid = 0;
    std::ifstream(pidFile) >> pid;
    ASSERT_GT(pid, 0);
    EXPECT_EQ(kill(pid, 0), -1);
}

TEST_F(Runner, PassesOnNoMoreOfTheEnvironmentThanNeeded) {
    setenv("SECRET", "token", 1);
    setenv("PENUMBRA_CONTEXT", "osmesa", 1);
    setenv("LP_NUM_THREADS", "1", 1);
    EXPECT_EQ(reason("environment"),
              "PENUMBRA_CONTEXT=osmesa LP_NUM_THREADS=1 SECRET=(none) stdin empty");
    unsetenv("PENUMBRA_CONTEXT");
}

TEST_F(Runner, BlamesTheMachineForWhatIsNotTheProgramsFault) {
    EXPECT_TRUE(render("no-opengl").graderFault);
    const RunOutcome none = runRender({.executable = "/none"}, {.scene = "fine"}, scratch.path());
    EXPECT_TRUE(none.graderFault);
    EXPECT_EQ(none.reason, "cannot be started (No such file or directory)");
}

TEST_F(Runner, EvaluatesRowsOfInputs) {
    EvaluateRequest request{
        .chunk = "x.glsl", .expression = "a", .inputs = {{"a", {{1, 2, 3, 4}, {5, 6, 7, 8}}}}};
    const RunOutcome outcome =
        runEvaluate({.executable = PENUMBRA_FAKE_PROGRAM}, request, scratch.path());
    ASSERT_TRUE(outcome.frame) << outcome.reason;
    EXPECT_EQ(outcome.frame->images.at("result").at(1, 0, 2), 14.0f);
    request.expression = "nan";
    EXPECT_EQ(runEvaluate({.executable = PENUMBRA_FAKE_PROGRAM}, request, scratch.path()).reason,
              "writes NaN: 1 of 8 values of result, first at pixel (1, 0)");
}

TEST_F(Runner, DoesNotStartWhatDidNotCompile) {
    const RunOutcome outcome =
        runRender({.executable = "/none", .broken = "does not compile: a.cpp:1: no"},
                  {.scene = "fine"}, scratch.path());
    EXPECT_EQ(outcome.reason, "does not compile: a.cpp:1: no");
    EXPECT_FALSE(outcome.graderFault);
}

}  // namespace
}  // namespace penumbra
