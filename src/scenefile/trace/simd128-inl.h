// Number types for the two lanes of WebAssembly's SIMD128, instead of wide-inl.h, because Highway
// 1.0.3 has no arithmetic on doubles for it. base/one_lane.h describes the functions. Included
// where <wasm_simd128.h> is.

namespace scenefile::SCENEFILE_LANES {

inline constexpr int lanes = 2;

struct F {
  v128_t v;
};
struct M {
  v128_t m;
};

inline F splat(double x) {
  return {wasm_f64x2_splat(x)};
}
inline F operator+(F a, F b) {
  return {wasm_f64x2_add(a.v, b.v)};
}
inline F operator-(F a, F b) {
  return {wasm_f64x2_sub(a.v, b.v)};
}
inline F operator*(F a, F b) {
  return {wasm_f64x2_mul(a.v, b.v)};
}
inline F operator/(F a, F b) {
  return {wasm_f64x2_div(a.v, b.v)};
}
inline F operator-(F a) {
  return {wasm_f64x2_neg(a.v)};
}
inline M operator<(F a, F b) {
  return {wasm_f64x2_lt(a.v, b.v)};
}
inline M operator>(F a, F b) {
  return {wasm_f64x2_gt(a.v, b.v)};
}
inline M operator<=(F a, F b) {
  return {wasm_f64x2_le(a.v, b.v)};
}
inline M operator>=(F a, F b) {
  return {wasm_f64x2_ge(a.v, b.v)};
}
inline M operator==(F a, F b) {
  return {wasm_f64x2_eq(a.v, b.v)};
}
inline M operator!=(F a, F b) {
  return {wasm_f64x2_ne(a.v, b.v)};
}
inline M operator&(M a, M b) {
  return {wasm_v128_and(a.m, b.m)};
}
inline M operator|(M a, M b) {
  return {wasm_v128_or(a.m, b.m)};
}
inline M operator^(M a, M b) {
  return {wasm_v128_xor(a.m, b.m)};
}
inline M operator!(M a) {
  return {wasm_v128_not(a.m)};
}
inline F select(M m, F yes, F no) {
  return {wasm_v128_bitselect(yes.v, no.v, m.m)};
}
inline M select(M m, M yes, M no) {
  return {wasm_v128_bitselect(yes.m, no.m, m.m)};
}
inline bool any(M m) {
  return wasm_v128_any_true(m.m);
}
inline bool none(M m) {
  return !any(m);
}
inline bool every(M m) {
  return wasm_i64x2_all_true(m.m);
}
inline M no_lanes() {
  return {wasm_i64x2_const(0, 0)};
}
/// A mask of lanes 0 to count - 1.
inline M first_lanes(std::size_t count) {
  return {wasm_i64x2_make(count > 0 ? -1 : 0, count > 1 ? -1 : 0)};
}
inline F sqrt(F x) {
  return {wasm_f64x2_sqrt(x.v)};
}
inline F floor(F x) {
  return {wasm_f64x2_floor(x.v)};
}
inline F abs(F x) {
  return {wasm_f64x2_abs(x.v)};
}
inline F copysign(F x, F sign) {
  return {wasm_v128_bitselect(sign.v, x.v, wasm_f64x2_const_splat(-0.0))};
}
// Like std::min and std::max for equal arguments.
inline F min(F a, F b) {
  return {wasm_f64x2_pmin(a.v, b.v)};
}
inline F max(F a, F b) {
  return {wasm_f64x2_pmax(a.v, b.v)};
}
/// From and to aligned memory.
inline F load(const double* from) {
  return {wasm_v128_load(from)};
}
inline void store(F x, double* to) {
  wasm_v128_store(to, x.v);
}
/// Extracts a byte of each number; 0 is the lowest.
template <int byte>
F load_byte(const std::int32_t* from) {
  const v128_t shifted = wasm_i32x4_shr(wasm_v128_load64_zero(from), 8 * byte);
  return {wasm_f64x2_convert_low_i32x4(wasm_v128_and(shifted, wasm_i32x4_const_splat(255)))};
}
/// x / 255 for bytes.
inline F share_of_255(F x) {
  return x / splat(255);
}
/// One bit per lane.
inline unsigned bits(M m) {
  return static_cast<unsigned>(wasm_i64x2_bitmask(m.m));
}
inline M of_bits(unsigned mask) {
  return {wasm_i64x2_make(-std::int64_t{mask & 1}, -std::int64_t{mask >> 1 & 1})};
}
/// The next larger number for positive numbers; infinity is unchanged.
inline F next_up(F x) {
  const F next{wasm_i64x2_add(x.v, wasm_i64x2_const_splat(1))};
  return select(x < splat(std::numeric_limits<double>::infinity()), next, x);
}
inline double min_of_lanes(F x) {
  return std::min(wasm_f64x2_extract_lane(x.v, 0), wasm_f64x2_extract_lane(x.v, 1));
}
inline double greatest_lane(F x) {
  return std::max(wasm_f64x2_extract_lane(x.v, 0), wasm_f64x2_extract_lane(x.v, 1));
}
/// The order is unspecified.
inline double sum_of_lanes(F x) {
  return wasm_f64x2_extract_lane(x.v, 0) + wasm_f64x2_extract_lane(x.v, 1);
}
/// From aligned memory.
inline F load_floats(const float* from) {
  return {wasm_f64x2_promote_low_f32x4(wasm_v128_load64_zero(from))};
}
template <typename Function>
F each(M m, const Function& f, F x, F y) {
  alignas(16) double xs[lanes];
  alignas(16) double ys[lanes];
  store(x, xs);
  store(y, ys);
  const unsigned mask = bits(m);
  for (int i = 0; i < lanes; ++i) {
    xs[i] = (mask >> i & 1) != 0 ? f(xs[i], ys[i]) : 0.0;
  }
  return load(xs);
}

}  // namespace scenefile::SCENEFILE_LANES
