#include "verify/cases/case_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "verify/cases/random_cases.h"

namespace haarlight::verify {

namespace {

constexpr std::size_t mostSpheres = 65536;
constexpr std::size_t mostReceivers = 1048576;
constexpr std::size_t mostVertices = 1048576;

void checkCount(const LineReader& line, std::size_t count, std::size_t most, const char* things) {
  if (count > most)
    line.fail("a case has at most " + std::to_string(most) + " " + things + "; remove some");
}

float readNotNegative(LineReader& line, const std::string& what) {
  const float number = line.number(what);
  if (std::signbit(number)) line.fail(what + " must not be negative");
  return number;
}

glm::vec3 readVector(LineReader& line, const std::string& what) {
  glm::vec3 vector;
  for (int i = 0; i < 3; ++i)
    vector[i] = line.number("the " + std::string(1, "xyz"[i]) + " of " + what);
  return vector;
}

glm::vec3 readColor(LineReader& line, const std::string& what) {
  glm::vec3 color;
  constexpr const char* channels[] = {"red", "green", "blue"};
  for (int i = 0; i < 3; ++i) color[i] = line.number(std::string(channels[i]) + " of " + what);
  return color;
}

}  // namespace

bool CaseLines::read(LineReader& line) {
  struct Reader {
    std::string_view keyword;
    void (CaseLines::*read)(LineReader&);
  };
  constexpr Reader readers[] = {
      {"name", &CaseLines::readName},      {"sphere", &CaseLines::readSphere},
      {"plane", &CaseLines::readPlane},    {"receiver", &CaseLines::readReceiver},
      {"light", &CaseLines::readLight},    {"texel", &CaseLines::readTexel},
      {"vertex", &CaseLines::readVertex},  {"bound", &CaseLines::readBound},
      {"follows", &CaseLines::readFollows}};
  const auto* reader = std::ranges::find(readers, line.keyword(), &Reader::keyword);
  if (reader == std::end(readers)) return false;
  (this->*reader->read)(line);
  line.endLine();
  return true;
}

void CaseLines::readName(LineReader& line) {
  if (!value_.name.empty()) line.fail("this is the second name of a case; remove the line");
  value_.name = line.restOfLine("the name");
}

void CaseLines::readSphere(LineReader& line) {
  checkCount(line, value_.spheres.size() + 1, mostSpheres, "spheres");
  const glm::vec3 center = readVector(line, "a sphere's centre");
  const float radius = line.number("a sphere's radius");
  if (!(radius > 0)) line.fail("a sphere's radius must be greater than zero");
  value_.spheres.push_back({center, radius});
}

void CaseLines::readReceiver(LineReader& line) {
  checkCount(line, value_.receivers.size() + 1, mostReceivers, "receivers");
  const glm::vec3 position = readVector(line, "a receiver's position");
  const glm::vec3 normal = readVector(line, "a receiver's normal");
  const double length = std::hypot(double(normal.x), double(normal.y), double(normal.z));
  if (std::abs(length - 1) > 1e-3) line.fail("a receiver's normal must have length 1 within 0.001");
  value_.receivers.add(position, normal);
}

void CaseLines::readPlane(LineReader& line) {
  const auto count = int(line.wholeNumber("the receivers per side of a plane", 1, 1024));
  const float spacing = line.number("the spacing of a plane");
  checkCount(line, value_.receivers.size() + std::size_t(count) * std::size_t(count), mostReceivers,
             "receivers");
  const auto coordinate = [&](int i) { return float(2 * i + 1 - count) * 0.5f * spacing; };
  for (int row = 0; row < count; ++row)
    for (int column = 0; column < count; ++column)
      value_.receivers.add({coordinate(column), 0, coordinate(row)}, {0, 1, 0});
}

void CaseLines::readLight(LineReader& line) {
  if (hasLight_ || !texelsRead_.empty())
    line.fail("a case has one light, which it has already; remove the line");
  hasLight_ = true;
  const std::string_view kind = line.word("the kind of light");
  if (kind == "constant")
    std::ranges::fill(value_.light.texels, readColor(line, "a constant light"));
  else if (kind == "random")
    value_.light = randomLight(line.wholeNumber("the seed of a light", 0, ~std::uint64_t(0)));
  else
    line.fail("the kind of light must be 'constant' or 'random'");
}

void CaseLines::readTexel(LineReader& line) {
  if (hasLight_) line.fail("a case has a light line or texels; remove one of them");
  const auto texel = std::size_t(line.wholeNumber("the index of a texel", 0, texelCount - 1));
  texelsRead_.resize(texelCount);
  if (texelsRead_[texel]) line.fail("this texel has a line already; remove one of them");
  texelsRead_[texel] = true;
  value_.light[int(texel)] = readColor(line, "a texel");
}

void CaseLines::readVertex(LineReader& line) {
  checkCount(line, value_.vertices.size() + 1, mostVertices, "vertices");
  value_.vertices.emplace_back(readVector(line, "a vertex"), 0);
}

void CaseLines::readBound(LineReader& line) {
  finishBound(line);
  checkCount(line, value_.binding.sphereCount() + 1, mostSpheres, "bound spheres");
  const float mean = readNotNegative(line, "the factor of the mean");
  bound_ = {{mean, readNotNegative(line, "the factor of the reach")}, {}, {}};
}

void CaseLines::readFollows(LineReader& line) {
  if (!bound_) line.fail("a line 'bound mean reach' must come before what the sphere follows");
  if (value_.vertices.empty())
    line.fail("the case has no vertex yet; add a line 'vertex x y z' before");
  bound_->vertices.push_back(
      std::uint32_t(line.wholeNumber("the number of a vertex", 0, value_.vertices.size() - 1)));
  const float forCenter = line.number("the weight for the centre");
  const float forMean = readNotNegative(line, "the weight for the mean");
  const float forReach = readNotNegative(line, "the weight for the reach");
  bound_->weights.emplace_back(forCenter, forMean, forReach, 0);
}

/// After the last line of a bound sphere, if there was one.
void CaseLines::finishBound(const LineReader& line) {
  if (!bound_) return;
  if (bound_->vertices.empty())
    line.fail("a bound sphere follows nothing; add a line 'follows vertex a b g'");
  value_.binding.add(bound_->vertices, bound_->weights, bound_->radiusFactors);
  bound_.reset();
}

void CaseLines::checkMovedSpheres(const LineReader& line) const {
  const auto isFinite = [](float number) { return std::isfinite(number); };
  for (const auto& [center, radius] : moveSpheres(value_.binding, value_.vertices))
    if (!std::ranges::all_of(std::array{center.x, center.y, center.z, radius}, isFinite))
      line.fail("a bound sphere leaves the range of float32; choose smaller numbers");
}

Case CaseLines::finish(const LineReader& line) {
  if (value_.name.empty()) line.fail("the case has no name; add a line 'name …'");
  if (value_.receivers.size() == 0)
    line.fail("the case has no receiver; add a line 'receiver x y z nx ny nz'");
  finishBound(line);
  checkMovedSpheres(line);
  value_.hasDenormals = involvesDenormals(value_);
  return std::exchange(*this, {}).value_;
}

}  // namespace haarlight::verify
