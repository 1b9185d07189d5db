#include "benchmark/tuning.h"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace haarlight;
using namespace haarlight::benchmark;

namespace {

const std::vector<KernelShape> shapes{{1, 1}, {1, 4}, {32, 1}, {32, 2}};

const auto never = [] { return false; };

/// Times by lanes and samples: product 6, 4, 4, and a failure.
ShapeSeconds fakeTime(const KernelShape& shape) {
  if (shape == KernelShape{1, 1}) return {3, 2};
  if (shape == KernelShape{1, 4}) return {1, 4};
  if (shape == KernelShape{32, 1}) return {2, 2};
  throw std::runtime_error("fails the self test");
}

}  // namespace

TEST_CASE("every shape is measured, and the fastest by both times is chosen") {
  const auto timings = timeShapes(shapes, fakeTime, never);
  REQUIRE(timings.size() == 4);
  for (std::size_t i = 0; i < shapes.size(); ++i) CHECK(timings[i].shape == shapes[i]);
  CHECK(timings[1].seconds.exact == 1);
  CHECK(timings[1].seconds.table == 4);
  CHECK(chosenShape(timings, {1, 1}) == &timings[1]);
  CHECK(chosenShape(std::span(timings).last(2), {1, 1}) == &timings[2]);
}

TEST_CASE("shapes that fail are passed over, however fast") {
  const auto timings = timeShapes(shapes, fakeTime, never);
  CHECK(timings[3].failure == "fails the self test");
  CHECK(timings[2].failure.empty());
  CHECK(chosenShape(timings, {32, 2}) == &timings[1]);
  CHECK(chosenShape(std::span(timings).last(1), {32, 2}) == nullptr);
  CHECK(chosenShape({}, {1, 1}) == nullptr);
}

TEST_CASE("the standard shape stays unless another saves a twentieth") {
  const auto chosenAgainst = [](double exact, double table) {
    const std::vector<ShapeTiming> timings{{{1, 1}, {exact, table}, {}}, {{1, 4}, {10, 10}, {}}};
    return chosenShape(timings, {1, 4})->shape;
  };
  CHECK(chosenAgainst(9.4, 9.4) == KernelShape{1, 1});
  CHECK(chosenAgainst(9.6, 9.6) == KernelShape{1, 4});
  CHECK(chosenAgainst(8, 11.25) == KernelShape{1, 1});  // √90 < 9.5
  CHECK(chosenAgainst(8, 11.5) == KernelShape{1, 4});   // √92 > 9.5
  CHECK(chosenAgainst(11, 11) == KernelShape{1, 4});
}

TEST_CASE("an interruption leaves the shapes that were finished before") {
  int measured = 0;
  const auto interrupted = [&] { return measured == 2; };
  const auto time = [&](const KernelShape& shape) {
    ++measured;
    return fakeTime(shape);
  };
  const auto timings = timeShapes(shapes, time, interrupted);
  CHECK(measured == 2);
  REQUIRE(timings.size() == 1);
  CHECK(timings[0].shape == shapes[0]);
}
