#include "scenefile/trace/part_set.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace scenefile {

namespace {

// The first candidate of the picture that most candidates are parts of.
std::size_t usual_candidate(std::span<const PartCandidate> candidates) {
  struct Group {
    std::size_t first = 0;
    std::size_t count = 0;
  };
  std::map<std::string, Group> groups;  // by what the parts of a picture have in common
  std::size_t best = no_file;
  std::size_t most = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!candidates[i].has_head) {
      continue;
    }
    PartHead common;
    common.picture = candidates[i].head.picture;
    Group& group = groups.try_emplace(encode_part_head(common), Group{i, 0}).first->second;
    ++group.count;
    if (group.count > most || (group.count == most && group.first < best)) {
      most = group.count;
      best = group.first;
    }
  }
  return best;
}

}  // namespace

PartSet sort_parts(std::span<const PartCandidate> candidates) {
  PartSet set;
  const std::size_t usual = usual_candidate(candidates);
  if (usual != no_file) {
    set.picture = candidates[usual].head.picture;
    set.files.assign(set.picture.count, no_file);
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const PartCandidate& candidate = candidates[i];
    if (candidate.has_head && candidate.head.picture != set.picture) {
      set.foreign.push_back(i);
    } else if (!candidate.damage.empty()) {
      set.damaged.push_back(i);
    } else if (std::size_t& file = set.files[candidate.head.index]; file == no_file) {
      file = i;
    } else {
      set.doubled.push_back(i);
    }
  }
  for (std::uint32_t index = 0; index < set.files.size(); ++index) {
    if (set.files[index] == no_file) {
      set.missing.push_back(index);
    }
  }
  return set;
}

std::string part_numbers(std::span<const std::uint32_t> sorted) {
  std::string text;
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t last = i;
    while (last + 1 < sorted.size() && sorted[last + 1] == sorted[last] + 1) {
      ++last;
    }
    text += fmt::format("{}{}", text.empty() ? "" : ", ", sorted[i] + 1);
    if (last > i) {
      text += fmt::format("{}{}", last == i + 1 ? ", " : "-", sorted[last] + 1);
    }
    i = last + 1;
  }
  return text;
}

}  // namespace scenefile
