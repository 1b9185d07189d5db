#pragma once

#include <array>
#include <string>

#include "engine/transfer_tables.h"
#include "verify/cases/case.h"

namespace haarlight::verify {

/// What transfer is compared at.
struct TransferSetting {
  int order = 5;
  int channels = 1;  ///< of the rows
  int lights = 1;
  bool blendsRows = false;  ///< three rows a receiver, else one
};
inline constexpr std::array allTransferSettings{
    TransferSetting{2, 1, 1, false}, TransferSetting{2, 3, 3, true},
    TransferSetting{5, 1, 1, true},  TransferSetting{5, 3, 2, false},
    TransferSetting{6, 3, 1, true},  TransferSetting{10, 1, 3, false}};

/// "order 5, coloured, 2 lights", "order 2, grey, 1 light, blended rows", …
std::string nameOf(const TransferSetting& setting);

/// Rows, lights and receivers made of a case: a row for each receiver, of the clamped cosine about
/// its normal, in channels of different albedo, every third one with half the mean, so that
/// radiance below zero is asked for too; the case's light, and the same turned by a radian about +y
/// and by two; rows and lights blended by random weights that are the same everywhere.
struct TransferQuestion {
  TransferSetting setting;
  TransferRows rows;
  TransferLights lights;
  TransferReceivers receivers;

  TransferQuestion(const Case& value, const TransferSetting& transferSetting);
};

}  // namespace haarlight::verify
