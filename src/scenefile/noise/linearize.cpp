#include "scenefile/noise/linearize.h"

#include "scenefile/path/lamps.h"

#include <fmt/format.h>

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

Color without_srgb(const Color& v) {
  Color result;
  for (int c = 0; c < 3; ++c) {
    result[c] = v[c] <= 0.04045 ? v[c] / 12.92 : std::pow((v[c] + 0.055) / 1.055, 2.4);
  }
  return result;
}

Color without_gamma(const Color& v, double exponent) {
  return exponent == srgb_gamma ? without_srgb(v) : glm::pow(v, Color(exponent));
}

std::string gamma_words(double exponent) {
  return exponent == srgb_gamma ? "sRGB"
         : exponent == 1        ? "no gamma"
                                : fmt::format("gamma {:.3g}", exponent);
}

Color undone(const Color& v, const ScreenCurve& screen) {
  switch (screen.curve) {
    case ToneCurve::course:
    case ToneCurve::compressed: {
      const Color square = screen.curve == ToneCurve::course ? v * v : v;
      const double shown = luminance(square);
      return shown > 0 ? square * (uncompressed(shown, screen.parameter) / shown) : Color(0);
    }
    case ToneCurve::reinhard: {
      const Color power = without_gamma(v, screen.parameter);
      return power / glm::max(Color(1) - power, Color(1e-3));
    }
    case ToneCurve::luminance: {
      const Color power = without_gamma(v, screen.parameter);
      return power / std::max(1 - luminance(power), 1e-3);
    }
    case ToneCurve::film:
      return -glm::log(glm::max(Color(1) - without_gamma(v, screen.parameter), Color(1e-3)));
    case ToneCurve::power:
      return glm::pow(v, Color(screen.parameter));
    case ToneCurve::srgb:
      return without_srgb(v);
    case ToneCurve::linear:
    case ToneCurve::clamp:
      break;
  }
  return v;
}

}  // namespace

std::string ScreenCurve::words() const {
  switch (curve) {
    case ToneCurve::linear:
      return "linear values";
    case ToneCurve::course:
      return "the tone curve of the course";
    case ToneCurve::compressed:
      return "the tone curve of the course without gamma";
    case ToneCurve::reinhard:
      return "the tone curve v / (1 + v) and " + gamma_words(parameter);
    case ToneCurve::luminance:
      return "the tone curve v / (1 + luminance) and " + gamma_words(parameter);
    case ToneCurve::film:
      return "the tone curve 1 - exp(-v) and " + gamma_words(parameter);
    case ToneCurve::power:
      return fmt::format("gamma {:.3g}", parameter);
    case ToneCurve::srgb:
      return "sRGB";
    case ToneCurve::clamp:
      break;
  }
  return "values from 0 to 1";
}

bool ScreenCurve::clamps() const {
  return curve == ToneCurve::power || curve == ToneCurve::srgb || curve == ToneCurve::clamp;
}

double ScreenCurve::unclamped(double value) const {
  switch (curve) {
    case ToneCurve::power:
      return std::pow(value, 1 / parameter);
    case ToneCurve::srgb:
      return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
    default:
      return value;
  }
}

LinearPicture linearized(const DecodedPicture& picture, const ScreenCurve& screen) {
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
      if (screen.curve == ToneCurve::linear) {
        result.pixels[i] = v;
        continue;
      }
      v = glm::clamp(v, Color(0), Color(1));
    }
    result.usable[i] = result.usable[i] != 0 && std::max({v.x, v.y, v.z}) < 1 ? 1 : 0;
    result.pixels[i] = undone(v, screen);
    const Color step = undone(glm::min(v + 0.5 / 255, Color(1)), screen) -
                       undone(glm::max(v - 0.5 / 255, Color(0)), screen);
    result.rounding[i] = step * step / 12.0;
  }
  return result;
}

}  // namespace scenefile
