#include "engine/tuned_shapes.h"

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "base/file.h"
#include "base/text_format.h"

namespace haarlight {

namespace fs = std::filesystem;

namespace {

// A first line of kind and version, a line of five fields for each device, a last line.
const std::string kind = "haarlight work shapes ", lastLine = "end";
constexpr int version = 1;
constexpr std::uint64_t mostBytes = 1 << 20;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// A positive number without sign, blanks or leading zeros; nothing when it is none.
std::optional<int> numberOf(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 1 || std::to_string(number) != text) return std::nullopt;
  return number;
}

[[noreturn]] void damaged() {
  throw InputError("it is damaged");
}

void checkFirstLine(const std::string& line) {
  if (!line.starts_with(kind)) throw InputError("it is no list of tuned work shapes");
  const auto number = numberOf(line.substr(kind.size()));
  if (!number) damaged();
  if (*number > version) throw InputError("a newer haarlight has written it");
}

}  // namespace

fs::path tunedShapesFile(const fs::path& folder) {
  return folder / "work-shapes.txt";
}

std::vector<TunedShapes::Entry> TunedShapes::parse(const std::string& text) {
  const auto lines = split(text, '\n');
  checkFirstLine(lines.front());
  if (lines.size() < 3 || lines[lines.size() - 2] != lastLine || !lines.back().empty()) damaged();
  std::vector<Entry> entries;
  for (std::size_t i = 1; i + 2 < lines.size(); ++i) {
    const auto fields = split(lines[i], '\t');
    if (fields.size() != 5) damaged();
    const auto lanes = numberOf(fields[3]), samples = numberOf(fields[4]);
    if (!lanes || !samples || !shapeProblem(fields[0], {*lanes, *samples}).empty()) damaged();
    entries.push_back({fields[0], fields[1], fields[2], {*lanes, *samples}});
  }
  return entries;
}

TunedShapes TunedShapes::read(const fs::path& folder,
                              const std::function<void(const std::string&)>& onWarning) {
  TunedShapes shapes;
  const fs::path file = tunedShapesFile(folder);
  std::error_code error;
  if (folder.empty() || !fs::exists(file, error)) return shapes;
  try {
    const auto bytes = readWholeFile(file, "tuned work shapes", mostBytes);
    shapes.entries_ = parse({bytes.begin(), bytes.end()});
  } catch (const InputError& problem) {
    if (onWarning)
      onWarning(file.string() + " is ignored: " + problem.what() +
                "; `haarlight devices --tune` writes it anew");
  }
  return shapes;
}

void TunedShapes::write(const fs::path& folder) const {
  std::string text = kind + std::to_string(version) + "\n";
  for (const Entry& entry : entries_)
    text += entry.engine + '\t' + entry.device + '\t' + entry.driver + '\t' +
            std::to_string(entry.shape.lanesPerItem) + '\t' +
            std::to_string(entry.shape.samplesPerGroup) + '\n';
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError("cannot make the folder " + folder.string() + ": " + error.message());
  writeFileAtomically(tunedShapesFile(folder), text + lastLine + "\n");
}

/// Names are kept without tabs and line ends.
bool TunedShapes::isOf(const Entry& entry, const DeviceDescription& device) {
  return entry.engine == device.engine && entry.device == visible(device.name) &&
         entry.driver == visible(device.driver);
}

std::optional<KernelShape> TunedShapes::find(const DeviceDescription& device) const {
  const auto found =
      std::ranges::find_if(entries_, [&](const Entry& entry) { return isOf(entry, device); });
  return found == entries_.end() ? std::nullopt : std::optional(found->shape);
}

void TunedShapes::keep(const DeviceDescription& device, std::optional<KernelShape> shape) {
  std::erase_if(entries_, [&](const Entry& entry) { return isOf(entry, device); });
  if (shape)
    entries_.push_back({device.engine, visible(device.name), visible(device.driver), *shape});
}

}  // namespace haarlight
