#include "demo/page.h"

#include <fmt/format.h>

namespace penumbra {

namespace {

constexpr const char* kStyle = R"css(
:root { color-scheme: light dark; --page: #f6f5f2; --card: #fff; --ink: #1d1c1a; --soft: #6b6862; --line: #e2dfd8; --link: #2a5db0; }
@media (prefers-color-scheme: dark) { :root { --page: #16171a; --card: #1e2024; --ink: #e8e6e1; --soft: #9b9890; --line: #33353b; --link: #7aa7f0; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink); font: 16px/1.5 system-ui, "Segoe UI", Roboto, sans-serif; }
main { max-width: 84rem; margin: 0 auto; padding: 2.5rem 1.25rem 4rem; }
h1 { font-size: 2.2rem; margin: 0; letter-spacing: -.02em; } h2 { margin: 2.5rem 0 .25rem; letter-spacing: -.01em; }
p { color: var(--soft); margin: .2rem 0 1rem; max-width: 46rem; } a { color: var(--link); }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(19rem, 1fr)); gap: 1.25rem; }
article { background: var(--card); border: 1px solid var(--line); border-radius: 8px; overflow: hidden; }
article > a img { width: 100%; aspect-ratio: 4 / 3; display: block; object-fit: cover; }
.strip { display: grid; grid-template-columns: repeat(3, 1fr); gap: 1px; background: var(--line); }
.strip img { width: 100%; display: block; aspect-ratio: 4 / 3; }
.strip figure { margin: 0; background: var(--card); } .strip figcaption { font-size: .75rem; color: var(--soft); text-align: center; padding: .15rem; }
.text { padding: .7rem .9rem .9rem; } .text h3 { margin: 0; font-size: 1.05rem; }
dl { display: grid; grid-template-columns: auto 1fr; gap: 0 .8rem; margin: .35rem 0 0; font-size: .85rem; font-variant-numeric: tabular-nums; }
.notes { font-size: .8rem; margin: .4rem 0 0; white-space: pre-line; overflow-wrap: anywhere; }
dt { color: var(--soft); } dd { margin: 0; text-align: right; }
)css";

std::string passes(const std::map<std::string, double>& milliseconds) {
    std::string text;
    for (const auto& [pass, ms] : milliseconds)
        text += fmt::format("{}{} {:.1f} ms", text.empty() ? "" : ", ", pass, ms);
    return text;
}

// Names of meshes come from files.
std::string escaped(const std::string& text) {
    std::string html;
    for (const char c : text) html += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return html;
}

std::string cardHtml(const DemoCard& c) {
    const auto picture = [&](const char* kind, const char* caption) {
        return fmt::format(
            R"(<figure><a href="pictures/{0}-{1}.png"><img loading="lazy" src="pictures/{0}-{1}.png" alt="{2} visibility of {3}"></a><figcaption>{2}</figcaption></figure>)",
            c.stem, kind, caption, c.scene);
    };
    return fmt::format(
        R"(<article><a href="pictures/{0}-color.png"><img loading="lazy" src="pictures/{0}-color.png" alt="{1}"></a>
<div class="strip">{2}{3}{4}</div>
<div class="text"><h3>{1}</h3><dl><dt>triangles</dt><dd>{5}</dd><dt>RMSE against rays</dt><dd>{6:.4f}</dd>
<dt>mean absolute error</dt><dd>{7:.2f} %</dd><dt>time</dt><dd>{8}</dd></dl>{9}</div></article>
)",
        c.stem, c.scene, picture("mine", "mine"), picture("truth", "truth"),
        picture("difference", "difference"), c.triangles, c.metrics.rmse,
        100 * c.metrics.meanAbsolute, passes(c.milliseconds),
        c.notes.empty() ? "" : "<p class=\"notes\">" + escaped(c.notes) + "</p>");
}

}  // namespace

std::string demoPage(const DemoPage& page) {
    std::string html = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\">"
        "<title>Penumbra</title><style>{}</style></head><body><main>\n<h1>Penumbra</h1>\n"
        "<p>Every reference solution on every scene, rendered without a window and compared with "
        "rays traced in the same run. "
        "In a difference, red is light that should be shadow, blue is shadow that should be "
        "light.</p>\n",
        kStyle);
    for (const DemoGrade& g : page.grades) {
        html += fmt::format(
            "<h2>{}</h2>\n<p>The solution's grade: <a href=\"grades/{}\">{:g} of 100</a>, in "
            "{:.0f} s.</p>\n<div class=\"grid\">\n",
            g.assignment, g.report, g.score, g.seconds);
        for (const DemoCard& c : page.cards)
            if (c.assignment == g.assignment) html += cardHtml(c);
        html += "</div>\n";
    }
    return html + "</main></body></html>\n";
}

}  // namespace penumbra
