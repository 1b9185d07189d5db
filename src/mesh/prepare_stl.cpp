#include <cmath>
#include <cstdint>
#include <cstring>

#include "mesh/mesh_file_formats.h"
#include "mesh/text_lines.h"

namespace haarlight {

namespace {

constexpr std::size_t binaryHeaderSize = 84;
constexpr std::size_t binaryTriangleSize = 50;

std::size_t binarySize(std::string_view bytes) {
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, bytes.data() + 80, sizeof triangles);
  return binaryHeaderSize + triangles * binaryTriangleSize;
}

PreparedMeshFile prepareBinary(const std::filesystem::path& path, std::string_view bytes) {
  if (bytes.size() < binaryHeaderSize || bytes.size() < binarySize(bytes))
    meshFileError(path, "it is neither ASCII STL nor a complete binary STL (" +
                            std::to_string(bytes.size()) + " bytes are too few); it is cut off");
  PreparedMeshFile result;
  result.content = bytes;
  result.binary = true;
  result.everyReadMustSucceed = true;
  result.faceCount = (binarySize(bytes) - binaryHeaderSize) / binaryTriangleSize;
  for (std::size_t triangle = 0; triangle < result.faceCount; ++triangle) {
    float values[12];  // the normal, then three vertices
    std::memcpy(values, bytes.data() + binaryHeaderSize + triangle * binaryTriangleSize,
                sizeof values);
    for (int i = 3; i < 12; ++i)
      if (!std::isfinite(values[i]))
        meshFileError(path, "vertex " + std::to_string(i / 3 - 1) + " of triangle " +
                                std::to_string(triangle) + " (from 0) is not finite");
  }
  return result;
}

PreparedMeshFile prepareAscii(const std::filesystem::path& path, std::string_view bytes) {
  PreparedMeshFile result;
  std::string_view line;
  TextLines lines(bytes);
  int verticesInLoop = 0;
  bool ended = false;
  while (lines.next(line)) {
    std::string_view words = line;
    const std::string_view keyword = takeWord(words);
    glm::vec3 position;
    if (keyword == "vertex" || keyword == "VERTEX") {
      if (!takeVector(words, position))
        meshFileError(path, lines.number(), quoted(line) + " needs three finite coordinates");
      result.content.append(verticesInLoop++ == 0 ? "outer loop\n" : "").append(line).append("\n");
    } else if (keyword == "endloop" || keyword == "ENDLOOP") {
      if (verticesInLoop != 3)
        meshFileError(
            path, lines.number(),
            "a facet ends with " + std::to_string(verticesInLoop) + " vertices and needs 3");
      verticesInLoop = 0;
      ++result.faceCount;
    }
    ended = keyword == "endsolid" || keyword == "ENDSOLID" || (ended && keyword.empty());
  }
  if (!ended) meshFileError(path, "there is no 'endsolid' at its end; it is cut off or no STL");
  return result;
}

bool startsAsAscii(std::string_view bytes) {
  const std::string_view word = takeWord(bytes);
  return word.starts_with("solid") || word.starts_with("SOLID");
}

}  // namespace

/// The header of a binary file may start with "solid", too; then its size tells.
PreparedMeshFile prepareStl(const std::filesystem::path& path, std::string_view bytes) {
  const bool exactBinary = bytes.size() >= binaryHeaderSize && bytes.size() == binarySize(bytes);
  return startsAsAscii(bytes) && !exactBinary ? prepareAscii(path, bytes)
                                              : prepareBinary(path, bytes);
}

}  // namespace haarlight
