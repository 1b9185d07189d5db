#include <algorithm>

#include "verify/report/format.h"
#include "verify/report/picture.h"
#include "verify/report/report_table.h"
#include "verify/report/report_writers.h"

namespace haarlight::verify {

namespace {

constexpr char style[] = R"(
:root {
  color-scheme: light dark;
  --page: #fcfcfa; --text: #1d1f24; --soft: #62666f; --line: #d9d9d4; --group: #f1f1ec;
  --agrees: #17692f; --agrees-fill: #e0f2e4; --differs: #a4121b; --differs-fill: #fbe1e1;
  --within: #7a5200; --within-fill: #faefd2;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #16181c; --text: #e4e5e8; --soft: #9a9fa9; --line: #34373e; --group: #1f2228;
    --agrees: #86d89b; --agrees-fill: #17341f; --differs: #ff9a9a; --differs-fill: #471a1d;
    --within: #efc767; --within-fill: #3c3014;
  }
}
body { margin: 0; background: var(--page); color: var(--text);
       font: 15px/1.5 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
main { max-width: 76rem; margin: 0 auto; padding: 2rem 1.5rem 4rem; }
h1 { font-size: 1.7rem; margin: 0 0 1rem; }
h2 { font-size: 1.2rem; margin: 2.5rem 0 .75rem; }
h3 { font-size: 1rem; margin: 2rem 0 .25rem; }
p { margin: .25rem 0 .75rem; }
.conclusion { padding: .7rem 1rem; border-radius: 6px; font-size: 1.1rem; font-weight: 600; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1.25rem; margin: 1rem 0; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; text-align: left; vertical-align: top;
         border-bottom: 1px solid var(--line); }
thead th { color: var(--soft); font-weight: 500; white-space: nowrap; }
th.group { background: var(--group); padding-top: .6rem; }
.number { text-align: right; white-space: nowrap; }
.verdict { white-space: nowrap; font-weight: 600; }
.agrees { color: var(--agrees); background: var(--agrees-fill); }
.differs { color: var(--differs); background: var(--differs-fill); }
.within { color: var(--within); background: var(--within-fill); }
.skipped { color: var(--soft); font-weight: 400; }
code { font: .9em ui-monospace, Consolas, "DejaVu Sans Mono", monospace; white-space: nowrap; }
figure { margin: 1.25rem 0; }
figcaption { font-weight: 600; margin-bottom: .4rem; }
.panels { display: flex; flex-wrap: wrap; gap: .75rem 1rem; }
.panel { max-width: 100%; }
.panel p, .faces { color: var(--soft); font-size: .85rem; margin: 0; }
.faces { display: grid; grid-template-columns: repeat(6, 1fr); text-align: center; }
img { display: block; width: 100%; height: auto; image-rendering: pixelated; }
)";

std::string element(const std::string& tag, const std::string& content,
                    const std::string& classes = {}) {
  const std::string attribute = classes.empty() ? "" : " class=\"" + classes + "\"";
  return "<" + tag + attribute + ">" + content + "</" + tag + ">";
}

std::string section(const std::string& title, const std::string& content) {
  return content.empty() ? "" : element("h2", title) + "\n" + content;
}

std::string classOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::agrees:
      return "agrees";
    case Verdict::withinTolerance:
      return "within";
    case Verdict::differs:
      return "differs";
    case Verdict::skipped:
      return "skipped";
  }
  return {};
}

std::string runSection(const Report& report) {
  const auto entry = [](const std::string& term, const std::string& text) {
    return element("dt", term) + element("dd", markup(text)) + "\n";
  };
  const std::string verdict = classOf(report.agrees() ? Verdict::agrees : Verdict::differs);
  return element("h1", "Verification") + "\n" +
         element("p", markup(report.conclusion()), "conclusion " + verdict) + "\n" +
         element("dl", entry("program", report.program) + entry("host", report.host) +
                           entry("date", report.date) + entry("cases", casesText(report)) +
                           entry("duration", fixedText(report.seconds, 1) + " s")) +
         "\n";
}

std::string tableHead() {
  std::string cells;
  for (const TableColumn& column : tableColumns)
    cells += element("th", column.title, column.number ? "number" : "");
  return element("thead", element("tr", cells)) + "\n";
}

std::string tableRow(const Row& row, const std::vector<std::string>& notes) {
  const TableCells cells = tableCells(row, notes);
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string verdict = "verdict " + classOf(row.verdict());
    text += element("td", markup(cells[i]),
                    i == verdictColumn       ? verdict
                    : tableColumns[i].number ? "number"
                                             : "");
  }
  return element("tr", text) + "\n";
}

std::string wideTable(const std::string& content) {
  return element("div", element("table", content), "wide") + "\n";
}

std::string resultsTable(const Report& report) {
  if (report.rows.empty()) return {};
  const std::vector<std::string> notes = notesOf(report);
  std::string text = tableHead();
  for (const RowGroup& group : groupsOf(report)) {
    std::string rows = "<tr><th class=\"group\" scope=\"rowgroup\" colspan=\"" +
                       numberText(tableColumns.size()) + "\">" + markup(group.name) +
                       "</th></tr>\n";
    for (const Row* row : group.rows) rows += tableRow(*row, notes);
    text += element("tbody", rows) + "\n";
  }
  return wideTable(text);
}

std::string notesList(const Report& report) {
  std::string items;
  for (const std::string& note : notesOf(report)) items += element("li", markup(note)) + "\n";
  return items.empty() ? "" : element("ol", items) + "\n";
}

std::string tableRow(Verdict verdict, const std::string& word, const std::string& name,
                     const std::string& text) {
  return element("tr", element("td", word, "verdict " + classOf(verdict)) +
                           element("td", markup(name)) + element("td", markup(text))) +
         "\n";
}

std::string absentTable(const Report& report) {
  std::string rows;
  for (const Absent& absent : report.absent)
    rows += tableRow(absent.failed ? Verdict::differs : Verdict::skipped,
                     absent.failed ? "FAILED" : "not run",
                     joined({absent.engine, absent.device}, " · "), absent.reason);
  return rows.empty() ? "" : wideTable(rows);
}

std::string faultsTable(const Report& report) {
  std::string rows;
  for (const FaultSummary& faults : report.faults)
    rows +=
        tableRow(faults.allLocated() ? Verdict::agrees : Verdict::differs,
                 faults.allLocated() ? "located" : "MISSED", nameOf(faults), countsText(faults));
  return rows.empty() ? "" : wideTable(rows);
}

bool isBitCube(const DifferencePicture& picture) {
  return picture.width == faceCount * faceSize && picture.height == faceSize;
}

std::string panel(const std::string& label, const DifferencePicture& picture,
                  const std::vector<std::uint8_t>& pixels) {
  const std::string data = base64(encodePng(picture.width, picture.height, pixels));
  const int enlargement = std::max(1, (isBitCube(picture) ? 1152 : 384) / picture.width);
  std::string faces;
  if (isBitCube(picture))
    for (const char* face : {"+X", "−X", "+Y", "−Y", "+Z", "−Z"}) faces += element("span", face);
  return "<div class=\"panel\" style=\"width: " + numberText(enlargement * picture.width) +
         "px\">" + element("p", label) + (faces.empty() ? "" : element("div", faces, "faces")) +
         "<img alt=\"" + label + "\" src=\"data:image/png;base64," + data + "\"/></div>\n";
}

std::string figure(const DifferencePicture& picture) {
  const std::string difference =
      isBitCube(picture) ? "difference: wrong texels red" : "difference: blue 1 ULP, red 2³¹ ULP";
  return element("figure", element("figcaption", markup(picture.title)) + "\n" +
                               element("div",
                                       panel("expected", picture, picture.expected) +
                                           panel("actual", picture, picture.actual) +
                                           panel(difference, picture, picture.difference),
                                       "panels")) +
         "\n";
}

std::string mismatchTable(const Row& row) {
  std::string rows =
      "<thead><tr><th>case</th><th class=\"number\">sample</th><th>place</th><th>expected</th>"
      "<th>actual</th><th class=\"number\">ULP</th></tr></thead>\n";
  const auto value = [](const Mismatch& mismatch, std::uint32_t bits) {
    return element("td", element("code", valueText(mismatch, bits)));
  };
  for (const Mismatch& mismatch : row.firstMismatches)
    rows +=
        element("tr",
                element("td", markup(mismatch.caseName)) +
                    element("td", countText(mismatch.sample), "number") +
                    element("td", markup(mismatch.place)) + value(mismatch, mismatch.expectedBits) +
                    value(mismatch, mismatch.actualBits) +
                    element("td", mismatch.isFloat ? countText(mismatch.ulp) : "-", "number")) +
        "\n";
  return row.firstMismatches.empty() ? "" : wideTable(rows);
}

std::string mismatchesOf(const RowGroup& group) {
  std::string text;
  for (const Row* row : group.rows) {
    if (row->agrees() && row->pictures.empty()) continue;
    text += element("h3", markup(row->name())) + "\n" +
            element("p", markup(group.name) + ": " + countText(row->mismatches) + " of " +
                             countText(row->compared, "value") + " differ") +
            "\n" + mismatchTable(*row);
    for (const DifferencePicture& picture : row->pictures) text += figure(picture);
  }
  return text;
}

}  // namespace

std::string htmlReport(const Report& report) {
  std::string mismatches;
  for (const RowGroup& group : groupsOf(report)) mismatches += mismatchesOf(group);
  const std::string title = markup(joined({report.program, "verify"}, " "));
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
         element("title", title) + "\n" + element("style", style) + "\n</head>\n<body>\n<main>\n" +
         runSection(report) + section("Results", resultsTable(report)) +
         section("Notes", notesList(report)) + section("Not run", absentTable(report)) +
         section("Injected faults", faultsTable(report)) + section("Mismatches", mismatches) +
         "</main>\n</body>\n</html>\n";
}

}  // namespace haarlight::verify
