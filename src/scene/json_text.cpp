#include "scene/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/error.h"

namespace haarlight {

namespace {

using nlohmann::json;

[[noreturn]] void failAt(std::string_view text, std::size_t position, const std::string& fileName,
                         const std::string& problem) {
  const std::string_view before = text.substr(0, position);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
  throw InputError(fmt::format("{}: line {}, column {}: {}", fileName, line,
                               before.size() - lineStart + 1, problem));
}

/// "[json.exception.…] parse error at line 1, column 2: syntax error while parsing value - <what
/// follows>; last read: '…'" to <what follows>.
std::string withoutPreamble(const std::string& message) {
  constexpr std::string_view separator = " - ";
  const std::size_t start = message.find(separator);
  const std::string problem =
      start == std::string::npos ? message : message.substr(start + separator.size());
  return problem.substr(0, problem.find("; last read: '"));
}

/// Where the number is that the library calls too large ("… parsing '<number>'"); it does not say.
std::size_t findOverflow(std::string_view text, const std::string& message) {
  const std::size_t open = message.find('\'') + 1;
  return text.find(message.substr(open, message.rfind('\'') - open));
}

/// Refuses what the grammar allows and the library would pass over in silence.
class StructureGuard {
 public:
  explicit StructureGuard(const std::string& fileName) : fileName_(fileName) {}

  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    using enum json::parse_event_t;
    if (depth >= maximumJsonDepth && (event == object_start || event == array_start))
      throw InputError(fmt::format("{}: arrays and objects are nested more than {} deep", fileName_,
                                   maximumJsonDepth));
    if (event == object_start) names_.emplace_back();
    if (event == object_end) names_.pop_back();
    if (event == key && !names_.back().insert(parsed.get<std::string>()).second)
      throw InputError(
          fmt::format("{}: field {} is given twice in one object", fileName_, parsed.dump()));
    return true;
  }

 private:
  const std::string& fileName_;
  std::vector<std::set<std::string>> names_;
};

}  // namespace

json parseJson(std::string_view text, const std::string& fileName) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
  try {
    StructureGuard guard(fileName);
    return json::parse(text, [&](int depth, json::parse_event_t event, json& parsed) {
      return guard(depth, event, parsed);
    });
  } catch (const json::parse_error& error) {
    const std::size_t position = std::min(error.byte - 1, text.size());
    const bool comment = position < text.size() && (text[position] == '/' || text[position] == '#');
    failAt(text, position, fileName,
           comment ? "JSON has no comments; remove it" : withoutPreamble(error.what()));
  } catch (const json::out_of_range& error) {
    failAt(text, findOverflow(text, error.what()), fileName, "the number is too large");
  }
}

}  // namespace haarlight
