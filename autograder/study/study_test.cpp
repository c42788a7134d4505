#include <gtest/gtest.h>

#include <fstream>

#include "core/error.h"
#include "core/process.h"
#include "scene/gallery.h"
#include "study/page.h"
#include "study/plan.h"
#include "study/style.h"

namespace penumbra {
namespace {

StudyPoint point(const std::string& scene, double floors, double rmse) {
    StudyPoint p{.program = "06-pcss", .curve = "PCSS", .scene = scene, .settings = "a=1,b=2"};
    p.light = "square";
    p.floors = {floors, floors, floors};
    p.metrics.rmse = rmse;
    return p;
}

std::vector<StudyCurve> curvesFrom(const std::string& text) {
    const ScratchFolder folder;
    std::ofstream(folder.path() / "study.json") << text;
    return loadCurves(folder.path() / "study.json");
}

TEST(StudyFront, HoldsWhatNothingBeatsOnBothAxes) {
    std::vector<StudyPoint> points = {point("a", 1, 0.1), point("a", 2, 0.05), point("a", 3, 0.07),
                                      point("a", 2, 0.06), point("b", 9, 0.5)};
    points.push_back(point("a", 0.5, 0.001));
    points.back().error = "crashed";  // what was not measured beats nobody
    findFronts(points);
    EXPECT_TRUE(points[0].front);
    EXPECT_TRUE(points[1].front);
    EXPECT_FALSE(points[2].front);
    EXPECT_FALSE(points[3].front);
    EXPECT_TRUE(points[4].front);  // alone in its scene
    EXPECT_FALSE(points[5].front);
}

TEST(StudySpread, OfAnEvenCountIsTheMeanOfTheMiddleTwo) {
    const Spread s = spread({4, 1, 3, 2});
    EXPECT_EQ(s.minimum, 1);
    EXPECT_EQ(s.median, 2.5);
    EXPECT_EQ(s.maximum, 4);
}

TEST(StudyPlan, ReadsCurves) {
    const auto curves =
        curvesFrom(R"({"curves": [{"name": "PCF", "points": ["r=1", "r=2"], "quick": ["r=2"]}]})");
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_EQ(curves[0].points, (std::vector<std::string>{"r=1", "r=2"}));
    EXPECT_EQ(curves[0].quick, std::vector<std::string>{"r=2"});
}

TEST(StudyPlan, RefusesAQuickPointThatIsNone) {
    EXPECT_THROW(
        curvesFrom(R"({"curves": [{"name": "PCF", "points": ["r=1"], "quick": ["r=3"]}]})"), Error);
}

TEST(StudyPlan, RefusesWhatIsNoPlan) {
    EXPECT_THROW(curvesFrom("nonsense"), Error);
    EXPECT_THROW(curvesFrom(R"({"curves": [{"name": 3}]})"), Error);
    EXPECT_THROW(loadCurves("nowhere/study.json"), Error);
}

TEST(StudyFiles, EveryCommaOfASettingStaysInItsField) {
    StudyResults results;
    results.points = {point("a", 1, 0.1)};
    EXPECT_NE(studyCsv(results).find("\"a=1,b=2\""), std::string::npos);
}

TEST(StudyStyle, TellsCurvesOfOneProgramByMarkerAndProgramsByColour) {
    StudyResults results;
    results.points = {point("a", 1, 0.1), point("a", 2, 0.1), point("a", 3, 0.1),
                      point("a", 4, 0.1), point("b", 1, 0.1)};
    results.points[1].curve = "PCF";
    results.points[2].program = "06-pcss of ada", results.points[2].submission = true;
    results.points[3].program = "rays", results.points[3].competitor = true;
    const auto styles = curveStyles(results);
    ASSERT_EQ(styles.size(), 4u);
    EXPECT_EQ(styles[0].color, styles[1].color);
    EXPECT_NE(styles[0].marker, styles[1].marker);
    EXPECT_NE(styles[0].color, styles[2].color);
    EXPECT_EQ(styles[3].color, "var(--ink)");
}

TEST(StudyStyle, AProgramHasItsColourInEveryStudy) {
    StudyResults one, all;
    one.points = {point("a", 1, 0.1)};
    all.points = {point("a", 1, 0.1), point("a", 1, 0.1)};
    all.points[0].program = "03-planar-shadows";
    EXPECT_EQ(curveStyles(one)[0].color, curveStyles(all)[1].color);
    EXPECT_NE(curveStyles(all)[0].color, curveStyles(all)[1].color);
}

TEST(StudyPlan, ASubmissionLiesBesideTheSolutionUnderTheStudentsName) {
    if (!std::filesystem::exists(repositoryRoot() / "solutions/07-vssm"))
        GTEST_SKIP() << "a tree without solutions";
    const ScratchFolder folder;
    const auto ada = folder.path() / "ada";
    std::filesystem::create_directories(ada);
    std::filesystem::copy(repositoryRoot() / "solutions/07-vssm/chebyshev.glsl", ada);
    const auto programs = studyPrograms(PENUMBRA_BUILD, {"07"}, ada);
    ASSERT_GE(programs.size(), 2u);
    EXPECT_EQ(programs[0].name, "07-vssm");
    EXPECT_EQ(programs[1].name, "07-vssm of ada");
    EXPECT_EQ(programs[1].curves[0].name, "ada: " + programs[0].curves[0].name);
    EXPECT_FALSE(programs[0].submission);
    EXPECT_TRUE(programs[1].submission);
}

TEST(StudyPicture, AnErrorOfZeroHasAPlaceOfItsOwn) {
    StudyResults results;
    results.points = {point("a", 1, 0.1), point("a", 2, 0)};
    const std::string svg = studySvg(results);
    EXPECT_NE(svg.find(">0</text>"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(StudyFiles, ANoteCannotEndThePagesScript) {
    StudyResults results;
    results.points = {point("a", 1, 0.1)};
    results.points[0].notes = "mesh </script><script>alert(1)";
    const std::string html = studyHtml(results);
    EXPECT_EQ(html.find("mesh </script>"), std::string::npos);
}

TEST(StudyFiles, AFailedPointIsAFieldOfItsOwn) {
    StudyResults results;
    results.points = {point("a", 1, 0.1)};
    results.points[0].error = "no such choice \"999\"";
    const std::string csv = studyCsv(results);
    const std::string row = csv.substr(csv.find('\n') + 1);
    EXPECT_NE(row.find("\"no such choice \"\"999\"\"\""), std::string::npos);
    const auto fields = [](const std::string& line) {  // commas outside quotes
        bool inside = false;
        int count = 1;
        for (const char c : line) {
            inside ^= c == '"';
            count += c == ',' && !inside;
        }
        return count;
    };
    EXPECT_EQ(fields(row), fields(csv.substr(0, csv.find('\n'))));
}

}  // namespace
}  // namespace penumbra
