#include "benchmark/record.h"

#include <algorithm>

#include "base/text_format.h"

namespace haarlight::benchmark {

std::string kindOf(const Peer& peer) {
  return peer.name.substr(0, peer.name.find(';'));
}

std::optional<double> embreeSeconds(const Record& record) {
  if (!record.peers) return std::nullopt;
  const auto& peers = record.peers->peers;
  const auto found = std::ranges::find(peers, embreePeer, &Peer::name);
  return found == peers.end() ? std::nullopt : std::optional(found->frame.median);
}

std::vector<std::string> timingNotes(const Record& record) {
  const std::string order =
      record.scale
          ? "Sizes are measured one after the other, with at most "
          : "Rows are measured in " + countText(record.rounds, "round") + " over all, with ";
  std::vector<std::string> notes{
      "A frame is one call of Engine::shade, from call to return on the host's clock: upload of "
      "spheres and samples, kernels, read-back of the radiance. Stages come from the device's own "
      "clock where it has one.",
      order + countText(record.frames, "frame") + " each in all and " +
          countText(record.warmUpFrames, "frame") + " before each part to warm up, not counted.",
      "Not in a frame: fitting spheres, opening an engine (kernels, sphere table, self test), and "
      "the tables of a light, which are brought to the device once per light."};
  if (record.peers)
    notes.push_back(
        "Peers are measured after the rows, each after one frame to warm up, on the host's clock; "
        "those for static light add the median of the device's stages that they build upon.");
  if (record.roofline)
    notes.push_back(
        "Ceilings are measured last, each as the best of several repetitions; least times are "
        "those "
        "of a model that counts a frame's operations and bytes.");
  return notes;
}

}  // namespace haarlight::benchmark
