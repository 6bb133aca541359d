#include "scenefile/format/codes.h"
#include "scenefile/format/xml_blocks.h"
#include "scenefile/format/xml_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

constexpr AttributeForm rotate_forms[] = {{{"x", "y", "z", "angle"}}, {{"x", "y", "z", "a"}, true}};
constexpr Signature rotate_signature{rotate_forms, 4, true, true};

bool is_finite(const glm::mat4& m) {
  const float* const first = &m[0][0];
  return std::all_of(first, first + 16, [](float value) { return std::isfinite(value); });
}

// Sets the last row to 0 0 0 1.
void make_affine(const XmlContext& context, const MatrixDraft& draft, glm::mat4& rows) {
  const glm::vec4 last = rows[3];
  if (last == glm::vec4(0, 0, 0, 1)) {
    return;
  }
  const bool only_w = glm::vec3(last) == glm::vec3(0);
  const auto report = [&](Severity severity, std::string_view what) {
    context.diagnostics.report(xml_matrix_not_affine, severity, draft.last_row,
                               fmt::format("the last row of the matrix is {} {} {} {}; {}", last.x,
                                           last.y, last.z, last.w, what));
  };
  const bool repeated = !only_w && last == rows[2];
  const bool no_translation = rows[0].w == 0 && rows[1].w == 0 && rows[2].w == 0;
  if (only_w && !is_finite(rows / last.w)) {
    report(Severity::error, "it must be 0 0 0 1");
  } else if (only_w) {
    report(Severity::warning, "the matrix was divided by its last number to make it 0 0 0 1");
    rows /= last.w;
  } else if (repeated) {
    report(Severity::warning, "it repeats the third row. It must be 0 0 0 1, so it has no effect");
  } else if (no_translation && last.w == 1) {
    report(Severity::warning,
           "it has no effect. The matrix seems to be transposed: a translation belongs in the last "
           "column");
  } else {
    report(Severity::warning, "projective maps are not supported, so it has no effect");
  }
  rows[3] = {0, 0, 0, 1};
}

}  // namespace

std::optional<Transform> read_translate(const XmlContext& context, const XmlTag& tag) {
  const std::optional<glm::vec3> by = read_three(context, tag, ValueKind::vector);
  return by ? std::optional(Transform{Translate{*by}, tag.location}) : std::nullopt;
}

std::optional<Transform> read_scale(const XmlContext& context, const XmlTag& tag) {
  const std::optional<glm::vec3> by = read_three(context, tag, ValueKind::vector);
  return by ? std::optional(Transform{Scale{*by}, tag.location}) : std::nullopt;
}

std::optional<Transform> read_rotate(const XmlContext& context, const XmlTag& tag) {
  const std::optional<Parts> found = find_parts(context, tag, rotate_signature);
  if (!found) {
    return std::nullopt;
  }
  const Parts& parts = *found;
  const int axis_parts = (parts[0] != nullptr) + (parts[1] != nullptr) + (parts[2] != nullptr);
  if (axis_parts == 0 && parts[3] != nullptr) {
    context.report(xml_rotate_axis, tag,
                   "<rotate> has no axis, so it has no effect; write its axis as x, y and z");
    return std::nullopt;
  }
  if (axis_parts != 3) {
    report_missing(context, tag, rotate_signature, parts);
    return std::nullopt;
  }
  if (parts[3] == nullptr) {
    context.report(xml_rotate_angle, tag,
                   "<rotate> has no angle, so it has no effect; write its degrees as angle");
  }
  const std::optional<glm::vec4> numbers = read_numbers(context, tag, parts);
  return numbers ? std::optional(Transform{Rotate{glm::vec3(*numbers), numbers->w}, tag.location})
                 : std::nullopt;
}

void read_matrix_child(const XmlContext& context, const XmlTag& tag, MatrixDraft& draft) {
  if (draft.count >= 4) {
    draft.valid = false;
    context.report(
        xml_matrix_rows, tag,
        fmt::format("{} is one row too many: a matrix has four", element_text(tag.name)));
    return;
  }
  const std::optional<glm::vec4> row = read_matrix_row(context, tag);
  draft.valid = draft.valid && row;
  draft.rows[static_cast<int>(draft.count)] = row.value_or(glm::vec4(0));
  draft.last_row = tag.location;
  ++draft.count;
}

std::optional<Transform> finish_matrix(const XmlContext& context, const MatrixDraft& draft) {
  if (draft.count < 4) {
    context.diagnostics.report(
        xml_matrix_rows, draft.location,
        fmt::format("the matrix has {} rows instead of four, each written <row a=\"1\" "
                    "b=\"0\" c=\"0\" d=\"0\"/>",
                    draft.count));
    return std::nullopt;
  }
  if (!draft.valid) {
    return std::nullopt;
  }
  glm::mat4 rows = draft.rows;
  make_affine(context, draft, rows);
  return Transform{Matrix{glm::transpose(rows)}, draft.location};
}

}  // namespace scenefile
