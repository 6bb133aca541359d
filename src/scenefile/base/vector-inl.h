// Vectors of lane numbers. Sums add in the order x, y, z, as glm does.
// No include guard: included once for each number of lanes, after the definitions of F and M.

namespace scenefile::SCENEFILE_LANES {

struct V3 {
  F x, y, z;
};

inline V3 operator+(const V3& a, const V3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline V3 operator-(const V3& a, const V3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline V3 operator*(const V3& a, const V3& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline V3 operator*(F s, const V3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline V3 operator/(const V3& a, F s) {
  return {a.x / s, a.y / s, a.z / s};
}
inline V3 operator-(const V3& a) {
  return {-a.x, -a.y, -a.z};
}
inline F dot(const V3& a, const V3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline V3 cross(const V3& a, const V3& b) {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
inline F length(const V3& a) {
  return sqrt(dot(a, a));
}
inline V3 normalize(const V3& a) {
  return (splat(1) / sqrt(dot(a, a))) * a;
}
inline V3 select(M m, const V3& yes, const V3& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}
/// Broadcasts any type with x, y and z to all lanes.
template <typename Vector>
V3 splat3(const Vector& v) {
  return {splat(double(v.x)), splat(double(v.y)), splat(double(v.z))};
}
inline M finite(F x) {
  return x - x == splat(0);
}
inline F clamp(F x, double low, double high) {
  return min(max(x, splat(low)), splat(high));
}

}  // namespace scenefile::SCENEFILE_LANES
