#include <signal.h>

#include <cmath>
#include <glm/vec2.hpp>

#include "clip_test_support.h"

namespace haarlight::test {

namespace {

namespace fs = std::filesystem;

/// The error of a clip whose encoder is the script, by default of pictures that no pipe can hold.
std::string errorWith(const std::string& script, const std::string& name = "clip.mp4",
                      glm::ivec2 size = {300, 200}) {
  const FakeFfmpeg fake(script);
  const TemporaryFolder folder;
  const std::string error = inputErrorOf([&] { writeClip(folder / name, size.x, size.y); });
  CHECK(fs::is_empty(folder.path()));
  const std::string start = "cannot write " + (folder / name).string() + ": ";
  return error.starts_with(start) ? error.substr(start.size()) : "otherwise: " + error;
}

volatile sig_atomic_t signalReceived = 0;

}  // namespace

TEST_CASE("a clip without ffmpeg on PATH is refused in one line") {
  const TemporaryFolder folder;
  const PathGuard path(":/nowhere:" + folder.path().string());
  const std::string expected =
      "cannot write clip.mp4: a clip needs the program ffmpeg, which is not on PATH; install it "
      "(Debian: apt install ffmpeg) or write frames: -o frame_%04d.png";
  CHECK(inputErrorOf([] { ClipWriter::checkTarget("clip.mp4", 25); }) == expected);
  CHECK(inputErrorOf([] { ClipWriter("clip.mp4", 8, 8, 25); }) == expected);
  // Neither a folder nor a file that may not be executed is a program.
  fs::create_directory(folder / "ffmpeg");
  CHECK(inputErrorOf([] { ClipWriter::checkTarget("clip.mp4", 25); }) == expected);
  fs::remove(folder / "ffmpeg");
  writeFile(folder / "ffmpeg", "#!/bin/sh\n");
  CHECK(inputErrorOf([] { ClipWriter::checkTarget("clip.mp4", 25); }) == expected);
  fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
  CHECK(inputErrorOf([] { ClipWriter::checkTarget("clip.mp4", 25); }) == "");
}

TEST_CASE("what cannot become a clip is refused") {
  const FakeFfmpeg fake("exit 1");
  const TemporaryFolder folder;
  const auto errorOf = [&](const fs::path& path, double rate) {
    const auto check = inputErrorOf([&] { ClipWriter::checkTarget(path, rate); });
    CHECK(inputErrorOf([&] { ClipWriter(path, 8, 8, rate); }) == check);
    return check;
  };
  CHECK(ClipWriter::isClip("a/b.webm"));
  CHECK_FALSE(ClipWriter::isClip("a/b.png"));
  CHECK(contains(errorOf("clip.avi", 25), "must end in .mp4, .webm or .gif"));
  fs::create_directory(folder / "clip.mp4");
  CHECK(contains(errorOf(folder / "clip.mp4", 25), "it is no plain file"));
  CHECK(contains(errorOf("clip.mp4", 0), "takes from 0.01 to 1000 frames per second, not 0"));
  CHECK(contains(errorOf("clip.mp4", std::nan("")), "frames per second, not nan"));
  CHECK(contains(errorOf("clip.gif", 60), "takes from 0.01 to 50 frames per second, not 60"));
  CHECK(inputErrorOf([&] { ClipWriter(folder / "no/clip.mp4", 8, 8, 25); }) ==
        "cannot write " + (folder / "no/clip.mp4").string() + ": No such file or directory");
}

TEST_CASE("the words of an ffmpeg that fails are told") {
  CHECK(errorWith("echo 'Unknown encoder x'  >&2; exit 1") == "ffmpeg failed: Unknown encoder x");
  CHECK(errorWith("printf 'one\\n\\n  t\\033wo\\n' >&2; cat >/dev/null; exit 1") ==
        "ffmpeg failed: one; t\\x1bwo");
  CHECK(errorWith("exit 3") == "ffmpeg failed: it ended with exit status 3");
  CHECK(errorWith("kill -KILL $$") == "ffmpeg failed: it was ended by signal 9");
}

TEST_CASE("an ffmpeg that writes nothing has failed") {
  CHECK(errorWith("exit 0") == "ffmpeg failed: it ended with exit status 0");
  CHECK(errorWith("cat >/dev/null") == "ffmpeg failed: it ended with exit status 0");
}

TEST_CASE("a clip that does not fit is no clip") {
  if (!hasFfmpeg()) return;
  // Files get 512 bytes, and going further is an error and no signal, as on a full disk.
  const std::string script =
      "ulimit -f 1; trap '' XFSZ; exec " + findProgram("ffmpeg")->string() + " \"$@\"";
  for (const std::string name : {"clip.mp4", "clip.webm", "clip.gif"}) {
    const std::string error = errorWith(script, name, {64, 48});
    CAPTURE(error);
    CHECK(error.starts_with("ffmpeg failed: "));
    CHECK(contains(error, "File too large"));
  }
}

TEST_CASE("an ffmpeg that talks much is listened to, but only its last words are kept") {
  const std::string error = errorWith(
      "i=0; while [ $i -lt 20000 ]; do echo line $i; i=$((i + 1)); done >&2; cat >/dev/null;"
      "echo end >&2; exit 1");
  CHECK(error.starts_with("ffmpeg failed: "));
  CHECK(error.ends_with("; line 19998; line 19999; end"));
  CHECK(error.size() < 1400);  // 1 KiB of lines of 11 bytes, each separated by two bytes, not one
}

TEST_CASE("a clip that has failed stays so") {
  const FakeFfmpeg fake("echo broken >&2; exit 1");
  const TemporaryFolder folder;
  ClipWriter clip(folder / "clip.mp4", 300, 200, 25);
  const Image image = movingSquare(300, 200, 0);
  const std::string first = inputErrorOf([&] {
    for (int frame = 0; frame < frameCount; ++frame) clip.add(image);
  });
  CHECK(contains(first, "ffmpeg failed: broken"));
  CHECK(inputErrorOf([&] { clip.add(image); }) == first);
  CHECK(contains(inputErrorOf([&] { clip.finish(); }), "cannot write"));
}

TEST_CASE("pictures of a clip have its size, and there is one") {
  const FakeFfmpeg fake("cat >/dev/null");
  const TemporaryFolder folder;
  ClipWriter clip(folder / "clip.mp4", 8, 6, 25);
  CHECK_THROWS_AS(clip.add(Image(6, 8)), std::invalid_argument);
  CHECK(contains(inputErrorOf([&] { clip.finish(); }), "it has no pictures"));
}

TEST_CASE("a program that cannot be started is an input error") {
  const TemporaryFolder folder;
  CHECK(inputErrorOf([&] { ChildProcess(folder / "none", {}); }) ==
        "cannot start " + (folder / "none").string() + ": No such file or directory");
}

TEST_CASE("what the terminal sends to our process group does not reach a child, nor vice versa") {
  const auto before = signal(SIGURG, [](int) { signalReceived = 1; });
  signalReceived = 0;
  ChildProcess child("/bin/sh", {"-c", "kill -URG 0"});
  CHECK(child.finish().success);
  CHECK(signalReceived == 0);
  signal(SIGURG, before);
}

TEST_CASE("a broken pipe leaves the way SIGPIPE is dealt with as it was") {
  const auto before = signal(SIGPIPE, [](int) { signalReceived = 1; });
  signalReceived = 0;
  ChildProcess child("/bin/sh", {"-c", "exit 0"});
  CHECK_FALSE(child.write(std::vector<std::uint8_t>(1 << 20)));
  CHECK(child.finish().success);
  CHECK(signalReceived == 0);
  raise(SIGPIPE);
  CHECK(signalReceived == 1);
  signal(SIGPIPE, before);
}

}  // namespace haarlight::test
