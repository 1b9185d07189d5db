#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace haarlight {

/// A mesh file brought into a form that OpenMesh's reader of its format reads without loss.
///
/// OpenMesh leaves out lines it cannot read, so that the indices after them point to wrong
/// vertices; it takes missing numbers for zeros, and loops on a header without an end. The
/// functions below find such faults first and say where they are; what needs no reading (comments,
/// materials, texture coordinates, colours) is left out.
struct PreparedMeshFile {
  std::string content;
  bool binary = false;
  /// Whether a read beyond the end or of no number must count as an error. The readers of OBJ and
  /// ASCII STL run into the end of the file as a matter of course.
  bool everyReadMustSucceed = false;
  /// Number of faces that the file states.
  std::size_t faceCount = 0;
  /// Normals that OpenMesh's reader would pass over: one per vertex, or none.
  std::vector<glm::vec3> vertexNormals;
};

/// Each throws InputError when the file is damaged or is of a kind that OpenMesh cannot read.
PreparedMeshFile prepareObj(const std::filesystem::path& path, std::string_view bytes);
PreparedMeshFile preparePly(const std::filesystem::path& path, std::string_view bytes);
PreparedMeshFile prepareOff(const std::filesystem::path& path, std::string_view bytes);
PreparedMeshFile prepareStl(const std::filesystem::path& path, std::string_view bytes);

/// Throws InputError("cannot read mesh <path>: <problem>").
[[noreturn]] void meshFileError(const std::filesystem::path& path, const std::string& problem);
[[noreturn]] void meshFileError(const std::filesystem::path& path, std::size_t line,
                                const std::string& problem);

/// A few words of the file for a message: printable, and not long.
std::string quoted(std::string_view words);

}  // namespace haarlight
