#include <cstdint>

#include "mesh/mesh_file_formats.h"
#include "mesh/text_lines.h"

namespace haarlight {

namespace {

class OffChecker {
 public:
  OffChecker(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), lines_(bytes) {}

  PreparedMeshFile run() {
    takeHeader();
    result_.everyReadMustSucceed = true;
    result_.faceCount = faceCount_;
    result_.content =
        "OFF\n" + std::to_string(vertexCount_) + " " + std::to_string(faceCount_) + " 0\n";
    for (std::size_t i = 0; i < vertexCount_; ++i) takeVertex(i);
    for (std::size_t i = 0; i < faceCount_; ++i) takeFace(i);
    return std::move(result_);
  }

 private:
  /// The next line with something on it; comments start with #.
  std::string_view nextLine(const std::string& expected) {
    std::string_view line;
    while (lines_.next(line)) {
      line = line.substr(0, line.find('#'));
      std::string_view words = line;
      if (!takeWord(words).empty()) return line;
    }
    meshFileError(path_, "it ends where " + expected + " is expected; the file is cut off");
  }

  void takeHeader() {
    std::string_view line = nextLine("the word OFF");
    const std::string_view keyword = takeWord(line);
    std::string_view kind = keyword;
    if (kind.starts_with("ST")) kind.remove_prefix(2);
    if (kind.starts_with("C")) kind.remove_prefix(1);
    hasNormals_ = kind.starts_with("N");
    if (hasNormals_) kind.remove_prefix(1);
    if (kind != "OFF")
      meshFileError(path_, lines_.number(),
                    quoted(keyword) + " is no kind of OFF file that can be read");
    std::string_view rest = line;
    if (const auto word = takeWord(rest); word == "BINARY")
      meshFileError(path_, "binary OFF cannot be read; save it as ASCII OFF or PLY");
    else if (word.empty())
      line = nextLine("the numbers of vertices and faces");
    takeCounts(line);
  }

  void takeCounts(std::string_view line) {
    const std::string_view whole = line;
    const std::size_t remaining = lines_.rest().size();
    if (!parseNumber(takeWord(line), vertexCount_) || !parseNumber(takeWord(line), faceCount_))
      meshFileError(path_, lines_.number(),
                    quoted(whole) + " needs the numbers of vertices and faces");
    if (vertexCount_ > remaining || faceCount_ > remaining)
      meshFileError(path_, lines_.number(),
                    quoted(whole) + " promises more than the file can hold; it is cut off");
  }

  void takeVertex(std::size_t index) {
    std::string_view line = nextLine("vertex " + std::to_string(index));
    const std::string_view whole = line;
    glm::vec3 vector;
    const bool valid = takeVector(line, vector);
    if (!valid)
      meshFileError(path_, lines_.number(),
                    "vertex " + std::to_string(index) + ", " + quoted(whole) +
                        ", needs three finite numbers");
    result_.content.append(whole.substr(0, whole.size() - line.size())).append("\n");
    if (!hasNormals_) return;
    result_.vertexNormals.push_back(takeVector(line, vector) ? vector : glm::vec3(0));
  }

  void takeFace(std::size_t index) {
    std::string_view line = nextLine("face " + std::to_string(index));
    const std::string_view whole = line;
    std::size_t corners = 0, corner = 0;
    bool valid = parseNumber(takeWord(line), corners) && corners > 0;
    for (std::size_t i = 0; valid && i < corners; ++i)
      valid = parseNumber(takeWord(line), corner) && corner < vertexCount_;
    if (!valid)
      meshFileError(path_, lines_.number(),
                    "face " + std::to_string(index) + ", " + quoted(whole) +
                        ", needs a number of corners and as many vertices from 0 to " +
                        std::to_string(std::int64_t(vertexCount_) - 1));
    result_.content.append(whole.substr(0, whole.size() - line.size())).append("\n");
  }

  const std::filesystem::path& path_;
  TextLines lines_;
  PreparedMeshFile result_;
  bool hasNormals_ = false;
  std::size_t vertexCount_ = 0;
  std::size_t faceCount_ = 0;
};

}  // namespace

PreparedMeshFile prepareOff(const std::filesystem::path& path, std::string_view bytes) {
  return OffChecker(path, bytes).run();
}

}  // namespace haarlight
