#include "core/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace penumbra {
namespace {

GradeRecord hostileWords() {
    CheckRecord check;
    check.suite = "Task1A", check.name = "B", check.sentence = "Task 1 · a: b";
    check.verdict = Verdict::fail, check.maximum = 100;
    check.reasons = {"</script><b>\"&'\x01\xff\xc0\x80\xed\xa0\x80 ä"};
    TaskRecord task{
        .suite = "Task1A", .title = "<A>", .section = "1", .files = {}, .checks = {check}};
    return {.assignment = "00",
            .title = "T",
            .variant = "<ada>",
            .tasks = {task},
            .warnings = {"<w>"},
            .looksLike = "",
            .handout = {}};
}

TEST(Sentence, ReadsATestsNameAloud) {
    EXPECT_EQ(sentence("Task3DepthBias", "NoAcneOnAPlaneUpTo89Degrees"),
              "Task 3 · depth bias: no acne on a plane up to 89 degrees");
    EXPECT_EQ(sentence("Task12PCFKernel", "UsesPCFOnly"), "Task 12 · PCF kernel: uses PCF only");
    EXPECT_EQ(sentence("HardCases", "EyeInVolume"), "hard cases: eye in volume");
}

TEST(Report, EscapesMarkupAndWhatIsNoText) {
    EXPECT_EQ(escaped("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
    EXPECT_EQ(escaped("\x01\xffz"), "\xef\xbf\xbd\xef\xbf\xbdz");
    EXPECT_EQ(escaped("ä·…"), "ä·…");
    EXPECT_EQ(escaped("\xc3"), "\xef\xbf\xbd");
}

TEST(Report, CarriesHostileWordsAsTextOnly) {
    const GradeRecord grade = hostileWords();
    const std::string html = reportHtml(grade, "/tmp"), xml = junitXml(grade);
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("</script"), std::string::npos);
    EXPECT_EQ(html.find("<ada>"), std::string::npos);
    EXPECT_NE(xml.find("&lt;/script&gt;&lt;b&gt;"), std::string::npos);
    EXPECT_EQ(xml.find('\x01'), std::string::npos);
    EXPECT_EQ(xml.find('\xff'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(resultsJson(grade))["score"], 0);
}

TEST(Report, KeepsToGradescopesSchema) {
    const auto json = nlohmann::json::parse(resultsJson(hostileWords()));
    EXPECT_TRUE(json["execution_time"].is_number());
    EXPECT_EQ(json["visibility"], "visible");
    const auto& test = json["tests"][0];
    EXPECT_EQ(test["name"], "Task 1 · a: b");
    EXPECT_EQ(test["status"], "failed");
    EXPECT_EQ(test["max_score"], 100);
    EXPECT_EQ(test["output_format"], "text");
    EXPECT_TRUE(json["extra_data"].is_object());
}

TEST(Report, ExitCodeTellsLostPointsFromTheGradersTrouble) {
    GradeRecord grade = hostileWords();
    EXPECT_EQ(exitCode(grade), 1);
    grade.tasks[0].checks[0].verdict = Verdict::graderError;
    EXPECT_EQ(exitCode(grade), 3);
    EXPECT_EQ(maximumOf(grade), 0);
    grade.tasks[0].checks[0].verdict = Verdict::pass;
    EXPECT_EQ(exitCode(grade), 0);
}

}  // namespace
}  // namespace penumbra
