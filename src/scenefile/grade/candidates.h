#pragma once
// Judges candidate combinations of mistakes: thresholds, which of several mistakes are needed, and
// what is missing. Internal to grade.

#include "scenefile/grade/simulation.h"

#include <optional>
#include <vector>

namespace scenefile {

inline constexpr double nearly_all = 0.95;  ///< share of pixels where one mistake leaves no doubt
/// How much more of the difference a rival may leave than what was found, as a share of all.
inline constexpr double rival_margin = 0.03;
inline constexpr std::size_t max_ties = 4;      ///< mistakes that a claim names for one picture
inline constexpr std::size_t screen = 240;      ///< points used to screen single mistakes
inline constexpr std::size_t few_points = 100;  ///< points used to screen combinations

/// How far colors that the mistakes explain may be from the test's, in 1/255: more with fitted
/// numbers, which are less exact.
double rounding_of(const Simulation& sim, const Combination& mistakes);
/// Whether the claim satisfies the thresholds in evidence.h.
bool good(const Tried& t);
/// Whether the mistakes leave nothing but rounding: at nearly all points that they should explain,
/// the simulated color equals that of the test within rounding. A mistake that only imitates the
/// actual one comes close, but is not equal.
bool leaves_only_rounding(const Simulation& sim, const Combination& mistakes);
/// A picture with mistakes at some points, and what judging it needs. Colors are by point.
struct Explanation {
  const std::vector<Point>& points;
  const Colors& reference;
  const Colors& drawn;                   ///< without mistakes
  const Colors& with;                    ///< with all of them
  std::vector<Colors> without{};         ///< each of several mistakes
  std::vector<std::uint32_t> sources{};  ///< of the objects, by point, if `usable`
  double rounding = 1.1;                 ///< as Simulation::rounding()
  bool usable = true;                    ///< whether the scene is that of the reference
  bool noisy = false;                    ///< whether compression changed the colors
  bool inexact = false;                  ///< whether points may differ where all is right
  bool fitted = false;                   ///< whether a number is estimated from the pictures
  /// Programs may change the finished picture after they have truncated its values.
  bool finished = false;
  bool moved = false;  ///< only the finished picture is changed, or flipped
};
bool leaves_only_rounding(const Explanation& e);
/// Whether the claim satisfies all thresholds, which are higher for several mistakes.
bool good_enough(const Simulation& sim, const Tried& t);
/// Whether the claim reproduces the picture.
bool reproduces_all(const Tried& t);
/// Whether the claim explains nearly everything, so that the search can stop.
bool sure(const Tried& t);
/// Whether `a`, with more mistakes than `b`, leaves much less, or makes nearly all pixels right.
bool clearly_better(const Tried& a, const Tried& b);
/// The largest remaining difference that counts as a tie with a mistake that leaves `raw` of `all`.
double tie_limit(double raw, double all);
/// Stable; the smallest key first.
void sort_by(std::vector<Tried>& list, double (*key)(const Tried&));
/// The best first.
void sort_by_merit(std::vector<Tried>& list);
void append(std::vector<Tried>& list, const std::vector<Tried>& more);
Combination joined(Combination a, const Combination& b);
/// Two mistakes of the same kind rarely combine: one replaces the other.
bool fits(const Simulation& sim, const Combination& start, std::uint16_t other);
/// Whether any of the colors in `a` differs from that in `b` by more than `limit`, in 1/255, after
/// limiting both to what a picture can show. `b` must have as many colors or more.
bool any_differs(const Colors& a, const Colors& b, double limit);
/// Whether `edit` is an edited scene that shows little or not at all beside the mistake: mistakes
/// in transforms replace all objects and lights, another camera makes a wrong one fit better, and
/// in gray pictures, or those of one channel, many colors look the same.
bool hides(const Hypothesis& mistake, const Hypothesis& edit);
/// Whether the mistake changes brightness or contrast of the whole picture, which fits many
/// pictures by chance.
bool is_about_brightness(Cause cause);
/// The mistakes without fitted numbers of which each can replace all `members` of `mistakes`
/// without changing the picture.
std::vector<std::uint16_t> same_instead(const Simulation& sim, const Combination& mistakes,
                                        const Combination& members);
/// The same picture by fewer mistakes, where one can replace two: these cancel in part.
Tried with_fewer(const Simulation& sim, const Tried& found);
/// The points where the picture with the mistakes differs from the test, and those where it does
/// not.
struct WrongAndRight {
  std::vector<Point> wrong;
  std::vector<Point> right;
};
WrongAndRight wrong_and_right(const Simulation& sim, const Combination& mistakes);
/// The correlation between the colors of the first points and those of the test.
double likeness(const Simulation& sim, const Colors& colors);
/// The effect of a change of the colors.
struct Effect {
  std::size_t points = 0;      ///< that change visibly; the other members are weights
  double changed = 0;          ///< of points that change visibly
  double right = 0;            ///< of those: right with the change
  double within_rounding = 0;  ///< of those: differing by no more than rounding
  double gained = 0;           ///< right with the change, minus right without it
  double shown = 0;            ///< of `gained`: points that are not dark in the test
  double gained_all = 0;       ///< the same as `gained`, of all points
  double differing_right = 0;  ///< points that differ from the reference, and are right
};
Effect effect_of(const Simulation& sim, const Colors& with, const Colors& without);
Effect effect_of(const std::vector<Point>& points, double rounding, const Colors& with,
                 const Colors& without);
/// Whether a mistake is right nearly everywhere where it changes the picture, mostly within
/// rounding. Otherwise it only happens to reduce the difference. `e`: of the mistake alone;
/// `differs`: the weight of the points that differ.
bool reproduces_its_part(const Effect& e, double differs);
/// Whether one of several mistakes is needed: where it changes the picture, the picture is right
/// with it and wrong without it. `e`: of the mistakes with and without it; `differs`: the weight of
/// the points that differ. `moves`: it moves objects; `fitted`, `any_fitted`: it, or any of them,
/// has a number that is estimated from the pictures.
bool needed(const Effect& e, double differs, bool moves, bool fitted, bool any_fitted);
/// Whether each of several mistakes is needed: where it changes the picture, the picture is right
/// with it and wrong without it.
bool each_needed(const Simulation& sim, const Combination& mistakes);
/// Removes the mistakes that are not needed.
Tried without_needless(Simulation& sim, Tried found);
/// Other combinations of those tried that give the same picture without any of the mistakes found.
std::vector<Tried> equal_instead(const Simulation& sim, const Tried& found,
                                 const std::vector<Tried>& tried);
/// The mistakes combined with one more, for each of those that explain most of the remaining
/// difference. Scored at some of the points only.
std::vector<Tried> likely_additions(Simulation& sim, const Combination& mistakes);
/// Adds the mistake that explains most of the remaining difference, if any.
Tried completed(Simulation& sim, const Tried& found);
/// The first candidate that satisfies the thresholds after removing mistakes that are not needed,
/// or a later one that is clearly better.
std::optional<Tried> first_good(Simulation& sim, const std::vector<Tried>& best);
/// The best screened mistakes, evaluated at all points; among similar ones the more likely first.
std::vector<Tried> verified(Simulation& sim, const std::vector<Tried>& ranked, std::size_t count,
                            double from, double to);
/// Evaluates the best candidates exactly, by drawing them.
std::vector<Tried> tried_again(Simulation& sim, const std::vector<Tried>& list,
                               std::size_t max_count, double from, double to);
/// Combines each start with each single mistake that fits it.
std::vector<Tried> extended(Simulation& sim, const std::vector<Combination>& starts,
                            std::size_t count, double from, double to);

}  // namespace scenefile
