#include "scenefile/base/number.h"
#include "scenefile/scene/check_parts.h"
#include "scenefile/scene/codes.h"
#include "scenefile/scene/transforms.h"
#include "scenefile/scene/vocabulary.h"
#include "scenefile/scene/walk.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_access.hpp>

#include <string>
#include <string_view>
#include <variant>

namespace scenefile {

namespace {

class TransformCheck {
 public:
  TransformCheck(const Transform& transform, const Subject& subject, Reporter& reporter)
      : transform_(transform), subject_(subject), reporter_(reporter) {}

  /// Whether the transform, by itself, leaves something to draw.
  bool run() {
    return std::visit([this](const auto& map) { return check(map); }, transform_.map);
  }

 private:
  bool check(const Translate& t) { return finite(transform_word<Translate>, t.by); }

  bool check(const Rotate& r) {
    if (!finite(transform_word<Rotate>, r.axis) ||
        !finite(transform_word<Rotate>, glm::vec3(r.angle_deg))) {
      return false;
    }
    if (r.axis == glm::vec3(0)) {
      reporter_.report("transform.axis-zero"_code, subject_,
                       "rotate has the axis 0 0 0 and does nothing");
    }
    return true;
  }

  bool check(const Scale& s) {
    if (!finite(transform_word<Scale>, s.by)) {
      return false;
    }
    return has_inverse([&] { return "scale " + vector_text(s.by); });
  }

  bool check(const Matrix& matrix) {
    for (int column = 0; column < 4; ++column) {
      if (!finite(transform_word<Matrix>, glm::vec3(matrix.m()[column])) ||
          !finite(transform_word<Matrix>, glm::vec3(matrix.m()[column].w))) {
        return false;
      }
    }
    check_last_row(matrix.m());
    return has_inverse([&] { return "matrix" + repeated_rows(matrix.m()); });
  }

  void check_last_row(const glm::mat4& m) {
    const glm::vec3 row(m[0].w, m[1].w, m[2].w);
    if (row == glm::vec3(0) && m[3].w == 1) {
      return;
    }
    const bool transposed = glm::vec3(m[3]) == glm::vec3(0) && m[3].w == 1;
    reporter_.report("transform.matrix-projective"_code, subject_,
                     fmt::format("the last row of the matrix is {} {}, not 0 0 0 1{}",
                                 vector_text(row), number_text(m[3].w),
                                 transposed ? "; is it transposed, with its translation in the row?"
                                            : "; it is taken as that"));
  }

  // " with its rows 1 and 2 the same", or nothing.
  static std::string repeated_rows(const glm::mat4& m) {
    for (int i = 0; i < 3; ++i) {
      for (int j = i + 1; j < 3; ++j) {
        if (glm::row(m, i) == glm::row(m, j)) {
          return fmt::format(" with its rows {} and {} the same", i + 1, j + 1);
        }
      }
    }
    return {};
  }

  // `what` describes the transform; a function because few scenes need the text.
  template <typename What>
  bool has_inverse(What what) {
    const DAffine map = composed(DAffine(), transform_);
    if (storable(map)) {
      return true;
    }
    if (const std::string_view extent = extent_text(map.linear); !extent.empty()) {
      reporter_.report(
          "transform.degenerate"_code, subject_,
          fmt::format("{} is too {} for single precision; objects inside it are not drawn", what(),
                      extent));
      return false;
    }
    reporter_.report("transform.flat"_code, subject_,
                     fmt::format("{} leaves no volume; objects inside it are not drawn", what()));
    return false;
  }

  // "large" or "small" if the lengths of the columns are the only reason that there is no inverse.
  static std::string_view extent_text(const glm::dmat3& linear) {
    constexpr double most = 1e30;
    std::string_view text;
    for (int i = 0; i < 3; ++i) {
      const double length = glm::length(linear[i]);
      if (length >= most) {
        return "large";
      }
      text = length > 0 && length <= 1 / most ? "small" : text;
    }
    return text;
  }

  bool finite(std::string_view name, const glm::vec3& value) {
    if (scenefile::finite(value)) {
      return true;
    }
    reporter_.report("scene.not-finite"_code, subject_,
                     fmt::format("{} contains a number that is not finite", name));
    return false;
  }

  const Transform& transform_;
  const Subject& subject_;
  Reporter& reporter_;
};

// The state of a walk: the map of the node, and whether a finding already reported it as flat.
struct Way {
  DAffine map;
  bool flat = false;
};

Way checked_way(const Scene& scene, NodeId id, const Way& above, Reporter& reporter) {
  const Node& node = scene.nodes[id];
  Way way = above;
  for (const Transform& transform : node.transforms) {
    const Subject subject{"transform",
                          transform.location.known() ? transform.location : node.location, id};
    way.flat = !TransformCheck(transform, subject, reporter).run() || way.flat;
    way.map = composed(way.map, transform);
  }
  const bool draws = !node.primitives.empty() || !node.instance_of.empty();
  if (draws && !way.flat && !storable(way.map)) {
    reporter.report("transform.degenerate"_code, {"node", node.location, id},
                    "the transforms of this object, multiplied, are too large, too small or flat; "
                    "it is not drawn");
  }
  return way;
}

}  // namespace

void check_transforms(const Scene& scene, Reporter& reporter) {
  std::vector<bool> seen(scene.nodes.size());
  for (const NodeId head : tree_heads(scene)) {
    walk_nodes(scene, head, Way{}, seen, [&](NodeId id, const Way& above) {
      return checked_way(scene, id, above, reporter);
    });
  }
}

}  // namespace scenefile
