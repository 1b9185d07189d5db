#include "scene/field_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace haarlight {

namespace {

/// Levenshtein distance: insertions, deletions and replacements that turn one word into the other.
std::size_t editDistance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> distances(to.size() + 1);
  std::iota(distances.begin(), distances.end(), 0);
  for (std::size_t row = 1; row <= from.size(); ++row) {
    std::size_t diagonal = std::exchange(distances[0], row);
    for (std::size_t column = 1; column <= to.size(); ++column) {
      const std::size_t replaced = diagonal + (from[row - 1] != to[column - 1]);
      const std::size_t added = std::min(distances[column], distances[column - 1]) + 1;
      diagonal = std::exchange(distances[column], std::min(replaced, added));
    }
  }
  return distances[to.size()];
}

std::string suggestion(std::string_view name, const std::vector<std::string_view>& knownNames) {
  constexpr std::size_t longestName = 64;
  const auto distance = [&](std::string_view known) {
    return editDistance(name.substr(0, longestName), known);
  };
  const auto nearest = std::min_element(knownNames.begin(), knownNames.end(),
                                        [&](std::string_view left, std::string_view right) {
                                          return distance(left) < distance(right);
                                        });
  if (distance(*nearest) <= std::max<std::size_t>(2, nearest->size() / 3))
    return fmt::format("did you mean '{}'?", *nearest);
  return "known are " + joinNames(knownNames);
}

/// Quoted for a message of one line.
std::string quoted(const std::string& name) {
  const std::string ascii = nlohmann::json(name.substr(0, 60))
                                .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return fmt::format("'{}'", ascii.substr(1, ascii.size() - 2));
}

}  // namespace

std::optional<JsonValue> FieldReader::find(const char* name) {
  knownNames_.push_back(name);
  if (!object_.json().contains(name)) return {};
  return object_.member(name);
}

void FieldReader::flag(const char* name, bool& value) {
  if (const auto field = find(name)) value = field->flag();
}

void FieldReader::integer(const char* name, int& value, const Range& range) {
  if (const auto field = find(name)) value = field->integer(range);
}

void FieldReader::integer(const char* name, std::optional<int>& value, const Range& range) {
  if (const auto field = find(name)) value = field->integer(range);
}

void FieldReader::number(const char* name, double& value, const Range& range) {
  if (const auto field = find(name)) value = field->number(range);
}

void FieldReader::number(const char* name, std::optional<double>& value, const Range& range) {
  if (const auto field = find(name)) value = field->number(range);
}

void FieldReader::text(const char* name, std::string& value) {
  if (const auto field = find(name)) value = field->text();
}

void FieldReader::text(const char* name, std::optional<std::string>& value) {
  if (const auto field = find(name)) value = field->text();
}

void FieldReader::path(const char* name, std::optional<std::filesystem::path>& value) {
  if (const auto field = find(name)) value = field->path();
}

void FieldReader::resource(const char* name, std::string& value,
                           const std::vector<std::string>& builtins) {
  if (const auto field = find(name)) value = field->resource(builtins);
}

void FieldReader::resource(const char* name, std::optional<std::string>& value,
                           const std::vector<std::string>& builtins) {
  if (const auto field = find(name)) value = field->resource(builtins);
}

void FieldReader::word(const char* name, std::string& value,
                       std::span<const std::string_view> words) {
  if (const auto field = find(name)) value = field->word(words);
}

void FieldReader::numberOrVector(const char* name, glm::dvec3& value, const Range& range) {
  if (const auto field = find(name))
    value = field->isNumber() ? glm::dvec3(field->number(range)) : field->vector<glm::dvec3>(range);
}

void FieldReader::countOrFile(const char* name, std::variant<int, std::filesystem::path>& value,
                              const Range& range) {
  const auto field = find(name);
  if (!field) return;
  if (field->isText())
    value = field->path();
  else if (field->isNumber())
    value = field->integer(range);
  else
    field->failWithValue("must be a number or the path of a file");
}

void FieldReader::numberOrWord(const char* name, std::optional<double>& value, const char* word,
                               const Range& range) {
  const auto field = find(name);
  if (!field) return;
  if (field->json() == word)
    value.reset();
  else if (field->isNumber())
    value = field->number(range);
  else
    field->failWithValue(fmt::format("must be a number or \"{}\"", word));
}

void FieldReader::vectorOrWord(const char* name, std::optional<glm::dvec3>& value, const char* word,
                               const Range& range) {
  const auto field = find(name);
  if (!field) return;
  if (field->json() == word)
    value.reset();
  else if (field->json().is_array())
    value = field->vector<glm::dvec3>(range);
  else
    field->failWithValue(fmt::format("must be an array of 3 numbers or \"{}\"", word));
}

void FieldReader::requireIncreasingSeconds(const JsonValue& keys) {
  if (keys.json().empty()) keys.fail("must not be empty");
  for (std::size_t i = 1; i < keys.json().size(); ++i) {
    const double before = keys.json()[i - 1]["seconds"];
    const JsonValue key = keys.element(i), seconds = key.member("seconds");
    if (!(seconds.json().get<double>() > before))
      seconds.failWithValue(fmt::format("must be > {}, those of the key before", before));
  }
}

void FieldReader::require(const char* name) const {
  if (!object_.json().contains(name)) object_.fail(fmt::format("field '{}' is missing", name));
}

void FieldReader::ignoredText(const char* name) {
  if (const auto field = find(name)) field->text();
}

void FieldReader::requireOneKnown() const {
  refuseUnknown();
  if (object_.json().size() != 1) object_.fail("give exactly one of " + joinNames(knownNames_));
}

void FieldReader::refuseUnknown() const {
  for (const auto& [name, value] : object_.json().items())
    if (std::find(knownNames_.begin(), knownNames_.end(), name) == knownNames_.end())
      object_.fail(
          fmt::format("unknown field {}; {}", quoted(name), suggestion(name, knownNames_)));
}

}  // namespace haarlight
