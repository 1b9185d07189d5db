#pragma once

/// The words that stand for choices, in scene files and on the command line.

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/scene_description.h"

namespace haarlight {

template <typename Choice>
struct Named {
  std::string_view name;
  Choice choice;
};

inline constexpr std::string_view builtinPrefix = "builtin:";

inline constexpr std::array<std::string_view, 5> builtinScenes{"builtin:default", "builtin:smooth",
                                                               "builtin:twist", "builtin:lamp-knot",
                                                               "builtin:cone-and-sphere"};

inline constexpr std::array<Named<Rest>, 2> restNames{{
    {"none", Rest::None},
    {"ground", Rest::Ground},
}};

/// "auto", and what chooseLayout (light/layout.h) knows.
inline constexpr std::array<std::string_view, 5> lightLayouts{"auto", "latlong", "vcross", "hcross",
                                                              "angular"};

inline constexpr std::array<Named<ShadingMethod>, 5> shadingMethodNames{{
    {"haar", ShadingMethod::Haar},
    {"pixel", ShadingMethod::Pixel},
    {"pixel-mesh", ShadingMethod::PixelMesh},
    {"shexp", ShadingMethod::Shexp},
    {"sh", ShadingMethod::Sh},
}};

inline constexpr std::array<Named<ShadedPer>, 2> shadedPerNames{{
    {"vertex", ShadedPer::vertex},
    {"pixel", ShadedPer::pixel},
}};

inline constexpr std::array<Named<VisibilityKind>, 2> visibilityKindNames{{
    {"exact", VisibilityKind::exact},
    {"table", VisibilityKind::table},
}};

inline constexpr std::array<Named<FitObjective>, 2> fitObjectiveNames{{
    {"cover", FitObjective::cover},
    {"shadow", FitObjective::shadow},
}};

inline constexpr std::array<Named<Axis>, 3> axisNames{{
    {"x", Axis::x},
    {"y", Axis::y},
    {"z", Axis::z},
}};

inline constexpr std::array<Named<Ease>, 3> easeNames{{
    {"linear", Ease::linear},
    {"smooth", Ease::smooth},
    {"hold", Ease::hold},
}};

inline constexpr std::array<Named<Repeat>, 3> repeatNames{{
    {"hold", Repeat::hold},
    {"loop", Repeat::loop},
    {"pingpong", Repeat::pingpong},
}};

constexpr std::string_view nameOf(FitObjective objective) {
  return std::ranges::find(fitObjectiveNames, objective, &Named<FitObjective>::choice)->name;
}

inline constexpr std::array<Named<EngineChoice>, 5> engineChoiceNames{{
    {"auto", EngineChoice::Auto},
    {"reference", EngineChoice::Reference},
    {"opencl", EngineChoice::OpenCl},
    {"cuda", EngineChoice::Cuda},
    {"cuda-host", EngineChoice::CudaHost},
}};

}  // namespace haarlight
