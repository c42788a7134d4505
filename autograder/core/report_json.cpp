#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base64.h"
#include "core/report.h"

namespace penumbra {

namespace {

using nlohmann::ordered_json;

std::string outputOf(const CheckRecord& check) {
    std::string text = toString(check.verdict);
    for (const auto& reason : check.reasons) text += "\n" + reason;
    for (const auto& c : check.comparisons)
        text +=
            fmt::format("\n{}: {} (allowed: {}; {})", c.subject, c.measured, c.tolerance, c.cause);
    return text;
}

std::string summaryOf(const GradeRecord& grade) {
    std::string text =
        fmt::format("{}: {:g} of {:g} points", grade.title, pointsOf(grade), maximumOf(grade));
    if (!grade.looksLike.empty()) text += "\nlooks like: " + grade.looksLike;
    for (const auto& warning : grade.warnings) text += "\nnote: " + warning;
    if (exitCode(grade) > 1)
        text +=
            "\nThe grader was in trouble: the points of those checks are neither given nor taken.";
    return text;
}

}  // namespace

std::string resultsJson(const GradeRecord& grade) {
    ordered_json tests = ordered_json::array(), verdicts = ordered_json::object();
    int taskNumber = 0;
    for (const auto& task : grade.tasks) {
        int checkNumber = 0;
        ++taskNumber;
        for (const auto& check : task.checks) {
            const bool counts = check.verdict != Verdict::graderError;
            tests.push_back({{"name", check.sentence},
                             {"number", fmt::format("{}.{}", taskNumber, ++checkNumber)},
                             {"score", check.points},
                             {"max_score", counts ? check.maximum : 0.0},
                             {"status", check.verdict == Verdict::pass ? "passed" : "failed"},
                             {"output", outputOf(check)},
                             {"output_format", "text"},
                             {"visibility", "visible"}});
            verdicts[check.suite + "." + check.name] = toString(check.verdict);
        }
    }
    const ordered_json results = {{"score", pointsOf(grade)},
                                  {"execution_time", grade.seconds},
                                  {"output", summaryOf(grade)},
                                  {"output_format", "text"},
                                  {"visibility", "visible"},
                                  {"stdout_visibility", "hidden"},
                                  {"tests", tests},
                                  {"extra_data",
                                   {{"assignment", grade.assignment},
                                    {"variant", grade.variant},
                                    {"max_score", maximumOf(grade)},
                                    {"grader_error", exitCode(grade) > 1},
                                    {"looks_like", grade.looksLike},
                                    {"warnings", grade.warnings},
                                    {"frames", grade.runs},
                                    {"peak_bytes", grade.peakBytes},
                                    {"verdicts", verdicts}}}};
    // Words of a student's program need not be UTF-8.
    return results.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string recordJson(const GradeRecord& grade) {
    ordered_json checks = ordered_json::array();
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks) {
            ordered_json comparisons = ordered_json::array();
            for (const auto& c : check.comparisons)
                comparisons.push_back({{"subject", c.subject},
                                       {"measured", c.measured},
                                       {"tolerance", c.tolerance},
                                       {"cause", c.cause},
                                       {"passed", c.passed},
                                       {"mine", base64(c.mine)},
                                       {"truth", base64(c.truth)},
                                       {"difference", base64(c.difference)}});
            checks.push_back({{"check", check.suite + "." + check.name},
                              {"sentence", check.sentence},
                              {"section", check.section},
                              {"verdict", toString(check.verdict)},
                              {"reasons", check.reasons},
                              {"comparisons", comparisons}});
        }
    return ordered_json{
               {"assignment", grade.assignment}, {"variant", grade.variant}, {"checks", checks}}
               .dump(2, ' ', false, ordered_json::error_handler_t::replace) +
           "\n";
}

std::string junitXml(const GradeRecord& grade) {
    std::string suites;
    for (const auto& task : grade.tasks) {
        std::string cases;
        int failures = 0, errors = 0, skipped = 0;
        double seconds = 0;
        for (const auto& check : task.checks) {
            std::string reason;
            for (const auto& r : check.reasons) reason += (reason.empty() ? "" : "; ") + r;
            const char* element = "";
            if (check.verdict == Verdict::fail) element = "failure", ++failures;
            if (check.verdict == Verdict::graderError) element = "error", ++errors;
            if (check.verdict == Verdict::notStarted) element = "skipped", ++skipped;
            const std::string open =
                fmt::format("    <testcase classname=\"{}.{}\" name=\"{}\" time=\"{:.3f}\"",
                            escaped(grade.assignment), check.suite, check.name, check.seconds);
            cases += check.verdict == Verdict::pass
                         ? open + "/>\n"
                         : fmt::format("{}>\n      <{} message=\"{}\"/>\n    </testcase>\n", open,
                                       element, escaped(reason));
            seconds += check.seconds;
        }
        suites += fmt::format(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" "
            "time=\"{:.3f}\">\n{}"
            "  </testsuite>\n",
            task.suite, task.checks.size(), failures, errors, skipped, seconds, cases);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\">\n{}</testsuites>\n",
        escaped(grade.assignment), suites);
}

}  // namespace penumbra
