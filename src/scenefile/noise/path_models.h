#pragma once
// Pictures that known mistakes and other conventions would give, fitted to the one under test.
// Internal to noise.

#include "scenefile/mistakes/cause.h"
#include "scenefile/noise/block_means.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile {

enum class ModelKind : std::uint8_t { right, mistake, convention };

/// A picture that may explain the one under test: fixed + factors * free.
struct PathModel {
  ModelKind kind = ModelKind::mistake;
  Cause page = Cause::scattering;
  std::string name;
  std::string what;
  BlockColors fixed;
  std::vector<BlockColors> free;
  double parameter = 1;  ///< found by search
  int parameters = 0;    // how many of those
  int edits = 1;
  BlockColors noise = {};  ///< variance beyond that of the truth; of the free part, for factor 1
  std::optional<Variant> variant = {};  ///< that it is a picture of
  BlockFit fit = {};
  double chi2 = 0;        ///< by the cautious weights, with the noise of the model
  double plain_chi2 = 0;  ///< without that noise
  double deviance = 0;    // chi2, and what the noise costs: -2 log(likelihood) up to a constant
  const PathModel* first = nullptr;  ///< of a pair: its parts, which must outlive it
  const PathModel* second = nullptr;

  double factor() const { return fit.factors.empty() ? 1 : fit.factors.front(); }
  /// Two mistakes, unless one of them has both effects.
  bool two_mistakes() const { return edits > 1 && parameters == 0; }
  double score() const {
    return deviance + 12.0 * (static_cast<double>(free.size()) + parameters + 2 * edits);
  }
};

/// Finds explanations of one linearization of the picture.
class ModelSearch {
 public:
  ModelSearch(const TruthBlocks& back, const ObservedBlocks& seen, bool any_exposure)
      : back_(back), seen_(seen), measured_(seen.measured), any_exposure_(any_exposure) {
    nuisance_ = gradients(back, seen.measured);
  }

  void solve(PathModel& model) const;

  /// What the model leaves of a block.
  Color residual(const PathModel& model, std::size_t b) const;

  PathModel right() const;

  /// All known mistakes and conventions, solved. `toned`: also tones of samples.
  std::vector<PathModel> models(bool toned) const;

  /// The best pair of two models, as if each changed the light of a block by its own factor.
  std::optional<PathModel> pair(const std::vector<PathModel>& singles) const;

  /// The same light, as the model has it.
  MeasuredBlocks measured_by(const PathModel& model) const {
    return {picture_of(model), measured_.weight};
  }

  /// How much of the step from the right picture to the model the picture makes, in standard
  /// errors.
  double significance(const PathModel& model) const;

 private:
  /// The picture under test, with weights that know the noise of the model.
  MeasuredBlocks measured_with(const PathModel& model) const;

  /// The fitted picture.
  BlockColors picture_of(const PathModel& model) const;

  /// The best of the models for parameters in a range.
  template <typename At>
  PathModel best_of(double low, double high, const At& at) const;

  PathModel by_parameter(Cause page, const char* name, int (*power)(const LightKind&),
                         bool free_direct) const;

  /// Throughputs that are replaced by the factor of a direction, or to which it is added, with or
  /// without dividing it by the probability of going on, which is the parameter.
  PathModel by_throughput(const std::vector<LooseThroughputs>& lights, bool added,
                          bool divided) const;

  const TruthBlocks& back_;
  const ObservedBlocks& seen_;
  const MeasuredBlocks& measured_;
  bool any_exposure_;
  std::vector<const BlockColors*> nuisance_;
};

}  // namespace scenefile
