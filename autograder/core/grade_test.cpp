// The whole grader as a person starts it, on core/selftest: hostile hand-ins, mistakes, reports.
#include "core/grade.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/process.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

class Grade : public testing::Test {
protected:
    // Exit code; 100 and up where it did not exit.
    int grade(std::vector<std::string> arguments, std::vector<std::string> environment = {}) {
        arguments.insert(arguments.end(), {"--out", out.string()});
        const auto r = runProcess({.program = PENUMBRA_SELFTEST_GRADE,
                                   .arguments = arguments,
                                   .folder = scratch.path(),
                                   .environment = environment});
        text = r.standardOutput, errors = r.standardError;
        return r.end == ProcessResult::End::exited ? r.code : 100 + int(r.end);
    }

    // A hand-in of this one file.
    std::string handIn(const std::string& source, const std::string& name = "gradient.glsl") {
        fs::create_directories(scratch.path() / "ada");
        std::ofstream(scratch.path() / "ada" / name) << source;
        return (scratch.path() / "ada").string();
    }

    nlohmann::json results() const {
        return nlohmann::json::parse(std::ifstream(out / "results.json"));
    }
    std::string firstOutput() const { return results()["tests"][0]["output"]; }

    ScratchFolder scratch;
    fs::path out = scratch.path() / "out";
    std::string text, errors;
};

TEST_F(Grade, GivesTheSolutionAllPoints) {
    EXPECT_EQ(grade({"--solution"}), 0) << text << errors;
    EXPECT_EQ(results()["score"], 100);
    EXPECT_EQ(results()["extra_data"]["frames"], 1);  // equal requests share a frame
    EXPECT_TRUE(fs::exists(out / "junit.xml"));
    EXPECT_FALSE(fs::exists(out / ".part"));
}

TEST_F(Grade, KnowsAHandoutThatNobodyHasTouched) {
    EXPECT_EQ(grade({}), 1);
    EXPECT_EQ(results()["score"], 0);
    EXPECT_EQ(results()["extra_data"]["verdicts"]["Task1Gradient.RisesFromLeftToRight"],
              "not started");
    EXPECT_EQ(results()["extra_data"]["frames"], 0);
    EXPECT_EQ(grade({"--expect-not-started"}), 0);
    // A comment is no work.
    EXPECT_EQ(grade({"--submission", handIn("// mine\nfloat gradient(float x) {\n return 1.0; }")}),
              1);
    EXPECT_EQ(results()["extra_data"]["frames"], 0);
}

TEST_F(Grade, NamesWhatHostileHandInsDo) {
    const std::pair<const char*, const char*> cases[] = {
        {"hang", "ran past its limit of 1 s"},
        {"exit-early", "ended without a frame (exit 0)"},
        {"nan", "writes NaN: 37 of 2048 values of visibility, first at pixel (3, 2)"},
        {"wrong-size", "wrong size: asked 64x32 of 'visibility', got 32x32"},
        {"abort", "crashed (aborted)"},
        {"shader", "shader does not compile: depth_bias.glsl:12"},
        {"garbage", "not a frame file"}};
    for (const auto& [behaviour, reason] : cases) {
        EXPECT_EQ(grade({"--submission", handIn(std::string("behave ") + behaviour)}), 1)
            << behaviour;
        EXPECT_NE(firstOutput().find(reason), std::string::npos) << firstOutput();
        EXPECT_EQ(results()["score"], 0);
    }
}

TEST_F(Grade, HoldsEachMistakeToTheChecksItNames) {
    EXPECT_EQ(grade({"--wrong", "dark", "--expect-mistake"}), 0) << errors;
    EXPECT_EQ(grade({"--wrong", "nan", "--expect-mistake"}), 0) << errors;
    EXPECT_EQ(grade({"--wrong", "dark"}), 1);
}

TEST_F(Grade, SaysWhichMistakeAHandInLooksLike) {
    EXPECT_EQ(grade({"--submission", handIn("behave dark")}), 1);
    EXPECT_EQ(results()["extra_data"]["looks_like"], "the gradient is half as steep");
    EXPECT_EQ(results()["score"], 30);
    std::ifstream stream(out / "report.html");
    const std::string html((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_NE(html.find("Looks like: the gradient is half as steep"), std::string::npos);
    EXPECT_NE(html.find("float32 holds every 64th exactly"), std::string::npos);
    EXPECT_NE(html.find("data:image/png;base64,"), std::string::npos);
}

TEST_F(Grade, TakesNoPointsForItsOwnErrors) {
    EXPECT_EQ(grade({"--solution"}, {"SELFTEST_GRADER_ERROR=1"}), 3);
    EXPECT_EQ(results()["score"], 70);
    EXPECT_EQ(results()["extra_data"]["max_score"], 70);
    EXPECT_EQ(results()["extra_data"]["grader_error"], true);
    EXPECT_EQ(grade({"--submission", handIn("behave no-opengl")}), 3);
}

TEST_F(Grade, IgnoresFilesThatAreNotTheStudents) {
    handIn("behave fine");
    handIn("x", "evil.cpp");
    fs::create_directories(scratch.path() / "ada/given");
    EXPECT_EQ(grade({"--submission", (scratch.path() / "ada").string()}), 0) << text << errors;
    EXPECT_EQ(results()["extra_data"]["warnings"],
              nlohmann::json::array({"evil.cpp is not part of this assignment: ignored"}));
    fs::remove(scratch.path() / "ada/gradient.glsl");
    fs::create_symlink("/etc/passwd", scratch.path() / "ada/gradient.glsl");
    EXPECT_EQ(grade({"--submission", (scratch.path() / "ada").string()}), 2);
}

TEST_F(Grade, FindsFilesOneFolderDown) {
    handIn("behave fine");
    EXPECT_EQ(grade({"--submission", scratch.path().string()}), 0) << text << errors;
}

TEST_F(Grade, AnswersBadInputInOneLineAndLeavesNoReport) {
    for (const std::vector<std::string>& bad : {std::vector<std::string>{"--submission", "/none"},
                                                {"--wrong", "none"},
                                                {"--only", "none"},
                                                {"--unknown"},
                                                {"--solution", "--wrong", "dark"},
                                                {"--expect-mistake"}}) {
        EXPECT_EQ(grade(bad), 2) << bad.front();
        EXPECT_EQ(errors.rfind("error: ", 0), 0u) << errors;
        EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
        EXPECT_FALSE(fs::exists(out / "results.json"));
    }
    EXPECT_EQ(grade({"--out", "/dev/null/x"}), 2);
}

TEST_F(Grade, RunsOnlyWhatIsAskedFor) {
    EXPECT_EQ(grade({"--solution", "--only", "Brighter"}), 0);
    EXPECT_EQ(results()["tests"].size(), 1u);
    EXPECT_EQ(grade({"--handout-hashes"}), 0) << text << errors;
}

TEST(Filter, MatchesStarsAndQuestionMarks) {
    EXPECT_TRUE(matches("Task1*Left?o*", "Task1.LeftToX"));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_FALSE(matches("Task1", "Task1.X"));
    EXPECT_FALSE(matches("?", ""));
}

}  // namespace
}  // namespace penumbra
