#include "image/clip_writer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "base/file_descriptor.h"
#include "base/parallel.h"
#include "base/text_format.h"
#include "image/tonemap.h"

namespace haarlight {

namespace {

namespace fs = std::filesystem;

struct ClipFormat {
  std::string_view extension;
  bool evenSize;
  double maximumRate;
  std::string_view encoding;  ///< ffmpeg's options for filter, encoder and container
};

constexpr ClipFormat clipFormats[]{
    {".mp4", true, 1000, "-c:v libx264 -preset medium -crf 18 -movflags +faststart -f mp4"},
    {".webm", true, 1000,
     "-c:v libvpx-vp9 -crf 24 -b:v 0 -deadline good -cpu-used 2 -row-mt 1 -f webm"},
    {".gif", false, 50,
     "-vf split[a][b];[a]palettegen[p];[b][p]paletteuse=diff_mode=rectangle -loop 0 -f gif"}};

/// For formats of even size; without out_color_matrix ffmpeg takes Rec. 601's, whatever the size.
constexpr std::string_view yuv420p =
    "-vf scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int,"
    "format=yuv420p -colorspace bt709 -color_range tv -color_primaries bt709 "
    "-color_trc iec61966-2-1";

[[noreturn]] void cannotWrite(const fs::path& target, const std::string& reason) {
  throw InputError("cannot write " + target.string() + ": " + reason);
}

/// Null when the name ends like no clip's.
const ClipFormat* findFormat(const fs::path& target) {
  const auto found =
      std::ranges::find(clipFormats, target.extension().string(), &ClipFormat::extension);
  return found == std::end(clipFormats) ? nullptr : found;
}

const ClipFormat& formatOf(const fs::path& target) {
  if (const ClipFormat* format = findFormat(target)) return *format;
  cannotWrite(target, "the name of a clip must end in .mp4, .webm or .gif");
}

fs::path findFfmpeg(const fs::path& target) {
  if (const auto program = findProgram("ffmpeg")) return *program;
  cannotWrite(target,
              "a clip needs the program ffmpeg, which is not on PATH; install it (Debian: "
              "apt install ffmpeg) or write frames: -o frame_%04d.png");
}

std::vector<std::string> ffmpegArguments(const ClipFormat& format, const fs::path& file, int width,
                                         int height, double framesPerSecond) {
  // Without -xerror ffmpeg 5.1 reports success when the end of the file could not be written.
  std::istringstream options(fmt::format(
      "-hide_banner -nostdin -loglevel error -xerror -y -f rawvideo -pixel_format rgb24 "
      "-video_size {}x{} -framerate {} -i pipe:0 {} {}",
      width, height, numberText(framesPerSecond), format.evenSize ? yuv420p : "", format.encoding));
  std::vector<std::string> arguments{std::istream_iterator<std::string>(options), {}};
  arguments.push_back("file:" + file.string());  // else a colon in the name would be a protocol
  return arguments;
}

fs::path checkedTarget(const fs::path& path, double framesPerSecond) {
  ClipWriter::checkTarget(path, framesPerSecond);
  return path;
}

int paddedSize(int size, const ClipFormat& format) {
  return format.evenSize ? size + size % 2 : size;
}

}  // namespace

ClipWriter::PartialFile::PartialFile(const fs::path& target)
    : path_(target.parent_path() / fmt::format(".{}.{}.clip{}", target.stem().string(), getpid(),
                                               target.extension().string())) {
  const FileDescriptor file(open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!file.isOpen()) cannotWrite(target, std::strerror(errno));
}

ClipWriter::PartialFile::~PartialFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

bool ClipWriter::isClip(const fs::path& path) {
  return findFormat(path) != nullptr;
}

void ClipWriter::checkTarget(const fs::path& path, double framesPerSecond) {
  const ClipFormat& format = formatOf(path);
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
    cannotWrite(path, "it is no plain file");
  if (!(framesPerSecond >= 0.01 && framesPerSecond <= format.maximumRate))
    cannotWrite(path, fmt::format("a {} clip takes from 0.01 to {} frames per second, not {}",
                                  format.extension, format.maximumRate, framesPerSecond));
  findFfmpeg(path);
}

ClipWriter::ClipWriter(const fs::path& path, int width, int height, double framesPerSecond)
    : target_(checkedTarget(path, framesPerSecond)),
      width_(width),
      height_(height),
      paddedWidth_(paddedSize(width, formatOf(path))),
      paddedHeight_(paddedSize(height, formatOf(path))),
      frame_(std::size_t(3) * paddedWidth_ * paddedHeight_),
      file_(path),
      encoder_(findFfmpeg(path), ffmpegArguments(formatOf(path), file_.path(), paddedWidth_,
                                                 paddedHeight_, framesPerSecond)) {}

void ClipWriter::add(const Image& image) {
  if (image.width != width_ || image.height != height_)
    throw std::invalid_argument("the pictures of a clip must have one size");
  parallelFor(std::size_t(paddedHeight_), 16, [&](std::size_t begin, std::size_t end) {
    std::uint8_t* sample = &frame_[3 * paddedWidth_ * begin];
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < paddedWidth_; ++x)
        for (int c = 0; c < 3; ++c)
          *sample++ = srgbByte(image.at(std::min(x, width_ - 1), std::min(y, height_ - 1))[c]);
  });
  if (!encoder_.write(frame_)) fail(encoder_.finish().words);
  empty_ = false;
}

void ClipWriter::finish() {
  if (empty_) cannotWrite(target_, "it has no pictures");
  const ChildEnd end = encoder_.finish();
  if (!end.success || fs::file_size(file_.path()) == 0) fail(end.words);
  writeFileAtomically(target_,
                      [&](const fs::path& temporary) { fs::rename(file_.path(), temporary); });
}

void ClipWriter::fail(const std::string& words) const {
  cannotWrite(target_, "ffmpeg failed: " + words);
}

}  // namespace haarlight
