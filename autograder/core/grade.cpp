#include "core/grade.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "core/error.h"
#include "core/grading_session.h"
#include "core/mistakes.h"

namespace penumbra {

namespace {

// GoogleTest's words for an exception that left a check; it has no place in the source.
bool isException(const testing::TestPartResult& result) { return result.file_name() == nullptr; }

std::string oneLine(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::string prefix = "C++ exception with description \"",
                      suffix = "\" thrown in the test body.";
    if (text.rfind(prefix, 0) == 0)
        text = text.substr(prefix.size(), text.rfind(suffix) - prefix.size());
    return text.substr(0, 600);
}

// Turns what GoogleTest saw into a verdict for each check.
class Recorder : public testing::EmptyTestEventListener {
public:
    Recorder(GradingSession& session, std::size_t total, bool show)
        : session_(session), total_(total), show_(show) {}

    void OnTestStart(const testing::TestInfo& info) override {
        session_.begin(info.test_suite_name(), info.name());
        graderError_.clear();
        if (show_)
            fmt::print(stderr, "[{:>2}/{}] {} … ", records.size() + 1, total_,
                       session_.check().sentence);
        std::fflush(stderr);
    }

    void OnTestPartResult(const testing::TestPartResult& result) override {
        auto& reasons = session_.check().reasons;
        const std::string message = oneLine(result.message());
        if (result.skipped()) graderError_ = "the check was skipped: " + message;
        if (!result.failed() || (isException(result) && session_.stopped())) return;
        if (isException(result))
            graderError_ = message;
        else if (reasons.empty() || reasons.back() != message)  // comparisons have said it already
            reasons.push_back(message);
    }

    void OnTestEnd(const testing::TestInfo&) override {
        CheckRecord record = session_.end();
        // A loop over nothing would pass.
        if (record.reasons.empty() && record.comparisons.empty() && graderError_.empty())
            graderError_ = "the check compares nothing; use the macros of checks.h";
        if (!graderError_.empty()) record.reasons = {graderError_};
        record.verdict = !graderError_.empty()     ? Verdict::graderError
                         : !record.reasons.empty() ? Verdict::fail
                                                   : Verdict::pass;
        if (show_) fmt::print(stderr, "{} ({:.1f} s)\n", toString(record.verdict), record.seconds);
        records[record.suite + "." + record.name] = std::move(record);
    }

    std::map<std::string, CheckRecord> records;

private:
    GradingSession& session_;
    std::size_t total_;
    bool show_;
    std::string graderError_;
};

// Runs these checks and no others, whatever GTEST_… variables say.
std::map<std::string, CheckRecord> runChecks(const std::vector<std::string>& checks,
                                             GradingSession& session, bool show) {
    if (checks.empty()) return {};
    testing::GTEST_FLAG(filter) = fmt::format("{}", fmt::join(checks, ":"));
    testing::GTEST_FLAG(catch_exceptions) = true;
    testing::GTEST_FLAG(break_on_failure) = false;
    testing::GTEST_FLAG(throw_on_failure) = false;
    testing::GTEST_FLAG(shuffle) = false;
    testing::GTEST_FLAG(repeat) = 1;
    testing::GTEST_FLAG(output) = "";
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    Recorder recorder(session, checks.size(), show);
    listeners.Append(&recorder);
    const int ignored = RUN_ALL_TESTS();  // the verdicts are in the records
    (void)ignored;
    listeners.Release(&recorder);
    return std::move(recorder.records);
}

bool selected(const std::string& only, const std::string& check) {
    if (only.empty()) return true;
    const bool plain = only.find_first_of("*?") == std::string::npos;
    return matches(plain ? "*" + only + "*" : only, check);
}

CheckRecord notStarted(const std::string& suite, const std::string& name) {
    CheckRecord record;
    record.suite = suite, record.name = name;
    record.sentence = sentence(suite, name);
    record.verdict = Verdict::notStarted;
    record.reasons = {"the task's files hold the handout's code"};
    return record;
}

void addLikeness(const Place& place, const Variant& variant, GradeRecord& grade) {
    if (variant.studentFolder.empty()) return;
    std::set<std::string> failed, unwritten;
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks) {
            if (check.verdict == Verdict::notStarted)
                unwritten.insert(check.suite + "." + check.name);
            if (check.verdict != Verdict::fail) continue;
            failed.insert(check.suite + "." + check.name);
            // Where code does not compile, the set of failed checks says nothing.
            for (const auto& reason : check.reasons)
                if (reason.find("does not compile") != std::string::npos) return;
        }
    try {
        auto mistakes = loadMistakes(place.grader() / "wrong");
        // A mistake in code that nobody has written yet is not the one that is seen.
        std::erase_if(mistakes, [&](const Mistake& mistake) {
            return std::any_of(mistake.fails.begin(), mistake.fails.end(),
                               [&](const auto& check) { return unwritten.count(check) > 0; });
        });
        grade.looksLike = looksLike(mistakes, failed);
    } catch (const Error& error) {
        grade.warnings.push_back(error.what());  // a hint that cannot be given costs nobody a grade
    }
}

}  // namespace

bool matches(const std::string& pattern, const std::string& text) {
    std::size_t p = 0, t = 0, star = std::string::npos, mark = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++, mark = t;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
            ++p, ++t;
        } else if (star != std::string::npos) {
            p = star + 1, t = ++mark;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string::npos;
}

std::vector<std::string> writtenChecks() {
    std::vector<std::string> checks;
    const auto& tests = *testing::UnitTest::GetInstance();
    for (int s = 0; s < tests.total_test_suite_count(); ++s)
        for (int i = 0; i < tests.GetTestSuite(s)->total_test_count(); ++i)
            checks.push_back(std::string(tests.GetTestSuite(s)->name()) + "." +
                             tests.GetTestSuite(s)->GetTestInfo(i)->name());
    return checks;
}

GradeRecord gradeVariant(const Place& place, const Variant& variant, const GradeOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const Rubric rubric = loadRubric(place.grader() / "rubric.json");
    requireSameChecks(rubric, writtenChecks());
    std::set<std::string> untouched;
    std::vector<std::string> toRun;
    for (const auto& task : rubric.tasks) {
        if (!variant.studentFolder.empty() && isUntouched(rubric, task, variant.studentFolder))
            untouched.insert(task.name);
        for (const auto& [name, points] : task.checks)
            if (selected(options.only, task.name + "." + name) && untouched.count(task.name) == 0)
                toRun.push_back(task.name + "." + name);
    }

    GradingSession session(
        variant.program,
        {.truths = options.truthCache.empty() ? TruthCache() : TruthCache(options.truthCache),
         .picturesOfPassed = options.picturesOfPassed});
    auto records = runChecks(toRun, session, options.showProgress);
    GradeRecord grade{.assignment = place.assignment,
                      .title = rubric.title,
                      .variant = variant.name,
                      .tasks = {},
                      .warnings = variant.warnings,
                      .looksLike = "",
                      .handout = place.handout()};
    for (const auto& task : rubric.tasks) {
        TaskRecord taskRecord{.suite = task.name,
                              .title = task.title,
                              .section = task.section,
                              .files = task.files,
                              .checks = {}};
        for (const auto& [name, points] : task.checks) {
            if (!selected(options.only, task.name + "." + name)) continue;
            CheckRecord check = untouched.count(task.name) > 0
                                    ? notStarted(task.name, name)
                                    : std::move(records[task.name + "." + name]);
            check.maximum = points;
            check.points = check.verdict == Verdict::pass ? points : 0;
            check.section = task.section;
            taskRecord.checks.push_back(std::move(check));
        }
        if (!taskRecord.checks.empty()) grade.tasks.push_back(std::move(taskRecord));
    }
    if (grade.tasks.empty())
        throw Error("no check matches", "--only " + options.only, "leave it out to see all names");
    addLikeness(place, variant, grade);
    grade.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    grade.runs = session.runs();
    grade.peakBytes = session.peakBytes();
    return grade;
}

std::set<std::string> failedChecks(const GradeRecord& grade) {
    std::set<std::string> failed;
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks)
            if (check.verdict != Verdict::pass) failed.insert(check.suite + "." + check.name);
    return failed;
}

}  // namespace penumbra
