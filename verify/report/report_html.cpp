#include <algorithm>

#include "base/html.h"
#include "base/text_format.h"
#include "verify/report/picture.h"
#include "verify/report/report_table.h"
#include "verify/report/report_writers.h"

namespace haarlight::verify {

namespace {

constexpr char style[] = R"(
.verdict { white-space: nowrap; font-weight: 600; }
.skipped { color: var(--soft); font-weight: 400; }
.panels { display: flex; flex-wrap: wrap; gap: .75rem 1rem; }
.panel { max-width: 100%; }
.panel p, .faces { color: var(--soft); font-size: .85rem; margin: 0; }
.faces { display: grid; grid-template-columns: repeat(6, 1fr); text-align: center; }
img { display: block; width: 100%; height: auto; image-rendering: pixelated; }
)";

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
  const std::string verdict = classOf(report.agrees() ? Verdict::agrees : Verdict::differs);
  return element("h1", "Verification") + "\n" +
         element("p", markup(report.conclusion()), "conclusion " + verdict) + "\n" +
         element("dl", definition("program", report.program) + definition("host", report.host) +
                           definition("date", report.date) +
                           definition("cases", casesText(report)) +
                           definition("duration", fixedText(report.seconds, 1) + " s")) +
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
  const int enlargement = std::max(1, (isBitCube(picture) ? 1152 : 384) / picture.width);
  std::string faces;
  if (isBitCube(picture))
    for (const char* face : {"+X", "−X", "+Y", "−Y", "+Z", "−Z"}) faces += element("span", face);
  return "<div class=\"panel\" style=\"width: " + numberText(enlargement * picture.width) +
         "px\">" + element("p", label) + (faces.empty() ? "" : element("div", faces, "faces")) +
         pngImage(label, encodePng(picture.width, picture.height, pixels)) + "</div>\n";
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
  return htmlPage(
      joined({report.program, "verify"}, " "), style,
      runSection(report) + section("Results", resultsTable(report)) +
          section("Notes", notesList(report)) + section("Not run", absentTable(report)) +
          section("Injected faults", faultsTable(report)) + section("Mismatches", mismatches));
}

}  // namespace haarlight::verify
