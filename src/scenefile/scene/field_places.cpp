#include "scenefile/scene/field_places.h"

#include <algorithm>
#include <tuple>

namespace scenefile {

namespace {

auto key(const FieldPlace& of) {
  return std::tuple(of.owner.line, of.owner.column, of.field);
}

bool comes_before(const FieldPlace& a, const FieldPlace& b) {
  return key(a) < key(b);
}

}  // namespace

Location FieldPlaces::find(Location owner, Field field) {
  if (!owner.known()) {
    return owner;
  }
  if (sorted_.size() != places_.size()) {
    sorted_ = places_;
    // Of several places for a value the last one counts, as for the value itself.
    std::stable_sort(sorted_.begin(), sorted_.end(), comes_before);
  }
  const FieldPlace wanted{owner, field, {}};
  const auto after = std::upper_bound(sorted_.begin(), sorted_.end(), wanted, comes_before);
  if (after == sorted_.begin() || key(*(after - 1)) != key(wanted)) {
    return owner;
  }
  return (after - 1)->location;
}

}  // namespace scenefile
