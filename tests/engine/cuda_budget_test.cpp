#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <regex>
#include <stdexcept>

#include "engine/cuda/cuda_host_kernels.h"
#include "engine/shading_tables.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// What nvcc says that a kernel needs on one architecture.
struct Usage {
  std::string kernel;
  std::string architecture;
  int registersPerThread = 0;
  int sharedBytes = 0;
};

constexpr int threadsPerBlock = partialSums * maximumSamplesPerGroup;
constexpr int registersPerBlock = 65536;
constexpr int sharedBytesPerBlock = 16384;

bool fits(const Usage& usage) {
  return usage.sharedBytes <= sharedBytesPerBlock &&
         usage.registersPerThread * threadsPerBlock <= registersPerBlock;
}

/// Reads what `nvcc --resource-usage` prints.
std::vector<Usage> readUsages(const std::string& text) {
  static const std::regex usage(
      R"(Compiling entry function '(\w+)' for '(sm_\w+)'[\s\S]*?Used (\d+) registers([^\n]*))");
  static const std::regex shared(R"((\d+) bytes smem)");
  std::vector<Usage> usages;
  for (std::sregex_iterator match(text.begin(), text.end(), usage), end; match != end; ++match) {
    usages.push_back({(*match)[1], (*match)[2], std::stoi((*match)[3]), 0});
    const std::string rest = (*match)[4];
    std::smatch bytes;
    if (std::regex_search(rest, bytes, shared)) usages.back().sharedBytes = std::stoi(bytes[1]);
  }
  return usages;
}

/// What a command prints. Throws when it fails.
std::string outputOf(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot start " + command);
  std::string output;
  std::array<char, 4096> part;
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe))
    output.append(part.data(), count);
  if (pclose(pipe) != 0) throw std::runtime_error(command + " failed:\n" + output);
  return output;
}

}  // namespace

TEST_CASE("what nvcc says of a kernel's needs is read") {
  const auto usages = readUsages(
      "ptxas info    : Compiling entry function '_Z4mainv' for 'sm_75'\n"
      "ptxas info    : Function properties for _Z4mainv\n"
      "    0 bytes stack frame, 0 bytes spill stores, 0 bytes spill loads\n"
      "ptxas info    : Used 80 registers, used 1 barriers, 16385 bytes smem, 504 bytes cmem[0]\n"
      "ptxas info    : Compiling entry function '_Z4restv' for 'sm_90'\n"
      "ptxas info    : Used 257 registers, used 0 barriers\n"
      "ptxas info    : Compiling entry function '_Z4goodv' for 'sm_90'\n"
      "ptxas info    : Used 256 registers, 16384 bytes smem\n");
  REQUIRE(usages.size() == 3);
  CHECK(usages[0].kernel == "_Z4mainv");
  CHECK(usages[0].architecture == "sm_75");
  CHECK(usages[0].registersPerThread == 80);
  CHECK(usages[0].sharedBytes == 16385);
  CHECK_FALSE(fits(usages[0]));
  CHECK_FALSE(fits(usages[1]));
  CHECK(fits(usages[2]));
}

TEST_CASE("CUDA kernels fit into 16 KiB of shared memory and can be launched with 256 threads") {
  const std::string command = HAARLIGHT_NVCC_COMMAND;
  if (command.empty()) {
    std::printf("SKIPPED: this build has no CUDA engine for architectures given by number\n");
    return;
  }
  const TemporaryFolder folder;
  const auto usages =
      readUsages(outputOf(command + " --resource-usage -o " + (folder / "kernels.o").string()));
  for (const CudaHostKernel& kernel : cudaHostKernels()) {
    const std::string name(kernel.signature.name);
    const auto isKernel = [&](const Usage& usage) {
      return usage.kernel.find(std::to_string(name.size()) + name) != std::string::npos;
    };
    CAPTURE(name);
    CHECK(std::ranges::count_if(usages, isKernel) == HAARLIGHT_NVCC_ARCHITECTURES);
  }
  for (const Usage& usage : usages) {
    CAPTURE(usage.kernel);
    CAPTURE(usage.architecture);
    CAPTURE(usage.sharedBytes);
    CAPTURE(usage.registersPerThread);
    CHECK(fits(usage));
  }
}
