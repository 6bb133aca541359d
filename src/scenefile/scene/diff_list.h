#pragma once
// Differences between values and between lists of items, as text. Internal to scene.

#include "scenefile/scene/diff.h"
#include "scenefile/scene/diff_align.h"
#include "scenefile/scene/diff_values.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A hash; equal values have equal hashes.
std::uint64_t hash_of(const Values& values);
/// Combines a hash_of() value with another number.
std::uint64_t mixed(std::uint64_t seed, std::uint64_t value);

std::string_view label_of(const Light& light);
std::string_view label_of(const Primitive& primitive);

/// "sphere, diffuse 1 0 0".
std::string described(std::string_view label, const Values& values);
/// "place 2" for the second one.
std::string place_text(std::size_t index);
/// "sphere 2" for each label: counted from 1 separately for each label.
std::vector<std::string> numbered(const std::vector<std::string_view>& labels);

/// A bounded list of differences.
class DifferenceList {
 public:
  explicit DifferenceList(std::size_t most) : most_(most) {}

  bool full() const { return differences_.size() >= most_; }
  std::vector<SceneDifference> take() { return std::move(differences_); }

  void add(std::string where, std::string a, std::string b, Location in_a, Location in_b);

  /// Adds the values that differ; `where` is a prefix for each name, such as "root: sphere 1: ".
  void compare_values(const std::string& where, const Values& a, const Values& b, Location in_a,
                      Location in_b);

  /// Compares two lists of lights or primitives of the same node.
  template <typename Item>
  void compare_items(const std::string& where, const std::vector<Item>& a,
                     const std::vector<Item>& b) {
    const std::vector<std::string> names_a = names(a);
    const std::vector<std::string> names_b = names(b);
    for (const AlignedPair& pair : align(align_items(a), align_items(b))) {
      if (!pair.b) {
        const Item& item = a[*pair.a];
        add(where + names_a[*pair.a], described(label_of(item), values_of(item)), "", item.location,
            {});
      } else if (!pair.a) {
        const Item& item = b[*pair.b];
        add(where + names_b[*pair.b], "", described(label_of(item), values_of(item)), {},
            item.location);
      } else if (!pair.equal) {
        compare_values(where + names_a[*pair.a] + ": ", values_of(a[*pair.a]),
                       values_of(b[*pair.b]), a[*pair.a].location, b[*pair.b].location);
      } else if (pair.moved) {
        add(where + names_a[*pair.a], place_text(*pair.a), place_text(*pair.b), a[*pair.a].location,
            b[*pair.b].location);
      }
    }
  }

 private:
  template <typename Item>
  static std::vector<AlignItem> align_items(const std::vector<Item>& items) {
    std::vector<AlignItem> result;
    for (const Item& item : items) {
      result.push_back({hash_of(values_of(item)), std::string(label_of(item))});
    }
    return result;
  }

  template <typename Item>
  static std::vector<std::string> names(const std::vector<Item>& items) {
    std::vector<std::string_view> labels;
    for (const Item& item : items) {
      labels.push_back(label_of(item));
    }
    return numbered(labels);
  }

  std::size_t most_;
  std::vector<SceneDifference> differences_;
};

}  // namespace scenefile
