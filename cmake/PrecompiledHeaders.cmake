# Standard headers and GLM's take longer to parse than most files of ours. Every file includes what it needs
# all the same: builds without this option find out.
option(HAARLIGHT_PRECOMPILE_HEADERS "Parse headers of libraries once for all files that share them" OFF)

function(haarlight_precompile_headers target)
  if(HAARLIGHT_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} PRIVATE
      <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <memory> <optional> <span>
      <string> <string_view> <vector> <glm/geometric.hpp> <glm/vec3.hpp> ${ARGN})
  endif()
endfunction()

# Takes those of another target that is compiled with the same options.
function(haarlight_share_precompiled_headers target other)
  if(HAARLIGHT_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()
