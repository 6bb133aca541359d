#include "scenefile/trace/part_set.h"

#include <fmt/format.h>

#include <map>
#include <string_view>

namespace scenefile {

namespace {

// The first file of the whole that most files are parts of.
std::size_t usual_file(std::span<const PartTag> tags) {
  struct Group {
    std::size_t first = 0;
    std::size_t count = 0;
  };
  std::map<std::string_view, Group> groups;
  std::size_t best = no_file;
  std::size_t most = 0;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (tags[i].whole.empty()) {
      continue;
    }
    Group& group = groups.try_emplace(tags[i].whole, Group{i, 0}).first->second;
    ++group.count;
    if (group.count > most || (group.count == most && group.first < best)) {
      most = group.count;
      best = group.first;
    }
  }
  return best;
}

}  // namespace

SortedParts sort_parts(std::span<const PartTag> tags) {
  SortedParts set;
  set.usual = usual_file(tags);
  if (set.usual != no_file) {
    set.files.assign(tags[set.usual].count, no_file);
  }
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const PartTag& tag = tags[i];
    if (!tag.whole.empty() && tag.whole != tags[set.usual].whole) {
      set.foreign.push_back(i);
    } else if (tag.whole.empty() || !tag.damage.empty()) {
      set.damaged.push_back(i);
    } else if (std::size_t& file = set.files[tag.index]; file == no_file) {
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

PartTag tag_of(const PartCandidate& candidate) {
  PartTag tag;
  if (candidate.has_head) {
    PartHead common;
    common.picture = candidate.head.picture;
    tag.whole = encode_part_head(common);
    tag.index = candidate.head.index;
    tag.count = candidate.head.picture.count;
  }
  tag.damage = candidate.damage;
  return tag;
}

PartSet sort_parts(std::span<const PartCandidate> candidates) {
  std::vector<PartTag> tags;
  tags.reserve(candidates.size());
  for (const PartCandidate& candidate : candidates) {
    tags.push_back(tag_of(candidate));
  }
  PartSet set{sort_parts(tags), {}};
  if (set.usual != no_file) {
    set.picture = candidates[set.usual].head.picture;
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
