#pragma once
// Whether a path-traced picture is right within its noise, and if not, which mistake it shows.
//
// The means of blocks of 8x8 pixels are compared with the truth's. The variance of a block is
// estimated from the truth's samples, averaged with neighboring blocks, and scaled by the median
// ratio of the picture's variance within its blocks to that estimate; the measured noise of the
// truth is added. Each known mistake is a picture of the same paths (path_truth.h). Some have a
// factor, which is fitted by weighted least squares together with a subpixel shift; the standard
// errors of factors take the residuals into account.
//
// A difference counts if it exceeds `claim_errors` standard errors and `least_effect` of the light
// that it concerns. For normal noise, the significance level of all tests together is then below
// 1e-6 (Sidak's correction); the margin allows for the heavy tails of path tracing. A mistake is
// named if it leaves at most 15 % of the excess over the noise, and no other one explains the
// picture as well.

#include "scenefile/asset/image_file.h"
#include "scenefile/mistakes/cause.h"
#include "scenefile/noise/path_truth.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace scenefile {

inline constexpr double claim_errors = 6;
inline constexpr double least_effect = 0.04;

/// A mistake, or another convention.
struct PathClaim {
  Cause page = Cause::scattering;  ///< of help
  std::string name;                ///< such as "lamp-cosine"
  std::string what;                ///< as a phrase
  std::string evidence;            ///< numbers, as text
  double explained = 0;            ///< of the excess over the noise, at most 1
};

/// A kind of light, and how much of it the picture has.
struct PathPlace {
  std::string name;   ///< "direct light"
  double share = 0;   ///< of the truth's light, without visible lamps
  double factor = 1;  ///< mine / truth
  double error = 0;   ///< standard error of the factor
};

struct PathVerdict {
  bool right = false;                  ///< nothing found, and noise would have hidden little
  bool too_noisy = false;              ///< nothing found, but noise could hide much
  double more_samples = 1;             ///< too_noisy: how many times as many would do; or infinity
  bool truth_too_noisy = false;        ///< then: because of the noise of the truth
  std::vector<PathClaim> causes;       ///< one, or several that give the same picture
  std::vector<PathClaim> partial;      ///< true, but not all
  std::vector<PathClaim> conventions;  ///< differences that are not wrong
  std::vector<PathClaim> notes;
  std::vector<PathPlace> places;
  std::vector<double> energy_truth;  ///< by bounces from 1, mean luminance, without visible lamps
  std::vector<double> energy_mine;   ///< the same as fitted; empty if that is not possible
  std::vector<double> significance;  ///< by block: (mine - truth) / standard error
  BlockColors mine;                  ///< by block: the picture, linear and without the exposure
  std::vector<double> errors;        ///< by block: of significance, as luminance; 0: left out
  int columns = 0;                   ///< of blocks
  std::size_t tested = 0;            ///< blocks that were compared
  double critical = 0;       ///< largest |significance| by chance at the corrected level of 1 %
  double largest = 0;        ///< largest |significance|
  glm::ivec2 largest_at{0};  ///< the pixel in the middle of that block
  double samples = 0;        ///< per pixel that a program like ours needs for this noise
  double truth_samples = 0;
  std::string curve;           ///< how 8-bit values were made
  double exposure = 1;         ///< fitted factor of 8-bit pictures
  std::size_t fireflies = 0;   ///< pixels far above their neighbors
  double firefly_energy = 0;   ///< their share of the light without visible lamps
  std::size_t not_finite = 0;  ///< pixels
  std::size_t clipped = 0;     ///< pixels
  double chi2_per_value = 0;   ///< of the best explanation; about 1 if it is complete
  /// Those that may explain a picture that nothing else does, but have too few samples to say so.
  std::vector<Variant> noisy_variants;
};

/// The picture must have the size of the truth.
PathVerdict judge_path(const PathTruth& truth, const DecodedPicture& mine);

}  // namespace scenefile
