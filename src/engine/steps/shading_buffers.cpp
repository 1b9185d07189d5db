#include "engine/steps/shading_buffers.h"

namespace haarlight {

void ShadingBuffers::set(const ShadingTables& tables) {
  host_.squareListEnds = tables.squareListEnds;
  host_.lobeSlots = tables.lobeSlots;
  host_.squarePlaces = tables.squarePlaces;
  host_.unshadowed = tables.unshadowed;
  host_.scales = tables.scales;
  queue_.upload(weights, tables.weights);
  queue_.upload(squaresOfBlocks, tables.blockSquares);
  hasOfLobes_ = false;
}

const ShadingBuffers::OfLobes& ShadingBuffers::ofLobes() {
  if (hasOfLobes_) return ofLobes_;
  const auto& ends = host_.squareListEnds;
  ofLobes_.squareListEnds = {ends[coarseSquares], ends[blockSquares], ends[quarterSquares], 0};
  queue_.upload(ofLobes_.slots, host_.lobeSlots);
  queue_.upload(ofLobes_.squarePlaces, host_.squarePlaces);
  queue_.upload(ofLobes_.unshadowed, host_.unshadowed);
  queue_.upload(ofLobes_.scales, host_.scales);
  hasOfLobes_ = true;
  return ofLobes_;
}

}  // namespace haarlight
