#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmark/power_law.h"
#include "benchmark/quartiles.h"
#include "benchmark/roofline.h"
#include "benchmark/subject.h"
#include "engine/engine.h"

namespace haarlight::benchmark {

/// What a row of the table is measured at.
struct Setting {
  int spheres = 64;
  int terms = 200;
  int levels = 2;

  bool operator==(const Setting&) const = default;
};

/// A subject as it was measured.
struct MeasuredSubject {
  Subject subject;
  double openSeconds = 0;
  /// Part of openSeconds: compiling kernels, or loading them from a driver's cache.
  double compileSeconds = 0;
  std::uint64_t deviceBytes = 0;
};

/// Frames at one setting. A frame is one call of Engine::shade, from call to return.
struct Row {
  std::size_t subject = 0;
  Setting setting;
  /// Spheres in the frame; others than the setting's where a scene has several objects.
  std::size_t blockers = 0;
  Quartiles frame;
  StageTimes stageMedians;
  /// Median seconds of bringing the light's tables to the device, once per light.
  double lightUploadSeconds = 0;
};

/// How far radiance is off, root mean square over the mean of the reference.
struct Errors {
  double againstMesh = 0;     ///< rays against the mesh
  double againstSpheres = 0;  ///< all texels, blocked exactly by the spheres
};

/// Another way to the same picture: same samples, light and spheres.
struct Peer {
  std::string name;
  /// In words, what computes it and what is timed.
  std::string description;
  Quartiles frame;
  /// Part of each of those times that was not measured with it but taken from the median of an
  /// engine's stages; 0 for peers that run on the host alone.
  double deviceSeconds = 0;
  Errors errors;
};

/// A peer's name without what differs between peers of a kind: "double product".
std::string kindOf(const Peer& peer);

struct RowErrors {
  std::size_t row = 0;
  Errors errors;
};

struct PeerComparison {
  int spheres = 0;
  unsigned threads = 0;
  /// The subject whose merging and transform serve the peers that need them.
  std::string stagedSubject;
  std::vector<Peer> peers;
  /// Of the rows with as many spheres.
  std::vector<RowErrors> rowErrors;
};

struct ScalePoint {
  double size = 0;
  Quartiles frame;
};

/// Frames as one of samples, spheres and terms grows.
struct Sweep {
  std::string parameter;
  std::vector<ScalePoint> points;
  std::optional<PowerLaw> law;
};

struct Scale {
  /// Index into subjects.
  std::size_t subject = 0;
  std::size_t samples = 0;  ///< where they are not swept
  Setting setting;          ///< where they are not swept
  std::vector<Sweep> sweeps;
};

/// Everything that a run has found out.
struct Record {
  std::string program, build, host, date;
  unsigned threads = 0;
  std::string scene, light;
  std::size_t samples = 0;
  std::size_t frames = 0, rounds = 0, warmUpFrames = 0;
  bool interrupted = false;
  double peakMemoryMebibytes = 0;
  std::vector<MeasuredSubject> subjects;
  std::vector<Row> rows;
  std::optional<PeerComparison> peers;
  std::optional<Scale> scale;
  std::optional<Roofline> roofline;
};

/// Seconds of Embree's pixel basis on the mesh, against which everything is set; nothing without
/// peers.
std::optional<double> embreeSeconds(const Record& record);
inline constexpr const char* embreePeer = "pixel basis, Embree on the mesh";

/// What is timed, in sentences.
std::vector<std::string> timingNotes(const Record& record);

}  // namespace haarlight::benchmark
