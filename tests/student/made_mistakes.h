#pragma once
// The mistakes that a student's program makes, for questions in its innermost loops.

#include "student/student_tracer.h"

#include <algorithm>
#include <bitset>
#include <iterator>
#include <stdexcept>

namespace scenefile::student {

/// Mistakes of the list `known`, an array of KnownMistake.
template <const auto& known>
class MadeMistakes {
 public:
  /// A place in the list. A name that is not in the list does not compile.
  struct Place {
    consteval Place(std::string_view name) : number(find(name)) {
      if (number == std::size(known)) {
        throw std::invalid_argument("no such mistake");
      }
    }
    consteval Place(const char* name) : Place(std::string_view(name)) {}
    std::size_t number;
  };

  explicit MadeMistakes(const std::set<std::string, std::less<>>& names) {
    for (const std::string& name : names) {
      const std::size_t number = find(name);
      if (number == std::size(known)) {
        throw std::invalid_argument("no mistake is called " + name);
      }
      made_.set(number);
    }
  }

  bool contains(Place place) const { return made_[place.number]; }

 private:
  static constexpr std::size_t find(std::string_view name) {
    return std::size_t(std::ranges::find(known, name, &KnownMistake::name) - std::begin(known));
  }

  std::bitset<std::size(known)> made_;
};

}  // namespace scenefile::student
