#include "scenefile/io/item.h"

#include "scenefile/base/hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace scenefile {

namespace {

// The number is the version of the text.
constexpr std::string_view item_start = "scenefile item 1: ";
constexpr std::string_view item_sum = " sum=";
constexpr std::size_t sum_digits = 16;

// Where the checksum of the first item_text() begins.
std::optional<std::size_t> place_of_sum(std::string_view bytes) {
  const std::size_t start = bytes.find(item_start);
  if (start == std::string_view::npos) {
    return std::nullopt;
  }
  const std::size_t sum = bytes.find(item_sum, start);
  if (sum == std::string_view::npos || sum + item_sum.size() + sum_digits > bytes.size()) {
    return std::nullopt;
  }
  return sum + item_sum.size();
}

// Of all bytes except the checksum, and what depends on it: the CRC that follows a text in PNG.
std::string checksum_at(std::string_view bytes, std::size_t sum) {
  const std::size_t crc = bytes.starts_with("\x89PNG") ? 4 : 0;
  Hash hash;
  hash.add(bytes.substr(0, sum));
  hash.add(bytes.substr(std::min(sum + sum_digits + crc, bytes.size())));
  return fmt::format("{:016x}", hash.value());
}

struct KeyWord {
  std::string_view name;
  std::string_view value;
};

std::vector<KeyWord> words_of_key(std::string_view key) {
  std::vector<KeyWord> words;
  while (!key.empty()) {
    const std::string_view word = key.substr(0, key.find(' '));
    key.remove_prefix(std::min(key.size(), word.size() + 1));
    const std::size_t equals = std::min(word.find('='), word.size());
    if (!word.empty()) {
      words.push_back({word.substr(0, equals), word.substr(std::min(equals + 1, word.size()))});
    }
  }
  return words;
}

std::string_view value_in(const std::vector<KeyWord>& words, std::string_view name) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const KeyWord& word) { return word.name == name; });
  return found == words.end() ? std::string_view() : found->value;
}

}  // namespace

std::string item_text(std::string_view key) {
  return fmt::format("{}{}{}{:0>{}}", item_start, key, item_sum, "", sum_digits);
}

void seal_item(std::string& bytes) {
  if (const std::optional<std::size_t> sum = place_of_sum(bytes)) {
    bytes.replace(*sum, sum_digits, checksum_at(bytes, *sum));
  }
}

std::vector<KeyDifference> compare_keys(std::string_view found, std::string_view wanted) {
  if (found == wanted) {
    return {};
  }
  const std::vector<KeyWord> of_found = words_of_key(found);
  const std::vector<KeyWord> of_wanted = words_of_key(wanted);
  std::vector<KeyDifference> differences;
  for (const auto& [name, value] : of_wanted) {
    if (const std::string_view other = value_in(of_found, name); other != value) {
      differences.push_back({std::string(name), std::string(other), std::string(value)});
    }
  }
  for (const auto& [name, value] : of_found) {
    if (!value.empty() && value_in(of_wanted, name).empty()) {
      differences.push_back({std::string(name), std::string(value), {}});
    }
  }
  // The same words in another order, or some of them twice: this program did not write that.
  return differences.empty()
             ? std::vector{KeyDifference{"key", std::string(found), std::string(wanted)}}
             : differences;
}

Item read_item(std::string_view bytes) {
  const std::optional<std::size_t> sum = place_of_sum(bytes);
  if (!sum) {
    const bool begun = bytes.find(item_start) != std::string_view::npos;
    return {begun ? ItemState::damaged : ItemState::none, {}};
  }
  if (bytes.substr(*sum, sum_digits) != checksum_at(bytes, *sum)) {
    return {ItemState::damaged, {}};
  }
  const std::size_t key = bytes.find(item_start) + item_start.size();
  return {ItemState::intact, std::string(bytes.substr(key, *sum - item_sum.size() - key))};
}

}  // namespace scenefile
