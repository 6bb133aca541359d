#pragma once
// Looks up what the reader noted about a value: its place in the file, or that it could not be
// read. Internal to scene.

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

/// Takes no time for scenes without such values.
class UnreadFields {
 public:
  explicit UnreadFields(std::vector<UnreadField> fields);

  bool has(Location owner, Field field) const { return !sorted_.empty() && find(owner, field); }

 private:
  bool find(Location owner, Field field) const;

  std::vector<UnreadField> sorted_;
};

}  // namespace scenefile
