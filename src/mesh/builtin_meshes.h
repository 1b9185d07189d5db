#pragma once

#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace haarlight {

/// A tube along the torus knot (p, q), p and q coprime: a curve that goes p times round the y axis
/// and q times round the tube of a torus with radii 2 and 1, lying flat and scaled so that all of
/// it fits exactly into the unit ball around the origin. Closed, with smooth normals;
/// 2 · lengthSegments · tubeSegments triangles. `tubeRadius` is relative to the torus; for the
/// trefoil (2, 3) the tube does not touch itself up to 0.8.
struct TorusKnot {
  int p = 2;
  int q = 3;
  int lengthSegments = 256;
  int tubeSegments = 24;
  double tubeRadius = 0.5;
};
TriangleMesh torusKnot(const TorusKnot& shape = {});

/// The unit sphere around the origin: an icosahedron with each triangle split into four
/// `subdivisions` times; 20 · 4^subdivisions triangles.
TriangleMesh icosphere(int subdivisions);

/// The square from (-halfExtent, 0, -halfExtent) to (halfExtent, 0, halfExtent) that faces +y, as
/// a grid of cells × cells squares of two triangles.
TriangleMesh groundGrid(float halfExtent, int cells);

/// Names that builtinMesh knows.
std::vector<std::string> builtinMeshNames();

/// "builtin:torusknot" or "builtin:sphere". Throws InputError for other names.
TriangleMesh builtinMesh(const std::string& name);

}  // namespace haarlight
