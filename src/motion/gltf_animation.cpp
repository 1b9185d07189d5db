#include "motion/gltf_animation.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "motion/gltf_accessor.h"

namespace haarlight {

namespace {

const std::map<std::string, AnimatedProperty> properties{
    {"translation", AnimatedProperty::translation},
    {"rotation", AnimatedProperty::rotation},
    {"scale", AnimatedProperty::scale},
    {"weights", AnimatedProperty::morphWeights}};

const std::map<std::string, Interpolation> interpolations{
    {"", Interpolation::linear},  // the default
    {"LINEAR", Interpolation::linear},
    {"STEP", Interpolation::step},
    {"CUBICSPLINE", Interpolation::cubicSpline}};

glm::dvec3 vectorOf(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

glm::dquat rotationOf(const std::vector<double>& numbers) {
  return glm::normalize(glm::dquat(numbers[3], numbers[0], numbers[1], numbers[2]));
}

int animationIndex(const GltfFile& file, const std::string& choice) {
  const auto& animations = file.model.animations;
  if (choice.empty() && !animations.empty()) return 0;
  const auto named = std::ranges::find(animations, choice, &tinygltf::Animation::name);
  if (named != animations.end()) return int(named - animations.begin());
  std::size_t number = 0;
  const char* end = choice.data() + choice.size();
  const auto read = std::from_chars(choice.data(), end, number);
  if (read.ec == std::errc() && read.ptr == end && number < animations.size()) return int(number);
  std::string names;
  for (std::size_t i = 0; i < animations.size(); ++i)
    names += (i == 0 ? "" : ", ") + std::to_string(i) + " '" + visible(animations[i].name) + "'";
  file.fail("animations", "there is none called '" + visible(choice) + "'; choose " +
                              (names.empty() ? "" : "one of " + names + ", or ") + "none");
}

class AnimationReader {
 public:
  AnimationReader(const GltfFile& file, const NodeHierarchy& nodes, int index)
      : file_(file),
        nodes_(nodes),
        animation_(file.model.animations[index]),
        place_("animation " + std::to_string(index)) {}

  GltfAnimation read() {
    requireSize();
    GltfAnimation result;
    for (std::size_t i = 0; i < animation_.channels.size(); ++i) {
      const tinygltf::AnimationChannel& channel = animation_.channels[i];
      channelPlace_ = place_ + ", channel " + std::to_string(i);
      // Extensions animate other things, and materials without any node.
      if (channel.target_node < 0 || !properties.contains(channel.target_path)) continue;
      result.tracks.push_back(readTrack(channel));
      result.duration = std::max(result.duration, double(result.tracks.back().keySeconds.back()));
    }
    return result;
  }

 private:
  const tinygltf::AnimationSampler& samplerOf(const tinygltf::AnimationChannel& channel) const {
    return file_.element(animation_.samplers, channel.sampler, "sampler", channelPlace_);
  }

  void requireSize() {
    std::size_t count = 0;
    for (std::size_t i = 0; i < animation_.channels.size(); ++i) {
      channelPlace_ = place_ + ", channel " + std::to_string(i);
      const int output = samplerOf(animation_.channels[i]).output;
      addToGltfCount(file_, count,
                     file_.element(file_.model.accessors, output, "accessor", channelPlace_).count);
    }
  }

  AnimationTrack readTrack(const tinygltf::AnimationChannel& channel) const {
    AnimationTrack track;
    track.node = channel.target_node;
    track.property = properties.at(channel.target_path);
    track.width = widthOf(channel);
    const tinygltf::AnimationSampler& sampler = samplerOf(channel);
    const auto interpolation = interpolations.find(sampler.interpolation);
    if (interpolation == interpolations.end())
      fail("it has an unknown interpolation, " + visible(sampler.interpolation));
    track.interpolation = interpolation->second;
    track.keySeconds = readKeySeconds(sampler.input);
    const bool spline = track.interpolation == Interpolation::cubicSpline;
    readValues(sampler.output, track.keySeconds.size() * (spline ? 3 : 1), track);
    return track;
  }

  std::size_t widthOf(const tinygltf::AnimationChannel& channel) const {
    const auto& node = file_.element(file_.model.nodes, channel.target_node, "node", channelPlace_);
    if (channel.target_path == "weights")
      return nodes_.rest()[channel.target_node].morphWeights.size();
    if (!node.matrix.empty())
      fail("it moves node " + std::to_string(channel.target_node) + ", which has a matrix");
    return channel.target_path == "rotation" ? 4 : 3;
  }

  std::vector<float> readKeySeconds(int accessor) const {
    const auto seconds = readGltfElements<float>(file_, accessor, channelPlace_);
    if (seconds.empty()) fail("it has no keys");
    if (seconds.front() < 0) fail("its first key lies before second 0");
    const auto wrong = std::ranges::adjacent_find(seconds, std::greater_equal());
    if (wrong != seconds.end())
      fail("the times of keys " + std::to_string(wrong - seconds.begin()) + " and " +
           std::to_string(wrong - seconds.begin() + 1) + " do not increase");
    return seconds;
  }

  void readValues(int accessor, std::size_t count, AnimationTrack& track) const {
    const bool scalars = track.property == AnimatedProperty::morphWeights;
    const std::size_t components = scalars ? 1 : track.width;
    const std::size_t elements = scalars ? count * track.width : count;
    const GltfAccessorReader reader(file_, accessor, components, elements, channelPlace_);
    track.keys.resize(count * track.width);
    reader.read(track.keys.data());
  }

  [[noreturn]] void fail(const std::string& problem) const {
    file_.fail(channelPlace_, problem + "; export it again");
  }

  const GltfFile& file_;
  const NodeHierarchy& nodes_;
  const tinygltf::Animation& animation_;
  std::string place_, channelPlace_;
};

/// Two keys, and how far the time has got from the first to the second one.
struct KeyInterval {
  const AnimationTrack& track;
  std::size_t first;
  double seconds, part;

  /// Number i of a key's value (of its incoming or outgoing tangent with −1 and 1).
  double number(std::size_t key, std::size_t i, int tangent = 0) const {
    const bool spline = track.interpolation == Interpolation::cubicSpline;
    const std::size_t entry = spline ? 3 * key + std::size_t(1 + tangent) : key;
    return track.keys[entry * track.width + i];
  }

  std::vector<double> value(std::size_t key) const {
    std::vector<double> result(track.width);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = number(key, i);
    return result;
  }

  std::vector<double> linear() const {
    std::vector<double> result(track.width);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = (1 - part) * number(first, i) + part * number(first + 1, i);
    return result;
  }

  /// Along the shorter arc.
  std::vector<double> spherical() const {
    const glm::dquat q = glm::slerp(rotationOf(value(first)), rotationOf(value(first + 1)), part);
    return {q.x, q.y, q.z, q.w};
  }

  /// Hermite's cubic; tangents are per second.
  std::vector<double> cubic() const {
    const double square = part * part, cube = square * part;
    std::vector<double> result(track.width);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = (2 * cube - 3 * square + 1) * number(first, i) +
                  seconds * (cube - 2 * square + part) * number(first, i, 1) +
                  (3 * square - 2 * cube) * number(first + 1, i) +
                  seconds * (cube - square) * number(first + 1, i, -1);
    return result;
  }
};

}  // namespace

std::vector<double> AnimationTrack::valueAt(double seconds) const {
  KeyInterval interval{*this, 0, 0, 0};
  if (!(seconds > keySeconds.front())) return interval.value(0);
  if (seconds >= keySeconds.back()) return interval.value(keySeconds.size() - 1);
  const auto next = std::upper_bound(keySeconds.begin(), keySeconds.end(), seconds);
  interval.first = std::size_t(next - keySeconds.begin()) - 1;
  interval.seconds = double(next[0]) - double(next[-1]);
  interval.part = (seconds - double(next[-1])) / interval.seconds;
  if (interpolation == Interpolation::step) return interval.value(interval.first);
  if (interpolation == Interpolation::cubicSpline) return interval.cubic();
  return property == AnimatedProperty::rotation ? interval.spherical() : interval.linear();
}

void GltfAnimation::apply(double seconds, std::vector<NodeState>& states) const {
  for (const AnimationTrack& track : tracks) {
    const std::vector<double> value = track.valueAt(seconds);
    NodeState& state = states[track.node];
    if (track.property == AnimatedProperty::translation) state.translation = vectorOf(value);
    if (track.property == AnimatedProperty::rotation) state.rotation = rotationOf(value);
    if (track.property == AnimatedProperty::scale) state.scale = vectorOf(value);
    if (track.property == AnimatedProperty::morphWeights) state.morphWeights = value;
  }
}

std::optional<GltfAnimation> readGltfAnimation(const GltfFile& file, const NodeHierarchy& nodes,
                                               const std::string& choice) {
  if (choice == "none" || (choice.empty() && file.model.animations.empty())) return {};
  return AnimationReader(file, nodes, animationIndex(file, choice)).read();
}

}  // namespace haarlight
