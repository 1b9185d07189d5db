#include "engine/steps/kernel_queue.h"

namespace haarlight {

KernelQueue::KernelQueue(std::unique_ptr<KernelDevice> device)
    : device_(std::move(device)),
      samplesPerGroup_(std::size_t(device_->shape().samplesPerGroup)),
      tileSamples_(device_->shape().lanesPerItem > 1 ? std::size_t(tileSamples) : 1) {}

std::size_t KernelQueue::fullGroups(std::size_t samples) const {
  return roundedUp(samples, samplesPerGroup_ * tileSamples_);
}

CommandSeconds KernelQueue::launch(std::string_view kernel, std::size_t samples,
                                   std::initializer_list<KernelArgument> arguments) {
  return device_->launch(kernel, roundedUp(samples, samplesPerGroup_) / samplesPerGroup_,
                         std::span(arguments.begin(), arguments.size()));
}

CommandSeconds KernelQueue::launchTiles(std::string_view kernel, std::size_t samples,
                                        std::initializer_list<KernelArgument> arguments) {
  return launch(kernel, roundedUp(samples, tileSamples_) / tileSamples_, arguments);
}

}  // namespace haarlight
