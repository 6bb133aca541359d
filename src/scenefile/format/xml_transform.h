#pragma once
// <translate>, <rotate>, <scale> and <matrix>. Internal to the room.

#include "scenefile/format/xml_context.h"
#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>

namespace scenefile {

/// Each of these returns nullopt if there is nothing to apply, after an error or a warning.
std::optional<Transform> read_translate(const XmlContext& context, const XmlTag& tag);
std::optional<Transform> read_scale(const XmlContext& context, const XmlTag& tag);
std::optional<Transform> read_rotate(const XmlContext& context, const XmlTag& tag);

/// A matrix while it is read.
struct MatrixDraft {
  glm::mat4 rows{1};  ///< as written: rows[i] is a row, not a column
  std::size_t count = 0;
  bool valid = true;
  Location location;
  Location last_row;
};

/// Reads any child of <matrix> as a row.
void read_matrix_child(const XmlContext& context, const XmlTag& tag, MatrixDraft& draft);
/// Called at the end of <matrix>.
std::optional<Transform> finish_matrix(const XmlContext& context, const MatrixDraft& draft);

}  // namespace scenefile
