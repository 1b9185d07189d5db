#include "engine/opencl/opencl_program.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "base/file.h"
#include "embedded/kernels.h"
#include "engine/kernel_constants.h"

namespace haarlight {

namespace {

std::string define(const std::string& name, int value) {
  return "#define " + name + " " + std::to_string(value) + "\n";
}

std::string constants(const KernelShape& shape) {
  std::string text = "// Constants of the host.\n";
#define CONSTANT(name, value) text += define(#name, value);
  HAARLIGHT_KERNEL_CONSTANTS(CONSTANT)
#undef CONSTANT
  return text + define("LANES_PER_ITEM", shape.lanesPerItem) +
         define("SAMPLES_PER_GROUP", shape.samplesPerGroup);
}

std::string kernelText(const std::string& fileName) {
  if (const char* folder = std::getenv("HAARLIGHT_KERNELS")) {
    const auto path = std::filesystem::path(folder) / fileName;
    if (std::filesystem::exists(path)) {
      const auto bytes = readWholeFile(path, "kernel");
      return {bytes.begin(), bytes.end()};
    }
  }
  return std::string(embedded::kernels(fileName));
}

}  // namespace

std::string openClSource(const KernelShape& shape) {
  std::string source = constants(shape);
  for (const char* file : {"lanes.cl",
                           "canonical_sum.cl",
                           "move_spheres.cl",
                           "seen_spheres.cl",
                           "sphere_bin.cl",
                           "sphere_table_entries.cl",
                           "bit_cube_rows.cl",
                           "merge_bit_cubes.cl",
                           "caps.cl",
                           "cap_rows.cl",
                           "tile_reach.cl",
                           "merge_bit_cubes_exactly.cl",
                           "transform_occlusion.cl",
                           "blend_radiance.cl",
                           "triple_product.cl",
                           "spread_weights.cl",
                           "shade.cl",
                           "float_functions.cl",
                           "sphere_logarithms.cl",
                           "shexp.cl",
                           "transfer.cl"})
    source += kernelText(file);
  return source;
}

OpenClProgram::OpenClProgram(const cl::Context& context, const cl::Device& device,
                             const KernelShape& shape) {
  const std::string source = openClSource(shape);
  if (const char* dump = std::getenv("HAARLIGHT_DUMP_KERNELS")) writeFileAtomically(dump, source);
  const auto start = std::chrono::steady_clock::now();
  program_ = cl::Program(context, source);
  try {
    program_.build({device}, "-cl-std=CL1.1");
  } catch (const cl::Error& error) {
    throw std::runtime_error("OpenCL kernels do not build on " + device.getInfo<CL_DEVICE_NAME>() +
                             " (error " + std::to_string(error.err()) + "):\n" +
                             program_.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  buildSeconds_ = seconds.count();
}

cl::Kernel& OpenClProgram::kernel(std::string_view name) {
  const auto found = kernels_.find(name);
  if (found != kernels_.end()) return found->second;
  return kernels_.emplace(name, cl::Kernel(program_, std::string(name).c_str())).first->second;
}

}  // namespace haarlight
