#include "engine/opencl/opencl_program.h"

#include <cstdlib>
#include <stdexcept>

#include "base/file.h"
#include "embedded/kernels.h"
#include "engine/shading_tables.h"
#include "haar/occlusion_transform.h"
#include "visibility/sphere_bin.h"

namespace haarlight {

namespace {

std::string define(const std::string& name, int value) {
  return "#define " + name + " " + std::to_string(value) + "\n";
}

std::string constants(int lanesPerItem) {
  return "// Constants of the host.\n" + define("LANES", partialSums) +
         define("LANES_PER_ITEM", lanesPerItem) + define("FACES", faceCount) +
         define("FACE_SIZE", faceSize) + define("BIT_CUBE_ROWS", bitCubeRows) +
         define("RADIUS_BINS", radiusBins) + define("HORIZON_FACTOR", int(horizonFactor)) +
         define("COARSE_COEFFICIENTS", coarseCoefficientsPerFace) +
         define("COARSE_MEANS", coarseMeansPerFace) + define("BLOCKS", blockCount) +
         define("BLOCKS_PER_FACE", blocksPerFace) + define("BLOCKS_PER_SIDE", blocksPerSide) +
         define("BLOCK_TABLE_STRIDE", blockTableStride) + define("TERM_DETAILS", termDetails);
}

}  // namespace

std::string openClSource(int lanesPerItem) {
  std::string source = constants(lanesPerItem);
  for (const char* file :
       {"lanes.cl", "sphere_bin.cl", "merge_bit_cubes.cl", "merge_bit_cubes_exactly.cl",
        "transform_occlusion.cl", "triple_product.cl"})
    source += embedded::kernels(file);
  return source;
}

cl::Program buildOpenClProgram(const cl::Context& context, const cl::Device& device,
                               int lanesPerItem) {
  const std::string source = openClSource(lanesPerItem);
  if (const char* dump = std::getenv("HAARLIGHT_DUMP_KERNELS")) writeFileAtomically(dump, source);
  cl::Program program(context, source);
  try {
    program.build({device}, "-cl-std=CL1.1");
  } catch (const cl::Error& error) {
    throw std::runtime_error("OpenCL kernels do not build on " + device.getInfo<CL_DEVICE_NAME>() +
                             " (error " + std::to_string(error.err()) + "):\n" +
                             program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device));
  }
  return program;
}

}  // namespace haarlight
