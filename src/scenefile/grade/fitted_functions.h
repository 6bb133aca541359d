#pragma once
// Functions of the lighting equation that are wrong in a way that no known mistake describes: how
// lights fade with distance or with the angle from a spotlight's axis, how diffuse light depends on
// N.L, the shape of highlights. The picture is linear in the values of such a function, so least
// squares over the points find it. Internal to grade.

#include "scenefile/grade/simulation.h"

#include <array>

namespace scenefile {

/// The terms with such a function; those whose function is likelier to be wrong come first.
enum class Term : std::uint8_t { fading, highlights, cones, diffuse };
inline constexpr std::size_t term_count = 4;

Cause cause_of(Term term);

/// The mistakes whose functions fit the points nearly everywhere, the likeliest first. The pictures
/// decide whether they are causes: see leaves_only_rounding().
/// `made_too`: other mistakes in the picture, except those that change the finished picture.
/// `only`: the term to fit; nullopt: all.
std::vector<Hypothesis> fitted_functions(const Simulation& sim, const Combination& made_too,
                                         std::optional<Term> only = std::nullopt);
/// By term, the mean difference that the best function leaves, roughly; infinity if none fits.
std::array<double, term_count> left_with_functions(const Simulation& sim,
                                                   const Combination& made_too);

}  // namespace scenefile
