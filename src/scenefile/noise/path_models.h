#pragma once
// Pictures that known mistakes and other conventions would give, fitted to the one under test.
// Internal to noise.

#include "scenefile/noise/block_means.h"

#include <string>
#include <vector>

namespace scenefile {

enum class ModelKind : std::uint8_t { right, mistake, convention };

/// A picture that may explain the one under test: fixed + factors * free.
struct PathModel {
  ModelKind kind = ModelKind::mistake;
  std::string name;
  std::string what;
  BlockColors fixed;
  std::vector<BlockColors> free;
  double parameter = 1;  ///< found by search
  int parameters = 0;    // how many of those
  int edits = 1;
  BlockFit fit = {};
  double chi2 = 0;  ///< by the cautious weights

  double factor() const { return fit.factors.empty() ? 1 : fit.factors.front(); }
  /// Two mistakes, unless one of them has both effects.
  bool two_mistakes() const { return edits > 1 && parameters == 0; }
  double score() const {
    return chi2 + 12.0 * (static_cast<double>(free.size()) + parameters + 2 * edits);
  }
};
/// Finds explanations of one linearization of the picture.
class ModelSearch {
 public:
  ModelSearch(const TruthBlocks& back, const ObservedBlocks& seen, bool any_exposure)
      : back_(back), seen_(seen), measured_(seen.measured), any_exposure_(any_exposure) {
    nuisance_ = {&back.gradient_x, &back.gradient_y};
  }

  void solve(PathModel& model) const;

  /// What the model leaves of a block.
  Color residual(const PathModel& model, std::size_t b) const;

  PathModel right() const;

  /// All known mistakes and conventions, solved.
  std::vector<PathModel> models() const;

  /// How much of the step from the right picture to the model the picture makes, in standard
  /// errors.
  double significance(const PathModel& model) const;

 private:
  PathModel by_parameter(const char* name, int (*power)(const LightKind&), bool free_direct) const;

  const TruthBlocks& back_;
  const ObservedBlocks& seen_;
  const MeasuredBlocks& measured_;
  bool any_exposure_;
  std::vector<const BlockColors*> nuisance_;
};

}  // namespace scenefile
