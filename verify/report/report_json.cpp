#include <bit>

#include "base/text_format.h"
#include "verify/report/json_writer.h"
#include "verify/report/report_writers.h"

namespace haarlight::verify {

namespace {

/// "Haar coefficients" → "haar_coefficients".
std::string identifier(std::string name) {
  for (char& c : name) {
    if (c == ' ') c = '_';
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }
  return name;
}

void writeValue(JsonWriter& json, const std::string& name, bool isFloat, std::uint32_t bits) {
  json.member(name + "_bits", bitsText(bits)).key(name);
  if (isFloat)
    json.value(std::bit_cast<float>(bits));
  else
    json.value(bits);
}

void writeMismatch(JsonWriter& json, const Mismatch& mismatch) {
  json.beginObject();
  json.member("case", mismatch.caseName);
  json.member("sample", mismatch.sample);
  json.member("place", mismatch.place);
  json.member("type", mismatch.isFloat ? "float32" : "uint32");
  writeValue(json, "expected", mismatch.isFloat, mismatch.expectedBits);
  writeValue(json, "actual", mismatch.isFloat, mismatch.actualBits);
  json.member("distance_ulp", mismatch.ulp);
  json.end();
}

void writeRow(JsonWriter& json, const Row& row) {
  json.beginObject();
  json.member("stage", identifier(nameOf(row.stage)));
  json.textOrNull("visibility", row.visibility == "-" ? "" : row.visibility);
  json.textOrNull("setting", row.setting);
  json.member("engine", row.engine);
  json.member("device", row.device);
  json.member("shape", row.shape);
  json.member("verdict", identifier(nameOf(row.verdict())));
  json.member("compared_values", row.compared);
  json.member("mismatched_values", row.mismatches);
  json.member("maximum_ulp", row.maximumUlp);
  json.member("median_ulp", row.medianUlp);
  json.member("seconds", row.seconds);
  json.textOrNull("tolerance", row.tolerance);
  json.textOrNull("skip_reason", row.verdict() == Verdict::skipped ? row.note() : "");
  json.key("first_mismatches").beginArray();
  for (const Mismatch& mismatch : row.firstMismatches) writeMismatch(json, mismatch);
  json.end().end();
}

void writeAbsent(JsonWriter& json, const Absent& absent) {
  json.beginObject();
  json.member("engine", absent.engine);
  json.textOrNull("device", absent.device);
  json.member("reason", absent.reason);
  json.member("failed", absent.failed);
  json.end();
}

void writeFaults(JsonWriter& json, const FaultSummary& faults) {
  json.beginObject();
  json.member("kind", faults.kind);
  json.member("engine", faults.engine);
  json.member("device", faults.device);
  json.member("shape", faults.shape);
  json.member("visibility", faults.visibility);
  json.member("injected_faults", faults.injected);
  json.member("located_faults", faults.located);
  json.member("unexplained_mismatches", faults.unexplained);
  json.member("all_located", faults.allLocated());
  json.end();
}

void writeRun(JsonWriter& json, const Report& report) {
  json.member("program", report.program);
  json.member("host", report.host);
  json.member("date_utc", report.date);
  json.member("seed", report.seed);
  json.key("cases").beginObject();
  json.member("known", report.knownCases);
  json.member("scene", report.sceneCases);
  json.member("random", report.randomCases);
  json.end();
  json.member("seconds", report.seconds);
  json.member("agrees", report.agrees());
  json.member("conclusion", report.conclusion());
}

}  // namespace

void writeReport(JsonWriter& json, const Report& report) {
  json.beginObject();
  writeRun(json, report);
  json.key("rows").beginArray();
  for (const Row& row : report.rows) writeRow(json, row);
  json.end().key("absent").beginArray();
  for (const Absent& absent : report.absent) writeAbsent(json, absent);
  json.end().key("injected").beginArray();
  for (const FaultSummary& faults : report.faults) writeFaults(json, faults);
  json.end().end();
}

std::string jsonReport(const Report& report) {
  JsonWriter json;
  writeReport(json, report);
  return json.text();
}

}  // namespace haarlight::verify
