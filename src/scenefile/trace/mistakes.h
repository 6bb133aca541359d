#pragma once
// Known mistakes of ray tracers that students write, for those who ask whether a wrong picture
// comes from one of them (grade/causes.h). Mistakes that a changed RenderScene or other options
// can express are not among them.

namespace scenefile {

/// Nothing set: the right equation.
struct Mistakes {
  float diffuse = 1;                  ///< factor of the diffuse term, textures included
  bool blinn = false;                 ///< highlights by (N.H)^n instead of (R.V)^n
  bool untransposed_normals = false;  ///< normals go to world space like directions
  bool linear_spots = false;          ///< spots fall off linearly with the angle

  friend bool operator==(const Mistakes&, const Mistakes&) = default;
};

}  // namespace scenefile
