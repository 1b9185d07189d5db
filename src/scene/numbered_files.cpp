#include "scene/numbered_files.h"

#include <algorithm>

#include "base/error.h"

namespace haarlight {

namespace fs = std::filesystem;

NumberedFiles::NumberedFiles(const fs::path& pattern)
    : folder_(pattern.parent_path()), name_(pattern.filename().string()) {}

fs::path NumberedFiles::path(int number) const {
  return folder_ / name_.path(number);
}

std::optional<int> NumberedFiles::numberOf(const std::string& name) const {
  constexpr std::size_t mostDigits = 9;
  for (std::size_t begin = 0; begin < name.size(); ++begin) {
    int number = 0;
    for (std::size_t i = begin; i < std::min(name.size(), begin + mostDigits); ++i) {
      if (name[i] < '0' || name[i] > '9') break;
      number = 10 * number + (name[i] - '0');
      if (name_.path(number) == name) return number;
    }
  }
  return std::nullopt;
}

std::vector<int> NumberedFiles::numbersInFolder() const {
  std::vector<int> numbers;
  std::error_code error;
  for (fs::directory_iterator entry(folder_.empty() ? "." : folder_, error), end;
       !error && entry != end; entry.increment(error))
    if (const auto number = numberOf(entry->path().filename().string())) numbers.push_back(*number);
  if (error)
    throw InputError("cannot read frames in folder " + folder_.string() + ": " + error.message());
  std::ranges::sort(numbers);
  return numbers;
}

std::vector<fs::path> NumberedFiles::list() const {
  const std::vector<int> numbers = numbersInFolder();
  if (numbers.empty())
    throw InputError("cannot read frames: there is no file such as " + path(1).string());
  std::vector<fs::path> files;
  for (const int number : numbers) {
    const int expected = numbers.front() + int(files.size());
    if (number != expected) throw InputError("missing frame: " + path(expected).string());
    files.push_back(path(number));
  }
  return files;
}

}  // namespace haarlight
