// The wide number types for the instruction set; base/one_lane.h describes the functions. No
// include guard: included once for each instruction set, where Highway is included.

namespace scenefile::SCENEFILE_LANES {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
inline constexpr int lanes = static_cast<int>(MaxLanes(D()));

struct F {
  hn::Vec<D> v;
};
struct M {
  hn::Mask<D> m;
};

inline F splat(double x) {
  return {hn::Set(D(), x)};
}
inline F operator+(F a, F b) {
  return {hn::Add(a.v, b.v)};
}
inline F operator-(F a, F b) {
  return {hn::Sub(a.v, b.v)};
}
inline F operator*(F a, F b) {
  return {hn::Mul(a.v, b.v)};
}
inline F operator/(F a, F b) {
  return {hn::Div(a.v, b.v)};
}
inline F operator-(F a) {
  return {hn::Neg(a.v)};
}
inline M operator<(F a, F b) {
  return {hn::Lt(a.v, b.v)};
}
inline M operator>(F a, F b) {
  return {hn::Gt(a.v, b.v)};
}
inline M operator<=(F a, F b) {
  return {hn::Le(a.v, b.v)};
}
inline M operator>=(F a, F b) {
  return {hn::Ge(a.v, b.v)};
}
inline M operator==(F a, F b) {
  return {hn::Eq(a.v, b.v)};
}
inline M operator!=(F a, F b) {
  return {hn::Ne(a.v, b.v)};
}
inline M operator&(M a, M b) {
  return {hn::And(a.m, b.m)};
}
inline M operator|(M a, M b) {
  return {hn::Or(a.m, b.m)};
}
inline M operator^(M a, M b) {
  return {hn::Xor(a.m, b.m)};
}
inline M operator!(M a) {
  return {hn::Not(a.m)};
}
inline F select(M m, F yes, F no) {
  return {hn::IfThenElse(m.m, yes.v, no.v)};
}
inline M select(M m, M yes, M no) {
  return (m & yes) | ((!m) & no);
}
inline bool none(M m) {
  return hn::AllFalse(D(), m.m);
}
inline bool any(M m) {
  return !none(m);
}
inline bool every(M m) {
  return hn::AllTrue(D(), m.m);
}
inline M no_lanes() {
  return {hn::FirstN(D(), 0)};
}
/// A mask of lanes 0 to count - 1.
inline M first_lanes(std::size_t count) {
  return {hn::FirstN(D(), count)};
}
inline F sqrt(F x) {
  return {hn::Sqrt(x.v)};
}
inline F floor(F x) {
  return {hn::Floor(x.v)};
}
inline F abs(F x) {
  return {hn::Abs(x.v)};
}
inline F copysign(F x, F sign) {
  return {hn::CopySign(x.v, sign.v)};
}
// Like std::min and std::max for equal arguments.
inline F min(F a, F b) {
  return {hn::Min(b.v, a.v)};
}
inline F max(F a, F b) {
  return {hn::Max(b.v, a.v)};
}
/// From and to aligned memory.
inline F load(const double* from) {
  return {hn::Load(D(), from)};
}
inline void store(F x, double* to) {
  hn::Store(x.v, D(), to);
}
/// Extracts a byte of each number; 0 is the lowest.
template <int byte>
F load_byte(const std::int32_t* from) {
  const hn::Rebind<std::int32_t, D> integers;
  const auto shifted = hn::ShiftRight<8 * byte>(hn::Load(integers, from));
  return {hn::PromoteTo(D(), hn::And(shifted, hn::Set(integers, 255)))};
}
// 1 / 255 as a sum of two numbers: products of bytes with the first are exact, so the result is
// rounded only once.
inline constexpr double high_255th = 0x0.010101010101p0;
inline constexpr double low_255th = 0x1p-48 / 255;
constexpr bool divides_bytes() {
  for (int x = 0; x < 256; ++x) {
    if (x * high_255th + x * low_255th != x / 255.0) {
      return false;
    }
  }
  return true;
}
static_assert(divides_bytes());
/// x / 255 for bytes.
inline F share_of_255(F x) {
  return x * splat(high_255th) + x * splat(low_255th);
}
/// One bit per lane.
inline unsigned bits(M m) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(D(), m.m, bytes);
  return bytes[0];
}
inline M of_bits(unsigned mask) {
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(mask)};
  return {hn::LoadMaskBits(D(), bytes)};
}
/// The next larger number for positive numbers; infinity is unchanged.
inline F next_up(F x) {
  const hn::RebindToSigned<D> integers;
  const F next{hn::BitCast(D(), hn::Add(hn::BitCast(integers, x.v), hn::Set(integers, 1)))};
  return select(x < splat(std::numeric_limits<double>::infinity()), next, x);
}
inline double min_of_lanes(F x) {
  return hn::GetLane(hn::MinOfLanes(D(), x.v));
}
inline double greatest_lane(F x) {
  return hn::GetLane(hn::MaxOfLanes(D(), x.v));
}
/// In any order.
inline double sum_of_lanes(F x) {
  return hn::GetLane(hn::SumOfLanes(D(), x.v));
}
/// From memory that is aligned for it.
inline F load_floats(const float* from) {
  const hn::Rebind<float, D> floats;
  return {hn::PromoteTo(D(), hn::Load(floats, from))};
}
template <typename Function>
F each(M m, const Function& f, F x, F y) {
  alignas(64) double xs[lanes];
  alignas(64) double ys[lanes];
  store(x, xs);
  store(y, ys);
  const unsigned mask = bits(m);
  for (int i = 0; i < lanes; ++i) {
    xs[i] = (mask >> i & 1) != 0 ? f(xs[i], ys[i]) : 0.0;
  }
  return load(xs);
}

}  // namespace scenefile::SCENEFILE_LANES
