#include "scenefile/scene/field_places.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace scenefile {

namespace {

// The sort key of FieldPlace and UnreadField.
template <typename T>
auto key(const T& of) {
  return std::tuple(of.owner.line, of.owner.column, of.field);
}

template <typename T>
bool comes_before(const T& a, const T& b) {
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
    std::stable_sort(sorted_.begin(), sorted_.end(), comes_before<FieldPlace>);
  }
  const FieldPlace wanted{owner, field, {}};
  const auto after =
      std::upper_bound(sorted_.begin(), sorted_.end(), wanted, comes_before<FieldPlace>);
  if (after == sorted_.begin() || key(*(after - 1)) != key(wanted)) {
    return owner;
  }
  return (after - 1)->location;
}

UnreadFields::UnreadFields(std::vector<UnreadField> fields) : sorted_(std::move(fields)) {
  std::sort(sorted_.begin(), sorted_.end(), comes_before<UnreadField>);
}

bool UnreadFields::find(Location owner, Field field) const {
  return std::binary_search(sorted_.begin(), sorted_.end(), UnreadField{owner, field},
                            comes_before<UnreadField>);
}

}  // namespace scenefile
