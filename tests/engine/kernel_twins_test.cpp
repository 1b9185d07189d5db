#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/cuda/cuda_host_kernels.h"
#include "kernel_sources.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

const std::filesystem::path openClFolder = HAARLIGHT_SOURCE_DIR "/opencl";
const std::filesystem::path cudaFolder = HAARLIGHT_SOURCE_DIR "/cuda";

/// Names, without their ending, of the folder's kernel files.
std::set<std::string> fileNames(const std::filesystem::path& folder, const std::string& ending) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ending) names.insert(entry.path().stem());
  return names;
}

std::string openClSource(const std::string& name) {
  return readFile(openClFolder / (name + ".cl"));
}
std::string cudaSource(const std::string& name) {
  return readFile(cudaFolder / (name + ".cu"));
}

/// Whether the file serves work-items of all lanes alone, which CUDA does not have.
bool isForTilesOnly(const std::string& source) {
  return !helperNames(source).empty() && helperNames(oneLaneSource(source)).empty() &&
         kernelDeclarations(source).empty();
}

/// Names of the OpenCL files that must have twins.
std::set<std::string> namesWithTwins() {
  std::set<std::string> names = fileNames(openClFolder, ".cl");
  std::erase_if(names, [](const std::string& name) { return isForTilesOnly(openClSource(name)); });
  return names;
}

const char* const openClExample = R"(
// HAARLIGHT_KERNEL void commentedOut(__global uint* restrict x) {}
inline float4 first(float4 a) { return a; }
inline LaneInt second(int a) { return a; }
HAARLIGHT_KERNEL void copy(__global const float4* restrict from, const uint count,
                           __global float4* restrict to) { })";

std::vector<std::string> differencesFromExample(const std::string& cuda) {
  return twinDifferences(kernelDeclarations(openClExample), kernelDeclarations(cuda));
}

}  // namespace

TEST_CASE("kernels are read from OpenCL source") {
  const auto kernels = kernelDeclarations(openClExample);
  CHECK(kernels == std::vector<KernelDeclaration>{
                       {"copy", {"const float4 * from", "const uint count", "float4 * to"}}});
  CHECK(helperNames(openClExample) == std::vector<std::string>{"first", "second"});
}

TEST_CASE("of code that is written for two shapes, twins share the one for one lane") {
  const std::string source =
      "a\n#if LANES_PER_ITEM == 1\nb\n#else\nc\n#endif\nd\n"
      "#if LANES_PER_ITEM == 1\ne\n#else\nf\n#endif\n";
  CHECK(oneLaneSource(source) == "a\nb\nd\ne\n");
  CHECK(oneLaneSource("a\n#if OTHER\nb\n#else\nc\n#endif\n") ==
        "a\n#if OTHER\nb\n#else\nc\n#endif\n");
}

TEST_CASE("only what is written for all lanes alone needs no twin") {
  const std::string tiles = "#if LANES_PER_ITEM == 1\n#else\ninline int a(int b) {}\n#endif\n";
  CHECK(isForTilesOnly(tiles));
  CHECK(!isForTilesOnly(tiles + "inline int c(int d) {}\n"));
  CHECK(!isForTilesOnly("#define LANES 32\n"));
  CHECK(!isForTilesOnly(openClExample));
}

TEST_CASE("twins differ in no more than how the languages mark pointers") {
  CHECK(differencesFromExample("HAARLIGHT_KERNEL void copy(const float4* __restrict__ from,\n"
                               "    const uint count, float4* __restrict__ to) {}")
            .empty());
}

TEST_CASE("twins with missing, exchanged or other parameters are noticed, and missing twins") {
  const std::vector<std::string> otherParameters{"copy takes other parameters in CUDA"};
  for (const char* const parameters :
       {"const float4* __restrict__ from, float4* __restrict__ to",
        "const float4* __restrict__ from, float4* __restrict__ to, const uint count",
        "const float4* __restrict__ to, const uint count, float4* __restrict__ from",
        "const float4* __restrict__ from, const int count, float4* __restrict__ to",
        "const float4* __restrict__ from, const uint count, uint4* __restrict__ to"}) {
    CAPTURE(parameters);
    CHECK(differencesFromExample(std::string("HAARLIGHT_KERNEL void copy(") + parameters +
                                 ") {}") == otherParameters);
  }
  CHECK(differencesFromExample("HAARLIGHT_KERNEL void paste(uint* __restrict__ to) {}") ==
        std::vector<std::string>{"copy has no CUDA twin", "paste has no OpenCL twin"});
}

TEST_CASE("every kernel has a twin with the same parameters") {
  const auto names = namesWithTwins();
  REQUIRE(names == fileNames(cudaFolder, ".cu"));
  std::size_t kernels = 0;
  for (const std::string& name : names) {
    CAPTURE(name);
    const auto openCl = kernelDeclarations(openClSource(name));
    CHECK(twinDifferences(openCl, kernelDeclarations(cudaSource(name))) ==
          std::vector<std::string>{});
    CHECK(helperNames(oneLaneSource(openClSource(name))) == helperNames(cudaSource(name)));
    kernels += openCl.size();
  }
  CHECK(kernels == cudaHostKernels().size());
}

TEST_CASE("every CUDA kernel is registered") {
  std::set<std::string> written, registered;
  for (const std::string& name : fileNames(cudaFolder, ".cu"))
    for (const KernelDeclaration& kernel : kernelDeclarations(cudaSource(name)))
      written.insert(kernel.name);
  for (const CudaHostKernel& kernel : cudaHostKernels()) registered.emplace(kernel.signature.name);
  CHECK(written == registered);
}

TEST_CASE("words beyond the budget are noticed") {
  using Words = std::vector<std::string>;
  CHECK(forbiddenWords("double x; // double") == Words{"double"});
  CHECK(forbiddenWords("x * 0.5 + 0.5f + 0x1p-15f + 1.0e-3") == Words{"0.5", "1.0e-3"});
  CHECK(forbiddenWords("y = __shfl_xor_sync(mask, y, 1);") == Words{"__shfl_xor_sync"});
  CHECK(forbiddenWords("y = sub_group_reduce_add(y);") == Words{"sub_group_reduce_add"});
  CHECK(forbiddenWords("read_only image2d_t picture") == Words{"image2d_t"});
  CHECK(forbiddenWords("atomicAdd(sum, rsqrtf(x))") == Words{"atomicAdd", "rsqrtf"});
  CHECK(forbiddenWords("divisor = directionBin(x, y, z) * reduced") == Words{});
}

TEST_CASE("kernels keep to the budget: single precision, no shuffles, atomics or images") {
  for (const std::string& name : fileNames(openClFolder, ".cl")) {
    CAPTURE(name);
    CHECK(forbiddenWords(openClSource(name)) == std::vector<std::string>{});
    CHECK(forbiddenWords(cudaSource(name)) == std::vector<std::string>{});
  }
}
