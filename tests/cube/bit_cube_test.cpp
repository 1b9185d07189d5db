#include "cube/bit_cube.h"

#include <doctest/doctest.h>

using namespace haarlight;

TEST_CASE("a texel's bit is bit `column` of word face·32 + row") {
  BitCube cube;
  const int face = 3, row = 7, column = 30;
  cube.rows[face * faceSize + row] = 1u << column;
  int blocked = 0;
  for (int texel = 0; texel < texelCount; ++texel) blocked += cube.blocked(texel);
  CHECK(blocked == 1);
  CHECK(cube.blocked((face * faceSize + row) * faceSize + column));
}

TEST_CASE("merging bit cubes is a union") {
  BitCube a, b;
  a.rows[5] = 0b0011;
  b.rows[5] = 0b0110;
  b.rows[191] = 1u << 31;
  a |= b;
  CHECK(a.rows[5] == 0b0111);
  CHECK(a.rows[191] == 1u << 31);
  CHECK(a.rows[0] == 0);
}
