#include "scenefile/grade/hypotheses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scenefile {

namespace {

using Hypotheses = std::vector<Hypothesis>;

template <typename F>
Texture rearranged(const Texture& picture, const F& place) {
  Texture result = picture;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto [from_x, from_y] = place(x, y);
      std::copy_n(picture.texel(from_x, from_y), 3,
                  result.rgb.begin() + (picture.texel(x, y) - picture.rgb.data()));
    }
  }
  return result;
}

Texture mirrored(const Texture& p, bool across, bool down) {
  return rearranged(p, [&](int x, int y) {
    return std::pair(across ? p.width - 1 - x : x, down ? p.height - 1 - y : y);
  });
}

Texture with_channels(const Texture& picture, const std::array<int, 3>& order) {
  Texture result = picture;
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    result.rgb[i] = picture.rgb[i - i % 3 + order[i % 3]];
  }
  return result;
}

template <typename F>
Texture with_curve(const Texture& picture, const F& curve) {
  std::array<std::uint8_t, 256> table{};
  for (int i = 0; i < 256; ++i) {
    table[i] = quantize(static_cast<float>(curve(i / 255.0)), Rounding::nearest);
  }
  Texture result = picture;
  std::transform(result.rgb.begin(), result.rgb.end(), result.rgb.begin(),
                 [&](std::uint8_t value) { return table[value]; });
  return result;
}

double srgb_code(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

double srgb_value(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

void add_gamma(Hypotheses& list) {
  const auto add = [&](std::string what, double (*curve)(double)) {
    list.push_back({Cause::gamma, std::move(what), {}, [curve](const Texture& p) {
                      return with_curve(p, curve);
                    }});
  };
  add("gamma 2.2 was applied, and the format knows none",
      [](double v) { return std::pow(v, 1 / 2.2); });
  add("values were taken to the power of 2.2 (gamma the wrong way)",
      [](double v) { return std::pow(v, 2.2); });
  add("gamma 2 was applied (a square root), and the format knows none",
      [](double v) { return std::sqrt(v); });
  add("values were stored as sRGB codes, and the format knows no gamma", srgb_code);
  add("values were decoded from sRGB, and the format knows no gamma", srgb_value);
}

bool any_light(const RenderScene& scene, bool (*is)(const RenderLight&)) {
  return std::any_of(scene.lights.begin(), scene.lights.end(), is);
}

bool any_material(const RenderScene& scene, bool (*is)(const RenderMaterial&)) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), is);
}

void add(Hypotheses& list, Cause cause, std::string what, std::function<void(Trial&)> draw) {
  list.push_back({cause, std::move(what), std::move(draw), {}});
}

template <typename F>
void for_spots(Trial& trial, const F& change) {
  for (RenderLight& light : trial.scene.lights) {
    if (light.type == LightType::spot) {
      change(light);
    }
  }
}

template <typename F>
void for_materials(Trial& trial, const F& change) {
  std::for_each(trial.scene.materials.begin(), trial.scene.materials.end(), change);
}

void add_terms(Hypotheses& list, const SceneView& view) {
  add(list, Cause::ambient, "the ambient term is missing",
      [](Trial& t) { t.scene.global.ambient = 0; });
  add(list, Cause::ambient, "the ambient term is added twice",
      [](Trial& t) { t.scene.global.ambient *= 2; });
  if (view.scene->lights.size() > 2) {
    add(list, Cause::ambient, "the ambient term is added once for each light",
        [](Trial& t) { t.scene.global.ambient *= static_cast<float>(t.scene.lights.size()); });
  }
  add(list, Cause::diffuse, "the diffuse term is missing",
      [](Trial& t) { t.options.mistakes.diffuse = 0; });
  add(list, Cause::diffuse, "the diffuse term is added twice",
      [](Trial& t) { t.options.mistakes.diffuse = 2; });
  for (const float factor : {0.0f, 2.0f}) {
    add(list, Cause::specular,
        factor == 0 ? "the specular term is missing" : "the specular term is added twice",
        [factor](Trial& t) { for_materials(t, [&](RenderMaterial& m) { m.specular *= factor; }); });
  }
}

void add_lighting(Hypotheses& list, const SceneView& view) {
  add(list, Cause::blinn, "highlights are Blinn's (N.H)^n, and the equation has Phong's (R.V)^n",
      [](Trial& t) { t.options.mistakes.blinn = true; });
  add(list, Cause::normals, "normals are not transformed by the inverse transpose",
      [](Trial& t) { t.options.mistakes.untransposed_normals = true; });
  if (any_light(*view.scene, [](const RenderLight& l) {
        return l.type != LightType::directional && l.attenuation != glm::vec3(1, 0, 0);
      })) {
    add(list, Cause::attenuation, "lights do not fade with distance", [](Trial& t) {
      for (RenderLight& light : t.scene.lights) {
        light.attenuation = {1, 0, 0};
      }
    });
  }
  if (view.options.features.shadows) {
    add(list, Cause::shadows, "there are no shadows",
        [](Trial& t) { t.options.features.shadows = false; });
  }
}

void add_spots(Hypotheses& list, const SceneView& view) {
  if (!any_light(*view.scene, [](const RenderLight& l) { return l.type == LightType::spot; })) {
    return;
  }
  const auto spot = [&](std::string what, void (*change)(RenderLight&)) {
    add(list, Cause::spot_falloff, std::move(what), [change](Trial& t) { for_spots(t, change); });
  };
  add(list, Cause::spot_falloff, "spots fall off in a straight line, not by the smoothstep",
      [](Trial& t) { t.options.mistakes.linear_spots = true; });
  spot("spots have no penumbra: full light up to the outer angle",
       [](RenderLight& l) { l.inner_angle = l.outer_angle; });
  spot("spots end at their inner angle", [](RenderLight& l) { l.outer_angle = l.inner_angle; });
  spot("spots fall off from their axis, not from the inner angle",
       [](RenderLight& l) { l.inner_angle = 0; });
  spot("spots shine in all directions", [](RenderLight& l) { l.type = LightType::point; });
  spot("the penumbra lies outside the angle of the spot, not inside", [](RenderLight& l) {
    const float penumbra = l.outer_angle - l.inner_angle;
    l.inner_angle = l.outer_angle;
    l.outer_angle += penumbra;
  });
  spot("the angle of the spot is taken for the full angle of the cone", [](RenderLight& l) {
    l.inner_angle /= 2;
    l.outer_angle /= 2;
  });
}

void add_textures(Hypotheses& list, const SceneView& view) {
  if (!view.options.features.texture ||
      !any_material(*view.scene, [](const RenderMaterial& m) { return m.texture.used(); })) {
    return;
  }
  const auto texture = [&](std::string what, void (*change)(RenderMaterial&)) {
    add(list, Cause::texture, std::move(what), [change](Trial& t) { for_materials(t, change); });
  };
  // A negative count turns the image around; whole repeats then meet as before.
  texture("textures are upside down",
          [](RenderMaterial& m) { m.texture.repeat_v = -m.texture.repeat_v; });
  texture("textures are mirrored left to right",
          [](RenderMaterial& m) { m.texture.repeat_u = -m.texture.repeat_u; });
  texture("textures are mirrored both ways", [](RenderMaterial& m) {
    m.texture.repeat_u = -m.texture.repeat_u;
    m.texture.repeat_v = -m.texture.repeat_v;
  });
  texture("textures are not repeated",
          [](RenderMaterial& m) { m.texture.repeat_u = m.texture.repeat_v = 1; });
  texture("the repeat counts of textures are swapped",
          [](RenderMaterial& m) { std::swap(m.texture.repeat_u, m.texture.repeat_v); });
  add(list, Cause::texture, "textures are not drawn",
      [](Trial& t) { t.options.features.texture = false; });
}

void add_depths(Hypotheses& list, const SceneView& view) {
  const bool bounces = any_material(*view.scene, [](const RenderMaterial& m) {
    return m.reflective != glm::vec3(0) || m.transparent != glm::vec3(0);
  });
  const Features& features = view.options.features;
  if (!bounces || (!features.reflect && !features.refract)) {
    return;
  }
  for (const int depth : {0, 1, 2, 3, 4, 5, 6, 8}) {
    if (depth != view.options.max_depth) {
      add(list, Cause::recursion_depth,
          depth == 0 ? std::string("there are no reflections (recursion depth 0)")
                     : fmt::format("the recursion ends at depth {}, not {}", depth,
                                   view.options.max_depth),
          [depth](Trial& t) { t.options.max_depth = depth; });
    }
  }
}

void add_shifts(Hypotheses& list) {
  constexpr std::array<std::pair<glm::dvec2, const char*>, 8> places{
      {{{-0.5, -0.5}, "upper left corners"},
       {{0.5, 0.5}, "lower right corners"},
       {{-0.5, 0.5}, "lower left corners"},
       {{0.5, -0.5}, "upper right corners"},
       {{-0.5, 0}, "left edges"},
       {{0.5, 0}, "right edges"},
       {{0, -0.5}, "upper edges"},
       {{0, 0.5}, "lower edges"}}};
  for (const auto& [shift, where] : places) {
    add(list, Cause::half_pixel_shift,
        fmt::format("rays go through the {} of pixels, not their middles", where),
        [by = shift](Trial& t) { t.shift = by; });
  }
}

}  // namespace

std::vector<Hypothesis> picture_hypotheses() {
  Hypotheses list;
  const auto turned = [&](Cause cause, const char* what, bool across, bool down) {
    list.push_back({cause, what, {}, [=](const Texture& p) { return mirrored(p, across, down); }});
  };
  turned(Cause::vertical_flip, "the picture is upside down (mirrored top to bottom)", false, true);
  turned(Cause::horizontal_flip, "the picture is mirrored left to right", true, false);
  turned(Cause::vertical_flip, "the picture is turned by half a turn (mirrored both ways)", true,
         true);
  constexpr std::array<std::pair<std::array<int, 3>, const char*>, 5> orders{
      {{{2, 1, 0}, "blue, green, red"},
       {{1, 0, 2}, "green, red, blue"},
       {{0, 2, 1}, "red, blue, green"},
       {{1, 2, 0}, "green, blue, red"},
       {{2, 0, 1}, "blue, red, green"}}};
  for (const auto& [order, words] : orders) {
    list.push_back({Cause::swapped_channels,
                    fmt::format("the channels stand in the order {}", words),
                    {},
                    [o = order](const Texture& p) { return with_channels(p, o); }});
  }
  add_gamma(list);
  return list;
}

std::vector<Hypothesis> drawing_hypotheses(const SceneView& view) {
  Hypotheses list;
  add_shifts(list);
  if (view.options.mode == Mode::normals) {
    return list;
  }
  add_terms(list, view);
  add_lighting(list, view);
  add_spots(list, view);
  if (view.options.mode == Mode::ray) {
    add_textures(list, view);
    add_depths(list, view);
  }
  return list;
}

}  // namespace scenefile
