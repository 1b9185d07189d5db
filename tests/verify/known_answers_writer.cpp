#include "known_answers_writer.h"

#include <sstream>
#include <utility>

#include "base/text_format.h"

namespace haarlight::test {

using namespace haarlight::verify;

namespace {

std::string digits(std::uint64_t number, std::size_t count) {
  const std::string text = numberText(number, 16);
  return std::string(count - text.size(), '0') + text;
}

/// Rows of a bit cube, a line for every face that is not empty.
void appendRows(std::string& text, const std::string& keyword, const BitCube& cube) {
  for (int face = 0; face < faceCount; ++face) {
    int first = face * faceSize, last = first + faceSize - 1;
    while (first <= last && cube.rows[std::size_t(first)] == 0) ++first;
    while (first <= last && cube.rows[std::size_t(last)] == 0) --last;
    if (first > last) continue;
    text += keyword + " " + std::to_string(first);
    for (int row = first; row <= last; ++row) text += " " + digits(cube.rows[std::size_t(row)], 8);
    text += "\n";
  }
}

void appendEntries(std::string& text, const KnownCase& known, std::size_t receiver) {
  const std::size_t count = known.question.spheres.size();
  if (count == 0) return;
  text += "entries " + std::to_string(receiver);
  for (std::size_t i = 0; i < count; ++i)
    text += " " + std::to_string(known.tableEntries[receiver * count + i]);
  text += "\n";
}

std::string answerLines(const KnownCase& known) {
  std::string text;
  for (const auto& [center, radius] : known.movedSpheres) {
    text += "moved";
    for (const float number : {center.x, center.y, center.z, radius})
      text += " " + floatText(number);
    text += "\n";
  }
  for (std::size_t i = 0; i < known.exactBitCubes.size(); ++i) {
    appendEntries(text, known, i);
    appendRows(text, "exact " + std::to_string(i), known.exactBitCubes[i]);
    appendRows(text, "table " + std::to_string(i), known.tableBitCubes[i]);
  }
  if (!known.exactBitCubes.empty()) text += "haar " + digits(known.haarHash, 16) + "\n";
  for (const KnownRadiance& radiance : known.radiance)
    text += std::string("radiance ") +
            (radiance.visibility == VisibilityKind::exact ? "exact " : "table ") +
            std::to_string(radiance.terms) + " " + std::to_string(radiance.levels) + " " +
            digits(radiance.hash, 16) + "\n";
  return text;
}

bool isAnswer(const std::string& line) {
  for (const char* keyword : {"moved ", "entries ", "exact ", "table ", "haar ", "radiance "})
    if (line.starts_with(keyword)) return true;
  return false;
}

}  // namespace

std::string withAnswers(const std::string& text, const std::vector<KnownCase>& known) {
  std::string result;
  std::size_t finished = 0;
  bool inCase = false;
  const auto finishCase = [&] {
    if (std::exchange(inCase, false)) result += answerLines(known.at(finished++));
  };
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (isAnswer(line)) continue;
    if (line.empty()) finishCase();
    if (line.starts_with("name ")) inCase = true;
    result += line + "\n";
  }
  finishCase();
  return result;
}

}  // namespace haarlight::test
