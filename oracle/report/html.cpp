#include <groundtruth/report/html.hpp>

#include <utility>

#include <fmt/format.h>

namespace groundtruth::report {

HtmlTable::HtmlTable(std::string caption, std::vector<Column> columns) : columns_(std::move(columns)) {
  html_ = fmt::format(
      "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\"><table><caption>{0}</caption>\n"
      "<thead><tr>",
      escaped(caption));
  for (const Column& column : columns_)
    html_ += fmt::format("<th scope=\"col\"{}>{}</th>",
                         column.align == Align::words ? " class=\"words\"" : "", escaped(column.heading));
  html_ += "</tr></thead>\n<tbody>\n";
}

void HtmlTable::add(const std::vector<std::string>& cells, const std::string& row_class) {
  html_ += row_class.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", row_class);
  for (std::size_t i = 0; i < cells.size(); ++i)
    html_ +=
        fmt::format("<td{}>{}</td>", columns_[i].align == Align::words ? " class=\"words\"" : "", cells[i]);
  html_ += "</tr>\n";
}

std::string HtmlTable::finished() const { return html_ + "</tbody></table></div>\n"; }

std::string duration_in_words(double nanoseconds) {
  if (nanoseconds < 999.5) return fmt::format("{:.3g} ns", nanoseconds);
  if (nanoseconds < 999.5e3) return fmt::format("{:.3g} µs", nanoseconds / 1e3);
  if (nanoseconds < 999.5e6) return fmt::format("{:.3g} ms", nanoseconds / 1e6);
  return fmt::format("{:.3g} s", nanoseconds / 1e9);
}

std::string short_number(double value) {
  if (value == 0) return "0";
  if (value >= 0.01 && value < 9999.5) return fmt::format("{:.3g}", value);
  return fmt::format("{:.1e}", value);
}

const char* const page_style = R"css(
:root { color-scheme: light dark; --ink: #1c2126; --soft: #4d565f; --page: #ffffff; --card: #f5f6f8;
  --line: #c9ced4; --accent: #0b5cad; --bad: #a3261b; --good: #14692f; --row: #e4eefa }
@media (prefers-color-scheme: dark) { :root { --ink: #e3e6e9; --soft: #aab3bb; --page: #14171a;
  --card: #1d2125; --line: #424a52; --accent: #7fbaf5; --bad: #ff9b8f; --good: #85d69b; --row: #1c2f45 } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--page); max-width: 62rem;
  margin: 0 auto; padding: 1.5rem 1rem 4rem }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .5rem } h2 { font-size: 1.3rem; margin: 2.6rem 0 .4rem }
h3 { font-size: 1.05rem; margin: 1.8rem 0 .3rem }
p, li { max-width: 48rem } a { color: var(--accent) } .soft, figcaption { color: var(--soft) }
figcaption { font-size: .86rem; max-width: none } figure { margin: .6rem 0 1.2rem }
figure > svg { max-width: 100%; height: auto; display: block }
nav ul { columns: 2; padding-left: 1.2rem; max-width: none }
code { font: .84em/1.4 ui-monospace, monospace; overflow-wrap: anywhere }
pre { font: .8rem/1.4 ui-monospace, monospace; background: var(--card); border: 1px solid var(--line);
  padding: .5rem .7rem; white-space: pre-wrap; overflow-wrap: anywhere; border-radius: 4px; margin: .4rem 0 }
.wide { overflow-x: auto; margin: .6rem 0 } table { border-collapse: collapse; font-size: .84rem;
  font-variant-numeric: tabular-nums; min-width: 100% }
caption { text-align: left; color: var(--soft); padding: .2rem 0 } th, td { padding: .22rem .55rem;
  border-bottom: 1px solid var(--line); text-align: right; vertical-align: top; white-space: nowrap }
th { font-weight: 600; border-bottom-width: 2px; white-space: normal; vertical-align: bottom }
.words { text-align: left } td.words { white-space: normal } td code { white-space: nowrap } tr.best td { background: var(--row) }
.bad { color: var(--bad); font-weight: 600 } .good { color: var(--good); font-weight: 600 }
details { margin: .5rem 0 1rem } summary { cursor: pointer; color: var(--accent) }
.facts { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; font-size: .88rem;
  background: var(--card); border: 1px solid var(--line); border-radius: 4px; padding: .7rem .9rem }
.facts dt { color: var(--soft) } .facts dd { margin: 0; overflow-wrap: anywhere }
@media print { body { max-width: none; font-size: 10pt; padding: 0 } figure, tr { break-inside: avoid }
  h2, h3 { break-after: avoid } nav { display: none } .wide { overflow: visible }
  :root { --ink: #000; --soft: #333; --page: #fff; --card: #fff; --accent: #000; --row: #eee } }
)css";

}  // namespace groundtruth::report
