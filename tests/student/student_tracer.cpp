#include "student/student_tracer.h"

#include "student/made_mistakes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace scenefile::student {

namespace {

using glm::mat3;
using glm::mat4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

constexpr float pi = 3.14159265f;
constexpr float far_away = 1e30f;

constexpr KnownMistake table[] = {
    {"camera-aspect-ignored", "camera", "camera"},
    {"camera-aspect-swapped", "camera", "camera"},
    {"camera-height-for-width", "camera", "camera"},
    {"camera-width-angle-times-aspect", "camera", "camera"},
    {"camera-full-angle", "camera", "camera"},
    {"camera-quarter-angle", "camera", "camera"},
    {"camera-degrees", "camera", "camera"},
    {"camera-backward", "camera", "camera"},
    {"camera-up-not-perpendicular", "camera", "camera"},
    {"camera-corners", "camera", "half-pixel-shift"},
    {"camera-transposed", "camera", "camera"},
    {"camera-look-as-point", "camera", "camera"},
    {"transform-reversed", "transforms", "transforms"},
    {"transform-rotation-sign", "transforms", "transforms"},
    {"transform-radians", "transforms", "transforms"},
    {"transform-transposed", "transforms", "transforms"},
    {"transform-no-scale", "transforms", "transforms"},
    {"transform-outer-lost", "transforms", "transforms"},
    {"normal-by-matrix", "normals", "normals"},
    {"normal-by-inverse", "normals", "normals"},
    {"normal-of-object", "normals", "normals"},
    {"normal-inverted", "normals", "normals"},
    {"normal-not-normalized", "normals", "normals"},
    {"normal-toward-eye", "normals", "normals"},
    {"shape-no-cylinder-caps", "shapes", "shapes"},
    {"shape-no-cone-cap", "shapes", "shapes"},
    {"shape-cone-normal-level", "shapes", "shapes|normals"},
    {"shape-no-spheres", "shapes", "shapes"},
    {"shape-no-cubes", "shapes", "shapes"},
    {"shape-no-cones", "shapes", "shapes"},
    {"shape-no-cylinders", "shapes", "shapes"},
    {"hit-last", "nearest-hit", "nearest-hit"},
    {"hit-farthest", "nearest-hit", "nearest-hit"},
    {"hit-object-distance", "nearest-hit", "nearest-hit"},
    {"light-not-normalized", "lights", "lights"},
    {"light-reversed", "lights", "lights"},
    {"light-directional-reversed", "lights", "lights"},
    {"light-position-as-direction", "lights", "lights"},
    {"light-only-first", "lights", "lights"},
    {"light-no-directional", "lights", "lights"},
    {"light-no-point", "lights", "lights"},
    {"light-no-spot", "lights", "lights"},
    {"light-white", "lights", "lights"},
    {"attenuation-none", "attenuation", "attenuation"},
    {"attenuation-square", "attenuation", "attenuation"},
    {"attenuation-no-quadratic", "attenuation", "attenuation"},
    {"attenuation-not-clamped", "attenuation", "attenuation"},
    {"spot-as-point", "spots", "spot-falloff"},
    {"spot-no-penumbra", "spots", "spot-falloff"},
    {"spot-linear", "spots", "spot-falloff"},
    {"spot-outside", "spots", "spot-falloff"},
    {"spot-penumbra-as-inner", "spots", "spot-falloff"},
    {"spot-half-angle", "spots", "spot-falloff"},
    {"shadow-none", "shadows", "shadows"},
    {"shadow-ambient-only", "shadows", "shadows"},
    {"shadow-stops", "shadows", "shadows"},
    {"shadow-beyond-light", "shadows", "shadows"},
    {"shadow-reversed", "shadows", "shadows"},
    {"shadow-acne", "shadows", "acne"},
    {"shadow-large-bias", "shadows", "shadows"},
    {"shadow-spot-axis", "shadows", "shadows"},
    {"shadow-keeps-specular", "shadows", "shadows"},
    {"shadow-black", "shadows", "shadows"},
    {"ambient-missing", "ambient", "ambient"},
    {"ambient-per-light", "ambient", "ambient"},
    {"ambient-no-coefficient", "ambient", "ambient"},
    {"diffuse-missing", "diffuse", "diffuse"},
    {"diffuse-twice", "diffuse", "diffuse"},
    {"diffuse-no-coefficient", "diffuse", "diffuse"},
    {"diffuse-absolute", "diffuse", "diffuse"},
    {"diffuse-not-clamped", "diffuse", "diffuse"},
    {"specular-missing", "specular", "specular"},
    {"specular-twice", "specular", "specular"},
    {"specular-no-coefficient", "specular", "specular"},
    {"specular-blinn", "specular", "blinn"},
    {"specular-light-view", "specular", "specular"},
    {"specular-times-cosine", "specular", "specular"},
    {"specular-absolute", "specular", "specular"},
    {"specular-no-exponent", "specular", "specular"},
    {"specular-eye-reversed", "specular", "specular"},
    {"texture-flip-u", "textures", "texture"},
    {"texture-flip-v", "textures", "texture"},
    {"texture-swapped", "textures", "texture"},
    {"texture-not-repeated", "textures", "texture"},
    {"texture-blend-ignored", "textures", "texture"},
    {"texture-times-coefficient", "textures", "texture"},
    {"texture-times-coefficient-no-blend", "textures", "texture"},
    {"texture-times-diffuse", "textures", "texture"},
    {"texture-blue-red", "textures", "texture"},
    {"texture-missing", "textures", "texture"},
    {"texture-missing-on-cones", "textures", "texture"},
    {"mirror-missing", "mirrors", "reflection|recursion-depth"},
    {"mirror-no-coefficient", "mirrors", "reflection"},
    {"mirror-color-ignored", "mirrors", "reflection"},
    {"mirror-blended", "mirrors", "reflection"},
    {"mirror-not-chained", "mirrors", "reflection"},
    {"mirror-eye-at-camera", "mirrors", "reflection"},
    {"mirror-reversed", "mirrors", "reflection"},
    {"mirror-depth-one", "mirrors", "recursion-depth"},
    {"mirror-depth-two", "mirrors", "recursion-depth"},
    {"glass-missing", "refraction", "refraction"},
    {"glass-eta-inverted", "refraction", "refraction"},
    {"glass-straight", "refraction", "refraction"},
    {"glass-shaded-inside", "refraction", "refraction"},
    {"output-wraps", "output", "overflow"},
    {"output-gamma", "output", "gamma"},
    {"output-gamma-inverse", "output", "gamma"},
    {"output-bgr", "output", "swapped-channels"},
    {"output-upside-down", "output", "vertical-flip"},
    {"output-mirrored", "output", "horizontal-flip"},
    {"output-background", "output", "background"},
    {"output-half", "output", "brightness"},
    {"output-normals", "output", "features"},
    {"output-black", "output", "black"},
    // Other forms of the same mistakes.
    {"camera-pixels-less-one", "camera", "camera|half-pixel-shift"},
    {"camera-backward-turned", "camera", "camera"},
    {"camera-right-edges", "camera", "half-pixel-shift"},
    {"camera-orthographic", "camera", "camera"},
    {"transform-nesting-reversed", "transforms", "transforms"},
    {"transform-all-transposed", "transforms", "transforms"},
    {"transform-not-restored", "transforms", "transforms"},
    {"transform-rays-forward", "transforms", "transforms"},
    {"transform-lights-not", "transforms", "transforms|lights"},
    {"normal-gradient", "normals", "normals"},
    {"normal-not-normalized-by-matrix", "normals", "normals"},
    {"shape-cone-normal-steep", "shapes", "shapes|normals"},
    {"shape-double-size", "shapes", "shapes"},
    {"shape-no-top-cap", "shapes", "shapes"},
    {"shape-no-bottom-cap", "shapes", "shapes"},
    {"shape-square-caps", "shapes", "shapes"},
    {"shape-endless-cylinders", "shapes", "shapes"},
    {"shape-double-cones", "shapes", "shapes"},
    {"shape-cylinder-normal-sphere", "shapes", "shapes|normals"},
    {"shape-cube-normals-positive", "shapes", "shapes|normals"},
    {"shape-some-missing", "shapes", "shapes"},
    {"normal-like-point", "normals", "normals"},
    {"normal-four-components", "normals", "normals"},
    {"hit-farthest-object", "nearest-hit", "nearest-hit"},
    {"hit-object-compared", "nearest-hit", "nearest-hit"},
    {"hit-behind", "nearest-hit", "nearest-hit"},
    {"light-shading-reversed", "lights", "lights"},
    {"light-direction-not-normalized", "lights", "lights"},
    {"light-no-color-share", "lights", "lights|brightness"},
    {"light-all-in-intersect", "lights", "features"},
    {"attenuation-square-unlimited", "attenuation", "attenuation"},
    {"attenuation-inverse", "attenuation", "attenuation"},
    {"attenuation-no-linear", "attenuation", "attenuation"},
    {"spot-linear-cosine", "spots", "spot-falloff"},
    {"spot-inner-only", "spots", "spot-falloff"},
    {"spot-angles-swapped", "spots", "spot-falloff"},
    {"shadow-bias-normal", "shadows", "shadows"},
    {"shadow-bias-one-third", "shadows", "shadows"},
    {"shadow-distance-of-eye", "shadows", "shadows"},
    {"shadow-distance-of-eye-positional", "shadows", "shadows"},
    {"shadow-unit-distance", "shadows", "shadows"},
    {"shadow-first-for-all", "shadows", "shadows"},
    {"shadow-spots-none", "shadows", "shadows"},
    {"ambient-twice", "ambient", "ambient"},
    {"ambient-times-diffuse", "ambient", "ambient"},
    {"diffuse-absolute-everywhere", "diffuse", "diffuse|lights"},
    {"diffuse-half-lambert", "diffuse", "diffuse"},
    {"diffuse-over-pi", "diffuse", "diffuse"},
    {"diffuse-no-cosine", "diffuse", "diffuse"},
    {"specular-negative-power", "specular", "specular"},
    {"specular-clamped-mirror", "specular", "specular"},
    {"specular-lit-side", "specular", "specular"},
    {"specular-half-exponent", "specular", "specular"},
    {"texture-flip-both", "textures", "texture"},
    {"texture-times-diffuse-no-blend", "textures", "texture"},
    {"texture-rest-lacks-coefficient", "textures", "texture"},
    {"texture-filtered", "textures", "texture|features"},
    {"texture-missing-on-caps", "textures", "texture"},
    {"texture-over-lighting", "textures", "texture"},
    {"texture-over-all", "textures", "texture"},
    {"mirror-wrong-sign", "mirrors", "reflection"},
    {"mirror-product", "mirrors", "reflection"},
    {"mirror-acne", "mirrors", "reflection|acne"},
    {"mirror-blended-plain", "mirrors", "reflection"},
    {"mirror-blended-color", "mirrors", "reflection"},
    {"mirror-specular-color", "mirrors", "reflection"},
    {"mirror-deep", "mirrors", "recursion-depth"},
    {"glass-same-ratio", "refraction", "refraction"},
    {"glass-no-total-reflection", "refraction", "refraction"},
    {"glass-no-coefficient", "refraction", "refraction"},
    {"glass-blended", "refraction", "refraction"},
    {"glass-blended-plain", "refraction", "refraction"},
    {"glass-eta-inverted-black", "refraction", "refraction"},
    {"output-half-drawn", "output", "black"},
    {"output-misses-black", "output", "background|samples"},
    {"output-sum-of-samples", "output", "brightness|samples"},
    {"output-scaled", "output", "overflow"},
    {"output-gamma-two", "output", "gamma"},
    {"output-srgb", "output", "gamma"},
    {"output-blurred", "output", "samples"},
    {"output-gray", "output", "brightness"},
    {"camera-zero-to-one", "camera", "camera"},
    {"transform-scale-divided", "transforms", "transforms"},
    {"transform-half-turned", "transforms", "transforms"},
    {"shape-wide-caps", "shapes", "shapes"},
    {"shape-wide-cylinders", "shapes", "shapes"},
    {"shape-cone-normal-constant", "shapes", "shapes|normals"},
    {"shape-cube-normal-sphere", "shapes", "shapes|normals"},
    {"light-unit-colors", "lights", "lights"},
    {"light-vector-sum", "lights", "lights"},
    {"attenuation-of-eye-distance", "attenuation", "attenuation"},
    {"spot-double-penumbra", "spots", "spot-falloff"},
    {"shadow-before-surface", "shadows", "shadows"},
    {"shadow-not-of-spheres", "shadows", "shadows"},
    {"shadow-inverted", "shadows", "shadows"},
    {"ambient-times-texture", "ambient", "ambient"},
    {"specular-eye-not-normalized", "specular", "specular"},
    {"texture-mirrored-repeat", "textures", "texture"},
    {"texture-half-turned-mirrored", "textures", "texture"},
    {"mirror-maximum", "mirrors", "reflection"},
    {"mirror-large-bias", "mirrors", "reflection"},
    {"glass-wrong-sign", "refraction", "refraction"},
    {"output-column-order", "output", "viewport"},
    {"output-one-pixel-off", "output", "half-pixel-shift|viewport"},
    {"output-signed", "output", "overflow"},
    // Correct programs that differ from ours: no mistake may be named.
    {"habit-rounds", "habits", "rounding"},
    {"habit-four-samples", "habits", ""},
    {"habit-nine-samples", "habits", ""},
    {"habit-jitter", "habits", ""},
    {"habit-small-bias", "habits", ""},
    {"habit-bias-along-normal", "habits", ""},
    {"habit-coarse-distances", "habits", ""},
    {"habit-clamped-lights", "habits", ""},
    // Forms of functions that are on no list.
    {"attenuation-root", "attenuation", "attenuation"},
    {"attenuation-exponential", "attenuation", "attenuation"},
    {"attenuation-late", "attenuation", "attenuation"},
    {"specular-root-of-exponent", "specular", "specular"},
    {"spot-cosine-cubed", "spots", "spot-falloff"},
    // Mistakes of no known family: no mistake may be named.
    {"strange-fog", "strange", ""},
    {"strange-vignette", "strange", ""},
    {"strange-noise", "strange", ""},
    {"strange-steps", "strange", ""},
    {"strange-rim", "strange", ""},
    {"strange-stripes", "strange", ""},
    {"output-contrast", "output", "brightness"},
    {"strange-saturation", "strange", ""},
    {"scene-moved-object", "scene", "scene-edited"},
    {"strange-headlight", "strange", ""},
    {"strange-bumps", "strange", ""},
    {"strange-posterized", "strange", ""},
    {"strange-fisheye", "strange", ""},
    {"output-warm", "output", "brightness"},
    {"output-lifted", "output", "brightness"},
    {"strange-soft-shadows", "strange", ""},
    {"strange-depth-dark", "strange", ""},
    {"strange-oren", "strange", ""},
    {"strange-fresnel", "strange", ""},
    {"scene-rolled-camera", "scene", "scene-edited|camera"},
    {"scene-moved-camera", "scene", "scene-edited|camera"},
    {"scene-moved-light", "scene", "scene-edited|lights"},
    {"strange-other-colors", "strange", "scene-edited"},
    // Other single lines that go wrong.
    {"camera-direction-as-point", "camera", "camera"},
    {"camera-view-matrix", "camera", "camera"},
    {"camera-at-origin", "camera", "camera"},
    {"camera-no-tangent", "camera", "camera"},
    {"camera-half-film", "camera", "camera"},
    {"camera-aspect-twice", "camera", "camera"},
    {"camera-look-long", "camera", "camera"},
    {"camera-up-not-normalized", "camera", "camera"},
    {"camera-cross-swapped", "camera", "horizontal-flip|camera"},
    {"transform-order-tsr", "transforms", "transforms"},
    {"transform-order-srt", "transforms", "transforms"},
    {"transform-order-str", "transforms", "transforms"},
    {"transform-order-rts", "transforms", "transforms"},
    {"transform-order-rst", "transforms", "transforms"},
    {"transform-scale-x", "transforms", "transforms"},
    {"transform-axis-not-normalized", "transforms", "transforms"},
    {"transform-move-negated", "transforms", "transforms"},
    {"transform-direction-not", "transforms", "transforms"},
    {"transform-direction-as-point", "transforms", "transforms"},
    {"transform-origin-as-direction", "transforms", "transforms"},
    {"transform-instances-not", "transforms", "transforms"},
    {"normal-absolute", "normals", "normals"},
    {"normal-by-transpose", "normals", "normals"},
    {"normal-sphere-for-all", "normals", "normals|shapes"},
    {"normal-from-center", "normals", "normals|shapes"},
    {"shape-cap-normals-up", "shapes", "shapes|normals"},
    {"shape-cap-normals-side", "shapes", "shapes|normals"},
    {"shape-cap-normals-inverted", "shapes", "shapes|normals"},
    {"shape-sphere-normals-inward", "shapes", "shapes|normals"},
    {"shape-sphere-radius-one", "shapes", "shapes"},
    {"shape-sphere-square-half", "shapes", "shapes"},
    {"shape-cylinder-square-half", "shapes", "shapes"},
    {"shape-caps-square-half", "shapes", "shapes"},
    {"shape-quadratic-precedence", "shapes", "shapes"},
    {"shape-roots-doubled", "shapes", "shapes"},
    {"shape-sphere-b-not-doubled", "shapes", "shapes"},
    {"shape-sphere-four-a", "shapes", "shapes"},
    {"shape-wide-cones", "shapes", "shapes"},
    {"shape-cube-face-missing", "shapes", "shapes"},
    {"hit-far-root", "nearest-hit", "nearest-hit"},
    {"hit-near-root-only", "nearest-hit", "nearest-hit"},
    {"light-replaces", "lights", "lights"},
    {"light-point-of-object", "lights", "lights|transforms"},
    {"light-attenuates-sum", "attenuation", "attenuation|lights"},
    {"ambient-times-light", "ambient", "ambient"},
    {"ambient-where-lit", "ambient", "ambient"},
    {"diffuse-no-light-color", "diffuse", "diffuse"},
    {"diffuse-specular-coefficient", "diffuse", "diffuse"},
    {"specular-no-light-color", "specular", "specular"},
    {"specular-diffuse-coefficient", "specular", "specular"},
    {"specular-reversed-mirror", "specular", "specular"},
    {"specular-eye-as-direction", "specular", "specular"},
    {"specular-normal-view", "specular", "specular"},
    {"specular-fixed-exponent", "specular", "specular"},
    {"attenuation-squared-distance", "attenuation", "attenuation"},
    {"attenuation-multiplied", "attenuation", "attenuation"},
    {"attenuation-reversed", "attenuation", "attenuation"},
    {"attenuation-no-constant", "attenuation", "attenuation"},
    {"spot-reversed", "spots", "spot-falloff|lights"},
    {"spot-penumbra-inverted", "spots", "spot-falloff"},
    {"shadow-greater", "shadows", "shadows"},
    {"shadow-bias-negative", "shadows", "shadows|acne|lights"},
    {"shadow-object-distance", "shadows", "shadows"},
    {"shadow-not-own", "shadows", "shadows"},
    {"shadow-of-last-object", "shadows", "shadows"},
    {"shadow-of-first-object", "shadows", "shadows"},
    {"shadow-half", "shadows", "shadows"},
    {"shadow-directional-none", "shadows", "shadows"},
    {"shadow-directional-ends", "shadows", "shadows"},
    {"shadow-points-none", "shadows", "shadows"},
    {"mirror-replaces", "mirrors", "reflection"},
    {"mirror-diffuse-coefficient", "mirrors", "reflection"},
    {"mirror-no-shadows", "mirrors", "reflection|shadows"},
    {"mirror-no-textures", "mirrors", "reflection|texture"},
    {"mirror-coefficient-once", "mirrors", "reflection"},
    {"mirror-last-weight", "mirrors", "reflection"},
    {"mirror-depth-three", "mirrors", "recursion-depth"},
    {"mirror-depth-five", "mirrors", "recursion-depth"},
    {"texture-caps-as-side", "textures", "texture"},
    {"texture-clamped", "textures", "texture"},
    {"texture-divided", "textures", "texture"},
    {"texture-quarter-turn", "textures", "texture"},
    {"texture-wrong-way-around", "textures", "texture"},
    {"texture-sphere-linear", "textures", "texture"},
    {"texture-sides-as-sphere", "textures", "texture"},
    {"texture-cube-front", "textures", "texture"},
    {"texture-cube-same-faces", "textures", "texture"},
    {"texture-unlit", "textures", "texture"},
    {"texture-blend-reversed", "textures", "texture"},
    {"texture-added", "textures", "texture"},
    {"texture-integer-division", "textures", "texture"},
    {"texture-bytes", "textures", "texture"},
    {"texture-missing-on-cubes", "textures", "texture"},
    {"glass-ior-fixed", "refraction", "refraction"},
    {"glass-one-side", "refraction", "refraction"},
    {"glass-no-local", "refraction", "refraction"},
    {"output-256", "output", "overflow"},
    {"output-average-side", "output", "brightness|samples"},
    {"output-tonemapped", "output", "gamma"},
    {"output-negative", "output", "brightness"},
    {"output-channels-turned", "output", "swapped-channels"},
    {"attenuation-of-highlights", "attenuation", "attenuation"},
    {"attenuation-of-diffuse", "attenuation", "attenuation"},
    {"shadow-directional-only", "shadows", "shadows"},
    {"shadow-resets", "shadows", "shadows"},
    {"ambient-faded", "ambient", "ambient"},
    {"ambient-in-sum", "ambient", "ambient"},
    {"normal-gradient-of-cones", "normals", "normals"},
    {"shape-square-caps-of-cones", "shapes", "shapes"},
    {"specular-times-diffuse", "specular", "specular"},
    {"specular-of-first-light", "specular", "lights|specular"},
    {"specular-of-last-light", "specular", "lights|specular"},
    {"diffuse-assigned", "diffuse", "lights|diffuse"},
    {"spot-powers-swapped", "spots", "spot-falloff"},
    {"spot-from-axis", "spots", "spot-falloff"},
};

using Made = MadeMistakes<table>;

struct Object {
  mat4 matrix{1};
  mat4 inverse{1};
  const Primitive* primitive = nullptr;
};

struct Lamp {
  Light light;
  vec3 position{0};
  vec3 direction{0};
};

struct Found {
  float t = far_away;
  float key = far_away;
  const Object* object = nullptr;
  vec3 point{0};   // object space
  vec3 normal{0};  // object space
  bool cap = false;
};

class Tracer {
 public:
  Tracer(const Scene& scene, const Assets& assets, std::span<const std::string> names,
         const Job& job)
      : scene_(scene), assets_(assets), names_(names), job_(job), made_(job.mistakes) {
    mat4 start(1);
    visit(scene.root, start);
    if (has("scene-moved-object") && !objects_.empty()) {
      Object& moved = objects_[objects_.size() / 2];
      moved.matrix[3] += vec4(0.3f, 0.2f, -0.2f, 0);
      moved.inverse = glm::inverse(moved.matrix);
    }
    if (has("scene-moved-light") && !lamps_.empty()) {
      if (lamps_[0].light.type == LightType::directional) {
        lamps_[0].direction = glm::normalize(lamps_[0].direction) + vec3(0.3f, 0.1f, -0.2f);
      } else {
        lamps_[0].position += vec3(1.3f, -0.4f, 0.7f);
      }
    }
    if (has("light-only-first") && lamps_.size() > 1) {
      lamps_.resize(1);
    }
    const Camera camera = scene.camera.value_or(Camera());
    eye_ = has("camera-at-origin") ? vec3(0) : camera.position;
    vec3 look = has("camera-look-long") ? camera.look : glm::normalize(camera.look);
    if (has("camera-look-as-point")) {
      look = glm::normalize(camera.look - camera.position);
    }
    w_ = -look;
    const vec3 up = glm::normalize(camera.up);
    v_ = up - glm::dot(up, w_) * w_;
    v_ = has("camera-up-not-perpendicular") ? up
         : has("camera-up-not-normalized")  ? v_
                                            : glm::normalize(v_);
    u_ = glm::normalize(has("camera-cross-swapped") ? glm::cross(w_, up) : glm::cross(up, w_));
    if (has("camera-view-matrix")) {
      eye_ = -(glm::transpose(mat3(u_, v_, w_)) * eye_);
    }
    if (has("camera-transposed") || has("camera-view-matrix")) {
      const mat3 axes = glm::transpose(mat3(u_, v_, w_));
      u_ = axes[0];
      v_ = axes[1];
      w_ = axes[2];
    }
    if (has("camera-backward") || has("camera-backward-turned")) {
      w_ = -w_;
      u_ = has("camera-backward-turned") ? -u_ : u_;
    }
    if (has("scene-rolled-camera")) {
      const vec3 u = u_;
      u_ = 0.97f * u_ + 0.243f * v_;
      v_ = 0.97f * v_ - 0.243f * u;
    }
    if (has("scene-moved-camera")) {
      eye_ += 0.3f * u_ + 0.2f * v_;
    }
    const float degrees = camera.height_angle_deg;
    const float angle = has("camera-degrees") ? degrees : degrees * pi / 180;
    const float aspect = float(job.width) / float(job.height);
    top_ = std::tan(has("camera-full-angle")      ? angle
                    : has("camera-quarter-angle") ? angle / 4
                                                  : angle / 2);
    top_ = has("camera-no-tangent") ? angle / 2 : top_;
    right_ = top_ * aspect * (has("camera-aspect-twice") ? aspect : 1);
    if (has("camera-aspect-ignored")) {
      right_ = top_;
    } else if (has("camera-aspect-swapped")) {
      right_ = top_ / aspect;
    } else if (has("camera-height-for-width")) {
      right_ = top_;
      top_ = right_ / aspect;
    } else if (has("camera-width-angle-times-aspect")) {
      right_ = std::tan(aspect * angle / 2);
    }
  }

  Texture picture() const {
    Texture result;
    result.width = job_.width;
    result.height = job_.height;
    result.rgb.resize(std::size_t{3} * job_.width * job_.height);
    for (int row = 0; row < job_.height; ++row) {
      for (int column = 0; column < job_.width; ++column) {
        const int place =
            has("output-column-order") ? column * job_.height + row : row * job_.width + column;
        store(result.rgb.data() + std::size_t{3} * place,
              has("output-black") ? vec3(0) : pixel(column, row));
      }
    }
    return has("output-blurred") ? blurred(result) : result;
  }

 private:
  static Texture blurred(const Texture& sharp) {
    Texture result = sharp;
    for (int y = 1; y + 1 < sharp.height; ++y) {
      for (int x = 1; x + 1 < sharp.width; ++x) {
        for (int i = 0; i < 3; ++i) {
          int sum = 0;
          for (int k = 0; k < 9; ++k) {
            sum += sharp.texel(x + k % 3 - 1, y + k / 3 - 1)[i];
          }
          result.rgb[3 * (std::size_t(y) * sharp.width + x) + i] =
              static_cast<std::uint8_t>(sum / 9);
        }
      }
    }
    return result;
  }

  // A fixed random number for each pixel, in [0, 1).
  static float chance(int a, int b) {
    auto x =
        static_cast<std::uint32_t>(a) * 2654435761u ^ static_cast<std::uint32_t>(b) * 2246822519u;
    x ^= x >> 15;
    x *= 2246822519u;
    x ^= x >> 13;
    return static_cast<float>(x & 0xffffff) / 16777216.0f;
  }

  vec3 pixel(int column, int row) const {
    const int y = has("output-upside-down") ? job_.height - 1 - row : row;
    int x = has("output-mirrored") ? job_.width - 1 - column : column;
    x = has("output-one-pixel-off") ? std::min(x + 1, job_.width - 1) : x;
    const bool four = has("habit-four-samples") || has("output-misses-black") ||
                      has("output-sum-of-samples") || has("output-average-side");
    const int side = four ? 2 : has("habit-nine-samples") ? 3 : 1;
    vec3 sum(0);
    bool missed = false;
    for (int i = 0; i < side * side; ++i) {
      vec2 at = (vec2(i % side, i / side) + 0.5f) / float(side);
      if (has("habit-jitter")) {
        at += 0.4f * (vec2(chance(x, y), chance(x + 7919, y)) - 0.5f);
      }
      if (has("camera-corners")) {
        at = vec2(0);
      }
      if (has("camera-right-edges")) {
        at.x = 1;
      }
      vec3 seen = sample(float(x) + at.x, float(y) + at.y, missed);
      if (side > 1) {
        seen = glm::clamp(seen, vec3(0), vec3(1));
      }
      sum += seen;
    }
    if (missed && has("output-misses-black")) {
      return vec3(0);
    }
    vec3 color = sum / float(has("output-sum-of-samples") ? 1
                             : has("output-average-side") ? side
                                                          : side * side);
    const vec2 middle(2 * float(x) / float(job_.width) - 1, 2 * float(y) / float(job_.height) - 1);
    if (has("strange-vignette")) {
      color *= 1 - 0.4f * glm::dot(middle, middle);
    }
    if (has("strange-noise")) {
      color += 0.15f * (vec3(chance(x, y), chance(y, x + 99), chance(x + 5, y + 3)) - 0.5f);
    }
    if (has("strange-stripes") && y % 8 < 2) {
      color *= 0.6f;
    }
    if (has("output-half-drawn") && 2 * x > job_.width) {
      color = vec3(0);
    }
    return color;
  }

  vec3 sample(float x, float y, bool& missed) const {
    const float less = has("camera-pixels-less-one") ? 1.0f : 0.0f;
    if (less > 0) {
      x -= 0.5f;
      y -= 0.5f;
    }
    float a = 2 * x / (float(job_.width) - less) - 1;
    float b = 1 - 2 * y / (float(job_.height) - less);
    if (has("camera-zero-to-one")) {
      a = (a + 1) / 2;
      b = (b + 1) / 2;
    }
    if (has("strange-fisheye")) {
      const float bend = 1 + 0.25f * (a * a + b * b);
      a *= bend;
      b *= bend;
    }
    if (has("camera-half-film")) {
      a /= 2;
      b /= 2;
    }
    if (has("camera-orthographic")) {
      return traced(eye_ + 3.0f * (a * right_ * u_ + b * top_ * v_), -w_, missed);
    }
    const vec3 added = has("camera-direction-as-point") ? eye_ : vec3(0);
    return traced(eye_, glm::normalize(a * right_ * u_ + b * top_ * v_ - w_ + added), missed);
  }

  vec3 traced(const vec3& from, const vec3& direction, bool& missed) const {
    const Found f = closest(from, direction, has("hit-behind") ? -far_away : 0, false);
    if (f.object == nullptr) {
      missed = true;
      return trace(from, direction, 0);
    }
    vec3 color = trace(from, direction, 0);
    if (has("strange-fog")) {
      const float clear = std::exp(-0.08f * f.t);
      color = clear * color + (1 - clear) * vec3(0.6f);
    }
    if (has("strange-depth-dark")) {
      color *= std::min(1.0f, 4 / std::max(f.t, 0.01f));
    }
    return color;
  }

  bool has(Made::Place mistake) const { return made_.contains(mistake); }

  void store(std::uint8_t* to, vec3 color) const {
    if (has("output-bgr")) {
      std::swap(color.x, color.z);
    }
    if (has("output-channels-turned")) {
      color = {color.y, color.z, color.x};
    }
    if (has("output-tonemapped")) {
      color = color / (color + 1.0f);
    }
    if (has("output-scaled")) {
      color /= std::max({1.0f, color.x, color.y, color.z});
    }
    if (has("output-gray")) {
      color = glm::clamp(color, vec3(0), vec3(1));
      color = vec3((color.x + color.y + color.z) / 3);
    }
    if (has("strange-saturation")) {
      const float middle = (color.x + color.y + color.z) / 3;
      color = middle + 1.5f * (color - middle);
    }
    if (has("output-warm")) {
      color *= vec3(1.1f, 1.0f, 0.75f);
    }
    for (int i = 0; i < 3; ++i) {
      float c = color[i];
      if (has("output-contrast")) {
        c = 1.35f * (c - 0.5f) + 0.5f;
      }
      if (has("output-lifted")) {
        c = 0.85f * std::min(std::max(c, 0.0f), 1.0f) + 0.1f;
      }
      if (has("strange-posterized")) {
        c = std::floor(c * 6) / 6;
      }
      if (has("output-wraps")) {
        to[i] = static_cast<std::uint8_t>(static_cast<int>(c * 255) & 255);
        continue;
      }
      c = std::min(std::max(c, 0.0f), 1.0f);
      if (has("output-256")) {
        to[i] = static_cast<std::uint8_t>(static_cast<int>(c * 256) & 255);
        continue;
      }
      c = has("output-negative") ? 1 - c : c;
      if (has("output-gamma")) {
        c = std::pow(c, 1 / 2.2f);
      }
      if (has("output-gamma-inverse")) {
        c = std::pow(c, 2.2f);
      }
      if (has("output-gamma-two")) {
        c = std::sqrt(c);
      }
      if (has("output-srgb")) {
        c = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
      }
      if (has("output-signed") && c >= 128 / 255.0f) {
        c = 0;
      }
      if (has("output-half")) {
        c = c / 2;
      }
      to[i] = static_cast<std::uint8_t>(c * 255 + (has("habit-rounds") ? 0.5f : 0.0f));
    }
  }

  mat4 matrix_of(const Transform& transform) const {
    mat4 m(1);
    if (const auto* move = std::get_if<Translate>(&transform.map)) {
      m[3] = vec4(has("transform-move-negated") ? -move->by : move->by, 1);
    } else if (const auto* scale = std::get_if<Scale>(&transform.map)) {
      const vec3 by = has("transform-no-scale")        ? vec3(1)
                      : has("transform-scale-divided") ? 1.0f / scale->by
                      : has("transform-scale-x")       ? vec3(scale->by.x)
                                                       : scale->by;
      m[0][0] = by.x;
      m[1][1] = by.y;
      m[2][2] = by.z;
    } else if (const auto* rotate = std::get_if<Rotate>(&transform.map)) {
      float angle = rotate->angle_deg;
      angle = has("transform-radians") ? angle : angle * pi / 180;
      angle = has("transform-rotation-sign") ? -angle : angle;
      angle = has("transform-half-turned") ? angle / 2 : angle;
      const vec3 a =
          has("transform-axis-not-normalized") ? rotate->axis : glm::normalize(rotate->axis);
      const float c = std::cos(angle);
      const float s = std::sin(angle);
      for (int column = 0; column < 3; ++column) {
        vec3 e(0);
        e[column] = 1;
        m[column] = vec4(c * e + s * glm::cross(a, e) + (1 - c) * glm::dot(a, e) * a, 0);
      }
    } else if (const auto* matrix = std::get_if<Matrix>(&transform.map)) {
      m = has("transform-transposed") ? glm::transpose(matrix->m()) : matrix->m();
    }
    return m;
  }

  // The transforms in an order of their kinds, whatever the order of the file is.
  std::vector<Transform> in_order(std::vector<Transform> transforms) const {
    for (const auto& [mistake, order] :
         {std::pair(Made::Place("transform-order-tsr"), std::string_view("tsr")),
          std::pair(Made::Place("transform-order-srt"), std::string_view("srt")),
          std::pair(Made::Place("transform-order-str"), std::string_view("str")),
          std::pair(Made::Place("transform-order-rts"), std::string_view("rts")),
          std::pair(Made::Place("transform-order-rst"), std::string_view("rst"))}) {
      if (has(mistake)) {
        const auto place = [&order = order](const Transform& t) {
          return std::holds_alternative<Translate>(t.map) ? order.find('t')
                 : std::holds_alternative<Scale>(t.map)   ? order.find('s')
                 : std::holds_alternative<Rotate>(t.map)  ? order.find('r')
                                                          : order.size();
        };
        std::stable_sort(
            transforms.begin(), transforms.end(),
            [&](const Transform& a, const Transform& b) { return place(a) < place(b); });
      }
    }
    return transforms;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the file
  void visit(NodeId id, mat4& parent) {
    const Node& node = scene_.nodes[id];
    mat4 here(1);
    for (const Transform& t : in_order(node.transforms)) {
      here = has("transform-reversed") ? matrix_of(t) * here : here * matrix_of(t);
    }
    const bool lost = has("transform-outer-lost") && !node.children.empty();
    mat4 matrix = lost ? parent : has("transform-nesting-reversed") ? here * parent : parent * here;
    for (const Light& light : node.lights) {
      const mat4 m = has("transform-lights-not") ? mat4(1) : matrix;
      lamps_.push_back(
          {light, vec3(m * vec4(light.position, 1)), vec3(m * vec4(light.direction, 0))});
    }
    for (const Primitive& primitive : node.primitives) {
      if (primitive.shape != Shape::mesh) {
        mat4 m = has("transform-all-transposed") ? glm::transpose(matrix) : matrix;
        if (has("shape-double-size")) {
          m = m * mat4(mat3(2));
        }
        objects_.push_back({m, has("transform-rays-forward") ? m : glm::inverse(m), &primitive});
      }
    }
    for (const NodeId child : node.children) {
      visit(child, matrix);
    }
    const std::string wanted(node.instance_of);
    if (!wanted.empty()) {
      for (const NodeId master : scene_.templates) {
        if (std::string(scene_.nodes[master].name) == wanted) {
          visit(master, has("transform-instances-not") ? parent : matrix);
        }
      }
    }
    if (has("transform-not-restored")) {
      parent = matrix;
    }
  }

  // ---- shapes ----

  static void offer(std::vector<Found>& list, float t, const vec3& o, const vec3& d,
                    const vec3& normal, bool cap) {
    Found f;
    f.t = t;
    f.point = o + t * d;
    f.normal = normal;
    f.cap = cap;
    list.push_back(f);
  }

  float solved(float above, float a) const {
    return has("shape-quadratic-precedence") ? above / 2 * a
           : has("shape-roots-doubled")      ? above / a
                                             : above / (2 * a);
  }

  void crossings(Shape shape, const vec3& o, const vec3& d, std::vector<Found>& list) const {
    switch (shape) {
      case Shape::sphere: {
        if (has("shape-no-spheres")) {
          return;
        }
        const float a = (has("shape-sphere-four-a") ? 4.0f : 1.0f) * glm::dot(d, d);
        const float b = (has("shape-sphere-b-not-doubled") ? 1.0f : 2.0f) * glm::dot(o, d);
        const float c = glm::dot(o, o) - (has("shape-sphere-radius-one")    ? 1.0f
                                          : has("shape-sphere-square-half") ? 0.5f
                                                                            : 0.25f);
        const float root = b * b - 4 * a * c;
        if (root < 0) {
          return;
        }
        for (const float sign : {-1.0f, 1.0f}) {
          const float t = solved(-b + sign * std::sqrt(root), a);
          offer(list, t, o, d, 2.0f * (o + t * d), false);
        }
        return;
      }
      case Shape::cube:
        if (has("shape-no-cubes")) {
          return;
        }
        for (int axis = 0; axis < 3; ++axis) {
          for (const float side : {-0.5f, 0.5f}) {
            if (has("shape-cube-face-missing") && axis == 2 && side > 0) {
              continue;
            }
            const float t = (side - o[axis]) / d[axis];
            const vec3 p = o + t * d;
            if (std::abs(p[(axis + 1) % 3]) <= 0.5f && std::abs(p[(axis + 2) % 3]) <= 0.5f) {
              vec3 n(0);
              n[axis] = side < 0 && !has("shape-cube-normals-positive") ? -1.0f : 1.0f;
              offer(list, t, o, d, has("shape-cube-normal-sphere") ? 2.0f * p : n, false);
            }
          }
        }
        return;
      case Shape::cylinder: {
        if (has("shape-no-cylinders")) {
          return;
        }
        const float a = d.x * d.x + d.z * d.z;
        const float b = 2 * (o.x * d.x + o.z * d.z);
        const float c = o.x * o.x + o.z * o.z -
                        (has("shape-wide-cylinders")         ? 1.0f
                         : has("shape-cylinder-square-half") ? 0.5f
                                                             : 0.25f);
        const float root = b * b - 4 * a * c;
        for (const float sign : {-1.0f, 1.0f}) {
          const float t = solved(-b + sign * std::sqrt(std::max(root, 0.0f)), a);
          const vec3 p = o + t * d;
          if (root >= 0 && (std::abs(p.y) <= 0.5f || has("shape-endless-cylinders"))) {
            const float up = has("shape-cylinder-normal-sphere") ? 2 * p.y : 0;
            offer(list, t, o, d, {2 * p.x, up, 2 * p.z}, false);
          }
          const bool missing = sign > 0 ? has("shape-no-top-cap") : has("shape-no-bottom-cap");
          cap(o, d, 0.5f * sign, missing || has("shape-no-cylinder-caps"), list);
        }
        return;
      }
      case Shape::cone: {
        if (has("shape-no-cones")) {
          return;
        }
        // x^2 + z^2 = ((0.5 - y) / 2)^2
        const float k = 0.5f - o.y;
        const float steep = has("shape-wide-cones") ? 1 : 4;
        const float a = d.x * d.x + d.z * d.z - d.y * d.y / steep;
        const float b = 2 * (o.x * d.x + o.z * d.z) + 2 * k * d.y / steep;
        const float c = o.x * o.x + o.z * o.z - k * k / steep;
        const float root = b * b - 4 * a * c;
        for (const float sign : {-1.0f, 1.0f}) {
          const float t = solved(-b + sign * std::sqrt(std::max(root, 0.0f)), a);
          const vec3 p = o + t * d;
          if (root >= 0 && p.y >= -0.5f && (p.y <= 0.5f || has("shape-double-cones"))) {
            const float slope = has("shape-cone-normal-level")   ? 0
                                : has("shape-cone-normal-steep") ? 0.5f - p.y
                                                                 : (0.5f - p.y) / 2;
            offer(list, t, o, d, {2 * p.x, has("shape-cone-normal-constant") ? 1 : slope, 2 * p.z},
                  false);
          }
        }
        cap(o, d, -0.5f, has("shape-no-cone-cap") || has("shape-no-bottom-cap"), list, true);
        return;
      }
      case Shape::mesh:
        return;
    }
  }

  void cap(const vec3& o, const vec3& d, float y, bool missing, std::vector<Found>& list,
           bool cone = false) const {
    const float t = (y - o.y) / d.y;
    const vec3 p = o + t * d;
    const float limit = has("shape-wide-caps")          ? 1.0f
                        : has("shape-caps-square-half") ? 0.5f
                                                        : 0.25f;
    const bool inside = has("shape-square-caps") || (has("shape-square-caps-of-cones") && cone)
                            ? std::max(std::abs(p.x), std::abs(p.z)) <= 0.5f
                            : p.x * p.x + p.z * p.z <= limit;
    if (!missing && inside) {
      const bool down =
          (y < 0 && !has("shape-cap-normals-up")) != has("shape-cap-normals-inverted");
      offer(list, t, o, d, {0, down ? -1.0f : 1.0f, 0}, true);
    }
  }

  // `shadow_of`: the object that a shadow ray starts at.
  Found closest(const vec3& from, const vec3& direction, float least, bool shadow,
                const Object* shadow_of = nullptr) const {
    Found best;
    std::vector<Found> list;
    for (const Object& object : objects_) {
      if (shadow && ((has("shadow-of-last-object") && &object != &objects_.back()) ||
                     (has("shadow-of-first-object") && &object != &objects_.front()) ||
                     (has("shadow-not-own") && &object == shadow_of))) {
        continue;
      }
      if (has("shape-some-missing") && (&object - objects_.data()) % 3 == 1) {
        continue;
      }
      if (has("shadow-not-of-spheres") && shadow && object.primitive->shape == Shape::sphere) {
        continue;
      }
      const float o_w = has("transform-origin-as-direction") ? 0.0f : 1.0f;
      const float d_w = has("transform-direction-as-point") ? 1.0f : 0.0f;
      const vec3 o = vec3(object.inverse * vec4(from, o_w));
      const vec3 d =
          has("transform-direction-not") ? direction : vec3(object.inverse * vec4(direction, d_w));
      list.clear();
      crossings(object.primitive->shape, o, d, list);
      Found nearest;
      if (has("hit-near-root-only") && !list.empty()) {
        list = {*std::min_element(list.begin(), list.end(),
                                  [](const Found& a, const Found& b) { return a.t < b.t; })};
      }
      for (const Found& f : list) {
        const bool farther =
            (has("hit-farthest") || has("hit-far-root")) && !shadow && nearest.object != nullptr;
        if (f.t > least && (farther ? f.t > nearest.t : f.t < nearest.t)) {
          nearest = f;
          nearest.object = &object;
        }
      }
      if (nearest.object == nullptr) {
        continue;
      }
      nearest.key = nearest.t;
      if (shadow && has("shadow-object-distance")) {
        nearest.key = nearest.t = nearest.t * glm::length(d);
      }
      if (!shadow) {
        const bool of_object = has("hit-object-distance") || has("hit-object-compared");
        const bool farthest = has("hit-farthest") || has("hit-farthest-object");
        nearest.key = of_object         ? nearest.t * glm::length(d)
                      : has("hit-last") ? -1
                      : farthest        ? -nearest.t
                                        : nearest.t;
      }
      if (best.object == nullptr || nearest.key <= best.key) {
        best = nearest;
      }
    }
    if (has("hit-object-distance") && !shadow && best.object != nullptr) {
      best.t = best.key;
    }
    if (has("habit-coarse-distances") && best.object != nullptr) {
      best.t = best.t * (1 + 2e-5f * (chance(static_cast<int>(1e4f * best.t), 3) - 0.5f));
    }
    return best;
  }

  // ---- textures ----

  vec2 uv_of(const Found& f) const {
    const vec3& p = f.point;
    const vec3& n = f.normal;
    const Shape shape = f.object->primitive->shape;
    if (shape == Shape::cube) {
      if (has("texture-cube-front")) {
        return {p.x + 0.5f, p.y + 0.5f};
      }
      if (has("texture-cube-same-faces")) {
        return {n.x != 0 ? 0.5f + p.z : p.x + 0.5f, n.y != 0 ? 0.5f - p.z : p.y + 0.5f};
      }
      if (n.x != 0) {
        return {n.x > 0 ? 0.5f - p.z : p.z + 0.5f, p.y + 0.5f};
      }
      if (n.z != 0) {
        return {n.z > 0 ? p.x + 0.5f : 0.5f - p.x, p.y + 0.5f};
      }
      return {p.x + 0.5f, n.y > 0 ? 0.5f - p.z : p.z + 0.5f};
    }
    if (f.cap && !has("texture-caps-as-side")) {
      return {p.x + 0.5f, n.y > 0 ? 0.5f - p.z : p.z + 0.5f};
    }
    const float theta = std::atan2(p.z, p.x);
    float u = has("texture-half-turned-mirrored") ? (theta + pi) / (2 * pi)
              : theta < 0                         ? -theta / (2 * pi)
                                                  : 1 - theta / (2 * pi);
    u = has("texture-quarter-turn") ? u + 0.25f - std::floor(u + 0.25f) : u;
    u = has("texture-wrong-way-around") ? 1 - u : u;
    const bool angle =
        shape == Shape::sphere ? !has("texture-sphere-linear") : has("texture-sides-as-sphere");
    return {u,
            angle ? std::asin(std::min(std::max(2 * p.y, -1.0f), 1.0f)) / pi + 0.5f : p.y + 0.5f};
  }

  const Texture* texture_of(const Material& m) const {
    if (!m.texture || !job_.texture || m.blend == 0) {
      return nullptr;
    }
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == m.texture->file && !assets_.textures[i].empty()) {
        return &assets_.textures[i];
      }
    }
    return nullptr;
  }

  static vec3 filtered(const Texture& texture, float u, float v) {
    const float x = u * float(texture.width) - 0.5f;
    const float y = v * float(texture.height) - 0.5f;
    vec3 sum(0);
    for (int k = 0; k < 4; ++k) {
      const float at_x = std::floor(x) + float(k % 2);
      const float at_y = std::floor(y) + float(k / 2);
      const float weight = (1 - std::abs(x - at_x)) * (1 - std::abs(y - at_y));
      const int column = ((static_cast<int>(at_x) % texture.width) + texture.width) % texture.width;
      const int row = ((static_cast<int>(at_y) % texture.height) + texture.height) % texture.height;
      const std::uint8_t* p = texture.texel(column, row);
      sum += weight * vec3(p[0], p[1], p[2]) / 255.0f;
    }
    return sum;
  }

  // The blend of the texture with the finished lighting. `texture`: its color.
  float share_over_lighting(const Found& f, vec3& texture) const {
    const Material& m = f.object->primitive->material;
    const Texture* const image = texture_of(m);
    if (image == nullptr) {
      return 0;
    }
    const vec2 uv = uv_of(f);
    const auto place = [](float x, int size) {
      const int i = static_cast<int>(std::floor(x * float(size))) % size;
      return i < 0 ? i + size : i;
    };
    const std::uint8_t* texel =
        image->texel(place(uv.x * m.texture->repeat_u, image->width),
                     place((1 - uv.y) * m.texture->repeat_v, image->height));
    texture = vec3(texel[0], texel[1], texel[2]) / 255.0f;
    return m.blend;
  }

  vec3 diffuse_of(const Found& f, int depth) const {
    const Material& m = f.object->primitive->material;
    const float kd = has("diffuse-no-coefficient")         ? 1
                     : has("diffuse-specular-coefficient") ? scene_.global.specular
                                                           : scene_.global.diffuse;
    const vec3 plain = kd * m.diffuse;
    const Texture* const texture = texture_of(m);
    const bool cone = f.object->primitive->shape == Shape::cone;
    if (texture == nullptr || has("texture-missing") || (has("mirror-no-textures") && depth > 0) ||
        has("texture-over-lighting") || has("texture-over-all") ||
        (cone && has("texture-missing-on-cones")) ||
        (f.object->primitive->shape == Shape::cube && has("texture-missing-on-cubes")) ||
        (f.cap && has("texture-missing-on-caps"))) {
      return plain;
    }
    vec2 uv = uv_of(f);
    uv.x = has("texture-flip-u") || has("texture-flip-both") ? 1 - uv.x : uv.x;
    uv.y = has("texture-flip-v") || has("texture-flip-both") ? uv.y : 1 - uv.y;
    if (has("texture-swapped")) {
      uv = {1 - uv.y, 1 - uv.x};
    }
    const bool repeats = !has("texture-not-repeated");
    const auto place = [this](float x, int size) {
      if (has("texture-mirrored-repeat")) {
        x = std::fmod(std::abs(x), 2.0f);
        x = x > 1 ? 2 - x : x;
      }
      const int whole = static_cast<int>(std::floor(x * float(size)));
      if (has("texture-clamped")) {
        return std::min(std::max(whole, 0), size - 1);
      }
      const int i = whole % size;
      return i < 0 ? i + size : i;
    };
    const auto repeated = [&](float x, float count) {
      return has("texture-divided") ? x / count : x * (repeats ? count : 1);
    };
    const int column = place(repeated(uv.x, m.texture->repeat_u), texture->width);
    const int row = place(repeated(uv.y, m.texture->repeat_v), texture->height);
    const std::uint8_t* texel = texture->texel(column, row);
    vec3 t = vec3(texel[0], texel[1], texel[2]) / 255.0f;
    if (has("texture-filtered")) {
      t = filtered(*texture, uv.x * (repeats ? m.texture->repeat_u : 1),
                   uv.y * (repeats ? m.texture->repeat_v : 1));
    }
    if (has("texture-blue-red")) {
      std::swap(t.x, t.z);
    }
    if (has("texture-integer-division")) {
      t = glm::floor(t);
    }
    if (has("texture-bytes")) {
      t *= 255.0f;
    }
    if (has("texture-blend-reversed")) {
      return m.blend * plain + (1 - m.blend) * t;
    }
    if (has("texture-added")) {
      return plain + m.blend * t;
    }
    if (has("texture-blend-ignored")) {
      return t;
    }
    if (has("texture-times-coefficient")) {
      t *= kd;
    }
    if (has("texture-times-coefficient-no-blend")) {
      return kd * t;
    }
    if (has("texture-times-diffuse")) {
      t *= plain;
    }
    if (has("texture-times-diffuse-no-blend")) {
      return plain * t;
    }
    if (has("texture-rest-lacks-coefficient")) {
      return (1 - m.blend) * m.diffuse + m.blend * t;
    }
    return (1 - m.blend) * plain + m.blend * t;
  }

  // ---- light ----

  float spot(const Light& light, const vec3& axis, const vec3& to_light) const {
    if (has("spot-as-point")) {
      return 1;
    }
    float outer = light.angle_deg.value_or(light.penumbra_deg) * pi / 180;
    const float penumbra = light.penumbra_deg * pi / 180;
    float inner = std::max(outer - penumbra, 0.0f);
    if (has("spot-half-angle")) {
      outer /= 2;
      inner = std::max(outer - penumbra, 0.0f);
    }
    if (has("spot-outside")) {
      inner = outer;
      outer += penumbra;
    }
    if (has("spot-penumbra-as-inner")) {
      inner = std::min(penumbra, outer);
    }
    if (has("spot-angles-swapped")) {
      inner = std::max(penumbra - outer, 0.0f);
      outer = penumbra;
    }
    if (has("spot-no-penumbra")) {
      inner = outer;
    }
    if (has("spot-double-penumbra")) {
      inner -= outer - inner;
    }
    if (has("spot-inner-only")) {
      outer = inner;
    }
    const float side = has("spot-reversed") ? -1.0f : 1.0f;
    const float angle =
        std::acos(std::min(std::max(side * glm::dot(-to_light, axis), -1.0f), 1.0f));
    if (has("spot-cosine-cubed")) {
      return std::pow(std::max(std::cos(angle), 0.0f), 3.0f);
    }
    if (angle <= inner) {
      return 1;
    }
    if (angle > outer) {
      return 0;
    }
    if (has("spot-linear-cosine")) {
      return (std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    }
    float x = (angle - inner) / (outer - inner);
    x = has("spot-penumbra-inverted") ? 1 - x : x;
    x = has("spot-from-axis") ? angle / outer : x;
    if (has("spot-powers-swapped")) {
      return 1 - (3 * x * x * x - 2 * x * x);
    }
    return has("spot-linear") ? 1 - x : 1 - (3 * x * x - 2 * x * x * x);
  }

  bool skipped(LightType type) const {
    return (job_.directional_alone && type != LightType::directional &&
            !has("light-all-in-intersect")) ||
           (has("light-no-directional") && type == LightType::directional) ||
           (has("light-no-point") && type == LightType::point) ||
           (has("light-no-spot") && type == LightType::spot) || type == LightType::area;
  }

  vec3 lighting(const Found& f, const vec3& point, const vec3& normal, const vec3& eye,
                int depth) const {
    const Material& m = f.object->primitive->material;
    const vec3 base = diffuse_of(f, depth);
    const vec3 ambient = (has("ambient-no-coefficient") ? 1 : scene_.global.ambient) * m.ambient;
    vec3 color = has("ambient-missing") ? vec3(0) : ambient;
    if (has("ambient-per-light")) {
      color *= float(lamps_.size());
    }
    if (has("ambient-twice")) {
      color *= 2.0f;
    }
    if (has("ambient-times-texture")) {
      vec3 texture(1);
      color *= share_over_lighting(f, texture) > 0 ? texture : vec3(1);
    }
    if (has("ambient-times-diffuse")) {
      color *= m.diffuse;
    }
    if (has("strange-rim")) {
      color += vec3(0.5f) * std::pow(1 - std::abs(glm::dot(normal, eye)), 2.0f);
    }
    if (has("strange-headlight")) {
      color += 0.4f * base * std::max(glm::dot(normal, eye), 0.0f);
    }
    if (has("ambient-times-light") || has("ambient-faded") || has("ambient-in-sum")) {
      color = vec3(0);
    }
    vec3 last_diffuse(0);
    bool first_shadowed = false;
    bool any_light = false;
    const float ks = has("specular-no-coefficient")        ? 1
                     : has("specular-diffuse-coefficient") ? scene_.global.diffuse
                                                           : scene_.global.specular;
    for (const Lamp& lamp : lamps_) {
      const Light& light = lamp.light;
      if (skipped(light.type)) {
        continue;
      }
      const bool directional = light.type == LightType::directional;
      const vec3 axis = glm::normalize(lamp.direction);
      vec3 to_light = has("light-direction-not-normalized") ? -lamp.direction : -axis;
      float distance = far_away;
      float strength = 1;
      if (directional && has("light-position-as-direction")) {
        to_light = glm::normalize(-lamp.position);
      }
      if (!directional) {
        distance = glm::length(lamp.position - point);
        to_light = has("light-vector-sum") ? glm::normalize(lamp.position + point)
                                           : (lamp.position - point) / distance;
        const vec3& a = light.attenuation;
        const float far = has("attenuation-of-eye-distance") ? glm::length(point - eye_) : distance;
        const float c = a.x + a.y * far + (has("attenuation-no-quadratic") ? 0 : a.z * far * far);
        strength = has("attenuation-not-clamped") ? 1 / c : std::min(1.0f, 1 / c);
        if (has("attenuation-squared-distance")) {
          const float square = distance * distance;
          strength = std::min(1.0f, 1 / (a.x + a.y * square + a.z * square * square));
        }
        if (has("attenuation-multiplied")) {
          strength = c;
        }
        if (has("attenuation-reversed")) {
          strength = std::min(1.0f, 1 / (a.z + a.y * distance + a.x * distance * distance));
        }
        if (has("attenuation-no-constant")) {
          strength = std::min(1.0f, 1 / (a.y * distance + a.z * distance * distance));
        }
        if (has("attenuation-none")) {
          strength = 1;
        }
        if (has("attenuation-square")) {
          strength = std::min(1.0f, 1 / (distance * distance));
        }
        if (has("attenuation-square-unlimited")) {
          strength = 1 / (distance * distance);
        }
        if (has("attenuation-inverse")) {
          strength = 1 / distance;
        }
        if (has("attenuation-no-linear")) {
          strength = std::min(1.0f, 1 / (a.x + a.z * distance * distance));
        }
        if (has("attenuation-root")) {
          strength = 1 / std::sqrt(distance);
        }
        if (has("attenuation-exponential")) {
          strength = std::exp(-0.2f * distance);
        }
        if (has("attenuation-late")) {
          strength = std::min(1.0f, 3 / (1 + distance));
        }
        if (light.type == LightType::spot) {
          strength *= spot(light, axis, to_light);
        }
      }
      if (has("light-reversed") || (directional && has("light-directional-reversed"))) {
        to_light = -to_light;
      }
      bool shadowed = false;
      const bool casts = !(directional && has("shadow-directional-none")) &&
                         !(light.type == LightType::point && has("shadow-points-none")) &&
                         !(!directional && has("shadow-directional-only")) &&
                         !(depth > 0 && has("mirror-no-shadows"));
      if (job_.shadows && !has("shadow-none") && casts) {
        const float bias = has("shadow-acne")             ? 0.0f
                           : has("shadow-large-bias")     ? 0.25f
                           : has("shadow-bias-one-third") ? 0.33f
                           : has("habit-small-bias")      ? 2e-4f
                                                          : 1e-3f;
        vec3 start = point;
        if (has("habit-bias-along-normal")) {
          start += 1e-3f * normal;
        }
        if (has("shadow-bias-normal")) {
          start += 0.2f * normal;
        }
        if (has("shadow-before-surface")) {
          start += 0.2f * glm::normalize(eye_ - point);
        }
        if (has("shadow-bias-negative")) {
          start -= 4e-3f * to_light;
        }
        vec3 toward = has("shadow-reversed") ? -to_light : to_light;
        if (has("shadow-spot-axis") && light.type == LightType::spot) {
          toward = -axis;
        }
        const bool ends = directional && has("shadow-directional-ends");
        const bool eye_distance = has("shadow-distance-of-eye") ||
                                  (!directional && has("shadow-distance-of-eye-positional"));
        const float end = has("shadow-beyond-light")    ? far_away
                          : has("shadow-unit-distance") ? 1.0f
                          : ends                        ? glm::length(lamp.position - point)
                          : eye_distance                ? glm::length(point - eye_)
                                                        : distance;
        const float met = closest(start, toward, bias, true, f.object).t;
        shadowed = (has("shadow-greater") ? met < far_away && met > end : met < end) !=
                   has("shadow-inverted");
        if (has("strange-soft-shadows")) {
          const vec3 side(
              0.15f * chance(static_cast<int>(1e4f * point.x), static_cast<int>(1e4f * point.z)),
              0.02f, 0.15f * chance(static_cast<int>(1e4f * point.y), 5));
          shadowed = closest(start, glm::normalize(toward + side), bias, true).t < end;
        }
        if (has("shadow-spots-none") && light.type == LightType::spot) {
          shadowed = false;
        }
        if (has("shadow-first-for-all")) {
          first_shadowed = &lamp == lamps_.data() ? shadowed : first_shadowed;
          shadowed = first_shadowed;
        }
      }
      if (has("light-shading-reversed") && directional) {
        to_light = -to_light;
      }
      if (shadowed && has("shadow-ambient-only")) {
        return ambient;
      }
      if (shadowed && has("shadow-stops")) {
        break;
      }
      if (shadowed && has("shadow-black")) {
        return vec3(0);
      }
      if (shadowed && has("shadow-resets")) {
        color = vec3(0);
      }
      any_light = any_light || !shadowed;
      const vec3 l = has("light-not-normalized") && !directional ? lamp.position - point : to_light;
      float cosine = glm::dot(normal, l);
      if (has("diffuse-absolute-everywhere")) {
        cosine = std::abs(cosine);
      }
      if (has("specular-clamped-mirror")) {
        cosine = std::max(cosine, 0.0f);
      }
      float weight = std::max(cosine, 0.0f);
      weight = has("diffuse-absolute") ? std::abs(cosine) : weight;
      weight = has("diffuse-not-clamped") ? cosine : weight;
      weight = has("diffuse-half-lambert") ? 0.5f * cosine + 0.5f : weight;
      weight = has("diffuse-over-pi") ? weight / pi : weight;
      weight = has("diffuse-no-cosine") && cosine > 0 ? 1 : weight;
      weight = has("strange-steps") ? std::floor(weight * 4) / 4 : weight;
      weight =
          has("strange-oren") ? weight * (1.2f - 0.6f * std::abs(glm::dot(normal, eye))) : weight;
      weight *= has("diffuse-missing") ? 0.0f : has("diffuse-twice") ? 2.0f : 1.0f;
      const vec3 v = has("specular-eye-reversed")         ? -eye
                     : has("specular-eye-not-normalized") ? eye_ - point
                     : has("specular-eye-as-direction")   ? glm::normalize(eye_)
                                                          : eye;
      float shine = glm::dot(2 * cosine * normal - l, v);
      if (has("specular-blinn")) {
        shine = glm::dot(normal, glm::normalize(l + v));
      }
      if (has("specular-reversed-mirror")) {
        shine = -shine;
      }
      if (has("specular-normal-view")) {
        shine = glm::dot(normal, v);
      }
      if (has("specular-light-view")) {
        shine = glm::dot(l, v);
      }
      if (has("specular-absolute")) {
        shine = std::abs(shine);
      }
      vec3 highlight(0);
      const float exponent = has("specular-half-exponent")      ? m.shininess / 2
                             : has("specular-root-of-exponent") ? std::sqrt(m.shininess) + 2
                             : has("specular-fixed-exponent")   ? 32
                                                                : m.shininess;
      const bool any_sign = has("specular-negative-power") && exponent == std::floor(exponent);
      if ((shine > 0 || any_sign) && m.shininess > 0) {
        highlight =
            ks * m.specular * (has("specular-no-exponent") ? shine : std::pow(shine, exponent));
      }
      if (has("specular-lit-side") && cosine < 0) {
        highlight = vec3(0);
      }
      highlight *= has("specular-missing") ? 0.0f : has("specular-twice") ? 2.0f : 1.0f;
      if (has("specular-times-cosine")) {
        highlight *= std::max(cosine, 0.0f);
      }
      highlight *= has("specular-times-diffuse") ? m.diffuse : vec3(1);
      if ((has("specular-of-first-light") && &lamp != lamps_.data()) ||
          (has("specular-of-last-light") && &lamp != &lamps_.back())) {
        highlight = vec3(0);
      }
      vec3 light_color = has("light-white")         ? vec3(1)
                         : has("light-unit-colors") ? glm::normalize(light.color)
                                                    : light.color;
      light_color /= has("light-no-color-share") ? float(lamps_.size()) : 1.0f;
      if (has("ambient-times-light")) {
        color += light_color * ambient;
      }
      if (has("ambient-faded")) {
        color += strength * ambient;
      }
      if (has("ambient-in-sum") && !shadowed) {
        color += strength * light_color * ambient;
      }
      if (shadowed && has("shadow-half")) {
        color += 0.5f * strength * light_color * (weight * base + highlight);
      }
      if (shadowed) {
        if (has("shadow-keeps-specular")) {
          color += strength * light_color * highlight;
        }
        continue;
      }
      if (has("texture-unlit") && texture_of(m) != nullptr) {
        weight = 1;
      }
      const vec3 diffuse = weight * base * (has("diffuse-no-light-color") ? vec3(1) : light_color);
      highlight *= has("specular-no-light-color") ? vec3(1) : light_color;
      const vec3 added = has("attenuation-of-highlights") ? diffuse + strength * highlight
                         : has("attenuation-of-diffuse")  ? strength * diffuse + highlight
                                                          : strength * (diffuse + highlight);
      if (has("light-replaces")) {
        color = added;
        continue;
      }
      if (has("diffuse-assigned")) {
        color += added - last_diffuse;
        last_diffuse = strength * diffuse;
        continue;
      }
      if (has("light-attenuates-sum")) {
        color = strength * (color + diffuse + highlight);
        continue;
      }
      color += has("habit-clamped-lights") ? glm::min(added, vec3(4)) : added;
    }
    if (has("ambient-where-lit") && !any_light) {
      color -= ambient;
    }
    return color;
  }

  vec3 world_normal(const Found& f) const {
    const bool side = f.cap && has("shape-cap-normals-side");
    const vec3 n = has("normal-sphere-for-all") ? glm::normalize(f.point)
                   : side                       ? glm::normalize(vec3(f.point.x, 0, f.point.z))
                                                : glm::normalize(f.normal);
    const mat3 m(f.object->matrix);
    const mat3 inverse(f.object->inverse);
    if (has("normal-gradient-of-cones")) {
      const bool round = f.object->primitive->shape == Shape::sphere ||
                         f.object->primitive->shape == Shape::cylinder;
      return glm::transpose(inverse) * (round && !f.cap ? 0.5f * f.normal : f.normal);
    }
    if (has("normal-gradient")) {
      const bool flat = f.cap || f.object->primitive->shape == Shape::cube;
      return glm::transpose(inverse) * (flat ? f.normal : 0.5f * f.normal);
    }
    if (has("normal-not-normalized-by-matrix")) {
      return m * n;
    }
    const bool sphere = f.object->primitive->shape == Shape::sphere;
    if (has("normal-by-matrix") || (sphere && has("normal-from-center"))) {
      return glm::normalize(m * n);
    }
    if (has("normal-by-inverse")) {
      return glm::normalize(inverse * n);
    }
    if (has("normal-by-transpose")) {
      return glm::normalize(glm::transpose(m) * n);
    }
    if (sphere && has("shape-sphere-normals-inward")) {
      return -glm::normalize(glm::transpose(inverse) * n);
    }
    if (has("normal-of-object")) {
      return n;
    }
    if (has("normal-like-point")) {
      return glm::normalize(vec3(f.object->matrix * vec4(n, 1)));
    }
    if (has("normal-four-components")) {
      return vec3(glm::normalize(glm::transpose(f.object->inverse) * vec4(n, 0)));
    }
    const vec3 world = glm::transpose(inverse) * n;
    if (has("normal-not-normalized")) {
      return world;
    }
    return has("normal-inverted") ? -glm::normalize(world) : glm::normalize(world);
  }

  // NOLINTNEXTLINE(misc-no-recursion): limited by the depth of reflections
  vec3 trace(const vec3& from, const vec3& direction, int depth,
             const vec3& last_weight = vec3(1)) const {
    const float least = depth == 0                 ? (has("hit-behind") ? -far_away : 0)
                        : has("mirror-acne")       ? 0
                        : has("mirror-large-bias") ? 0.5f
                                                   : 1e-3f;
    const Found f = closest(from, direction, least, false);
    if (f.object == nullptr) {
      return has("output-background") && depth == 0 ? vec3(0.5f, 0.7f, 0.9f) : vec3(0);
    }
    return hit(f, from, direction, depth, last_weight);
  }

  // NOLINTNEXTLINE(misc-no-recursion)
  vec3 hit(const Found& f, const vec3& from, const vec3& direction, int depth,
           const vec3& last_weight = vec3(1)) const {
    const Material& m = f.object->primitive->material;
    vec3 normal = world_normal(f);
    if (has("normal-toward-eye") && glm::dot(normal, direction) > 0) {
      normal = -normal;
    }
    if (has("normal-absolute")) {
      normal = glm::abs(normal);
    }
    if (has("output-normals")) {
      return (normal + 1.0f) / 2.0f;
    }
    if (has("strange-bumps")) {
      normal = glm::normalize(normal + 0.25f * glm::sin(25.0f * f.point));
    }
    const vec3 point = has("light-point-of-object") ? f.point : from + f.t * direction;
    const vec3 eye = has("mirror-eye-at-camera") ? glm::normalize(eye_ - point) : -direction;
    vec3 color = last_weight * lighting(f, point, normal, eye, depth);
    if (has("glass-no-local") && job_.refract && m.transparent != vec3(0)) {
      color = vec3(0);
    }
    if (has("strange-other-colors") && m.diffuse.x > m.diffuse.y) {
      color = vec3(color.y, color.x, color.z);
    }
    vec3 texture(0);
    const float over = has("texture-over-lighting") || has("texture-over-all")
                           ? share_over_lighting(f, texture)
                           : 0;
    if (has("texture-over-lighting")) {
      color = (1 - over) * color + over * texture;
    }
    const int depths = has("mirror-depth-one")     ? 1
                       : has("mirror-depth-two")   ? 2
                       : has("mirror-depth-three") ? 3
                       : has("mirror-depth-five")  ? 5
                       : has("mirror-deep")        ? 9
                                                   : 4;
    if (job_.reflect && !has("mirror-missing") && m.reflective != vec3(0) && depth < depths) {
      vec3 mirrored = direction - 2 * glm::dot(direction, normal) * normal;
      mirrored = has("mirror-reversed") ? -mirrored : mirrored;
      mirrored = has("mirror-wrong-sign") ? direction + 2 * glm::dot(direction, normal) * normal
                                          : mirrored;
      const float ks = scene_.global.specular;
      vec3 weight = ks * m.reflective;
      const bool chained = !has("mirror-last-weight");
      const vec3 seen =
          trace(point, glm::normalize(mirrored), depth + 1, chained ? vec3(1) : weight);
      weight = chained ? weight : vec3(1);
      if (has("mirror-diffuse-coefficient")) {
        weight = scene_.global.diffuse * m.reflective;
      }
      if (has("mirror-coefficient-once") && depth > 0) {
        weight = m.reflective;
      }
      weight = has("mirror-no-coefficient") ? m.reflective : weight;
      weight = has("mirror-color-ignored") ? vec3(ks) : weight;
      weight = has("mirror-specular-color") ? ks * m.specular : weight;
      if (has("strange-fresnel")) {
        weight *= 0.2f + 0.8f * std::pow(1 - std::abs(glm::dot(normal, direction)), 3.0f);
      }
      if (has("mirror-not-chained") && depth > 0) {
        weight = vec3(1);
      }
      color = has("mirror-blended")         ? (1.0f - weight) * color + weight * seen
              : has("mirror-blended-plain") ? (1.0f - ks) * color + ks * seen
              : has("mirror-blended-color") ? (1.0f - m.reflective) * color + m.reflective * seen
              : has("mirror-replaces")      ? weight * seen
              : has("mirror-maximum")       ? glm::max(color, weight * seen)
              : has("mirror-product")       ? (1.0f - weight) * color + weight * seen * color
                                            : color + weight * seen;
    }
    if (job_.refract && !has("glass-missing") && m.transparent != vec3(0) && depth < depths) {
      const float kt = scene_.global.transparent.value_or(0);
      const vec3 weight = has("glass-blended-plain")    ? vec3(kt)
                          : has("glass-no-coefficient") ? m.transparent
                                                        : kt * m.transparent;
      if (has("glass-blended") || has("glass-blended-plain")) {
        color *= 1.0f - weight;
      }
      color += weight * through(f, point, glm::normalize(direction), depth);
    }
    if (has("texture-over-all")) {
      color = (1 - over) * color + over * texture;
    }
    return depth > 0 ? glm::clamp(color, vec3(0), vec3(1)) : color;
  }

  // NOLINTNEXTLINE(misc-no-recursion)
  vec3 through(const Found& f, const vec3& point, const vec3& direction, int depth) const {
    const Material& m = f.object->primitive->material;
    const float ior = has("glass-ior-fixed") ? 1.5f : m.ior > 0 ? m.ior : 1;
    const vec3 outward = glm::normalize(glm::transpose(mat3(f.object->inverse)) * f.normal);
    const bool entering = glm::dot(direction, outward) < 0;
    vec3 inside;
    const bool in = bend(direction, outward, entering, ior, inside);
    if (!in && (has("glass-no-total-reflection") || has("glass-eta-inverted-black"))) {
      return vec3(0);
    }
    if (!in || !entering || has("glass-shaded-inside")) {
      return trace(point, inside, depth + 1);
    }
    vec3 origin = point;
    for (int i = 0; i < 4 - depth; ++i) {
      const Found wall = closest(origin, inside, 1e-3f, false);
      if (wall.object == nullptr) {
        return vec3(0);
      }
      if (wall.object != f.object) {
        return hit(wall, origin, inside, depth + 1);
      }
      origin = origin + wall.t * inside;
      const vec3 n = glm::normalize(glm::transpose(mat3(f.object->inverse)) * wall.normal);
      vec3 out;
      if (bend(inside, n, false, ior, out)) {
        return trace(origin, out, depth + 1);
      }
      if (has("glass-no-total-reflection")) {
        return vec3(0);
      }
      inside = out;
    }
    return vec3(0);
  }

  bool bend(const vec3& d, vec3 n, bool entering, float ior, vec3& out) const {
    float eta = entering || has("glass-same-ratio") ? 1 / ior : ior;
    if (has("glass-eta-inverted") || has("glass-eta-inverted-black")) {
      eta = 1 / eta;
    }
    if (has("glass-straight") || (!entering && has("glass-one-side"))) {
      out = d;
      return true;
    }
    n = glm::dot(d, n) > 0 ? -n : n;
    const float c = -glm::dot(d, n);
    const float k = 1 - eta * eta * (1 - c * c);
    if (k < 0) {
      out = d + 2 * c * n;
      return false;
    }
    out = glm::normalize(eta * d +
                         (eta * c - (has("glass-wrong-sign") ? -std::sqrt(k) : std::sqrt(k))) * n);
    return true;
  }

  const Scene& scene_;
  const Assets& assets_;
  std::span<const std::string> names_;
  const Job& job_;
  Made made_;
  std::vector<Object> objects_;
  std::vector<Lamp> lamps_;
  vec3 eye_{0}, u_{0}, v_{0}, w_{0};
  float right_ = 1;
  float top_ = 1;
};

}  // namespace

std::span<const KnownMistake> known_mistakes() {
  return table;
}

Texture draw(const Scene& scene, const Assets& assets, std::span<const std::string> texture_names,
             const Job& job) {
  return Tracer(scene, assets, texture_names, job).picture();
}

}  // namespace scenefile::student
