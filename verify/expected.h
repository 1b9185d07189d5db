#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "engine/engine.h"
#include "verify/cases/case.h"
#include "verify/transfer_question.h"
#include "visibility/visibility_kind.h"

namespace haarlight::verify {

/// Terms and levels that sums are compared at.
struct Setting {
  int terms = 200;
  int levels = 2;
};
inline constexpr std::array allSettings{Setting{50, 1},  Setting{50, 2},   Setting{200, 1},
                                        Setting{200, 2}, Setting{6144, 1}, Setting{6144, 2}};

/// Orders that exponentiation is compared at.
inline constexpr std::array allOrders{4, 5, 6};

/// What every engine is handed for a case: the tables of each setting, built once on the host.
struct Question {
  Case value;
  std::vector<ShadingTables> tables;
  /// Which of `tables` the whole frame is rendered with.
  std::size_t frameTables = 0;
  /// By order.
  std::vector<ExponentiationTables> exponentiation;
  std::vector<TransferQuestion> transfer;

  Question(Case caseToAsk, std::span<const Setting> settings,
           std::span<const int> orders = allOrders,
           std::span<const TransferSetting> transferSettings = allTransferSettings);
};

/// The settings that question `index` of a run is asked with: all of them when `asksAll`; 200 terms
/// and two levels for frames of many receivers; else two levels of one number of terms, in turn.
std::span<const Setting> settingsFor(const Case& value, std::size_t index, bool asksAll);

/// The orders that question `index` of a run is asked with: all of them when `asksAll` and it is no
/// frame of many receivers, else one in turn.
std::span<const int> ordersFor(const Case& value, std::size_t index, bool asksAll);

/// The settings of transfer of question `index` of a run: all of them when `asksAll` and it is no
/// frame of many receivers, else one in turn.
std::span<const TransferSetting> transferSettingsFor(const Case& value, std::size_t index,
                                                     bool asksAll);

/// The scalar reference's answers, stage by stage.
struct Answers {
  std::vector<Sphere> movedSpheres;
  /// Only with the sphere table, else empty.
  std::vector<std::uint32_t> tableEntries;
  std::vector<BitCube> bitCubes;
  std::vector<OcclusionHaar> occlusion;
  /// By tables of the question.
  std::vector<std::vector<glm::vec4>> radiance;
  std::vector<glm::vec4> frame;
  /// By order of the question.
  std::vector<std::vector<glm::vec4>> exponentiation;
  /// By transfer of the question.
  std::vector<std::vector<glm::vec4>> transfer;
};

/// Asks the reference, on all threads. Without a table visibility is exact.
Answers referenceAnswers(const Question& question, std::shared_ptr<const SphereTable> table);

}  // namespace haarlight::verify
