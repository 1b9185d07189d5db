#include "scene/playback.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace haarlight;

TEST_CASE("a motion holds its start and its end") {
  const Playback playback{1, 2, Repeat::hold};
  CHECK(motionSeconds(playback, 3, 0) == 0);
  CHECK(motionSeconds(playback, 3, 1.5) == 1);
  CHECK(motionSeconds(playback, 3, 2.5) == 3);
  CHECK(motionSeconds(playback, 3, 100) == 3);
}

TEST_CASE("a motion repeats from its start, or turns round at its ends") {
  CHECK(motionSeconds({0, 1, Repeat::loop}, 4, 4) == 0);
  CHECK(motionSeconds({0, 1, Repeat::loop}, 4, 9) == 1);
  CHECK(motionSeconds({0, 1, Repeat::pingpong}, 4, 4) == 4);
  CHECK(motionSeconds({0, 1, Repeat::pingpong}, 4, 5) == 3);
  CHECK(motionSeconds({0, 1, Repeat::pingpong}, 4, 9) == 1);
}

TEST_CASE("a motion without duration stands still") {
  for (const Repeat repeat : {Repeat::hold, Repeat::loop, Repeat::pingpong})
    CHECK(motionSeconds({0, 1, repeat}, 0, 7) == 0);
}
