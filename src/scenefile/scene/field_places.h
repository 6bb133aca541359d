#pragma once
// Looks up where values stand in the file. Internal to the room.

#include "scenefile/scene/scene.h"

#include <vector>

namespace scenefile {

/// Sorted on the first question, so that scenes without findings do not pay for it.
class FieldPlaces {
 public:
  explicit FieldPlaces(const std::vector<FieldPlace>& places) : places_(places) {}

  /// The place of the value, else that of its owner.
  Location find(Location owner, Field field);

 private:
  const std::vector<FieldPlace>& places_;
  std::vector<FieldPlace> sorted_;
};

}  // namespace scenefile
