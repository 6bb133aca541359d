#pragma once
// Affine maps as twelve numbers. A map is named to-from: `world_from_object` takes a point from
// object space to world space, and products read naturally: world_from_group * group_from_object.

#include <glm/glm.hpp>

namespace scenefile {

/// x -> linear * x + offset, column vectors. T is float for storage, double for
/// composition.
template <typename T>
struct BasicAffine {
  glm::mat<3, 3, T> linear{1};  ///< columns are the images of the x, y and z axes
  glm::vec<3, T> offset{T(0)};  ///< image of the origin

  BasicAffine() = default;
  BasicAffine(const glm::mat<3, 3, T>& l, const glm::vec<3, T>& o) : linear(l), offset(o) {}
  /// Converts between float and double.
  template <typename U>
  explicit BasicAffine(const BasicAffine<U>& other) : linear(other.linear), offset(other.offset) {}

  glm::vec<3, T> point(const glm::vec<3, T>& p) const { return linear * p + offset; }
  glm::vec<3, T> vector(const glm::vec<3, T>& v) const { return linear * v; }

  friend BasicAffine operator*(const BasicAffine& a, const BasicAffine& b) {
    return {a.linear * b.linear, a.linear * b.offset + a.offset};
  }
  friend bool operator==(const BasicAffine&, const BasicAffine&) = default;
};

using Affine = BasicAffine<float>;
using DAffine = BasicAffine<double>;

/// The inverse map. Requires invertible(a); otherwise the result is not finite.
inline DAffine inverse(const DAffine& a) {
  const glm::dmat3 linear = glm::inverse(a.linear);
  return {linear, -(linear * a.offset)};
}

/// Direction of a normal under the map whose inverse is `object_from_world`: the inverse
/// transpose. Not normalized.
inline glm::dvec3 transform_normal(const DAffine& object_from_world, const glm::dvec3& normal) {
  return glm::transpose(object_from_world.linear) * normal;
}

/// Whether the map is finite and far enough from singular to be inverted: tests the
/// determinant relative to the lengths of the columns.
bool invertible(const DAffine& a);

}  // namespace scenefile
