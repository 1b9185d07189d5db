#include "verify/places.h"

#include <array>

#include "haar/basis.h"
#include "haar/occlusion_transform.h"
#include "visibility/sphere_bin.h"

namespace haarlight::verify {

namespace {

std::string faceName(int face) {
  constexpr std::array names{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  return std::string("face ") + names.at(std::size_t(face));
}

std::string rowAndColumn(int square, int side) {
  return "row " + std::to_string(square / side) + ", column " + std::to_string(square % side);
}

std::string sphereName(std::size_t sphere) {
  return "sphere " + std::to_string(sphere) + ": ";
}

Place squarePlace(int face, int level, int square) {
  return faceName(face) + ", level " + std::to_string(level) + ", " +
         rowAndColumn(square, squaresPerSide(level));
}

}  // namespace

Place bitPlace(int word, int column) {
  return faceName(word / faceSize) + ", row " + std::to_string(word % faceSize) + ", column " +
         std::to_string(column);
}

Place coefficientPlace(int index) {
  constexpr std::array types{"horizontal", "vertical", "diagonal"};
  const int face = index / coarseCoefficientsPerFace, own = index % coarseCoefficientsPerFace;
  if (own == 0) return faceName(face) + ", scaling coefficient";
  const Wavelet wavelet = waveletAt(own);
  return squarePlace(face, wavelet.level, wavelet.square) + ", " +
         types.at(std::size_t(wavelet.type)) + " coefficient";
}

Place meanPlace(int index) {
  const int face = index / coarseMeansPerFace, own = index % coarseMeansPerFace;
  int level = 0;
  while (firstMean(level + 1) <= own) ++level;
  return squarePlace(face, level, own - firstMean(level)) + ", mean";
}

Place blockPlace(int index) {
  const int block = index % blocksPerFace;
  return faceName(index / blocksPerFace) + ", block row " + std::to_string(block / blocksPerSide) +
         ", block column " + std::to_string(block % blocksPerSide);
}

Place movedSpherePlace(std::size_t sphere, int number) {
  constexpr std::array names{"centre x", "centre y", "centre z", "radius"};
  return sphereName(sphere) + names.at(std::size_t(number));
}

Place entryPlace(std::size_t sphere, std::uint32_t entry) {
  const int texel = int(entry) / radiusBins;
  return sphereName(sphere) + faceName(texel / texelsPerFace) + ", " +
         rowAndColumn(texel % texelsPerFace, faceSize) + ", radius bin " +
         std::to_string(int(entry) % radiusBins);
}

Place channelPlace(int channel) {
  constexpr std::array names{"red", "green", "blue", "alpha"};
  return names.at(std::size_t(channel));
}

}  // namespace haarlight::verify
