#include "scenefile/asset/obj_corner.h"

#include "scenefile/base/text.h"
#include "scenefile/geometry/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace scenefile {

namespace {

// Why a well-formed number does not refer to an element.
std::string out_of_range(std::string_view word, const IndexList& list) {
  if (word.find_first_of("123456789") == std::string_view::npos) {
    return fmt::format("there is no {} 0: numbers start at 1, or at -1 for the last one",
                       list.name);
  }
  if (word[0] == '-') {
    return fmt::format("there is no {} {}: {} come before this face", list.name, escaped(word, 40),
                       list.so_far);
  }
  return fmt::format("there is no {} {}: the file has {}", list.name, escaped(word, 40),
                     list.in_file);
}

// A number of the file (from 1, or negative from the end) as an index; else why it is not one.
struct ParsedIndex {
  std::uint32_t value = mesh_no_index;
  std::string error;
  bool out_of_range = false;
};

ParsedIndex parse_index(std::string_view word, const IndexList& list) {
  const bool minus = !word.empty() && word[0] == '-';
  const std::string_view digits = word.substr(minus || (!word.empty() && word[0] == '+') ? 1 : 0);
  const char* end = digits.data() + digits.size();
  std::uint64_t number = 0;
  const auto result = std::from_chars(digits.data(), end, number);
  if (result.ptr != end || result.ec == std::errc::invalid_argument) {
    return {mesh_no_index,
            word.empty() ? fmt::format("the number of the {} is missing", list.name)
                         : fmt::format("{} is not the number of a {}", quoted(word), list.name)};
  }
  const std::uint64_t most = minus ? list.so_far : list.in_file;
  if (result.ec == std::errc::result_out_of_range || number == 0 || number > most) {
    return {mesh_no_index, out_of_range(word, list), true};
  }
  return {static_cast<std::uint32_t>(minus ? list.so_far - number : number - 1), {}};
}

}  // namespace

Result<Corner> parse_corner(std::string_view word, const CornerLists& lists,
                            std::string& missing_normal) {
  const IndexList* const list[] = {&lists.positions, &lists.uvs, &lists.normals};
  std::uint32_t indices[] = {mesh_no_index, mesh_no_index, mesh_no_index};
  std::string_view rest = word;
  for (std::size_t part = 0; part < 3; ++part) {
    const std::size_t end = std::min(rest.find('/'), rest.size());
    if (part == 0 || end > 0) {
      ParsedIndex index = parse_index(rest.substr(0, end), *list[part]);
      if (!index.error.empty()) {
        std::string text = end == word.size()
                               ? std::move(index.error)
                               : fmt::format("in the corner {}: {}", quoted(word), index.error);
        if (!index.out_of_range || list[part] != &lists.normals) {
          return input_error(std::move(text));
        }
        missing_normal = std::move(text);
      }
      indices[part] = index.value;
    }
    if (end == rest.size()) {
      return Corner{indices[0], indices[1], indices[2]};
    }
    rest.remove_prefix(end + 1);
  }
  return input_error(fmt::format(
      "{} is not a corner of a face: it has at most three parts, v/vt/vn", quoted(word)));
}

}  // namespace scenefile
