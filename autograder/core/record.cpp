#include "core/record.h"

#include <fmt/format.h>

#include <cctype>

namespace penumbra {

namespace {

bool upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// A word starts at a capital after a small letter or digit, at the last capital of several (PCFIs
// -> PCF is), and at digits after a small letter.
bool startsWord(const std::string& s, std::size_t i) {
    if (i == 0) return false;
    if (digit(s[i])) return lower(s[i - 1]);
    if (!upper(s[i])) return digit(s[i - 1]);
    return lower(s[i - 1]) || digit(s[i - 1]) ||
           (upper(s[i - 1]) && i + 1 < s.size() && lower(s[i + 1]));
}

std::string words(const std::string& camelCase) {
    std::string result, word;
    const auto flush = [&] {
        if (word.empty()) return;
        const bool acronym = word.size() > 1 && upper(word[1]);
        if (!acronym) word[0] = char(std::tolower(static_cast<unsigned char>(word[0])));
        result += (result.empty() ? "" : " ") + word;
        word.clear();
    };
    for (std::size_t i = 0; i < camelCase.size(); ++i) {
        if (startsWord(camelCase, i)) flush();
        if (camelCase[i] == '_')
            flush();
        else
            word += camelCase[i];
    }
    flush();
    return result;
}

}  // namespace

std::string sentence(const std::string& suite, const std::string& name) {
    std::size_t end = 4;
    while (end < suite.size() && digit(suite[end])) ++end;
    const bool task = suite.rfind("Task", 0) == 0 && end > 4;
    const std::string subject =
        task ? fmt::format("Task {} · {}", suite.substr(4, end - 4), words(suite.substr(end)))
             : words(suite);
    return subject + ": " + words(name);
}

std::string toString(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return "pass";
        case Verdict::fail:
            return "fail";
        case Verdict::notStarted:
            return "not started";
        case Verdict::graderError:
            return "grader error";
    }
    return "";
}

double pointsOf(const GradeRecord& grade) {
    double sum = 0;
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks) sum += check.points;
    return sum;
}

double maximumOf(const GradeRecord& grade) {
    double sum = 0;
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks)
            if (check.verdict != Verdict::graderError) sum += check.maximum;
    return sum;
}

int exitCode(const GradeRecord& grade) {
    int code = 0;
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks) {
            if (check.verdict == Verdict::graderError) return 3;
            if (check.verdict != Verdict::pass) code = 1;
        }
    return code;
}

}  // namespace penumbra
