# The one place where floating-point and warning flags are set (docs/numerics.md).
#
# The numeric contract asks for the same bits on every engine, so the compiler may neither fuse a
# multiplication with an addition nor reorder sums: fused operations are written std::fma.
add_library(haarlight_compiler_settings INTERFACE)
target_compile_options(haarlight_compiler_settings INTERFACE
  -ffp-contract=off -fno-fast-math -Wall -Wextra -Wpedantic -Wshadow)
# GCC 12 warns of overlapping copies in "text" + std::string that do not overlap (its bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(haarlight_compiler_settings INTERFACE -Wno-restrict)
  if(HAARLIGHT_PRECOMPILE_HEADERS)  # of which it then no longer knows that they are a library's
    target_compile_options(haarlight_compiler_settings INTERFACE -Wno-stringop-overflow -Wno-array-bounds)
  endif()
endif()

# The same for nvcc, where fused operations are written __fmaf_rn. (GLM's headers mark functions in
# a way that nvcc remarks on.)
add_library(haarlight_cuda_compiler_settings INTERFACE)
target_compile_options(haarlight_cuda_compiler_settings INTERFACE
  -fmad=false -Xcompiler=-ffp-contract=off,-Wall,-Wextra --diag-suppress=20012)
