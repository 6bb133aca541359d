#include "scenefile/mistakes/hypothesis_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace scenefile {

void add_textures(HypothesisList& list) {
  if (!list.textured()) {
    return;
  }
  list.add(Cause::texture, "textures are not drawn",
           [](Trial& t) { t.options.features.texture = false; });
  const auto change = [&](std::string_view what, void (*change_one)(RenderMaterial&)) {
    list.add(Cause::texture, what, [change_one](Trial& t) {
      std::for_each(t.scene.materials.begin(), t.scene.materials.end(), change_one);
    });
  };
  const auto uv = [&](std::initializer_list<Row<UvMistake>> rows) {
    list.set_each(Cause::texture, &ModelMistakes::uv, rows);
  };
  const auto put = [&](std::initializer_list<Row<TextureMistake>> rows) {
    list.set_each(Cause::texture, &ModelMistakes::texture, rows);
  };
  using U = UvMistake;
  using T = TextureMistake;
  uv({{U::flip_v, "textures are upside down"},
      {U::flip_u, "textures are mirrored left to right"},
      {U::flip_both, "textures are mirrored both ways"},
      {U::shift_u, "textures are shifted by half of their width"},
      {U::shift_v, "textures are shifted by half of their height"}});
  put({{T::swapped_uv, "u and v of textures are swapped"}});
  change("textures are not repeated",
         [](RenderMaterial& m) { m.texture.repeat_u = m.texture.repeat_v = 1; });
  change("the repeat counts of textures are swapped",
         [](RenderMaterial& m) { std::swap(m.texture.repeat_u, m.texture.repeat_v); });
  put({{T::blend_ignored, "the blend of textures is ignored: the texture replaces the color"},
       {T::times_coefficient, "textures are multiplied by the global diffuse coefficient"},
       {T::times_coefficient_no_blend,
        "textures are multiplied by the global diffuse coefficient, and the blend is ignored"},
       {T::times_diffuse, "textures are multiplied by the diffuse color"},
       {T::times_diffuse_no_blend,
        "textures are multiplied by the diffuse color, and the blend is ignored"},
       {T::blend_reversed, "the blend of textures is reversed"},
       {T::added, "textures are added to the diffuse color, not blended with it"},
       {T::white_rest, "the diffuse color's share of the blend is white"},
       {T::blend_drops_color, "the diffuse color's share of the blend is missing"},
       {T::no_coefficient_on_rest,
        "the diffuse color blended with the texture is missing its coefficient"},
       {T::averaged, "the texture and the diffuse color are averaged: the blend is ignored"},
       {T::unlit, "textures are drawn without N.L"},
       {T::times_lighting, "the finished lighting is multiplied by the texture"},
       {T::times_lighting_too,
        "the finished lighting, already textured, is multiplied by the texture"},
       {T::specular_too, "the texture multiplies the specular term as well"},
       {T::over_lighting, "textures are blended with the finished lighting: they are not lit"},
       {T::over_all,
        "textures are blended with the finished lighting and reflections: they are not lit"},
       {T::over_lighting_too,
        "textures are blended twice: with the diffuse color, and with the finished lighting"},
       {T::over_all_too,
        "textures are blended twice: with the diffuse color, and with the finished lighting and "
        "reflections"},
       {T::blue_red, "red and blue of textures are swapped"},
       {T::gray, "textures are gray"},
       {T::integer_division, "colors of textures are divided by 255 as integers: they are 0 or 1"},
       {T::bytes, "colors of textures are from 0 to 255, not from 0 to 1"},
       {T::mirrored_repeat, "every other copy of the texture is mirrored"},
       {T::lookup_clamped, "textures end at their edges: the lookup does not wrap around"},
       {T::divided_repeat, "u and v are divided by the repeat counts"},
       {T::decoded, "textures are decoded with gamma 2.2"},
       {T::to_nearest, "positions in textures are rounded, not truncated: half a texel off"},
       {T::size_less_one, "u and v are multiplied by the texture's size less one"}});
  const auto put_sampling = [&](T value, const char* what) {
    list.set(Cause::features, &ModelMistakes::texture, value, what);
    list.items.back().mistake = false;
  };
  if (list.view.options.features.texture_filter) {
    put_sampling(T::not_filtered,
                 "textures are sampled at one point, but those of the reference are smooth "
                 "(filtered, or with several samples per pixel)");
    put_sampling(T::filtered_centered,
                 "textures are filtered half a texel from where those of the reference are");
  } else {
    put_sampling(T::filtered_centered, "textures are filtered, but those of the reference are not");
    put_sampling(T::filtered,
                 "textures are filtered (half a texel off), but those of the reference are not");
  }
  put({{T::ambient_too, "the texture replaces the ambient color as well"}});
  uv({{U::round_flip_u, "textures run the wrong way around spheres, cylinders and cones"},
      {U::half, "textures are rotated by half a turn around spheres, cylinders and cones"},
      {U::quarter, "textures are rotated by a quarter turn around spheres, cylinders and cones"},
      {U::three_quarters,
       "textures are rotated by three quarters of a turn around spheres, cylinders and cones"},
      {U::round_flip_half,
       "textures run the wrong way around spheres, cylinders and cones, and are rotated by half a "
       "turn"},
      {U::round_flip_quarter,
       "textures run the wrong way around spheres, cylinders and cones, and are rotated by a "
       "quarter "
       "turn"},
      {U::round_flip_three_quarters,
       "textures run the wrong way around spheres, cylinders and cones, and are rotated by three "
       "quarters of a turn"},
      {U::sphere_linear_v, "v of spheres grows with the height, not with the angle"},
      {U::sphere_planar, "u and v of spheres are x and y, not angles"},
      {U::sphere_flip_v, "textures are upside down on spheres"},
      {U::sides_like_sphere, "v of cylinders and cones is that of spheres"},
      {U::cube_front, "u and v of cubes are x and y on all faces"},
      {U::cube_same_faces, "opposite faces of cubes have the same u and v"},
      {U::flat_flip_u, "textures are mirrored on flat faces"},
      {U::flat_flip_v, "textures are upside down on flat faces"},
      {U::cube_ends_flip_v, "textures are upside down on the top and bottom of cubes"},
      {U::caps_flip_v, "textures are upside down on caps"},
      {U::caps_as_side, "caps are textured like the side"},
      {U::caps_polar, "u of caps is the angle around the axis"},
      {U::sphere_missing, "spheres have no texture"},
      {U::cube_missing, "cubes have no texture"},
      {U::cylinder_missing, "cylinders have no texture"},
      {U::cone_missing, "cones have no texture"},
      {U::caps_missing, "caps have no texture"}});
  std::set<std::uint32_t> files;
  for (const RenderMaterial& m : list.scene.materials) {
    if (m.texture.used()) {
      files.insert(m.texture.file);
    }
  }
  if (files.size() > 1) {
    for (const auto& [file, which] :
         {std::pair(*files.begin(), "first"), std::pair(*files.rbegin(), "last")}) {
      list.add(Cause::texture, fmt::format("all objects have the {} texture", which),
               [file = file](Trial& t) {
                 for (RenderMaterial& m : t.scene.materials) {
                   m.texture.file = m.texture.used() ? file : m.texture.file;
                 }
               });
    }
  }
  if (list.any_material([](const RenderMaterial& m) {
        return m.texture.repeat_u != m.texture.repeat_v || m.texture.repeat_u != 1;
      })) {
    change("textures repeat only along u", [](RenderMaterial& m) { m.texture.repeat_v = 1; });
    change("textures repeat only along v", [](RenderMaterial& m) { m.texture.repeat_u = 1; });
  }
}

void add_mirrors(HypothesisList& list) {
  if (!list.mirrors()) {
    return;
  }
  if (list.glass()) {
    list.add(Cause::reflection, "there are no reflections",
             [](Trial& t) { t.options.features.reflect = false; });
  } else {
    list.add(Cause::recursion_depth, "there are no reflections (recursion depth 0)",
             [](Trial& t) { t.options.max_depth = 0; });
  }
  using M = MirrorMistake;
  const auto put = [&](std::initializer_list<Row<M>> rows) {
    list.set_each(Cause::reflection, &ModelMistakes::mirror, rows);
  };
  put({{M::color_ignored, "the reflective color is ignored"},
       {M::no_coefficient, "reflections are missing the global specular coefficient"},
       {M::neither, "reflections have no weight: neither coefficient nor reflective color"},
       {M::blended_coefficient,
        "reflections are blended with the lighting (by coefficient and color), not added"},
       {M::blended, "reflections are blended with the lighting (by their color), not added"},
       {M::blended_all, "reflections are blended with the lighting, not added"},
       {M::blended_plain,
        "reflections are blended with the lighting by only the coefficient, not added"},
       {M::multiplied,
        "reflections are mixed with the lighting as a product: (1 - r) c + r c reflected"},
       {M::multiplied_by_color,
        "reflections are mixed with the lighting as a product, by the reflective color alone"},
       {M::averaged, "reflections and lighting are averaged, not added"},
       {M::replaces, "reflections replace the lighting"},
       {M::maximum, "the larger of lighting and reflection is used, not their sum"},
       {M::screened, "reflections are screened with the lighting, not added"},
       {M::not_chained,
        "weights are not multiplied along the path: nothing after the first mirror is weighted"},
       {M::last_weight_only,
        "weights are not multiplied along the path: each reflection only has the weight of its "
        "mirror"},
       {M::coefficient_once, "the specular coefficient only counts in the first reflection"},
       {M::eye_at_camera,
        "highlights in reflections are computed for the camera, not for the reflected ray"},
       {M::specular_color, "reflections are weighted by the specular color"},
       {M::all_materials, "everything that has highlights reflects"},
       {M::reversed, "reflected rays point into the surface"},
       {M::wrong_sign, "reflected rays have the wrong sign: d + 2 (d.n) n"},
       {M::not_doubled, "reflected rays lack a factor of 2: d - (d.n) n"},
       {M::along_normal, "reflected rays follow the normal"},
       {M::from_eye, "reflected rays start at the eye, not at the surface"},
       {M::straight, "reflected rays continue straight ahead"},
       {M::no_shadows, "reflections show no shadows"},
       {M::no_textures, "reflections show no textures"},
       {M::no_ambient, "reflections are missing the ambient term"},
       {M::doubled, "reflections are added twice"},
       {M::halved, "reflections are halved"},
       {M::diffuse_coefficient, "reflections are weighted by the diffuse coefficient"},
       {M::no_local, "mirrors are not lit"},
       {M::times_cosine, "reflections are multiplied by N.V"},
       {M::times_diffuse, "reflections are multiplied by the diffuse color"},
       {M::white_background, "reflected rays that hit nothing are white"},
       {M::clamped_never, "reflected colors are not clamped to 1 before they are added"}});
  for (const double bias : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
    list.set(Cause::reflection, &ModelMistakes::mirror_bias, bias,
             fmt::format("reflected rays start too far from the surface (about {} units)", bias));
  }
}

void add_glass(HypothesisList& list) {
  if (!list.glass()) {
    return;
  }
  list.add(Cause::refraction, "there is no refraction",
           [](Trial& t) { t.options.features.refract = false; });
  using G = GlassMistake;
  const auto put = [&](std::initializer_list<Row<G>> rows) {
    list.set_each(Cause::refraction, &ModelMistakes::glass, rows);
  };
  put({{G::eta_inverted, "the ratio of the indices of refraction is inverted"},
       {G::eta_inverted_black,
        "the ratio of the indices of refraction is inverted, and total reflection on the way in is "
        "black"},
       {G::eta_inverted_all_black,
        "the ratio of the indices of refraction is inverted, and total reflection is black"},
       {G::straight, "rays go straight through transparent objects: they are not bent"},
       {G::straight_shaded,
        "rays go straight through transparent objects, and the inner walls are lit, too"},
       {G::wrong_sign, "the refracted direction has a wrong sign"},
       {G::one_side, "rays are bent on the way in, not on the way out"},
       {G::entering_always, "the ratio of the indices is the same on the way in and out"},
       {G::shaded_inside, "the inner walls of transparent objects are lit and weighted again"},
       {G::no_coefficient, "refraction is missing the global transparent coefficient"},
       {G::color_ignored, "the transparent color is ignored"},
       {G::no_total_reflection, "total internal reflection is black"},
       {G::black_inside, "rays end inside of transparent objects"},
       {G::mirrored, "transparent objects reflect: the wrong direction is used"},
       {G::times_diffuse, "refraction is multiplied by the diffuse color"},
       {G::no_local, "transparent objects are not lit"},
       {G::replaces_all, "what is seen through transparent objects replaces their lighting"},
       {G::ior_one_and_half, "the index of refraction is always 1.5"},
       {G::ior_of_water, "the index of refraction is always 1.33"},
       {G::half, "refraction is halved"}});
  for (const auto& [value, by] : {std::pair(G::blended, "coefficient and color"),
                                  std::pair(G::blended_by_color, "the transparent color"),
                                  std::pair(G::blended_plain, "the coefficient, without color"),
                                  std::pair(G::blended_all, "the coefficient")}) {
    for (const bool over_mirror : {false, true}) {
      if (!over_mirror || list.mirrors()) {
        list.add(Cause::refraction,
                 fmt::format("refraction is blended with the lighting{} (by {}), not added",
                             over_mirror ? " and reflections" : "", by),
                 [value = value, over_mirror](Trial& t) {
                   t.mistakes.glass = value;
                   t.mistakes.glass_over_mirror = over_mirror;
                 });
      }
    }
  }
}

void add_depths(HypothesisList& list) {
  if (!list.mirrors() && !list.glass()) {
    return;
  }
  for (const int depth : {0, 1, 2, 3, 4, 5, 6, 8, 10}) {
    if (depth != list.view.options.max_depth && (depth != 0 || (list.mirrors() && list.glass()))) {
      list.add(Cause::recursion_depth,
               depth == 0
                   ? std::string("there is neither reflection nor refraction (recursion depth 0)")
                   : fmt::format("the recursion ends at depth {}, not {}", depth,
                                 list.view.options.max_depth),
               [depth](Trial& t) { t.options.max_depth = depth; });
    }
  }
}

}  // namespace scenefile
