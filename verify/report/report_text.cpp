#include <algorithm>
#include <array>

#include "base/text_format.h"
#include "verify/report/report_table.h"
#include "verify/report/report_writers.h"

namespace haarlight::verify {

namespace {

using Widths = std::array<std::size_t, tableColumns.size()>;

std::size_t widthOf(const std::string& text) {
  return std::size_t(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

std::string inColor(const std::string& text, Verdict verdict, bool colored) {
  if (!colored) return text;
  const char* code = verdict == Verdict::agrees    ? "32"
                     : verdict == Verdict::differs ? "1;31"
                     : verdict == Verdict::skipped ? "2"
                                                   : "33";
  return "\x1b[" + std::string(code) + "m" + text + "\x1b[0m";
}

std::string runText(const Report& report) {
  return visible(joined({report.program, report.host, report.date}, " · ")) + "\n" +
         casesText(report) + " · " + fixedText(report.seconds, 1) + " s\n";
}

std::string tableLine(const TableCells& cells, const Widths& widths, const Row* row, bool colored) {
  std::string line;
  for (std::size_t i = 0; i < tableColumns.size(); ++i) {
    const std::string blanks(widths[i] - widthOf(cells[i]), ' ');
    const std::string text = tableColumns[i].number ? blanks + cells[i] : cells[i] + blanks;
    const bool isVerdict = row && i == verdictColumn;
    line += "  " + (isVerdict ? inColor(text, row->verdict(), colored) : text);
  }
  return line + "\n";
}

std::string table(const Report& report, bool colored) {
  const std::vector<std::string> notes = notesOf(report);
  TableCells titles;
  Widths widths{};
  const auto widen = [&](const TableCells& cells) {
    for (std::size_t i = 0; i < tableColumns.size(); ++i)
      widths[i] = std::max(widths[i], widthOf(cells[i]));
  };
  for (std::size_t i = 0; i < tableColumns.size(); ++i) titles[i] = tableColumns[i].title;
  widen(titles);
  for (const Row& row : report.rows) widen(tableCells(row, notes));
  std::string text = tableLine(titles, widths, nullptr, colored);
  for (const RowGroup& group : groupsOf(report)) {
    text += "\n" + visible(group.name) + "\n";
    for (const Row* row : group.rows)
      text += tableLine(tableCells(*row, notes), widths, row, colored);
  }
  return text;
}

std::string notesText(const Report& report) {
  std::string text;
  const std::vector<std::string> notes = notesOf(report);
  for (std::size_t i = 0; i < notes.size(); ++i)
    text += "  [" + numberText(i + 1) + "] " + visible(notes[i]) + "\n";
  return text;
}

std::string absentText(const Report& report, bool colored) {
  std::string text;
  for (const Absent& absent : report.absent)
    text += "  " +
            (absent.failed ? inColor("FAILED ", Verdict::differs, colored)
                           : inColor("not run", Verdict::skipped, colored)) +
            "  " + visible(joined({absent.engine, absent.device}, " · ")) + ": " +
            visible(absent.reason) + "\n";
  return text;
}

std::string faultsText(const Report& report, bool colored) {
  std::string text;
  for (const FaultSummary& faults : report.faults)
    text += "  " +
            (faults.allLocated() ? inColor("located", Verdict::agrees, colored)
                                 : inColor("MISSED ", Verdict::differs, colored)) +
            "  " + visible(nameOf(faults)) + ": " + countsText(faults) + "\n";
  return text;
}

std::string mismatchesText(const Report& report) {
  std::string text;
  for (const RowGroup& group : groupsOf(report))
    for (const Row* row : group.rows) {
      if (row->agrees()) continue;
      text += (text.empty() ? "  " : "\n  ") + visible(group.name) + "\n  " + visible(row->name()) +
              "\n";
      for (const std::string& line : mismatchLines(*row)) text += "    " + line + "\n";
    }
  return text;
}

std::string section(const std::string& title, const std::string& content) {
  return content.empty() ? "" : "\n" + title + "\n" + content;
}

}  // namespace

std::string textReport(const Report& report, bool colored) {
  const Verdict verdict = report.agrees() ? Verdict::agrees : Verdict::differs;
  return runText(report) + "\n" + table(report, colored) +
         section("Mismatches", mismatchesText(report)) + section("Notes", notesText(report)) +
         section("Not run", absentText(report, colored)) +
         section("Injected faults", faultsText(report, colored)) + "\n" +
         inColor(report.conclusion(), verdict, colored) + "\n";
}

}  // namespace haarlight::verify
