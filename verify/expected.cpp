#include "verify/expected.h"

#include <algorithm>

#include "base/parallel.h"

namespace haarlight::verify {

namespace {

constexpr std::size_t receiversPerTask = 64;

/// Cases of more receivers are frames.
constexpr std::size_t mostReceiversForAllSettings = 64;
constexpr Setting frameSetting{200, 2};

ShadingTables tablesFor(const Case& value, const Setting& setting) {
  ShadingSettings settings;
  settings.terms = setting.terms;
  settings.levels = setting.levels;
  return buildShadingTables(value.light, settings, countLobes(value.receivers.lobes));
}

/// All elements when `asksAll` and the case is no frame, else one in turn.
template <typename Element, std::size_t size>
std::span<const Element> allOrOneInTurn(const std::array<Element, size>& all, const Case& value,
                                        std::size_t index, bool asksAll) {
  if (asksAll && value.receivers.size() <= mostReceiversForAllSettings) return all;
  return std::span(all).subspan(index % size, 1);
}

/// Copies a part's results to their place in the whole.
template <typename Element>
void place(std::vector<Element>& whole, std::size_t first, const std::vector<Element>& part) {
  std::ranges::copy(part, whole.begin() + std::ptrdiff_t(first));
}

}  // namespace

Question::Question(Case caseToAsk, std::span<const Setting> settings, std::span<const int> orders,
                   std::span<const TransferSetting> transferSettings)
    : value(std::move(caseToAsk)) {
  const auto importance = countLobes(value.receivers.lobes);
  for (const int order : orders)
    exponentiation.push_back(buildExponentiationTables(value.light, order, importance));
  for (const TransferSetting& setting : transferSettings) transfer.emplace_back(value, setting);
  for (const Setting& setting : settings) tables.push_back(tablesFor(value, setting));
  frameTables = value.spheres.size() % tables.size();
}

std::span<const Setting> settingsFor(const Case& value, std::size_t index, bool asksAll) {
  if (value.receivers.size() > mostReceiversForAllSettings) return std::span(&frameSetting, 1);
  if (asksAll) return allSettings;
  constexpr std::size_t levels = 2;
  return std::span(allSettings).subspan(index * levels % allSettings.size(), levels);
}

std::span<const int> ordersFor(const Case& value, std::size_t index, bool asksAll) {
  return allOrOneInTurn(allOrders, value, index, asksAll);
}

std::span<const TransferSetting> transferSettingsFor(const Case& value, std::size_t index,
                                                     bool asksAll) {
  return allOrOneInTurn(allTransferSettings, value, index, asksAll);
}

Answers referenceAnswers(const Question& question, std::shared_ptr<const SphereTable> table) {
  const auto& [spheres, receivers] = std::tie(question.value.spheres, question.value.receivers);
  const std::size_t count = receivers.size();
  Answers answers;
  answers.movedSpheres = moveSpheres(question.value.binding, question.value.vertices);
  if (table) answers.tableEntries.resize(count * spheres.size());
  answers.bitCubes.resize(count);
  answers.occlusion.resize(count);
  answers.radiance.assign(question.tables.size(), std::vector<glm::vec4>(count));
  answers.frame.resize(count);
  answers.exponentiation.assign(question.exponentiation.size(), std::vector<glm::vec4>(count));
  parallelFor(count, receiversPerTask, [&](std::size_t begin, std::size_t end) {
    const auto reference = makeReferenceEngine(table);
    const ReceiverSpan part = ReceiverSpan(receivers).part(begin, end - begin);
    if (table)
      place(answers.tableEntries, begin * spheres.size(),
            reference->sphereTableEntries(spheres, part));
    const auto cubes = reference->mergeBitCubes(spheres, part);
    const auto occlusion = reference->transformOcclusion(cubes);
    place(answers.bitCubes, begin, cubes);
    place(answers.occlusion, begin, occlusion);
    for (std::size_t i = 0; i < question.tables.size(); ++i) {
      reference->setShading(question.tables[i]);
      place(answers.radiance[i], begin, reference->tripleProduct(occlusion, part.lobes));
    }
    reference->setShading(question.tables[question.frameTables]);
    place(answers.frame, begin, reference->shade(spheres, part));
    for (std::size_t i = 0; i < question.exponentiation.size(); ++i) {
      reference->setExponentiation(question.exponentiation[i]);
      place(answers.exponentiation[i], begin, reference->shadeByExponentiation(spheres, part));
    }
  });
  for (const TransferQuestion& transfer : question.transfer) {
    const auto reference = makeReferenceEngine(nullptr);
    reference->setTransferRows(transfer.rows);
    reference->setTransferLights(transfer.lights);
    answers.transfer.push_back(reference->shadeByTransfer(transfer.receivers));
  }
  return answers;
}

}  // namespace haarlight::verify
