#pragma once

/// What a scene file says, as plain data (docs/scene.md). Coordinates are right-handed with y up,
/// in world units of the user's choice; angles are in degrees and turn counter-clockwise seen from
/// the tip of their axis; colours are linear RGB with Rec. 709 primaries.

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "light/sky_settings.h"
#include "scene/fit_objective.h"
#include "scene/motion_description.h"
#include "solids/shapes.h"
#include "visibility/visibility_kind.h"

namespace haarlight {

/// What an object's lowest point is put on before it is translated.
enum class Rest { None, Ground };

/// How an object is placed: its points go through the fields in the order given here (see
/// objectToWorld in scene/transform.h).
struct TransformDescription {
  /// When given, the mesh's bounding box is centred at the origin and its longest side scaled to
  /// this length (world units).
  std::optional<double> fit;
  /// Factor along each of the mesh's own axes.
  glm::dvec3 scale{1, 1, 1};
  /// Rotation about x, then about y, then about z; the axes stay where they are.
  glm::dvec3 rotateDegrees{0, 0, 0};
  /// Ground: moved along y until the lowest point lies on the receiver plane (y = 0 without one).
  Rest rest = Rest::None;
  /// Moved by this much at last (world units).
  glm::dvec3 translate{0, 0, 0};
};

/// A mesh or a solid that is seen, receives shadows and, unless told otherwise, casts them.
struct ObjectDescription {
  /// For messages and for choosing an object; see defaultObjectName (scene/scene_file.h).
  std::string name;
  /// Path of a mesh or glTF file, or a name of builtinMeshNames (mesh/builtin_meshes.h); empty:
  /// there is a solid.
  std::string mesh;
  /// Instead of a mesh. Its transform has no `fit` and the same scale along all axes; it has
  /// neither deformation nor transfer.
  std::optional<Shape> solid;
  /// Objects of one family get a node of their own in the tree of boxes that hard shadows are found
  /// by (shadow/box_tree.h).
  std::optional<std::string> family;
  TransformDescription transform;
  /// Diffuse reflectance, 0 to 1.
  glm::dvec3 albedo{0.5, 0.5, 0.5};
  /// How many spheres to fit to the mesh, or the file that holds a set fitted before.
  std::variant<int, std::filesystem::path> spheres = 64;
  /// What the fit of that many spheres makes small.
  FitObjective objective = FitObjective::shadow;
  /// Whether the object blocks light.
  bool castsShadow = true;
  /// Precomputed transfer of the mesh as its file has it, for the method sh; nothing: computed at
  /// the start, with the shadows of the whole scene.
  std::optional<std::filesystem::path> transfer;
  /// How the mesh changes its shape; nothing: not at all, or as a glTF file's first animation says.
  std::optional<DeformationDescription> deformation;
  /// How the object moves after `transform`.
  std::optional<MotionDescription> motion;
};

/// A horizontal rectangle (normal +y) that receives shadows on a grid of samples.
struct ReceiverDescription {
  /// World units.
  glm::dvec3 center{0, 0, 0};
  /// Extent along x and z, world units.
  glm::dvec2 size{8, 8};
  /// Number of samples along x and z.
  glm::ivec2 samples{128, 128};
  /// Diffuse reflectance, 0 to 1.
  glm::dvec3 albedo{0.5, 0.5, 0.5};
};

/// Light as it was measured at a place of the scene.
struct LightSampleDescription {
  /// World units.
  glm::dvec3 position{0, 0, 0};
  /// As LightDescription has them; rotation and scale come on top of the light's.
  std::string source;
  std::string layout = "auto";
  double rotateDegrees = 0;
  double scale = 1;
};

/// The distant light all around.
struct LightDescription {
  /// Path of an EXR or Radiance HDR image, or a name of builtinLightNames
  /// (light/builtin_lights.h).
  std::string source = "builtin:lamps";
  /// How the image covers the sphere of directions, one of lightLayouts (scene/names.h); "auto": by
  /// its aspect ratio.
  std::string layout = "auto";
  /// Rotation of the light about +y: what came from +z then comes from +z turned towards +x.
  double rotateDegrees = 0;
  /// Factor on the radiance, >= 0.
  double scale = 1;
  std::optional<LightMotionDescription> motion;
  /// Where the sun stands and what else a source that is a sky leaves open; nothing: the defaults.
  std::optional<SkySettings> sky;
  /// Near light, for the method sh: these shine on surfaces instead of `source`, blended by the
  /// inverse squares of their distances.
  std::vector<LightSampleDescription> samples;
};

/// A light at one point, with hard shadows.
struct PointLightDescription {
  /// World units.
  glm::dvec3 position{0, 0, 0};
  /// W/sr: a white diffuse surface that faces the light at the distance r has the radiance
  /// intensity / (π r²).
  glm::dvec3 intensity{0, 0, 0};
  std::optional<PointLightMotionDescription> motion;
};

/// A light so far away that its rays are parallel, with hard shadows.
struct DirectionalLightDescription {
  /// From the scene to the light; of any length but 0.
  glm::dvec3 towards{0, 1, 0};
  /// On a surface that faces the light.
  glm::dvec3 irradiance{0, 0, 0};
  std::optional<DirectionalLightMotionDescription> motion;
};

/// A pinhole camera.
struct CameraDescription {
  /// World units.
  glm::dvec3 position{0, 4, 8};
  /// The point in the middle of the image; differs from the position.
  glm::dvec3 target{0, 0.5, 0};
  /// Any vector that is not parallel to the line of sight; the image's upward side.
  glm::dvec3 up{0, 1, 0};
  /// Angle between the lower and the upper edge of the image.
  double verticalFieldOfViewDegrees = 40;
  std::optional<CameraMotionDescription> motion;
};

/// The image that is computed.
struct ImageDescription {
  /// Pixels.
  int width = 960;
  int height = 540;
  /// Camera rays per pixel.
  int samplesPerPixel = 4;
  /// The image is multiplied by 2^exposure before tone mapping; nothing: chosen from the image.
  std::optional<double> exposure;
  /// Radiance where nothing is seen; nothing: the light itself.
  std::optional<glm::dvec3> background;
};

/// Haar: triple products of wavelet coefficients. Pixel: sum over the texels of the cube, blocked
/// by the spheres. PixelMesh: the same, blocked by the meshes (the reference image). Shexp: the
/// spheres' visibility in spherical harmonics. Sh: diffuse transfer of meshes that stand still,
/// precomputed in spherical harmonics.
enum class ShadingMethod { Haar, Pixel, PixelMesh, Shexp, Sh };

/// Where the method sh multiplies light by transfer: at vertices, between which radiance is
/// interpolated, or at pixels, for which transfer is interpolated.
enum class ShadedPer { vertex, pixel };

/// Which engine computes. Auto: OpenCL when there is a device, else the reference engine.
enum class EngineChoice { Auto, Reference, OpenCl, Cuda, CudaHost };

struct ShadingDescription {
  ShadingMethod method = ShadingMethod::Haar;
  /// Number of the light's largest Haar coefficients that are kept, besides the six face means;
  /// 6144 keeps all.
  int terms = 200;
  /// 1: visibility coefficients down to squares of 4x4 texels; 2: down to the texel.
  int levels = 2;
  /// Bands of spherical harmonics of the methods shexp and sh; nothing: what the method takes when
  /// not told.
  std::optional<int> order;
  ShadedPer per = ShadedPer::vertex;
  /// How the spheres' visibility is found, for the methods haar and pixel.
  VisibilityKind visibility = VisibilityKind::exact;
  EngineChoice engine = EngineChoice::Auto;
  /// Of the hard shadows of point and directional lights: the largest edge of the octrees' smallest
  /// cells in world units; nothing: a 512th of the scene's longest side.
  std::optional<double> shadowDetail;
};

struct SceneDescription {
  /// Of the file format.
  int version = 1;
  std::vector<ObjectDescription> objects;
  std::optional<ReceiverDescription> receiver;
  LightDescription light;
  std::vector<PointLightDescription> pointLights;
  std::vector<DirectionalLightDescription> directionalLights;
  CameraDescription camera;
  ImageDescription image;
  ShadingDescription shading;
  AnimationDescription animation;
};

}  // namespace haarlight
