#pragma once
// Mistakes inside a student's ray tracer, as plain data: an enumeration for each family, whose
// first value is correct. Mistakes that can be expressed by another scene, camera or finished
// picture are in hypotheses.h.

#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace scenefile {

enum class NormalMistake : std::uint8_t {
  none,
  by_matrix,                     ///< transformed like a direction
  by_inverse,                    ///< by the inverse, not transposed
  by_transpose,                  ///< by the transpose, not inverted
  of_object,                     ///< not transformed at all
  absolute,                      ///< |n|, by component
  inverted,                      ///< pointing inward
  toward_eye,                    ///< flipped toward the eye
  not_normalized,                ///< normalized in object space only
  raw_not_normalized,            ///< curved sides: as long as the distance from the axis
  gradient_not_normalized,       ///< as long as the gradient of the shape's equation
  cone_gradient_not_normalized,  ///< ... on cones; otherwise like raw_not_normalized
  matrix_not_normalized,         ///< transformed like a direction, and not normalized
  translated,                    ///< transformed like a point, with the translation
  inverse_translated,            ///< (n, 1) by the inverse of the 4x4 matrix
  right_translated,              ///< the normal matrix, plus the translation
  four_normalized,               ///< (n, 0) by the 4x4 inverse transpose; w counts in the length
  four_normalized_w1,            ///< ... (n, 1)
};

enum class ConeNormalMistake : std::uint8_t {
  none,
  level,
  like_sphere,
  half_slope,
  double_slope,
  four_slopes,
  slope_down,
  constant_y,       ///< (x, 1/2, z)
  half_constant_y,  ///< (x, 1/4, z)
  from_apex,        ///< the vector from the apex
};

enum class NearestMistake : std::uint8_t {
  none,
  first_of_ties,               ///< of equal distances, the first object of the file wins
  farthest,                    ///< the farthest hit wins
  farthest_object,             ///< the farthest of the nearest hits of each object wins
  last,                        ///< the last object of the file wins
  first,                       ///< the first object of the file wins
  object_distance,             ///< t of rays that are normalized in object space
  object_distance_compared,    ///< ... only when objects are compared
  object_distance_everywhere,  ///< ... and for shadow rays
  far_root,                    ///< the farther hit of each object
  near_root_only,              ///< no hit if the nearer root is negative
  behind,                      ///< hits with negative t count too
  behind_first,                ///< ... and the smallest t wins, even if negative
};

enum class LightVectorMistake : std::uint8_t {
  none,
  not_normalized,  ///< vectors to point lights and spotlights
  reversed,        ///< vectors to all lights
  reversed_directional,
  reversed_positional,
  reversed_shading,  ///< only for shading; shadow rays are right
  reversed_directional_shading,
  reversed_positional_shading,
  position_as_direction,  ///< directional lights: uses their position
  directional_as_long_as_written,
  spot_as_long_as_written,
  as_long_as_written,     ///< directions of lights are not normalized
  to_origin,              ///< the direction from the origin, at every point
  to_origin_all,          ///< ... also for the falloff of spotlights and shadow rays
  from_object_point,      ///< to point and spot lights: from the point in object space
  from_object_point_all,  ///< ... also for the distance and shadow rays
  sum,                    ///< position of the light plus the point, not minus
  sum_all,                ///< ... also for the falloff of spotlights and shadow rays
};

enum class AttenuationMistake : std::uint8_t {
  none,
  absent,
  inverse_square,
  inverse,
  inverse_square_unlimited,
  inverse_unlimited,
  one_plus_square,  ///< 1 / (1 + d^2)
  no_quadratic,
  no_linear,
  no_constant,
  not_clamped,
  squared,
  reversed_coefficients,
  multiplied,    ///< multiplied by the polynomial instead of divided
  diffuse_only,  ///< highlights are not attenuated
  specular_only,
  one_plus,                 ///< 1 / (1 + polynomial)
  squared_distance,         ///< the squared distance is used as the distance
  to_eye,                   ///< by the distance from the light to the eye
  eye_to_point,             ///< by the distance from the eye to the point
  from_origin,              ///< by the distance from the world's origin to the light
  spots_only,               ///< point lights do not fade
  points_only,              ///< spotlights do not fade
  clamped_below,            ///< max(1, f)
  infinite_white,           ///< not clamped: 1 / 0 is infinite, and 0 * infinity is stored as 255
  infinite_black,           ///< ... stored as 0
  specular_only_with_cone,  ///< the diffuse term has no falloff of spotlights, either
  diffuse_only_with_cone,   ///< the specular term has no falloff of spotlights, either
};

enum class SpotMistake : std::uint8_t {
  none,
  linear,
  in_cosine,  ///< smoothstep between cosines
  linear_in_cosine,
  inverted,           ///< full light outside, none inside
  penumbra_inverted,  ///< 1 - falloff in the penumbra
  no_limit,           ///< falloff not clamped outside: light beyond the cone
  squared,
  quadratic,         ///< (1 - t)^2
  one_minus_square,  ///< 1 - t^2
  cosine_power,
  reversed_axis,
  inner_only_penumbra,  ///< no light between the two angles
};

enum class ShadowMistake : std::uint8_t {
  none,
  reversed,           ///< the ray points away from the light
  beyond_light,       ///< objects behind the light cast shadows
  ambient_only,       ///< once in shadow, all later lights are ignored too
  stops,              ///< lights after the first one in shadow are ignored
  black,              ///< in shadow of any light: black, even ambient
  resets,             ///< ... but later lights are added
  no_ambient_if_all,  ///< in shadow of every light: black
  keeps_specular,     ///< shadows only remove diffuse light
  keeps_diffuse,
  half,             ///< shadows remove half of the light
  spot_along_axis,  ///< the shadow ray of a spotlight runs along its axis
  spot_without,
  point_without,
  directional_without,
  directional_only,     ///< point lights and spotlights cast no shadows
  first_light_for_all,  ///< the first light's shadow applies to all
  glass_lets_through,
  not_own_object,              ///< an object does not shadow itself
  any_nearer_than_eye,         ///< compared with the distance to the eye
  positional_nearer_than_eye,  ///< ... for point lights and spotlights
  unit_length,                 ///< only objects nearer than 1 cast shadows
  direction_unnormalized_far,  ///< shadow rays to directional lights have length 1
  squared_distance,            ///< compared with the square of the light's distance
  directional_ends_at_position,
  light_to_eye,          ///< compared with the distance from the light to the eye
  light_from_origin,     ///< compared with the light's distance from the world's origin
  object_distance,       ///< t of rays that are normalized in object space
  only_camera_rays,      ///< no shadows in reflections
  from_eye,              ///< the ray starts at the eye
  from_origin,           ///< the ray starts at the world's origin
  point_as_directional,  ///< t ends at 1, but the direction is a unit vector
  inverted,              ///< lit where the light is shadowed
  beyond_light_only,     ///< only objects behind the light cast shadows: > instead of <
  first_object_only,     ///< other objects cast no shadows
  last_object_only,
  first_light_only,  ///< other lights cast no shadows
  last_light_only,
  no_spheres,  ///< spheres cast no shadows
  no_cubes,
  no_cylinders,
  no_cones,
  no_meshes,
};

enum class AmbientMistake : std::uint8_t {
  none,
  times_diffuse,
  times_texture,
  only_texture,  ///< coefficient * texture
  textured,      ///< blended with the texture
  lit_only,
  unlit_only,
  no_in_reflections,
  faded,           ///< added for each light, times its attenuation and falloff
  faded_colored,   ///< ... and color
  faded_shadowed,  ///< ... and lost in its shadow
};

enum class DiffuseMistake : std::uint8_t {
  none,
  no_coefficient,
  absolute,             ///< |N.L|
  absolute_everywhere,  ///< ... in the specular term, too
  not_clamped,          ///< negative values darken
  no_cosine,
  by_view,  ///< N.V
  half_lambert,
  squared,
  no_color,  ///< of the material
  no_light_color,
  color_of_ambient,
  color_of_specular,
};

enum class SpecularMistake : std::uint8_t {
  none,
  blinn,
  blinn_four,  ///< with four times the exponent
  no_coefficient,
  times_cosine,  ///< multiplied by N.L
  lit_side_only,
  absolute,        ///< |R.V|
  negative_power,  ///< R.V below 0 is raised, too
  clamped_mirror,  ///< R is computed with N.L clamped to 0
  no_exponent,
  by_light_view,       ///< L.V
  reversed_mirror,     ///< R has the wrong sign
  by_normal_view,      ///< N.V
  by_normal_light,     ///< N.L
  mirror_not_doubled,  ///< R = (N.L) N - L
  exponent_quarter,
  exponent_double,
  exponent_half,
  exponent_four,
  zero_shines,  ///< exponent 0 gives a uniform highlight
  no_color,
  no_light_color,
  diffuse_color,
  times_diffuse,         ///< both colors
  mirror_of_view_wrong,  ///< uses the ray's direction instead of the direction to the eye
  eye_at_origin,
  looks_along_camera,   ///< uses the camera's axis as the eye vector
  eye_as_direction,     ///< the vector from the world's origin to the eye
  point_as_direction,   ///< the vector from the world's origin to the point
  eye_not_normalized,   ///< as long as the distance to the eye
  ray_not_normalized,   ///< as long as the camera ray to the film at distance 1
  half_not_normalized,  ///< Blinn's, with N.(L + V)
  squared_coefficient,
  times_shininess,
};

enum class TextureMistake : std::uint8_t {
  none,
  blend_ignored,
  times_coefficient,           ///< kd multiplies the texture
  times_coefficient_no_blend,  ///< ... and the blend is ignored
  times_diffuse,               ///< times the diffuse color
  times_diffuse_no_blend,
  blend_reversed,
  added,
  unlit,  ///< not multiplied by N.L
  blue_red,
  gray,
  integer_division,  ///< bytes / 255 as integers: 0 or 1
  bytes,             ///< from 0 to 255, not to 1
  lookup_clamped,    ///< no wrap mode: lookups are clamped to the edge
  divided_repeat,
  white_rest,  ///< the diffuse color's share of the blend is white
  swapped_uv,
  blend_drops_color,       ///< only blend * texture
  decoded,                 ///< from sRGB
  ambient_too,             ///< replaces the ambient color as well
  no_coefficient_on_rest,  ///< the diffuse color's share lacks kd
  over_lighting,           ///< blended with the finished lighting
  over_all,                ///< ... and reflections
  over_lighting_too,       ///< blended with the diffuse color, and with the finished lighting
  over_all_too,            ///< ... and reflections
  filtered,                ///< bilinear, half a texel off
  filtered_centered,       ///< bilinear
  not_filtered,
  averaged,            ///< half diffuse color, half texture
  times_lighting,      ///< the finished lighting is multiplied by the texture
  times_lighting_too,  ///< ... and blended with the diffuse color
  specular_too,        ///< multiplies the specular color as well
  mirrored_repeat,     ///< every other copy is mirrored
  size_less_one,       ///< u and v are multiplied by size - 1
  to_nearest,          ///< u and v times the size are rounded, not truncated
};

enum class UvMistake : std::uint8_t {
  none,
  flip_u,
  flip_v,
  flip_both,
  shift_u,  ///< by half of the texture
  shift_v,
  quarter,
  half,
  three_quarters,  ///< of a turn around the axis
  round_flip_u,    ///< only around the axis
  round_flip_quarter,
  round_flip_half,
  round_flip_three_quarters,
  sphere_linear_v,
  sphere_planar,  ///< x and y, not angles
  sphere_flip_v,
  sides_like_sphere,  ///< v of cylinders and cones is that of spheres
  cube_ends_flip_v,   ///< only on the faces at the top and bottom
  cube_front,         ///< x and y on all faces
  cube_same_faces,    ///< opposite faces have the same u and v
  caps_flip_v,
  caps_as_side,
  caps_polar,  ///< u around the axis, v from the center
  flat_flip_u,
  flat_flip_v,
  sphere_missing,
  cube_missing,
  cylinder_missing,
  cone_missing,
  caps_missing,
};

enum class MirrorMistake : std::uint8_t {
  none,
  no_coefficient,
  color_ignored,        ///< only ks
  neither,              ///< the full reflected color
  specular_color,       ///< ks * specular color
  all_materials,        ///< everything with a highlight reflects
  blended,              ///< mixed with the lighting, not added
  blended_coefficient,  ///< ... by ks * color
  blended_all,
  blended_plain,        ///< ... by ks, without the reflective color
  multiplied,           ///< mixed with the lighting times the reflection, by ks * color
  multiplied_by_color,  ///< ... by the reflective color
  averaged,             ///< half lighting, half reflection
  not_chained,          ///< no weights after the first mirror
  last_weight_only,     ///< only the weight of the last mirror counts
  coefficient_once,     ///< ks only counts at the first mirror
  replaces,             ///< the lighting is dropped
  maximum,              ///< the larger of lighting and reflection
  screened,             ///< 1 - (1 - lighting) (1 - reflection)
  reversed,             ///< the reflected ray points into the surface
  wrong_sign,           ///< d + 2 (d.n) n
  not_doubled,          ///< d - (d.n) n
  from_eye,             ///< the reflected ray starts where the ray started
  along_normal,
  straight,       ///< the ray is not deflected
  eye_at_camera,  ///< highlights in reflections are those for the camera
  no_shadows,
  no_textures,
  no_ambient,
  doubled,
  diffuse_coefficient,
  no_local,  ///< mirrors are not lit
  times_cosine,
  clamped_never,
  times_diffuse,
  white_background,
  halved,
};

enum class GlassMistake : std::uint8_t {
  none,
  no_coefficient,
  color_ignored,
  eta_inverted,
  no_total_reflection,     ///< black where it occurs
  straight,                ///< not refracted
  straight_shaded,         ///< ... and the back wall is lit, and counts as another refraction
  wrong_sign,              ///< of the normal's share in the refracted direction
  one_side,                ///< only refracted on entering
  shaded_inside,           ///< the back wall is lit, and counts as another refraction
  entering_always,         ///< 1 / ior at both walls
  blended,                 ///< mixed with the lighting, by kt * color
  blended_by_color,        ///< ... by the transparent color
  blended_plain,           ///< ... by kt, without the transparent color
  blended_all,             ///< the lighting by 1 - kt, refraction by kt * color
  eta_inverted_black,      ///< inverted; total reflection on entering is black
  eta_inverted_all_black,  ///< inverted; any total reflection is black
  black_inside,            ///< the ray ends at the back wall
  mirrored,                ///< follows the reflected direction
  times_diffuse,
  no_local,
  replaces_all,  ///< only what is seen through the object, without a weight
  ior_one_and_half,
  ior_of_water,
  half,
};

/// Wrong limits and normals of round shapes and cubes.
enum class ShapeMistake : std::uint8_t {
  none,
  no_top_cap,          ///< of cylinders
  no_bottom_cap,       ///< of cylinders and cones
  no_cylinder_bottom,  ///< cones are right
  square_caps,         ///< not cut to a disk
  endless_cylinder,    ///< y is not checked
  endless_cone,        ///< y is not checked: two cones without end
  double_cone,         ///< y is not checked against the apex
  deep_cone,           ///< y is not checked against the base
  endless,             ///< cylinders and cones
  cylinder_normal_like_sphere,
  cube_normals_positive,  ///< faces at -0.5 have the normals of those at 0.5
  cap_normals_up,
  cap_normals_like_side,
  caps_square_half,          ///< the square of the radius is 0.5
  cylinder_square_half,      ///< ... of the sides of cylinders
  cylinder_sides_wide,       ///< sides of cylinders have the radius 1
  sphere_normals_by_matrix,  ///< from the center of the sphere, in world space
  roots_doubled,             ///< roots of quadratic equations are divided by a, not by 2 a
  precedence,                ///< roots are divided by 2, and multiplied by a
  like_sphere,               ///< all normals are those of spheres
  wide_caps,                 ///< the radius is 1
  wide_cone,                 ///< the radius at the base is 1
  cube_normals_like_sphere,
  sphere_normals_inward,
  cube_normals_inward,
  cylinder_normals_inward,  ///< of the side
  cone_normals_inward,      ///< of the side
  side_normals_inward,      ///< of cylinders and cones
};

/// What is shown instead of the lit surface.
enum class ShownInstead : std::uint8_t {
  none,
  normals,
  absolute_normals,
  raw_normals,
  object_normals,
  flat_diffuse,
  flat_ambient_diffuse,
  white
};

/// A function that is linear between its knots, and constant beyond them.
struct Curve {
  std::vector<double> knots;  ///< rising; empty: no function
  std::vector<double> values;
  double at(double x) const;
};

/// How the colors of several lights become one.
enum class LightSum : std::uint8_t {
  none,
  brightest,         ///< the maximum of the lights
  last,              ///< each light replaces those before it
  last_of_all,       ///< ... and the ambient term
  attenuated_again,  ///< what was added before is attenuated, too
  first_of_term,     ///< of one term only the first light counts
  last_of_term,
  replaces_term,  ///< ... and of one term each light that is not shadowed replaces those before it
};

/// The term in LightSum::first_of_term and the like.
enum class LightTerm : std::uint8_t { diffuse, specular };

/// What the directions of rays are in object space.
enum class DirectionMistake : std::uint8_t {
  none,
  translated,  ///< like points (w = 1)
  of_world,    ///< not transformed
};

struct ModelMistakes {
  NormalMistake normals = NormalMistake::none;
  ConeNormalMistake cone_normal = ConeNormalMistake::none;
  bool no_cylinder_caps = false;
  bool no_cone_cap = false;
  bool cap_normals_down = false;
  ShapeMistake shape = ShapeMistake::none;
  std::optional<Shape> caps_of;  ///< the only shape whose caps are too large by `shape`; else all
  NearestMistake nearest = NearestMistake::none;
  LightVectorMistake light_vector = LightVectorMistake::none;
  AttenuationMistake attenuation = AttenuationMistake::none;
  SpotMistake spot = SpotMistake::none;
  ShadowMistake shadow = ShadowMistake::none;
  /// Replaces the attenuation of lights with these coefficients: functions of the distance.
  std::vector<std::pair<glm::vec3, Curve>> fading;
  /// Replaces the falloff of spotlights with these angles, inner and outer: functions of the angle
  /// from the axis. In radians.
  std::vector<std::pair<glm::vec2, Curve>> cone;
  Curve diffuse_response;  ///< replaces max(0, N.L): a function of N.L
  /// Replaces powers of R.V, by exponent: functions of the angle in radians.
  std::vector<std::pair<double, Curve>> highlights;
  std::vector<double> light_lengths;  ///< of the written directions, for as_long_as_written
  double shadow_bias = 1e-3;          ///< along the ray
  double shadow_lift = 0;             ///< along the normal
  double shadow_back = 0;             ///< toward where the ray came from
  double mirror_bias = 1e-3;
  AmbientMistake ambient = AmbientMistake::none;
  DiffuseMistake diffuse = DiffuseMistake::none;
  double diffuse_factor = 1;
  double mirror_factor = 1;
  double glass_factor = 1;
  bool glass_over_mirror = false;  ///< GlassMistake::blended*: mixed with reflections, too
  SpecularMistake specular = SpecularMistake::none;
  std::optional<double> exponent;  ///< the same for all materials
  TextureMistake texture = TextureMistake::none;
  UvMistake uv = UvMistake::none;
  MirrorMistake mirror = MirrorMistake::none;
  GlassMistake glass = GlassMistake::none;
  ShownInstead shown = ShownInstead::none;
  glm::dvec3 background{0};
  bool background_in_reflections = false;
  DirectionMistake directions = DirectionMistake::none;
  bool object_points = false;         ///< lighting and reflections use points in object space
  bool behind_in_reflections = true;  ///< reflected rays also hit objects behind their start
  double orthographic = 0;  ///< parallel rays from a film at this distance; 0: perspective
  LightSum light_sum = LightSum::none;
  LightTerm summed_term = LightTerm::diffuse;
  int missing_face = 0;     ///< of cubes, see ModelHit::face
  bool all_lights = false;  ///< in a mode that only uses directional lights
};

}  // namespace scenefile
