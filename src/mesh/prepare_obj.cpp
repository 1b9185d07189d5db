#include <algorithm>
#include <cstdint>

#include "mesh/mesh_file_formats.h"
#include "mesh/text_lines.h"

namespace haarlight {

namespace {

/// The list that a face refers to by numbers: from 1, or from -1 backwards from the current end.
struct ReferredList {
  std::string_view name;
  std::int64_t count = 0;
  std::int64_t largestReference = 0;
  std::size_t lineOfLargest = 0;
};

class ObjChecker {
 public:
  ObjChecker(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), lines_(bytes) {
    result_.content.reserve(bytes.size());
  }

  PreparedMeshFile run() {
    std::string_view line;
    while (lines_.next(line)) takeLine(line);
    checkReferences(vertices_);
    checkReferences(normals_);
    return std::move(result_);
  }

 private:
  void takeLine(std::string_view line) {
    std::string_view values = line;
    const std::string_view keyword = takeWord(values);
    if (keyword == "v")
      takeVertex(line, values);
    else if (keyword == "vn")
      takeNormal(line, values);
    else if (keyword == "f")
      takeFace(line, values);
  }

  void keep(std::string_view line) { result_.content.append(line).append("\n"); }

  void takeVertex(std::string_view line, std::string_view values) {
    glm::vec3 position;
    if (!takeVector(values, position))
      meshFileError(path_, lines_.number(),
                    "vertex " + std::to_string(vertices_.count + 1) + ", " + quoted(line) +
                        ", needs three finite coordinates; correct or export it again");
    keep(line);
    ++vertices_.count;
  }

  /// A normal that is none is kept as zero, which stands for a missing one.
  void takeNormal(std::string_view line, std::string_view values) {
    glm::vec3 normal;
    keep(takeVector(values, normal) ? line : "vn 0 0 0");
    ++normals_.count;
  }

  void takeFace(std::string_view line, std::string_view values) {
    int corners = 0;
    for (auto word = takeWord(values); !word.empty(); word = takeWord(values), ++corners) {
      if (word.starts_with('#')) break;
      takeCorner(word);
    }
    if (corners < 3)
      meshFileError(path_, lines_.number(),
                    "the face " + quoted(line) +
                        " has fewer than three corners; the file is damaged or cut off");
    keep(line.substr(0, line.find('#')));
    ++result_.faceCount;
  }

  /// A corner is vertex, vertex/texture, vertex//normal or vertex/texture/normal.
  void takeCorner(std::string_view word) {
    const std::string_view whole = word;
    for (int part = 0; part < 3; ++part) {
      const std::string_view number = word.substr(0, word.find('/'));
      std::int32_t reference = 0;
      const bool valid = parseNumber(number, reference) || (part > 0 && number.empty());
      if (!valid || (part == 2 && number.size() < word.size()))
        meshFileError(path_, lines_.number(), quoted(whole) + " is no corner of a face");
      if (part == 0) refer(vertices_, reference);
      if (part == 2 && !number.empty()) refer(normals_, reference);
      if (number.size() == word.size()) return;
      word.remove_prefix(number.size() + 1);
    }
  }

  void refer(ReferredList& list, std::int64_t reference) {
    if (reference == 0 || reference < -list.count) referenceError(list, reference, lines_.number());
    if (reference > list.largestReference) {
      list.largestReference = reference;
      list.lineOfLargest = lines_.number();
    }
  }

  void checkReferences(const ReferredList& list) const {
    if (list.largestReference > list.count)
      referenceError(list, list.largestReference, list.lineOfLargest);
  }

  [[noreturn]] void referenceError(const ReferredList& list, std::int64_t reference,
                                   std::size_t line) const {
    meshFileError(path_, line,
                  "a face refers to " + std::string(list.name) + " " + std::to_string(reference) +
                      ", but there are " + std::to_string(list.count) +
                      " (counted from 1); the file is damaged or cut off");
  }

  const std::filesystem::path& path_;
  TextLines lines_;
  PreparedMeshFile result_;
  ReferredList vertices_{.name = "vertex"};
  ReferredList normals_{.name = "normal"};
};

}  // namespace

PreparedMeshFile prepareObj(const std::filesystem::path& path, std::string_view bytes) {
  return ObjChecker(path, bytes).run();
}

}  // namespace haarlight
