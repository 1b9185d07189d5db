#pragma once

/// Reads kernels from their source text, OpenCL C or CUDA.

#include <string>
#include <vector>

namespace haarlight::test {

struct KernelDeclaration {
  std::string name;
  /// Type and name of every parameter, without what the languages write differently:
  /// `__global const float4* restrict x` and `const float4* __restrict__ x` are `const float4 * x`.
  std::vector<std::string> parameters;

  bool operator==(const KernelDeclaration&) const = default;
};

std::string withoutComments(const std::string& source);

/// What HAARLIGHT_KERNEL declares.
std::vector<KernelDeclaration> kernelDeclarations(const std::string& source);

/// The source as it is for work-items of one lane, which the CUDA twin is written for: of every
/// "#if LANES_PER_ITEM == 1", the part before "#else".
std::string oneLaneSource(const std::string& source);

/// Names of the inline functions, in their order.
std::vector<std::string> helperNames(const std::string& source);

/// How the kernels differ, a line each; nothing when they are twins.
std::vector<std::string> twinDifferences(const std::vector<KernelDeclaration>& openCl,
                                         const std::vector<KernelDeclaration>& cuda);

/// What the budget (cuda/README.md) forbids and the source uses: double precision, functions across
/// a warp, atomics, images, quotients and roots by the language's functions.
std::vector<std::string> forbiddenWords(const std::string& source);

}  // namespace haarlight::test
