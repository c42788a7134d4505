#include "core/rubric.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.h"
#include "core/handout_hash.h"
#include "core/mistakes.h"
#include "core/process.h"
#include "core/variant.h"

namespace penumbra {
namespace {

class RubricTest : public testing::Test {
protected:
    Rubric load(const std::string& tasks) {
        std::ofstream(path) << R"({"title": "T", "handout": {"a.glsl": "1"}, "tasks": [)" << tasks
                            << "]}";
        return loadRubric(path);
    }
    ScratchFolder scratch;
    std::filesystem::path path = scratch.path() / "rubric.json";
};

const std::string kTask =
    R"({"name": "Task1A", "title": "A", "files": ["a.glsl"], "checks": {"Z": 60, "B": 40}})";

TEST_F(RubricTest, KeepsTheOrderOfChecks) {
    const Rubric rubric = load(kTask);
    ASSERT_EQ(rubric.tasks.at(0).checks.size(), 2u);
    EXPECT_EQ(rubric.tasks[0].checks[0].first, "Z");
}

TEST_F(RubricTest, RefusesPointsThatAreNoHundredAndUnknownFiles) {
    EXPECT_THROW(load(R"({"name": "A", "title": "A", "files": [], "checks": {"B": 99}})"), Error);
    EXPECT_THROW(load(R"({"name": "A", "title": "A", "files": [], "checks": {"B": 101, "C": -1}})"),
                 Error);
    EXPECT_THROW(load(R"({"name": "A", "title": "A", "files": ["b.cpp"], "checks": {"B": 100}})"),
                 Error);
    EXPECT_THROW(load(kTask + "," + kTask), Error);
    EXPECT_THROW(load("3"), Error);
    EXPECT_THROW(loadRubric(scratch.path() / "none"), Error);
}

TEST_F(RubricTest, AgreesWithTheProgramOrRefuses) {
    const Rubric rubric = load(kTask);
    EXPECT_NO_THROW(requireSameChecks(rubric, {"Task1A.B", "Task1A.Z"}));
    EXPECT_THROW(requireSameChecks(rubric, {"Task1A.B"}), Error);
    EXPECT_THROW(requireSameChecks(rubric, {"Task1A.B", "Task1A.Z", "Task1A.C"}), Error);
}

TEST(HandoutHash, SeesCodeOnly) {
    EXPECT_EQ(codeOnly("float a() { return 0.0; } // yours\n/* x */\n"), "floata(){return0.0;}");
    EXPECT_EQ(codeOnly("s = \"// no comment\";"), "s=\"// no comment\";");
    EXPECT_EQ(codeOnly("/* open"), "");
    EXPECT_EQ(codeOnly("\"open \\"), "\"open \\");
    EXPECT_NE(contentHash(std::string_view("return 0.0;")),
              contentHash(std::string_view("return 1.0;")));
    EXPECT_EQ(hashOf(""), "cbf29ce484222325");
}

TEST(Mistakes, AreReadFromTheirFirstLine) {
    ScratchFolder scratch;
    std::filesystem::create_directories(scratch.path() / "sign");
    std::ofstream(scratch.path() / "sign/a.glsl") << "float x;\n";
    std::ofstream(scratch.path() / "sign/b.glsl") << "// Fails: T.A, T.B · the sign is wrong\n";
    const auto mistakes = loadMistakes(scratch.path());
    ASSERT_EQ(mistakes.size(), 1u);
    EXPECT_EQ(mistakes[0].name, "the sign is wrong");
    EXPECT_EQ(mistakes[0].fails, (std::set<std::string>{"T.A", "T.B"}));
    std::filesystem::remove(scratch.path() / "sign/b.glsl");
    EXPECT_THROW(loadMistakes(scratch.path()), Error);
    EXPECT_TRUE(loadMistakes(scratch.path() / "none").empty());
}

TEST(Mistakes, AreRecognisedWhenEqualOrHalfShared) {
    const std::vector<Mistake> mistakes = {{"a", "A", {"1", "2"}}, {"b", "B", {"1", "2", "3"}}};
    EXPECT_EQ(looksLike(mistakes, {"1", "2"}), "A");
    EXPECT_EQ(looksLike(mistakes, {"2"}), "A");
    EXPECT_EQ(looksLike(mistakes, {"3"}), "");
    EXPECT_EQ(looksLike(mistakes, {}), "");
}

TEST(Submission, QuotesTheCompilersFirstComplaint) {
    EXPECT_EQ(
        firstComplaint("[1/2] Building\n/a/src/light.cpp:12:5: error: 'x' was not declared\nfoo"),
        "light.cpp:12: 'x' was not declared");
    EXPECT_EQ(firstComplaint("C:\\a\\light.cpp(12): error C2065: 'x': undeclared"),
              "light.cpp:12: 'x': undeclared");
    EXPECT_EQ(firstComplaint("/usr/bin/ld: a.o: in function `f': undefined reference to `g()'"),
              "undefined reference to `g()'");
    EXPECT_EQ(firstComplaint("all is well"), "");
}

}  // namespace
}  // namespace penumbra
