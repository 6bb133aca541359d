#pragma once
// Looks up the places of values in the file. Internal to scene and grade.

#include "scenefile/scene/scene.h"

#include <vector>

namespace scenefile {

/// Sorted at the first lookup, so that scenes without findings do not pay for it.
class FieldPlaces {
 public:
  explicit FieldPlaces(const std::vector<FieldPlace>& places) : places_(places) {}

  /// The place of the value if known, otherwise that of its owner.
  Location find(Location owner, Field field);

 private:
  const std::vector<FieldPlace>& places_;
  std::vector<FieldPlace> sorted_;
};

}  // namespace scenefile
