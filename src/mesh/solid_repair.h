#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace haarlight {

struct SolidRepair {
  /// Without normals: a vertex on a seam, which has several, is one here.
  TriangleMesh mesh;
  std::size_t joinedVertices = 0;       ///< left out, since an earlier one has their position
  std::size_t unusedVertices = 0;       ///< positions that no triangle kept uses
  std::size_t degenerateTriangles = 0;  ///< left out: without area
  std::size_t duplicateTriangles = 0;   ///< left out: with the same vertices as an earlier one
  std::size_t wallTriangles = 0;        ///< left out: between touching solids
  std::size_t strayTriangles = 0;       ///< left out: debris that bounds nothing
  std::size_t turnedTriangles = 0;      ///< turned so that neighbours agree
  std::size_t turnedParts = 0;          ///< turned as a whole
  /// One line each on what was done to triangles.
  std::vector<std::string> warnings;
};

/// Makes a mesh fit for questions of inside and outside, and for fitting. Coordinates must be
/// finite.
///
/// - Vertices at the same position are joined; triangles without area and unused vertices go.
/// - Of triangles with the same three vertices the first stays, so a sheet made of two coincident
///   layers becomes one. Where all triangles of a patch were doubled and all its rims are those of
///   other surfaces that close without it, as between two boxes that share a face, it goes whole.
/// - Stray triangles go, those of open patches of at most 8 triangles. All patches smaller than a
///   thousandth of the other patches' area go when together they are smaller than that, too, so
///   that leaf cards stay. Larger ones go when together they have fewer than the 4 triangles of the
///   least solid, in a mesh of 200 times as many; but one of which every corner touches another
///   boundary may be a lid, and stays.
/// - The triangles of a patch are made to agree, and patches to face outwards; walls of cavities
///   face inwards (facePatches).
///
/// Triangles keep their order and start with their smallest vertex; vertices are numbered in the
/// order in which triangles use them, those of a triangle by x, y, z. So the result is the same to
/// the bit for a mesh and for the mesh with duplicates or stray triangles appended, turned inside
/// out, with some triangles turned, or with other numbers for its vertices.
SolidRepair prepareSolid(const TriangleMesh& mesh);

}  // namespace haarlight
