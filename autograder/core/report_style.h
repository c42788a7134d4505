// The look of report.html: one sheet, light and dark, no script, no font to load.
#pragma once

namespace penumbra {

inline constexpr const char* kReportStyle = R"css(
:root { color-scheme: light dark;
  --page: #f6f5f2; --card: #fff; --ink: #1d1c1a; --soft: #6b6862; --line: #e2dfd8;
  --pass: #1a7f4b; --fail: #b3352b; --idle: #8a8578; --odd: #a06400; --link: #2a5db0; }
@media (prefers-color-scheme: dark) { :root {
  --page: #16171a; --card: #1e2024; --ink: #e8e6e1; --soft: #9b9890; --line: #33353b;
  --pass: #4cc38a; --fail: #f0796d; --idle: #8f8c84; --odd: #e0a13c; --link: #7aa7f0; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 16px/1.5 system-ui, "Segoe UI", Roboto, "Helvetica Neue", sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 2.5rem 1.25rem 4rem; }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
header { display: flex; gap: 2rem; align-items: flex-end; flex-wrap: wrap; }
header div:first-child { flex: 1 1 20rem; }
.kicker { color: var(--soft); margin: 0; }
h1 { font-size: 2.1rem; line-height: 1.15; margin: .1rem 0 0; letter-spacing: -.02em; }
.score { font-size: 3.2rem; font-weight: 650; line-height: 1; letter-spacing: -.03em; margin: 0;
  font-variant-numeric: tabular-nums; }
.score small { font-size: 1.1rem; font-weight: 400; color: var(--soft); letter-spacing: 0; }
.bar { display: flex; gap: 2px; height: .6rem; margin: 1.4rem 0 .6rem; }
.bar i { border-radius: 2px; min-width: 2px; }
.bar .pass { background: var(--pass); } .bar .fail { background: var(--fail); }
.bar .idle { background: var(--line); } .bar .odd { background: var(--odd); }
.facts { color: var(--soft); font-size: .88rem; margin: 0; }
.note { background: var(--card); border: 1px solid var(--line); border-left: 4px solid var(--odd);
  border-radius: 8px; padding: .8rem 1.1rem; margin: 1.4rem 0 0; }
.note b { display: block; }
section { margin-top: 2.6rem; }
h2 { font-size: 1.25rem; margin: 0; letter-spacing: -.01em; }
.task { display: flex; align-items: baseline; gap: 1rem; flex-wrap: wrap; margin-bottom: .7rem; }
.task span { color: var(--soft); font-size: .9rem; } .task span:last-child { margin-left: auto; }
details { background: var(--card); border: 1px solid var(--line); border-radius: 8px; margin: .5rem 0; }
summary { display: flex; gap: .8rem; align-items: baseline; padding: .65rem 1rem; cursor: pointer;
  list-style: none; } summary::-webkit-details-marker { display: none; }
summary .what { flex: 1; } summary .points { color: var(--soft); font-variant-numeric: tabular-nums;
  white-space: nowrap; }
.verdict { flex: 0 0 6.6rem; font-size: .8rem; font-weight: 650; white-space: nowrap; }
.verdict::before { content: "●"; margin-right: .45em; }
.verdict.pass { color: var(--pass); } .verdict.pass::before { content: "✓"; }
.verdict.fail { color: var(--fail); } .verdict.fail::before { content: "✗"; }
.verdict.idle { color: var(--idle); } .verdict.idle::before { content: "○"; }
.verdict.odd { color: var(--odd); } .verdict.odd::before { content: "!"; }
.body { border-top: 1px solid var(--line); padding: .9rem 1rem 1rem; }
.reason { margin: 0 0 .8rem; padding: .5rem .8rem; border-radius: 6px; overflow-wrap: anywhere;
  background: color-mix(in srgb, var(--fail) 10%, transparent);
  font: .86rem/1.5 ui-monospace, "SF Mono", Menlo, Consolas, monospace; }
.reason.odd { background: color-mix(in srgb, var(--odd) 14%, transparent); }
.figures { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: .8rem; margin: 0 0 .7rem; }
figure { margin: 0; } figcaption { color: var(--soft); font-size: .82rem; margin-top: .25rem; }
img { display: block; width: 100%; border-radius: 4px; border: 1px solid var(--line);
  image-rendering: pixelated; background: #808080; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1.1rem; margin: 0 0 1rem;
  font-size: .92rem; }
dl:last-child { margin-bottom: 0; } dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; }
dd.fail { color: var(--fail); } dd.pass { color: var(--pass); }
code { font: .82rem/1.5 ui-monospace, "SF Mono", Menlo, Consolas, monospace; color: var(--soft);
  overflow-wrap: anywhere; display: block; }
@media (max-width: 36rem) { .verdict { flex-basis: 1.2rem; overflow: hidden; } dl { display: block; } }
)css";

}  // namespace penumbra
