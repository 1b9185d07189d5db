#include <algorithm>

#include "base/text_format.h"
#include "benchmark/reports.h"
#include "benchmark/roofline_report.h"
#include "benchmark/table_columns.h"
#include "benchmark/text_table.h"

namespace haarlight::benchmark {

namespace {

std::string millisecondsText(double seconds) {
  return fixedText(1e3 * seconds, 3);
}

std::string headText(const Record& record) {
  std::string text =
      joined({record.program, record.host, record.date}, " · ") + "\n" +
      joined({record.build, countText(record.threads, "thread") + " on the host"}, " · ") + "\n";
  if (!record.scale)
    text +=
        visible(joined({record.scene, record.light, countText(record.samples, "sample")}, " · ")) +
        "\n";
  text += "\n";
  for (const std::string& note : timingNotes(record)) text += note + "\n";
  return text;
}

std::string openingText(const MeasuredSubject& subject) {
  const DeviceDescription& device = subject.subject.device;
  const std::string driver = joined({device.platform, device.version, device.driver}, ", ");
  return "\n" + visible(subject.subject.name()) + "\n  " + visible(driver) +
         (driver.empty() ? "" : "; ") + "opened in " + fixedText(subject.openSeconds, 2) +
         " s, kernels of it " + fixedText(subject.compileSeconds, 2) + " s; " +
         countText(subject.deviceBytes) + " bytes on the device\n";
}

std::string cellText(const Column& column, const Row& row) {
  const auto value = column.value(row);
  return value ? fixedText(column.scale * *value, column.decimals) : "-";
}

/// One part of the rows' figures; columns that none of them has anything for are left out.
std::string partText(const Record& record, const std::vector<const Row*>& rows, Column::Part part) {
  std::vector<Cells> lines(1 + rows.size());
  for (const Column& column : tableColumns(record)) {
    const auto has = [&](const Row* row) { return column.value(*row).value_or(0) != 0; };
    if ((column.part != part && column.part != Column::Part::setting) ||
        std::ranges::none_of(rows, has))
      continue;
    lines[0].push_back(column.title);
    for (std::size_t i = 0; i < rows.size(); ++i)
      lines[i + 1].push_back(cellText(column, *rows[i]));
  }
  return alignedText(lines, 0, "  ");
}

std::string rowsText(const Record& record, std::size_t subject) {
  std::vector<const Row*> rows;
  for (const Row& row : record.rows)
    if (row.subject == subject) rows.push_back(&row);
  if (rows.empty()) return {};
  return "  milliseconds a frame\n" + partText(record, rows, Column::Part::frame) +
         "  milliseconds by stage, medians\n" + partText(record, rows, Column::Part::stages);
}

Cells peerCells(const std::string& name, const Quartiles& frame, const Errors& errors,
                double embree) {
  return {visible(name),
          numberText(frame.count),
          millisecondsText(frame.median),
          millisecondsText(frame.minimum),
          fixedText(embree / frame.median, 1),
          fixedText(100 * errors.againstMesh, 3),
          fixedText(100 * errors.againstSpheres, 3)};
}

std::string peersText(const Record& record) {
  if (!record.peers) return {};
  const PeerComparison& comparison = *record.peers;
  const double embree = embreeSeconds(record).value_or(0);
  std::vector<Cells> lines{
      {"method", "frames", "median", "min", "times Embree", "error, mesh %", "error, spheres %"}};
  for (const Peer& peer : comparison.peers)
    lines.push_back(peerCells(peer.name, peer.frame, peer.errors, embree));
  for (const RowErrors& errors : comparison.rowErrors) {
    const Row& row = record.rows[errors.row];
    const std::string setting = countText(std::uint64_t(row.setting.terms), "term") + ", level " +
                                numberText(row.setting.levels);
    lines.push_back(peerCells(joined({record.subjects[row.subject].subject.name(), setting}, ", "),
                              row.frame, errors.errors, embree));
  }
  std::string text = "\nPeers with " + countText(std::uint64_t(comparison.spheres), "sphere") +
                     "; milliseconds; root mean square errors against rays to the mesh and against "
                     "all texels with the spheres\n" +
                     alignedText(lines, 1, "  ");
  std::string described;
  for (const Peer& peer : comparison.peers)
    if (std::exchange(described, kindOf(peer)) != kindOf(peer))
      text += "  " + kindOf(peer) + ": " + peer.description + "\n";
  return text;
}

std::string sweepText(const Sweep& sweep) {
  std::vector<Cells> lines{{sweep.parameter, "frames", "median", "min", "frames/s"}};
  for (const ScalePoint& point : sweep.points)
    lines.push_back({numberText(point.size), numberText(point.frame.count),
                     millisecondsText(point.frame.median), millisecondsText(point.frame.minimum),
                     fixedText(point.frame.perSecond(), 2)});
  std::string text = alignedText(lines, 0, "  ");
  if (sweep.law)
    text += "  exponent " + fixedText(sweep.law->exponent, 3) + ", of the upper half " +
            fixedText(sweep.law->upperHalfExponent, 3) + ", above a fixed cost of " +
            millisecondsText(sweep.law->fixedSeconds) + " ms " +
            fixedText(sweep.law->exponentAboveFixed, 3) + "\n";
  return text + "\n";
}

std::string scaleText(const Record& record) {
  if (!record.scale) return {};
  const Setting& setting = record.scale->setting;
  std::string text = "  spheres along a torus knot above the plane; where not swept: " +
                     countText(record.scale->samples, "sample") + ", " +
                     countText(std::uint64_t(setting.spheres), "sphere") + ", " +
                     countText(std::uint64_t(setting.terms), "term") + ", level " +
                     numberText(setting.levels) + "; milliseconds\n\n";
  for (const Sweep& sweep : record.scale->sweeps) text += sweepText(sweep);
  return text;
}

std::string comparisonText(const Comparison& comparison) {
  std::string text = "\nTime now over time in " + visible(comparison.earlier.file) + " (" +
                     joined({comparison.earlier.host, comparison.earlier.date}, " · ") +
                     "); below 1 is faster\n";
  std::vector<Cells> lines{{"row", "ratio", "lowest", "highest", "verdict"}};
  for (const RowRatio& row : comparison.ratios)
    lines.push_back({visible(row.name.text()), fixedText(row.ratio, 3), fixedText(row.lowest, 3),
                     fixedText(row.highest, 3), row.verdict()});
  text += alignedText(lines, 1, "  ");
  for (const RowName& name : comparison.onlyNow)
    text += "  only now: " + visible(name.text()) + "\n";
  for (const RowName& name : comparison.onlyBefore)
    text += "  only before: " + visible(name.text()) + "\n";
  return text;
}

}  // namespace

std::string textReport(const Record& record, const Comparison* comparison) {
  std::string text = headText(record);
  for (std::size_t i = 0; i < record.subjects.size(); ++i)
    text += openingText(record.subjects[i]) + rowsText(record, i);
  text += scaleText(record) + peersText(record) + rooflineText(record);
  return comparison ? text + comparisonText(*comparison) : text;
}

}  // namespace haarlight::benchmark
