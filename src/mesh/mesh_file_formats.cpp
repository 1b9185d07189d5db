#include "mesh/mesh_file_formats.h"

#include "base/error.h"

namespace haarlight {

void meshFileError(const std::filesystem::path& path, const std::string& problem) {
  throw InputError("cannot read mesh " + path.string() + ": " + problem);
}

void meshFileError(const std::filesystem::path& path, std::size_t line,
                   const std::string& problem) {
  meshFileError(path, "line " + std::to_string(line) + ": " + problem);
}

std::string quoted(std::string_view words) {
  constexpr std::size_t longest = 40;
  std::string text;
  for (const char c : words.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return "'" + text + (words.size() > longest ? "…'" : "'");
}

}  // namespace haarlight
