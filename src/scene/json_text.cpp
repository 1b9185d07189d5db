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

/// Refuses what the grammar allows and the library would pass over in silence. It comes before the
/// library's own parse, whose callbacks take time with the square of an array's size.
class StructureGuard : public nlohmann::json_sax<json> {
 public:
  explicit StructureGuard(const std::string& fileName) : fileName_(fileName) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }

  bool start_object(std::size_t) override { return enter(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }

  bool key(string_t& name) override {
    if (!names_.back().insert(name).second)
      throw InputError(
          fmt::format("{}: field {} is given twice in one object", fileName_, json(name).dump()));
    return true;
  }

  /// Left to the parse that follows.
  bool parse_error(std::size_t, const std::string&, const json::exception&) override {
    return false;
  }

 private:
  bool enter() {
    if (names_.size() >= maximumJsonDepth)
      throw InputError(fmt::format("{}: arrays and objects are nested more than {} deep", fileName_,
                                   maximumJsonDepth));
    names_.emplace_back();
    return true;
  }

  bool leave() {
    names_.pop_back();
    return true;
  }

  const std::string& fileName_;
  std::vector<std::set<std::string>> names_;  // one for each array and object around
};

}  // namespace

json parseJson(std::string_view text, const std::string& fileName) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
  try {
    StructureGuard guard(fileName);
    json::sax_parse(text, &guard);
    return json::parse(text);
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
