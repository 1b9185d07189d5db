#include "engine/cuda/kernel_call.h"

#include <cstring>
#include <stdexcept>
#include <string>

namespace haarlight {

namespace {

ParameterKind kindOf(const KernelArgument& argument) {
  if (std::holds_alternative<const DeviceBuffer*>(argument)) return ParameterKind::buffer;
  if (std::holds_alternative<std::uint32_t>(argument)) return ParameterKind::number;
  return ParameterKind::fourNumbers;
}

void checkArguments(const KernelSignature& signature, std::span<const KernelArgument> arguments) {
  const std::string kernel = "kernel " + std::string(signature.name);
  if (arguments.size() != signature.parameters.size())
    throw std::logic_error(kernel + " takes " + std::to_string(signature.parameters.size()) +
                           " arguments, not " + std::to_string(arguments.size()));
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (kindOf(arguments[i]) != signature.parameters[i])
      throw std::logic_error(kernel + ": argument " + std::to_string(i) + " is of the wrong kind");
}

}  // namespace

std::byte* memoryOf(const DeviceBuffer& buffer, std::size_t count) {
  const auto& cudaBuffer = static_cast<const CudaBuffer&>(buffer);
  if (count > cudaBuffer.bytes)
    throw std::logic_error("a copy of " + std::to_string(count) + " bytes leaves a buffer of " +
                           std::to_string(cudaBuffer.bytes));
  return static_cast<std::byte*>(cudaBuffer.memory);
}

KernelCall::KernelCall(const KernelSignature& signature,
                       std::span<const KernelArgument> arguments) {
  checkArguments(signature, arguments);
  values_.reserve(arguments.size());  // addresses of the values are kept
  for (const KernelArgument& argument : arguments) {
    Value& value = values_.emplace_back();
    const auto store = [&](const auto& data) { std::memcpy(&value, &data, sizeof data); };
    if (const auto* buffer = std::get_if<const DeviceBuffer*>(&argument))
      store(static_cast<const CudaBuffer&>(**buffer).memory);
    else if (const auto* number = std::get_if<std::uint32_t>(&argument))
      store(*number);
    else
      store(std::get<glm::uvec4>(argument));
    addresses_.push_back(&value);
  }
}

void throwUnknownKernel(std::string_view name) {
  throw std::logic_error("no kernel is called " + std::string(name));
}

}  // namespace haarlight
