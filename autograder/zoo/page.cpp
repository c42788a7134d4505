#include <fmt/format.h>

#include <algorithm>

#include "core/base64.h"
#include "core/report.h"
#include "zoo/zoo.h"

namespace penumbra {

namespace {

constexpr const char* kStyle = R"css(
:root { color-scheme: light dark; --page: #f6f5f2; --card: #fff; --ink: #1d1c1a; --soft: #65625c; --line: #dedad2; --good: #1d7a4d; --bad: #b3392f; --link: #2a5db0; }
@media (prefers-color-scheme: dark) { :root { --page: #16171a; --card: #1e2024; --ink: #e8e6e1; --soft: #a19e96; --line: #393b42; --good: #5cc48d; --bad: #f08a80; --link: #7aa7f0; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink); font: 16px/1.5 system-ui, "Segoe UI", Roboto, sans-serif; }
main { max-width: 84rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
h1 { font-size: 2rem; margin: 0; letter-spacing: -.02em; } h2 { margin: 2.25rem 0 .5rem; }
p { color: var(--soft); max-width: 52rem; margin: .25rem 0 1rem; } nav a { margin-right: 1rem; } a { color: var(--link); }
article { background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: .9rem 1.1rem; margin: 0 0 .9rem; }
h3 { margin: 0; font-size: 1.05rem; } .check { color: var(--soft); font-size: .85rem; margin: 0 0 .6rem; }
.columns { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 1rem; font-size: .9rem; }
@media (max-width: 48rem) { .columns { grid-template-columns: minmax(0, 1fr); } }
.columns > div { overflow-wrap: anywhere; } .label { font-size: .8rem; color: var(--soft); } .bad { color: var(--bad); } .good { color: var(--good); }
.pictures { display: flex; gap: .4rem; flex-wrap: wrap; margin-top: .4rem; } .pictures img { width: 132px; border: 1px solid var(--line); border-radius: 4px; image-rendering: pixelated; background: #888; }
article > img { max-width: 100%; display: block; margin-top: .5rem; } ul { color: var(--soft); font-size: .85rem; margin: .5rem 0 0; padding-left: 1.2rem; }
)css";

std::string picture(const std::string& png, const std::string& what) {
    if (png.empty()) return "";
    return fmt::format(
        "<img loading=\"lazy\" src=\"data:image/png;base64,{}\" alt=\"{}\" title=\"{}\">", png,
        escaped(what), escaped(what));
}

std::string variantHtml(const char* label, const ZooResult& result, const std::string& note) {
    return fmt::format(
        "<div><span class=\"label\">{}</span><br><b class=\"{}\">{}</b><br>{}<div "
        "class=\"pictures\">{}{}</div></div>",
        label, result.passed ? "good" : "bad", escaped(result.measured), escaped(note),
        picture(result.mine, std::string(label) + ": mine"),
        picture(result.difference,
                std::string(label) + ": difference, red too bright, blue too dark"));
}

std::string rowHtml(const ZooRow& r) {
    return fmt::format(
        "<article><h3>{}</h3><p class=\"check\">{}{}</p><div class=\"columns\">{}{}<div><span "
        "class=\"label\">bound{}</span><br><b>{}</b><br>{}<div class=\"pictures\">{}</div></div>"
        "</div></article>\n",
        escaped(r.which.failure), escaped(r.sentence),
        r.holds() ? "" : " <b class=\"bad\">does not hold</b>",
        variantHtml("naive", r.naive, r.mistake), variantHtml("solution", r.solution, ""),
        r.subject.empty() ? "" : " on " + escaped(r.subject), escaped(r.bound), escaped(r.cause),
        picture(r.truth, "truth"));
}

// As an image: no style of one curve reaches the page or another curve.
std::string curveHtml(const ZooCurve& c) {
    std::string facts;
    for (const std::string& fact : c.facts) facts += fmt::format("<li>{}</li>", escaped(fact));
    const auto* bytes = reinterpret_cast<const unsigned char*>(c.svg.data());
    return fmt::format(
        "<article><h3>{}</h3><p class=\"check\">{}: {}{}</p><img loading=\"lazy\" "
        "src=\"data:image/svg+xml;base64,{}\" alt=\"{}\"><ul>{}</ul></article>\n",
        escaped(c.title), c.assignment, escaped(c.says),
        c.holds ? "" : " <b class=\"bad\">a fact does not hold</b>",
        base64(std::span(bytes, c.svg.size())), escaped(c.title), facts);
}

}  // namespace

std::string zooHtml(const std::vector<ZooRow>& rows, const std::vector<ZooCurve>& curves) {
    std::string body, links, current;
    for (const ZooRow& r : rows) {
        if (r.which.assignment != current) {
            current = r.which.assignment;
            links += fmt::format("<a href=\"#{0}\">{0}</a>", current);
            body += fmt::format("<h2 id=\"{0}\">{0}</h2>\n", current);
        }
        body += rowHtml(r);
    }
    if (!curves.empty()) {
        links += "<a href=\"#curves\">curves</a>";
        body += "<h2 id=\"curves\">Curves</h2>\n";
        for (const ZooCurve& c : curves) body += curveHtml(c);
    }
    const auto holding =
        std::count_if(rows.begin(), rows.end(), [](const ZooRow& r) { return r.holds(); });
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\"><title>Hard "
        "cases</title><style>{}</style></head><body><main>\n"
        "<h1>Hard cases</h1>\n<p>{} cases on which a technique fails if it is written as it comes "
        "to mind. "
        "In each, the naive variant breaks the bound and the solution keeps it: {} of {}. Truth, "
        "bound and "
        "its cause are those of the grader's check of that "
        "name.</p>\n<nav>{}</nav>\n{}</main></body></html>\n",
        kStyle, rows.size(), holding, rows.size(), links, body);
}

}  // namespace penumbra
