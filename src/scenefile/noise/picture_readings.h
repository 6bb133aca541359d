#pragma once
// Ways to read a picture: of 8-bit values, several tone curves, as they are or with an exposure.
// For each of them, what explains the picture. Internal to noise.

#include "scenefile/noise/path_models.h"

#include <optional>
#include <vector>

namespace scenefile {

/// The exponents of 2.2 or 2, applied twice, are near it.
inline constexpr double gamma_twice = 4.4;

/// Of the difference beyond noise, the part that an explanation may leave. The rest is what
/// programs with the same mistake do differently.
inline constexpr double most_left = 0.15;

/// The most that an explanation may leave, as a multiple of the variance of the noise. What exceeds
/// the noise is what programs with the same mistake do differently.
inline constexpr double max_noise = 3;

/// How far the factor of a kind of light is off at least, to say that it is wrong.
inline constexpr double least_off = 0.1;

/// The factor of lamps that the camera sees.
struct LampFactor {
  double value = 1;
  double error = 0;             ///< standard error, by rounding and differences of programs
  double beyond_reflected = 0;  ///< the largest factor of a channel over what lamps reflect there

  /// A dark color of a bright lamp may be rounded to nothing, so each of them counts.
  bool is_black() const { return value < 0.03 && beyond_reflected < 2; }
};

/// One way to linearize the picture, and what the search found then.
struct Reading {
  ScreenCurve screen;
  bool any_exposure = false;
  double exposure = 1;  ///< the values were divided by it, so that noise has the truth's units
  LinearPicture picture;
  std::optional<LampFactor> lamps;  ///< in `picture`
  ObservedBlocks seen;
  PathModel right;
  std::vector<PathModel> models;  ///< the best first
  std::optional<PathModel> two;   ///< mistakes, where none explains it alone

  double values() const { return 3.0 * static_cast<double>(std::max<std::size_t>(1, seen.tested)); }

  /// Whether some model explains it better than the right picture does, beyond chance.
  bool differs() const;

  /// The part of the difference beyond noise.
  double explained(const PathModel& m) const;

  /// Whether the model, with its own noise, leaves little more than noise.
  bool is_like_noise(const PathModel& m) const;

  /// Whether the model leaves little of the difference beyond noise. What its own noise could
  /// explain does not count.
  bool is_complete(const PathModel& m) const;

  /// Of two models that explain as much but for this, the simpler one is likelier.
  double tie() const;

  /// How badly it explains the file: by mean logarithms, in the units of the file.
  double cost() const;
};

/// Reads the picture with this curve; Reading::models stays empty.
Reading read_as(const TruthBlocks& back, const DecodedPicture& mine, const ScreenCurve& screen,
                bool any_exposure);

/// Other pixels, such as those of another view, read like `before`. Without models.
Reading read_again(const TruthBlocks& back, const Reading& before, LinearPicture pixels);

/// 8-bit values read by the rising curve, the same for all channels, that brings them nearest to
/// the truth: `before`, times a piecewise linear factor. None if there are too few values.
std::optional<Reading> read_by_any_curve(const TruthBlocks& back, const DecodedPicture& mine,
                                         const Reading& before);

/// The likeliest first; none if most of the picture is clipped.
std::vector<Reading> readings_of(const TruthBlocks& back, const DecodedPicture& mine);

/// Of floats that may be values for the screen: as they are, without an exposure or models.
std::vector<Reading> readings_as_shown(const TruthBlocks& back, const DecodedPicture& mine);

/// Whether a fitted number is a constant within its error.
bool is_number(double value, double error, double constant);

/// Pixels that show nothing but lamps.
std::vector<std::size_t> lamp_pixels(const TruthBlocks& back);

}  // namespace scenefile
