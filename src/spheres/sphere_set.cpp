#include "spheres/sphere_set.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "scene/json_text.h"
#include "scene/names.h"

namespace haarlight {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* formatName = "haarlight-spheres";
constexpr int formatVersion = 2;
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

  /// What `read` gives for a value, none for null.
  template <typename Read>
  auto unlessNull(const Read& read) const -> std::optional<decltype(read(*this))> {
    if (value_.is_null()) return std::nullopt;
    return read(*this);
  }

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

FitObjective readObjective(const Field& field) {
  const std::string name = field.text();
  const auto named = std::ranges::find(fitObjectiveNames, name, &Named<FitObjective>::name);
  if (named == fitObjectiveNames.end()) field.fail("must be 'cover' or 'shadow'");
  return named->choice;
}

SilhouetteError readSilhouette(const Field& field) {
  const auto part = [&](const char* name) { return field.member(name).atLeastZero(); };
  return {part("mean"), part("worst"), part("over"), part("under")};
}

/// `version`: of the file's format; the first one has two measures.
SphereMeasures readMeasures(const Field& field, std::uint64_t version) {
  const auto ratio = [&](const char* name) {
    return field.member(name).unlessNull([](const Field& value) { return value.atLeastZero(); });
  };
  SphereMeasures measures;
  const Field covered = field.member("coveredFraction");
  measures.coveredFraction = covered.atLeastZero();
  if (measures.coveredFraction > 1) covered.fail("must be at most one");
  measures.outsideVolumeRatio = ratio("outsideVolumeRatio");
  if (version == 1) return measures;
  measures.unionOutsideRatio = ratio("unionOutsideRatio");
  measures.uncoveredVolumeRatio = ratio("uncoveredVolumeRatio");
  measures.silhouette = field.member("silhouette").unlessNull(readSilhouette);
  return measures;
}

std::uint64_t readVersion(const Field& root) {
  if (root.member("format").text() != formatName)
    root.member("format").fail("must be '" + std::string(formatName) + "'");
  const Field field = root.member("version");
  const std::uint64_t version = field.unsignedInteger();
  if (version < 1 || version > formatVersion)
    field.fail("must be from 1 to " + std::to_string(formatVersion));
  return version;
}

std::vector<Sphere> readSpheres(const Field& field) {
  const std::size_t count = field.arraySize();
  if (count == 0 || count > maximumSphereCount)
    field.fail("must hold 1 to " + std::to_string(maximumSphereCount) + " spheres, not " +
               std::to_string(count));
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < count; ++i) spheres.push_back(readSphere(field.element(i)));
  return spheres;
}

SphereSet readFields(const Field& root) {
  const std::uint64_t version = readVersion(root);
  SphereSet set;
  set.meshName = root.member("mesh").member("name").text();
  set.meshHash = root.member("mesh").member("hash").hexadecimal();
  if (version > 1) set.objective = readObjective(root.member("objective"));
  set.method = root.member("method").text();
  set.seed = root.member("seed").unsignedInteger();
  set.measures = readMeasures(root.member("measures"), version);
  set.spheres = readSpheres(root.member("spheres"));
  return set;
}

std::string hexadecimal(std::uint64_t number) {
  std::string digits(16, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, number /= 16)
    *digit = "0123456789abcdef"[number % 16];
  return digits;
}

ordered_json valueOrNull(const std::optional<double>& number) {
  return number ? ordered_json(*number) : ordered_json(nullptr);
}

ordered_json measuresJson(const SphereMeasures& measures) {
  ordered_json fields{{"coveredFraction", measures.coveredFraction},
                      {"outsideVolumeRatio", valueOrNull(measures.outsideVolumeRatio)},
                      {"unionOutsideRatio", valueOrNull(measures.unionOutsideRatio)},
                      {"uncoveredVolumeRatio", valueOrNull(measures.uncoveredVolumeRatio)},
                      {"silhouette", nullptr}};
  if (const auto& error = measures.silhouette)
    fields["silhouette"] = {{"mean", error->mean},
                            {"worst", error->worst},
                            {"over", error->over},
                            {"under", error->under}};
  return fields;
}

}  // namespace

SphereSet readSphereSet(const std::filesystem::path& path) {
  const auto bytes = readWholeFile(path, "sphere set", largestFile);
  const json root = parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                              "cannot read sphere set " + path.string());
  return readFields(Field(path, root, ""));
}

void writeSphereSet(const std::filesystem::path& path, const SphereSet& set) {
  ordered_json root;
  root["format"] = formatName;
  root["version"] = formatVersion;
  root["mesh"] = {{"name", set.meshName}, {"hash", hexadecimal(set.meshHash)}};
  root["objective"] = nameOf(set.objective);
  root["method"] = set.method;
  root["seed"] = set.seed;
  root["measures"] = measuresJson(set.measures);
  for (const Sphere& sphere : set.spheres) {
    const glm::vec3& c = sphere.center;
    root["spheres"].push_back({{"center", {c.x, c.y, c.z}}, {"radius", sphere.radius}});
  }
  const auto replaceInvalid = ordered_json::error_handler_t::replace;  // in the name
  writeFileAtomically(path, root.dump(1, ' ', false, replaceInvalid) + "\n");
}

}  // namespace haarlight
