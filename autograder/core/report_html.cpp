#include <fmt/format.h>

#include "core/base64.h"
#include "core/report.h"
#include "core/report_style.h"

namespace penumbra {

namespace fs = std::filesystem;

namespace {

const char* styleOf(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return "pass";
        case Verdict::fail:
            return "fail";
        case Verdict::notStarted:
            return "idle";
        case Verdict::graderError:
            return "odd";
    }
    return "";
}

std::string figure(const std::vector<unsigned char>& png, const std::string& caption,
                   const std::string& of) {
    return fmt::format(
        "<figure><img alt=\"{0} of {1}\" "
        "src=\"data:image/png;base64,{2}\"><figcaption>{0}</figcaption></figure>",
        caption, of, base64(png));
}

std::string comparisonHtml(const Comparison& c) {
    const std::string subject = escaped(c.subject);
    std::string html;
    if (!c.mine.empty())
        html += "<div class=\"figures\">" + figure(c.mine, "mine", subject) +
                figure(c.truth, "truth", subject) +
                figure(c.difference, "difference: red too bright, blue too dark", subject) +
                "</div>\n";
    html += fmt::format(
        "<dl><dt>compared</dt><dd>{}</dd><dt>measured</dt><dd class=\"{}\">{}</dd>"
        "<dt>allowed</dt><dd>{}</dd><dt>because</dt><dd>{}</dd></dl>\n",
        subject, c.passed ? "pass" : "fail", escaped(c.measured), escaped(c.tolerance),
        escaped(c.cause));
    return html;
}

std::string checkHtml(const CheckRecord& check, const std::string& handoutLink) {
    std::string body;
    // What a comparison says stands in its own table; other reasons stand above.
    for (const auto& reason : check.reasons) {
        bool told = false;
        for (const auto& c : check.comparisons)
            told = told || (!c.passed && reason.rfind(c.subject + ": " + c.measured, 0) == 0);
        if (!told && check.verdict != Verdict::notStarted)
            body += fmt::format("<p class=\"reason {}\">{}</p>\n", styleOf(check.verdict),
                                escaped(reason));
    }
    if (check.verdict == Verdict::notStarted)
        body += "<p class=\"facts\">The files of this task still hold the handout's code.</p>\n";
    for (const auto& comparison : check.comparisons) body += comparisonHtml(comparison);
    for (const auto& frame : check.frames) body += fmt::format("<code>{}</code>\n", escaped(frame));
    if (!handoutLink.empty() && check.verdict != Verdict::pass)
        body += fmt::format(
            "<p class=\"facts\"><a href=\"{}\">Read the handout’s section</a></p>\n", handoutLink);
    const char* style = styleOf(check.verdict);
    return fmt::format(
        "<details{}><summary><span class=\"verdict {}\">{}</span><span class=\"what\">{}</span>"
        "<span class=\"points\">{:g} / {:g}</span></summary><div "
        "class=\"body\">\n{}</div></details>\n",
        check.verdict == Verdict::fail || check.verdict == Verdict::graderError ? " open" : "",
        style, toString(check.verdict), escaped(check.sentence), check.points, check.maximum, body);
}

// From where the report stands to the handout's section; relative, so that a tree may be moved.
std::string linkTo(const GradeRecord& grade, const fs::path& out, const std::string& section) {
    std::error_code error;
    const fs::path readme = grade.handout / "README.md";
    if (grade.handout.empty() || !fs::exists(readme, error)) return "";
    const fs::path relative = fs::relative(readme, out, error);
    return error ? "" : escaped(relative.generic_string() + (section.empty() ? "" : "#" + section));
}

std::string taskHtml(const GradeRecord& grade, const TaskRecord& task, const fs::path& out) {
    std::string checks, files;
    double points = 0, maximum = 0;
    const std::string link = linkTo(grade, out, task.section);
    for (const auto& check : task.checks) {
        checks += checkHtml(check, link);
        points += check.points;
        maximum += check.maximum;
    }
    for (const auto& file : task.files) files += (files.empty() ? "" : ", ") + file;
    return fmt::format(
        "<section><div class=\"task\"><h2>{}</h2><span>{}</span>{}<span>{:g} of "
        "{:g}</span></div>\n{}</section>\n",
        escaped(task.title), escaped(files),
        link.empty() ? "" : fmt::format("<span><a href=\"{}\">handout</a></span>", link), points,
        maximum, checks);
}

std::string barHtml(const GradeRecord& grade) {
    std::string html = "<div class=\"bar\" aria-hidden=\"true\">";
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks)
            html += fmt::format("<i class=\"{}\" style=\"flex:{:g}\"></i>", styleOf(check.verdict),
                                check.maximum);
    return html + "</div>\n";
}

std::string notesHtml(const GradeRecord& grade) {
    std::string html;
    if (!grade.looksLike.empty())
        html += fmt::format(
            "<p class=\"note\"><b>Looks like: {}</b>Most of the checks that fail here fail with "
            "this mistake, too.</p>\n",
            escaped(grade.looksLike));
    if (exitCode(grade) > 1)
        html +=
            "<p class=\"note\"><b>The grader was in trouble</b>Checks marked “grader error” cost "
            "no points; "
            "please tell your instructor.</p>\n";
    if (!grade.warnings.empty()) {
        html += "<p class=\"note\"><b>About the files</b>";
        for (const auto& warning : grade.warnings) html += escaped(warning) + "<br>";
        html += "</p>\n";
    }
    return html;
}

}  // namespace

std::string reportHtml(const GradeRecord& grade, const fs::path& out) {
    int passed = 0, total = 0;
    std::string tasks;
    for (const auto& task : grade.tasks) {
        for (const auto& check : task.checks) ++total, passed += check.verdict == Verdict::pass;
        tasks += taskHtml(grade, task, out);
    }
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{0} · {1:g} of {2:g}</title>\n<style>{3}</style></head>\n<body><main>\n"
        "<header><div><p class=\"kicker\">{4} · {5}</p><h1>{0}</h1></div>"
        "<p class=\"score\">{1:g} <small>of {2:g} points</small></p></header>\n{6}"
        "<p class=\"facts\">{7} of {8} checks pass · {9:.0f} s · {10} frames rendered · largest "
        "process {11} MB</p>\n"
        "{12}{13}</main></body></html>\n",
        escaped(grade.title), pointsOf(grade), maximumOf(grade), kReportStyle,
        escaped(grade.assignment), escaped(grade.variant), barHtml(grade), passed, total,
        grade.seconds, grade.runs, grade.peakBytes >> 20, notesHtml(grade), tasks);
}

}  // namespace penumbra
