#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/scene/check_parts.h"
#include "scenefile/scene/codes.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace scenefile {

namespace {

constexpr float huge_color = 255;
constexpr float min_ior = 0.25f;

const NumberRange& range_of(Field field) {
  return row_of(material_rows, field).range;
}

void check_color(const ValueRow<Material>& row, const glm::vec3& color, const Subject& subject,
                 Reporter& reporter) {
  if (!reporter.finite(subject, *row.field, row.xml, color)) {
    return;
  }
  const auto report = [&](const Code& code, std::string_view what) {
    reporter.report(
        code, subject, *row.field,
        fmt::format("{} {} of the {} is {}", row.xml, vector_text(color), subject.what, what));
  };
  if (smallest(color) < row.range.low) {
    report("material.color-negative"_code, "negative");
  }
  if (largest(color) > huge_color) {
    report("material.color-huge"_code, "far above 1");
  } else if (largest(color) > row.range.high) {
    report("material.color-255"_code, "far above 1; did you mean a value out of 255?");
  }
}

void check_highlight(const Material& material, const Subject& subject, Reporter& reporter) {
  if (!reporter.finite(subject, Field::shininess, "shininess", material.shininess)) {
    return;
  }
  const auto report = [&](const Code& code, std::string_view what) {
    reporter.report(code, subject, Field::shininess,
                    fmt::format("shininess {} of the {} {}", number_text(material.shininess),
                                subject.what, what));
  };
  if (material.shininess < 0) {
    report("material.shininess-negative"_code, "is negative; it counts as 0, no highlight");
  } else if (material.shininess > range_of(Field::shininess).high) {
    report("material.shininess-huge"_code, "makes a highlight too small to see");
  } else if (material.shininess == 0 && largest(glm::abs(material.specular)) > 0) {
    reporter.report("material.specular-without-shininess"_code, subject, Field::specular,
                    fmt::format("specular {} of the {} has no effect, because its shininess is 0",
                                vector_text(material.specular), subject.what));
  }
}

void check_refraction(const Material& material, const Subject& subject, Reporter& reporter) {
  if (!reporter.finite(subject, Field::ior, "ior", material.ior)) {
    return;
  }
  const float ior = material.ior;
  if (ior < 0) {
    reporter.report("material.ior-negative"_code, subject, Field::ior,
                    fmt::format("ior {} of the {} is negative; it counts as 1", number_text(ior),
                                subject.what));
  } else if (ior == 0 && largest(material.transparent) > 0 && reporter.gives(subject, Field::ior)) {
    reporter.report("material.ior-unusual"_code, subject, Field::ior,
                    fmt::format("ior 0 of the transparent {} counts as 1, so light passes straight "
                                "through it; glass has 1.5",
                                subject.what));
  } else if (ior != 0 && (ior < min_ior || ior > range_of(Field::ior).high)) {
    reporter.report("material.ior-unusual"_code, subject, Field::ior,
                    fmt::format("ior {} of the {} is not that of a real material", number_text(ior),
                                subject.what));
  }
}

// The energy that a surface passes on, summed like the renderers do.
void check_energy(const Material& material, const Global& global, const Subject& subject,
                  Reporter& reporter) {
  if (global.unread.contains(Field::specular) || global.unread.contains(Field::transparent)) {
    return;
  }
  const glm::vec3 reflected = global.specular * material.reflective;
  const glm::vec3 passed = global.transparent.value_or(0.5f) * material.transparent;
  if (largest(reflected) > 0 && largest(passed) > 0 && largest(reflected + passed) > 1.0001f) {
    reporter.report(
        "material.reflective-and-transparent"_code, subject, Field::transparent,
        fmt::format("reflective {} and transparent {} of the {}, each times its coefficient, add "
                    "up to more than 1",
                    vector_text(material.reflective), vector_text(material.transparent),
                    subject.what));
  }
}

// `name` is the element in files, "texture" or "bumpmap".
void check_texture(const TextureUse& texture, std::string_view name, const Subject& subject,
                   Reporter& reporter) {
  const Subject place{subject.what, texture.location.known() ? texture.location : subject.location,
                      subject.node};
  if (texture.file.empty()) {
    reporter.report("material.texture-without-file"_code, place,
                    fmt::format("{} of the {} names no file", name, subject.what));
  }
  const std::pair<char, float> repeats[] = {{'u', texture.repeat_u}, {'v', texture.repeat_v}};
  for (const auto& [axis, repeat] : repeats) {
    if (!ranges::repeats.contains(repeat)) {
      reporter.report(std::isfinite(repeat) ? "material.repeat"_code : "scene.not-finite"_code,
                      place,
                      fmt::format("{} {} repeats {} times along {}", name, quoted(texture.file),
                                  number_text(repeat), axis));
    }
  }
}

void check_blend(const Material& material, const Subject& subject, Reporter& reporter) {
  if (!reporter.finite(subject, Field::blend, "blend", material.blend)) {
    return;
  }
  const float blend = material.blend;
  if (!range_of(Field::blend).contains(blend)) {
    reporter.report("material.blend-range"_code, subject, Field::blend,
                    fmt::format("blend {} of the {} is not between 0 and 1; it counts as {}",
                                number_text(blend), subject.what, blend < 0 ? 0 : 1));
  } else if (material.texture && blend == 0) {
    const Location place = material.texture->location;
    reporter.report("material.texture-without-blend"_code,
                    {subject.what, place.known() ? place : subject.location, subject.node},
                    fmt::format("texture {} of the {} is not visible, because its blend is 0",
                                quoted(material.texture->file), subject.what));
  } else if (!material.texture && blend > 0) {
    reporter.report("material.blend-without-texture"_code, subject, Field::blend,
                    fmt::format("blend {} of the {} has no effect without a texture",
                                number_text(blend), subject.what));
  }
}

}  // namespace

void check_primitive(const Primitive& primitive, NodeId node, const Global& global,
                     Reporter& reporter) {
  const Subject subject{word_of(primitive.shape), primitive.location, node, primitive.unread};
  const Material& m = primitive.material;
  if (primitive.shape == Shape::mesh && primitive.mesh_file.empty()) {
    reporter.report("tree.mesh-without-file"_code, subject, Field::mesh_file,
                    "the mesh names no file (filename or meshfile, JSON meshFile)");
  }
  for (const ValueRow<Material>& row : material_rows) {
    if (const auto* const color = std::get_if<glm::vec3 Material::*>(&row.member)) {
      check_color(row, m.**color, subject, reporter);
    }
  }
  check_highlight(m, subject, reporter);
  check_refraction(m, subject, reporter);
  check_energy(m, global, subject, reporter);
  check_blend(m, subject, reporter);
  if (m.texture) {
    check_texture(*m.texture, "texture", subject, reporter);
  }
  if (m.bump_map) {
    check_texture(*m.bump_map, "bumpmap", subject, reporter);
  }
}

}  // namespace scenefile
