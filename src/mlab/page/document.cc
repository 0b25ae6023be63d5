#include "mlab/page/document.h"

#include <string>
#include <string_view>

#include <fmt/core.h>

#include "mlab/text/escape.h"

namespace mlab::page {
namespace {

// What the page looks like, light and dark.
constexpr std::string_view kStyle = R"css(
:root { color-scheme: light dark; --back: #fff; --ink: #1b1f24; --faint: #57606a; --line: #d0d7de; --box: #f6f8fa;
  --one: #0b62b8; --two: #a04800; --good: #116329; --bad: #b3261e; }
@media (prefers-color-scheme: dark) { :root { --back: #0d1117; --ink: #e6edf3; --faint: #9da7b1; --line: #30363d;
  --box: #161b22; --one: #6cb6ff; --two: #f0a35e; --good: #57ab5a; --bad: #ff7b72; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 90rem; background: var(--back); color: var(--ink);
  font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: .5rem 0; }
h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; }
h3 { font-size: 1rem; margin: 1.25rem 0 .25rem; }
p { margin: .5rem 0; max-width: 50rem; overflow-wrap: anywhere; text-wrap: pretty; }
.faint, .figure, .marks { color: var(--faint); }
.good { color: var(--good); font-weight: 600; }
.bad { color: var(--bad); font-weight: 600; }
.row { display: grid; grid-template-columns: minmax(6rem, 20rem) minmax(0, 1fr) 14rem; gap: 0 .75rem; align-items: center; }
.label { font-size: .9375rem; line-height: 1.3; overflow-wrap: anywhere; text-wrap: balance; }
a { color: var(--one); }
.figure { font-size: .875rem; font-variant-numeric: tabular-nums; }
.row svg { display: block; width: 100%; height: 30px; overflow: visible; margin: 2px 0; --color: var(--one); }
.second svg { --color: var(--two); }
.axis .marks { position: relative; height: 1.5rem; font-size: .8125rem; }
.marks span { position: absolute; top: 0; white-space: nowrap; }
path { vector-effect: non-scaling-stroke; fill: none; }
.grid { stroke: var(--line); stroke-width: 1; }
.range { stroke: var(--color); stroke-width: 3; }
.point { stroke: var(--color); stroke-width: 11; stroke-linecap: round; }
.bars { fill: var(--color); opacity: .75; }
.median { stroke: var(--ink); stroke-width: 2; }
.line { stroke: var(--one); stroke-width: 1.5; stroke-linejoin: round; }
.line.two, .key.two { stroke: var(--two); color: var(--two); }
.key { color: var(--one); font-weight: 600; }
.map { display: block; width: 100%; max-height: 36rem; border: 1px solid var(--line); border-radius: 6px; }
.scroll { overflow-x: auto; border: 1px solid var(--line); border-radius: 6px; }
.scroll:focus-visible { outline: 2px solid var(--one); }
table { border-collapse: collapse; width: 100%; font-size: .875rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding: .4rem .6rem; color: var(--faint); }
th, td { padding: .3rem .6rem; text-align: right; vertical-align: top; border-top: 1px solid var(--line); }
th { font-weight: 600; }
thead th { background: var(--box); }
.left { text-align: left; overflow-wrap: break-word; }
.wide th, .wide td { padding: .3rem .45rem; }
.wide .left { min-width: 12rem; }
ol.causes { padding: 0; list-style: none; }
ol.causes li { margin: .75rem 0; padding: .5rem .75rem; border: 1px solid var(--line); border-left: 4px solid var(--bad);
  border-radius: 6px; overflow-wrap: anywhere; }
code { display: block; margin-top: .4rem; padding: .4rem .6rem; background: var(--box); border-radius: 4px;
  font: .8125rem/1.5 ui-monospace, "DejaVu Sans Mono", monospace; white-space: pre-wrap; overflow-wrap: anywhere;
  user-select: all; }
.word { display: inline; margin: 0; padding: .1rem .3rem; white-space: normal; user-select: auto; }
dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: .15rem 1rem; margin: .5rem 0; }
dt { color: var(--faint); }
dd { margin: 0; overflow-wrap: anywhere; }
@media (max-width: 45rem) {
  .row { grid-template-columns: minmax(0, 1fr) max-content; margin-bottom: .4rem; }
  .row .figure { grid-row: 1; grid-column: 2; text-align: right; }
  .row svg, .row .marks { grid-column: 1 / -1; }
  .axis .label, .axis .figure { display: none; }
}
@media print { .scroll { overflow: visible; } }
)css";

// Tables whose rows stand by themselves on screens up to a width, with a word for each of their cells.
std::string stacked(std::string_view width, std::string_view tables) {
  return fmt::format(R"css(
@media screen and (max-width: {0}) {{
  {1}, {1} caption, {1} tbody {{ display: block; }}
  {1} thead {{ position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }}
  {1} tbody tr {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(9rem, 1fr)); gap: .15rem .75rem;
    padding: .5rem .6rem; border-top: 1px solid var(--line); }}
  {1} tbody th {{ grid-column: 1 / -1; overflow-wrap: anywhere; }}
  {1} tbody th, {1} td {{ display: block; min-width: 0; padding: 0; border: 0; text-align: left; }}
  {1} td::before {{ content: attr(data-head); display: block; color: var(--faint); font-size: .8125rem; }}
  {1} tbody th::before {{ content: attr(data-head) " "; color: var(--faint); font-weight: 400; }}
  {1} td:empty {{ display: none; }}
}}
)css",
                     width, tables);
}

}  // namespace

std::string prose(std::string_view sentence) {
  std::string out;
  for (;;) {
    const std::size_t begin = sentence.find('`');
    const std::size_t end = begin == std::string_view::npos ? begin : sentence.find('`', begin + 1);
    if (end == std::string_view::npos) return out + text::markup(sentence);
    out += fmt::format("{}<code class=\"word\">{}</code>", text::markup(sentence.substr(0, begin)),
                       text::markup(sentence.substr(begin + 1, end - begin - 1)));
    sentence.remove_prefix(end + 1);
  }
}

std::string document(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta http-equiv=\"Content-Security-Policy\" "
      R"(content="default-src 'none'; style-src )"
      "'unsafe-inline'\">\n<title>{0}</title>\n<style>{1}</style>\n</head>\n"
      "<body>\n<main>\n<h1>{0}</h1>\n{2}</main>\n</body>\n</html>\n",
      text::markup(title), std::string(kStyle) + stacked("80rem", ".wide") + stacked("36rem", "table"), body);
}

}  // namespace mlab::page
