#include "scenefile/mistakes/hypotheses.h"
#include "scenefile/mistakes/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scenefile {

namespace {

using glm::dvec3;
using Hypotheses = std::vector<Hypothesis>;

double srgb_code(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

double srgb_value(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

void add_picture(Hypotheses& list, Cause cause, std::string what,
                 std::function<dvec3(const dvec3&)> color) {
  list.push_back({cause, std::move(what), Stage::picture, {}, {}, std::move(color)});
}

void add_curve(Hypotheses& list, std::string what, double (*curve)(double)) {
  add_picture(list, Cause::gamma, std::move(what), [curve](const dvec3& color) {
    const dvec3 c = clamped(color);
    return dvec3(curve(c.x), curve(c.y), curve(c.z));
  });
}

void add_gamma(Hypotheses& list) {
  add_curve(list, "gamma 2.2 was applied, but the format has no gamma correction",
            [](double v) { return std::pow(v, 1 / 2.2); });
  add_curve(list, "values were raised to the power of 2.2 (inverse gamma)",
            [](double v) { return std::pow(v, 2.2); });
  add_curve(list, "gamma 2 was applied (a square root), but the format has no gamma correction",
            [](double v) { return std::sqrt(v); });
  add_curve(list, "gamma 1.8 was applied, but the format has no gamma correction",
            [](double v) { return std::pow(v, 1 / 1.8); });
  add_curve(list, "values were squared", [](double v) { return v * v; });
  add_curve(list, "values were raised to the power of 1.8",
            [](double v) { return std::pow(v, 1.8); });
  add_curve(list, "values were encoded as sRGB, but the format has no gamma correction", srgb_code);
  add_curve(list, "values were decoded from sRGB, but the format has no gamma correction",
            srgb_value);
  add_curve(list, "values were tone mapped (x / (1 + x)), but the format has no tone mapping",
            [](double v) { return v / (1 + v); });
  add_picture(list, Cause::gamma,
              "values were tone mapped (1 - exp(-x)), but the format has no tone mapping",
              [](const dvec3& c) { return 1.0 - glm::exp(-c); });
}

void add_brightness(Hypotheses& list) {
  for (const auto& [factor, what] :
       {std::pair(0.5, "the picture is half as bright"),
        std::pair(2.0, "the picture is twice as bright"),
        std::pair(0.25, "the picture has a quarter of its brightness"),
        std::pair(4.0, "the picture is four times as bright"),
        std::pair(1 / 3.0, "the picture has a third of its brightness")}) {
    add_picture(list, Cause::brightness, what,
                [factor = factor](const dvec3& c) { return factor * clamped(c); });
  }
  add_picture(list, Cause::brightness, "the picture is a negative",
              [](const dvec3& c) { return 1.0 - clamped(c); });
  add_picture(list, Cause::brightness, "the picture is gray", [](const dvec3& color) {
    const dvec3 c = clamped(color);
    return dvec3((c.x + c.y + c.z) / 3);
  });
  add_picture(list, Cause::brightness, "the picture is gray (by luminance)",
              [](const dvec3& color) {
                const dvec3 c = clamped(color);
                return dvec3(0.299 * c.x + 0.587 * c.y + 0.114 * c.z);
              });
  static constexpr std::array<const char*, 3> names{"red", "green", "blue"};
  for (int channel = 0; channel < 3; ++channel) {
    add_picture(list, Cause::swapped_channels,
                fmt::format("the {} of the picture is missing", names[channel]),
                [channel](const dvec3& color) {
                  dvec3 c = clamped(color);
                  c[channel] = 0;
                  return c;
                });
    add_picture(list, Cause::swapped_channels,
                fmt::format("only the {} of the picture is stored", names[channel]),
                [channel](const dvec3& color) {
                  dvec3 c(0);
                  c[channel] = clamped(color)[channel];
                  return c;
                });
    add_picture(list, Cause::swapped_channels,
                fmt::format("the {} of the picture is stored in all channels", names[channel]),
                [channel](const dvec3& color) { return dvec3(clamped(color)[channel]); });
  }
}

// Values keep their fractions: truncating them here would explain a curve after truncation.
void add_overflow(Hypotheses& list) {
  add_picture(list, Cause::overflow, "values over 1 wrap around to dark: they are not clamped",
              [](const dvec3& color) {
                dvec3 c;
                for (int i = 0; i < 3; ++i) {
                  c[i] = std::fmod(255 * std::max(color[i], 0.0), 256) / 255;
                }
                return c;
              });
  add_picture(list, Cause::overflow,
              "values over 1 wrap around to dark: they are multiplied by 256 and not clamped",
              [](const dvec3& color) {
                dvec3 c;
                for (int i = 0; i < 3; ++i) {
                  c[i] = std::fmod(256 * std::max(color[i], 0.0), 256) / 255;
                }
                return c;
              });
  add_picture(list, Cause::overflow, "colors over 1 are scaled down by their maximum",
              [](const dvec3& color) {
                const double most = std::max({color.x, color.y, color.z, 1.0});
                return color / most;
              });
  add_picture(list, Cause::overflow, "colors over 1 become black", [](const dvec3& color) {
    return std::max({color.x, color.y, color.z}) > 1 ? dvec3(0) : color;
  });
  add_picture(list, Cause::overflow, "values over 127 become 0: they are stored in a signed type",
              [](const dvec3& color) {
                dvec3 c = clamped(color);
                for (int i = 0; i < 3; ++i) {
                  c[i] = c[i] >= 128 / 255.0 ? 0 : c[i];
                }
                return c;
              });
  add_picture(list, Cause::overflow, "values over 1 become 0", [](const dvec3& color) {
    return dvec3(color.x > 1 ? 0 : color.x, color.y > 1 ? 0 : color.y, color.z > 1 ? 0 : color.z);
  });
  add_picture(list, Cause::overflow, "colors are scaled to full brightness", [](const dvec3& c) {
    const double most = std::max({c.x, c.y, c.z});
    return most > 0 ? c / most : c;
  });
}

}  // namespace

std::vector<Hypothesis> picture_hypotheses() {
  Hypotheses list;
  const auto turned = [&](Cause cause, const char* what, bool across, bool down) {
    list.push_back({cause, what, Stage::picture, {}, {across, down}, {}});
  };
  turned(Cause::vertical_flip, "the picture is upside down (mirrored top to bottom)", false, true);
  turned(Cause::horizontal_flip, "the picture is mirrored left to right", true, false);
  turned(Cause::vertical_flip, "the picture is rotated by half a turn (mirrored both ways)", true,
         true);
  static constexpr std::array<std::pair<std::array<int, 3>, const char*>, 5> orders{
      {{{2, 1, 0}, "blue, green, red"},
       {{1, 0, 2}, "green, red, blue"},
       {{0, 2, 1}, "red, blue, green"},
       {{1, 2, 0}, "green, blue, red"},
       {{2, 0, 1}, "blue, red, green"}}};
  for (const auto& [order, said] : orders) {
    add_picture(list, Cause::swapped_channels,
                fmt::format("the channels are in the order {}", said),
                [o = order](const dvec3& c) { return dvec3(c[o[0]], c[o[1]], c[o[2]]); });
  }
  add_gamma(list);
  add_brightness(list);
  add_overflow(list);
  return list;
}

}  // namespace scenefile
