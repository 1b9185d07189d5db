# The one place where floating-point and warning flags are set (docs/numerics.md).
#
# The numeric contract asks for the same bits on every engine, so the compiler may neither fuse a
# multiplication with an addition nor reorder sums: fused operations are written std::fma.
add_library(haarlight_compiler_settings INTERFACE)
target_compile_options(haarlight_compiler_settings INTERFACE
  -ffp-contract=off -fno-fast-math -Wall -Wextra -Wpedantic -Wshadow)
