#pragma once

#include "engine/transfer_tables.h"

namespace haarlight::test {

struct TestTransfer {
  TransferRows rows;
  TransferLights lights;
  TransferReceivers receivers;
};

/// Rows and lights of random numbers, and receivers of random rows: each of one, or with `blends`
/// of three by random weights.
TestTransfer randomTransfer(unsigned seed, int order, int channels, std::size_t receivers,
                            std::size_t lights, bool blends);

}  // namespace haarlight::test
