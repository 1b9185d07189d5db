#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/mesh_file_formats.h"
#include "mesh/text_lines.h"

namespace haarlight {

namespace {

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool isFloatType(std::string_view type) {
  return isOneOf(type, {"float", "float32", "double", "float64"});
}

bool isIntegerType(std::string_view type) {
  return isOneOf(type, {"char", "int8", "uchar", "uint8", "short", "int16", "ushort", "uint16",
                        "int", "int32", "uint", "uint32"});
}

/// OpenMesh knows few names for the type of a list's length; others of the same width do as well.
std::string_view knownLengthType(std::string_view type) {
  if (isOneOf(type, {"char", "int8", "uchar", "uint8"})) return "uchar";
  if (isOneOf(type, {"short", "int16", "ushort", "uint16"})) return "uint16";
  return "int";
}

/// Checks the header and writes it anew, so that OpenMesh meets only what it reads correctly:
/// properties that are not needed become nameless ones, which it skips by their size.
class PlyChecker {
 public:
  PlyChecker(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), lines_(bytes), fileSize_(bytes.size()) {}

  PreparedMeshFile run() {
    takeFormat();
    std::string_view line;
    while (true) {
      if (!lines_.next(line)) fail("the header has no end; the file is cut off or no PLY");
      std::string_view words = line;
      const std::string_view keyword = takeWord(words);
      if (keyword == "end_header") break;
      if (keyword == "element")
        takeElement(words);
      else if (keyword == "property")
        takeProperty(words);
      else if (!isOneOf(keyword, {"comment", "obj_info", ""}))
        failHere(quoted(line) + " is no line of a PLY header");
    }
    checkElements();
    result_.content.append("end_header\n").append(lines_.rest());
    result_.everyReadMustSucceed = true;
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const { meshFileError(path_, problem); }
  [[noreturn]] void failHere(const std::string& problem) const {
    meshFileError(path_, lines_.number(), problem);
  }

  void takeFormat() {
    std::string_view line;
    if (!lines_.next(line) || takeWord(line) != "ply") fail("it does not start with 'ply'");
    while (lines_.next(line)) {
      std::string_view words = line;
      const std::string_view keyword = takeWord(words), format = takeWord(words);
      if (isOneOf(keyword, {"comment", "obj_info", ""})) continue;
      if (keyword != "format" ||
          !isOneOf(format, {"ascii", "binary_little_endian", "binary_big_endian"}))
        failHere(quoted(line) + " should be the format");
      result_.binary = format != "ascii";
      result_.content = "ply\nformat " + std::string(format) + " 1.0\n";
      return;
    }
    fail("it has no format");
  }

  void takeElement(std::string_view words) {
    element_ = takeWord(words);
    std::size_t count = 0;
    if (!parseNumber(takeWord(words), count)) failHere("an element needs a name and a number");
    if (count > fileSize_)
      failHere(std::to_string(count) + " elements are more than the file can hold; it is cut off");
    if (element_ == "face") result_.faceCount = count;
    if (element_ == "face" && !coordinates_[2]) failHere("the faces come before the vertices");
    write("element " + std::string(element_) + " " + std::to_string(count));
  }

  void takeProperty(std::string_view words) {
    const std::string_view type = takeWord(words);
    if (element_.empty()) failHere("a property comes before the first element");
    if (type == "list") return takeList(words);
    if (!isFloatType(type) && !isIntegerType(type)) failHere(quoted(type) + " is no type");
    const std::string_view name = takeWord(words);
    const bool inFace = element_ == "face";
    if (inFace && !hasCorners_) failHere("a property of faces comes before 'vertex_indices'");
    const bool needed = element_ == "vertex" && isOneOf(name, {"x", "y", "z", "nx", "ny", "nz"});
    if (needed) takeVertexProperty(type, name);
    write("property " + std::string(type) + " " + (needed ? std::string(name) : "unused"));
  }

  void takeVertexProperty(std::string_view type, std::string_view name) {
    if (!isFloatType(type)) failHere(quoted(name) + " must be float or double");
    if (name.size() > 1) return;
    bool& known = coordinates_[std::size_t(name[0] - 'x')];
    if (known) failHere(quoted(name) + " is there twice");
    known = true;
  }

  void takeList(std::string_view words) {
    if (hasCorners_ && element_ != "face") return;  // what follows the faces is not read
    const std::string_view length = takeWord(words), type = takeWord(words), name = takeWord(words);
    if (element_ != "face" || !isOneOf(name, {"vertex_indices", "vertex_index"}) || hasCorners_)
      failHere("the list " + quoted(name) + " of " + quoted(element_) +
               " cannot be read; save the mesh without it or as OBJ");
    if (!isIntegerType(length) || !isIntegerType(type))
      failHere("'vertex_indices' must be of integer types");
    hasCorners_ = true;
    write("property list " + std::string(knownLengthType(length)) + " " + std::string(type) +
          " vertex_indices");
  }

  void checkElements() const {
    if (std::count(coordinates_.begin(), coordinates_.end(), true) != 3)
      fail("its vertices have no 'x', 'y' and 'z'");
    if (!hasCorners_) fail("it has no faces with 'vertex_indices'");
  }

  void write(const std::string& line) { result_.content.append(line).append("\n"); }

  const std::filesystem::path& path_;
  TextLines lines_;
  std::size_t fileSize_;
  PreparedMeshFile result_;
  std::string_view element_;
  std::array<bool, 3> coordinates_{};
  bool hasCorners_ = false;
};

}  // namespace

PreparedMeshFile preparePly(const std::filesystem::path& path, std::string_view bytes) {
  return PlyChecker(path, bytes).run();
}

}  // namespace haarlight
