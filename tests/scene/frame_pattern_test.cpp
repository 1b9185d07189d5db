#include "scene/frame_pattern.h"

#include <doctest/doctest.h>

#include "error_text.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("a pattern names frames as printf does") {
  for (const std::string text :
       {"frame_%04d.png", "out/%d/x.exr", "%01d", "a%09d.png", "%03d", "100%%_%02d%%.png"}) {
    const FramePattern pattern(text);
    for (const int frame : {0, 7, 42, 12345, -3}) {
      char expected[64];
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
      std::snprintf(expected, sizeof expected, text.c_str(), frame);
#pragma GCC diagnostic pop
      CHECK(pattern.path(frame) == expected);
    }
  }
  CHECK(FramePattern("frame_%04d.png").path(12) == "frame_0012.png");
}

TEST_CASE("a name without a percent sign is no pattern") {
  CHECK_FALSE(FramePattern::isPattern("frame.png"));
  CHECK(FramePattern::isPattern("frame_%04d.png"));
  CHECK(FramePattern::isPattern("50%.png"));
}

TEST_CASE("a pattern needs one number and no other percent sign") {
  const auto errorOf = [](const std::string& text) {
    return inputErrorOf([&] { FramePattern pattern(text); });
  };
  CHECK(errorOf("a_%s.png") ==
        "cannot use the name a_%s.png: '%s.p' is no number of a frame; write one %d or %04d, as in "
        "frame_%04d.png, and %% for a percent sign");
  for (const std::string text : {"%", "a%", "%4d", "%00d", "%0d", "%010d", "%0", "%02", "%+d", "%i",
                                 "%02x", "%ld", "%d%n", "%02 d", "% d"}) {
    CAPTURE(text);
    CHECK(contains(errorOf(text), "is no number of a frame"));
  }
  for (const std::string text : {"frame.png", "", "100%%.png", "%%d"})
    CHECK(contains(errorOf(text), "has no number of a frame"));
  for (const std::string text : {"%d%d", "a_%04d/%04d.png"})
    CHECK(contains(errorOf(text), "has two numbers of a frame"));
}
