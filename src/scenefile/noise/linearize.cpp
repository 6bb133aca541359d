#include "scenefile/noise/linearize.h"

#include "scenefile/path/lamps.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

// The luminance before the course's curve (path/tone.h).
double uncompressed(double shown, double white) {
  const double square = white * white;
  const double b = 1 - shown;
  return square / 2 * (-b + std::sqrt(b * b + 4 * shown / square));
}

Color undone(const Color& v, ToneCurve curve, double white) {
  switch (curve) {
    case ToneCurve::course: {
      const Color square = v * v;
      const double shown = luminance(square);
      return shown > 0 ? square * (uncompressed(shown, white) / shown) : Color(0);
    }
    case ToneCurve::reinhard: {
      const Color power = glm::pow(v, Color(2.2));
      return power / glm::max(Color(1) - power, Color(1e-3));
    }
    case ToneCurve::power22:
      return glm::pow(v, Color(2.2));
    case ToneCurve::srgb: {
      Color result;
      for (int c = 0; c < 3; ++c) {
        result[c] = v[c] <= 0.04045 ? v[c] / 12.92 : std::pow((v[c] + 0.055) / 1.055, 2.4);
      }
      return result;
    }
    case ToneCurve::power2:
      return v * v;
    case ToneCurve::linear:
    case ToneCurve::clamp:
      break;
  }
  return v;
}

}  // namespace

LinearPicture linearized(const DecodedPicture& picture, ToneCurve curve, double white) {
  LinearPicture result;
  const bool floats = picture.is_linear();
  const std::size_t count = (floats ? picture.linear.rgb.size() : picture.texture.rgb.size()) / 3;
  result.pixels.resize(count);
  result.rounding.resize(count);
  result.usable.resize(count, 1);
  for (std::size_t i = 0; i < count; ++i) {
    Color v;
    for (int c = 0; c < 3; ++c) {
      v[c] =
          floats ? double(picture.linear.rgb[3 * i + c]) : picture.texture.rgb[3 * i + c] / 255.0;
    }
    if (floats) {
      result.usable[i] = std::isfinite(v.x + v.y + v.z) ? 1 : 0;
      v = result.usable[i] != 0 ? v : Color(0);
      if (curve == ToneCurve::linear) {
        result.pixels[i] = v;
        continue;
      }
      v = glm::clamp(v, Color(0), Color(1));
    }
    result.usable[i] = result.usable[i] != 0 && std::max({v.x, v.y, v.z}) < 1 ? 1 : 0;
    result.pixels[i] = undone(v, curve, white);
    const Color step = undone(glm::min(v + 0.5 / 255, Color(1)), curve, white) -
                       undone(glm::max(v - 0.5 / 255, Color(0)), curve, white);
    result.rounding[i] = step * step / 12.0;
  }
  return result;
}

}  // namespace scenefile
