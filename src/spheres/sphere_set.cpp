#include "spheres/sphere_set.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "scene/json_text.h"

namespace haarlight {

namespace {

using nlohmann::json;

constexpr const char* formatName = "haarlight-spheres";
constexpr int formatVersion = 1;
constexpr std::uint64_t largestFile = std::uint64_t(64) << 20;

/// A value in the file together with its place, such as /spheres/3/radius.
class Field {
 public:
  Field(const std::filesystem::path& file, const json& value, std::string place)
      : file_(file), value_(value), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError("cannot read sphere set " + file_.string() + ": " +
                     (place_.empty() ? "the whole" : place_) + " " + problem);
  }

  Field member(const std::string& name) const {
    if (!value_.is_object()) fail("must be an object");
    const auto found = value_.find(name);
    if (found == value_.end()) Field(file_, value_, place_ + "/" + name).fail("is missing");
    return Field(file_, *found, place_ + "/" + name);
  }

  std::size_t arraySize() const {
    if (!value_.is_array()) fail("must be an array");
    return value_.size();
  }

  Field element(std::size_t index) const {
    return Field(file_, value_[index], place_ + "/" + std::to_string(index));
  }

  std::string text() const {
    if (!value_.is_string()) fail("must be a string");
    return value_.get<std::string>();
  }

  double number() const {
    if (!value_.is_number()) fail("must be a number");
    return value_.get<double>();
  }

  float finiteFloat() const {
    const auto single = static_cast<float>(number());
    if (!std::isfinite(single)) fail("is too large");
    return single;
  }

  double atLeastZero() const {
    if (!(number() >= 0)) fail("must be zero or more");
    return number();
  }

  std::uint64_t unsignedInteger() const {
    if (!value_.is_number_unsigned()) fail("must be a whole number of zero or more");
    return value_.get<std::uint64_t>();
  }

  std::uint64_t hexadecimal() const {
    const std::string digits = text();
    std::uint64_t number = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number, 16);
    if (error != std::errc() || stop != end || digits.size() != 16)
      fail("must be 16 hexadecimal digits");
    return number;
  }

  bool isNull() const { return value_.is_null(); }

 private:
  const std::filesystem::path& file_;
  const json& value_;
  std::string place_;
};

Sphere readSphere(const Field& field) {
  const Field center = field.member("center"), radius = field.member("radius");
  if (center.arraySize() != 3) center.fail("must have three numbers");
  Sphere sphere{};
  for (int i = 0; i < 3; ++i) sphere.center[i] = center.element(std::size_t(i)).finiteFloat();
  sphere.radius = radius.finiteFloat();
  if (!(sphere.radius > 0)) radius.fail("must be greater than zero");
  return sphere;
}

SphereMeasures readMeasures(const Field& field) {
  SphereMeasures measures;
  const Field covered = field.member("coveredFraction");
  const Field ratio = field.member("outsideVolumeRatio");
  measures.coveredFraction = covered.atLeastZero();
  if (measures.coveredFraction > 1) covered.fail("must be at most one");
  if (!ratio.isNull()) measures.outsideVolumeRatio = ratio.atLeastZero();
  return measures;
}

SphereSet readFields(const Field& root) {
  if (root.member("format").text() != formatName)
    root.member("format").fail("must be '" + std::string(formatName) + "'");
  if (root.member("version").unsignedInteger() != formatVersion)
    root.member("version").fail("must be " + std::to_string(formatVersion));
  SphereSet set;
  set.meshName = root.member("mesh").member("name").text();
  set.meshHash = root.member("mesh").member("hash").hexadecimal();
  set.method = root.member("method").text();
  set.seed = root.member("seed").unsignedInteger();
  set.measures = readMeasures(root.member("measures"));
  const Field spheres = root.member("spheres");
  const std::size_t count = spheres.arraySize();
  if (count == 0 || count > maximumSphereCount)
    spheres.fail("must hold 1 to " + std::to_string(maximumSphereCount) + " spheres, not " +
                 std::to_string(count));
  for (std::size_t i = 0; i < count; ++i) set.spheres.push_back(readSphere(spheres.element(i)));
  return set;
}

std::string hexadecimal(std::uint64_t number) {
  std::string digits(16, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, number /= 16)
    *digit = "0123456789abcdef"[number % 16];
  return digits;
}

}  // namespace

SphereSet readSphereSet(const std::filesystem::path& path) {
  const auto bytes = readWholeFile(path, "sphere set", largestFile);
  const json root = parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                              "cannot read sphere set " + path.string());
  return readFields(Field(path, root, ""));
}

void writeSphereSet(const std::filesystem::path& path, const SphereSet& set) {
  nlohmann::ordered_json root;
  root["format"] = formatName;
  root["version"] = formatVersion;
  root["mesh"] = {{"name", set.meshName}, {"hash", hexadecimal(set.meshHash)}};
  root["method"] = set.method;
  root["seed"] = set.seed;
  root["measures"]["coveredFraction"] = set.measures.coveredFraction;
  root["measures"]["outsideVolumeRatio"] = nullptr;
  if (set.measures.outsideVolumeRatio)
    root["measures"]["outsideVolumeRatio"] = *set.measures.outsideVolumeRatio;
  for (const Sphere& sphere : set.spheres) {
    const glm::vec3& c = sphere.center;
    root["spheres"].push_back({{"center", {c.x, c.y, c.z}}, {"radius", sphere.radius}});
  }
  const auto replaceInvalid = nlohmann::ordered_json::error_handler_t::replace;  // in the name
  writeFileAtomically(path, root.dump(1, ' ', false, replaceInvalid) + "\n");
}

}  // namespace haarlight
