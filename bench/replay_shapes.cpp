// Compiled for the machine that runs it (bench/CMakeLists.txt), because this is a lower bound.

#include "replay_shapes.h"

#if SCENEFILE_EMBREE_MAJOR == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile::bench {

namespace {

constexpr float none = 1e30f;

struct Line {
  float ox, oy, oz, dx, dy, dz, near, far;
};

inline float inside(const Line& ray, float t) {
  return t > ray.near && t < ray.far ? t : none;
}

// The roots of a x^2 + 2 b x + c, with the height y there between the caps.
inline float between_caps(const Line& ray, float t) {
  const float y = ray.oy + t * ray.dy;
  return y >= -0.5f && y <= 0.5f ? inside(ray, t) : none;
}

inline float cap(const Line& ray, float height) {
  const float t = (height - ray.oy) / ray.dy;
  const float x = ray.ox + t * ray.dx;
  const float z = ray.oz + t * ray.dz;
  return x * x + z * z <= 0.25f ? inside(ray, t) : none;
}

struct Roots {
  float first, second;
};
inline Roots roots(float a, float b, float c) {
  const float d = b * b - a * c;
  const float s = std::sqrt(d > 0 ? d : 0);
  return {d >= 0 ? (-b - s) / a : none, d >= 0 ? (-b + s) / a : none};
}

template <Shape shape>
inline float meet(const Line& r) {
  if constexpr (shape == Shape::cube) {
    const float ix = 1 / r.dx, iy = 1 / r.dy, iz = 1 / r.dz;
    const float x0 = (-0.5f - r.ox) * ix, x1 = (0.5f - r.ox) * ix;
    const float y0 = (-0.5f - r.oy) * iy, y1 = (0.5f - r.oy) * iy;
    const float z0 = (-0.5f - r.oz) * iz, z1 = (0.5f - r.oz) * iz;
    const float enter = std::max(std::max(std::min(x0, x1), std::min(y0, y1)), std::min(z0, z1));
    const float leave = std::min(std::min(std::max(x0, x1), std::max(y0, y1)), std::max(z0, z1));
    const float t = std::min(inside(r, enter), inside(r, leave));
    return enter <= leave ? t : none;
  } else if constexpr (shape == Shape::sphere) {
    const Roots t =
        roots(r.dx * r.dx + r.dy * r.dy + r.dz * r.dz, r.ox * r.dx + r.oy * r.dy + r.oz * r.dz,
              r.ox * r.ox + r.oy * r.oy + r.oz * r.oz - 0.25f);
    return std::min(inside(r, t.first), inside(r, t.second));
  } else if constexpr (shape == Shape::cylinder) {
    const Roots t = roots(r.dx * r.dx + r.dz * r.dz, r.ox * r.dx + r.oz * r.dz,
                          r.ox * r.ox + r.oz * r.oz - 0.25f);
    return std::min(std::min(between_caps(r, t.first), between_caps(r, t.second)),
                    std::min(cap(r, -0.5f), cap(r, 0.5f)));
  } else {
    static_assert(shape == Shape::cone);
    const float k = 0.25f - 0.5f * r.oy;  // the radius at the height of the origin
    const float m = -0.5f * r.dy;
    const Roots t = roots(r.dx * r.dx + r.dz * r.dz - m * m, r.ox * r.dx + r.oz * r.dz - k * m,
                          r.ox * r.ox + r.oz * r.oz - k * k);
    return std::min(std::min(between_caps(r, t.first), between_caps(r, t.second)), cap(r, -0.5f));
  }
}

struct Stored {
  float m[12];
  Shape shape;
};

template <Shape shape, int lanes>
inline void meet_all(const float* m, const float* ray, const int* valid, float* t) {
  // RTCRayN: ox oy oz near dx dy dz time far, each `lanes` floats.
#pragma GCC ivdep
  for (int i = 0; i < lanes; ++i) {
    const float ox = ray[i], oy = ray[lanes + i], oz = ray[2 * lanes + i];
    const float dx = ray[4 * lanes + i], dy = ray[5 * lanes + i], dz = ray[6 * lanes + i];
    const Line line{m[0] * ox + m[3] * oy + m[6] * oz + m[9],
                    m[1] * ox + m[4] * oy + m[7] * oz + m[10],
                    m[2] * ox + m[5] * oy + m[8] * oz + m[11],
                    m[0] * dx + m[3] * dy + m[6] * dz,
                    m[1] * dx + m[4] * dy + m[7] * dz,
                    m[2] * dx + m[5] * dy + m[8] * dz,
                    ray[3 * lanes + i],
                    ray[8 * lanes + i]};
    const float met = meet<shape>(line);
    t[i] = valid[i] != 0 ? met : none;
  }
}

template <int lanes>
inline void meet_any(const Stored& object, const float* ray, const int* valid, float* t) {
  switch (object.shape) {
    case Shape::cube:
      return meet_all<Shape::cube, lanes>(object.m, ray, valid, t);
    case Shape::sphere:
      return meet_all<Shape::sphere, lanes>(object.m, ray, valid, t);
    case Shape::cylinder:
      return meet_all<Shape::cylinder, lanes>(object.m, ray, valid, t);
    case Shape::cone:
      return meet_all<Shape::cone, lanes>(object.m, ray, valid, t);
    case Shape::mesh:
      break;
  }
  std::fill_n(t, lanes, none);  // replay.cpp takes no scenes with meshes
}

template <int lanes>
inline void intersect_lanes(const RTCIntersectFunctionNArguments* a) {
  const Stored& object = static_cast<const Stored*>(a->geometryUserPtr)[a->primID];
  auto* const ray = reinterpret_cast<float*>(a->rayhit);
  auto* const hit = reinterpret_cast<unsigned*>(ray + 12 * lanes);  // Ng x y z, u, v, prim, geom
  float t[lanes];
  meet_any<lanes>(object, ray, a->valid, t);
  for (int i = 0; i < lanes; ++i) {
    if (t[i] < none) {
      ray[8 * lanes + i] = t[i];
      hit[5 * lanes + i] = a->primID;
      hit[6 * lanes + i] = a->geomID;
    }
  }
}

template <int lanes>
inline void occlude_lanes(const RTCOccludedFunctionNArguments* a) {
  const Stored& object = static_cast<const Stored*>(a->geometryUserPtr)[a->primID];
  auto* const ray = reinterpret_cast<float*>(a->ray);
  float t[lanes];
  meet_any<lanes>(object, ray, a->valid, t);
  for (int i = 0; i < lanes; ++i) {
    if (t[i] < none) {
      ray[8 * lanes + i] = -std::numeric_limits<float>::infinity();
    }
  }
}

void intersect_callback(const RTCIntersectFunctionNArguments* a) {
  a->N == 1 ? intersect_lanes<1>(a) : a->N == 8 ? intersect_lanes<8>(a) : intersect_lanes<16>(a);
}

void occluded_callback(const RTCOccludedFunctionNArguments* a) {
  a->N == 1 ? occlude_lanes<1>(a) : a->N == 8 ? occlude_lanes<8>(a) : occlude_lanes<16>(a);
}

#if SCENEFILE_EMBREE_MAJOR == 4
struct Asking {
  RTCRayQueryContext context;
  RTCIntersectArguments intersect;
  RTCOccludedArguments occluded;
  explicit Asking(bool coherent) {
    rtcInitRayQueryContext(&context);
    rtcInitIntersectArguments(&intersect);
    rtcInitOccludedArguments(&occluded);
    intersect.context = occluded.context = &context;
    intersect.flags = occluded.flags =
        coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }
};
#define ASK(NAME, KIND, SCENE, RAY, VALID) NAME(VALID SCENE, RAY, &asking.KIND)
#else
struct Asking {
  RTCIntersectContext context;
  explicit Asking(bool coherent) {
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
};
#define ASK(NAME, KIND, SCENE, RAY, VALID) NAME(VALID SCENE, &asking.context, RAY)
#endif
#define VALID_LANES valid,

template <int lanes>
void fill(const RayRecord* rays, int count, int* valid, float* to) {
  for (int i = 0; i < lanes; ++i) {
    const RayRecord& ray = rays[std::min(i, count - 1)];
    const float values[] = {ray.ox, ray.oy, ray.oz, ray.near, ray.dx, ray.dy, ray.dz, 0, ray.far};
    for (int k = 0; k < 9; ++k) {
      to[k * lanes + i] = values[k];
    }
    reinterpret_cast<unsigned*>(to)[9 * lanes + i] = 0xffffffffu;
    valid[i] = i < count ? -1 : 0;
  }
}

template <int lanes>
void forget_hits(float* hit) {
  for (int i = 0; i < lanes; ++i) {
    reinterpret_cast<unsigned*>(hit)[6 * lanes + i] = RTC_INVALID_GEOMETRY_ID;
  }
}

}  // namespace

struct BareScene::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Stored> objects;

  void one(const RayRecord& record, bool shadow) const {
    Asking asking(false);
    int valid[1];
    RTCRayHit ray;
    fill<1>(&record, 1, valid, &ray.ray.org_x);
    if (shadow) {
      ASK(rtcOccluded1, occluded, scene, &ray.ray, );
      return;
    }
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ASK(rtcIntersect1, intersect, scene, &ray, );
  }

  void eight(const RayRecord* rays, int count, bool shadow) const {
    Asking asking(true);
    alignas(32) int valid[8];
    RTCRayHit8 ray;
    fill<8>(rays, count, valid, ray.ray.org_x);
    if (shadow) {
      ASK(rtcOccluded8, occluded, scene, &ray.ray, VALID_LANES);
      return;
    }
    forget_hits<8>(ray.hit.Ng_x);
    ASK(rtcIntersect8, intersect, scene, &ray, VALID_LANES);
  }

  void sixteen(const RayRecord* rays, int count, bool shadow) const {
    Asking asking(true);
    alignas(64) int valid[16];
    RTCRayHit16 ray;
    fill<16>(rays, count, valid, ray.ray.org_x);
    if (shadow) {
      ASK(rtcOccluded16, occluded, scene, &ray.ray, VALID_LANES);
      return;
    }
    forget_hits<16>(ray.hit.Ng_x);
    ASK(rtcIntersect16, intersect, scene, &ray, VALID_LANES);
  }
};

BareScene::BareScene(const std::vector<BareObject>& objects) : state_(new State) {
  State& s = *state_;
  std::vector<RTCBounds> boxes;
  for (const BareObject& object : objects) {
    Stored stored{{}, object.shape};
    const float* const linear = &object.object_from_world.linear[0][0];
    std::copy_n(linear, 9, stored.m);
    std::copy_n(&object.object_from_world.offset[0], 3, stored.m + 9);
    s.objects.push_back(stored);
    const glm::vec3 low(object.bounds.min), high(object.bounds.max);
    boxes.push_back({low.x, low.y, low.z, 0, high.x, high.y, high.z, 0});
  }
  s.device = rtcNewDevice("threads=1,frequency_level=simd256");
  s.scene = rtcNewScene(s.device);
  RTCGeometry geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(objects.size()));
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* a) {
        *a->bounds_o = static_cast<const RTCBounds*>(a->geometryUserPtr)[a->primID];
      },
      nullptr);
  rtcSetGeometryUserData(geometry, boxes.data());
  rtcSetGeometryIntersectFunction(geometry, intersect_callback);
  rtcSetGeometryOccludedFunction(geometry, occluded_callback);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(s.scene, geometry);
  rtcCommitScene(s.scene);
  rtcSetGeometryUserData(geometry, s.objects.data());
  rtcReleaseGeometry(geometry);
}

BareScene::~BareScene() {
  rtcReleaseScene(state_->scene);
  rtcReleaseDevice(state_->device);
  delete state_;
}

void BareScene::ask(const RayRecord* rays, std::size_t count, int lanes, bool shadow) const {
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  for (std::size_t i = 0; i < count; i += static_cast<std::size_t>(lanes)) {
    const int part = static_cast<int>(std::min(count - i, static_cast<std::size_t>(lanes)));
    if (lanes == 1) {
      state_->one(rays[i], shadow);
    } else if (lanes == 8) {
      state_->eight(rays + i, part, shadow);
    } else {
      state_->sixteen(rays + i, part, shadow);
    }
  }
}

}  // namespace scenefile::bench
