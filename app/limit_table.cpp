#include "app/limit_table.h"

#include "app/option_table.h"
#include "app/wrap.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <vector>

namespace scenefile::app {

namespace {

template <auto Limits::*member>
std::uint64_t get(const Limits& limits) {
  return limits.*member;
}

template <auto Limits::*member>
void set(Limits& limits, std::uint64_t value) {
  using Member = std::remove_reference_t<decltype(limits.*member)>;
  limits.*member = static_cast<Member>(value);
}

template <auto Limits::*member>
constexpr LimitRow row(std::string_view name, std::string_view help, std::uint64_t most,
                       bool bytes = false) {
  return {name, help, bytes, most, get<member>, set<member>};
}

constexpr std::uint64_t any32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t any_size = std::uint64_t{1} << 50;

constexpr std::array limit_rows{
    row<&Limits::file_bytes>("file-bytes", "a scene or asset file", any_size, true),
    row<&Limits::nesting>("nesting", "nested elements or values", 1u << 20),
    row<&Limits::attributes>("attributes", "attributes of one element", any32),
    row<&Limits::name_bytes>("name-bytes", "a name of an element, object or file", any32, true),
    row<&Limits::value_bytes>("value-bytes", "any other attribute or string", any32, true),
    row<&Limits::messages_per_code>("messages-per-code",
                                    "messages of one code; any others are only counted", any32),
    row<&Limits::message_bytes>("message-bytes", "all messages", any32, true),
    row<&Limits::lights>("lights", "lights in world space, including instances of templates",
                         1u << 20),
    row<&Limits::texture_side>("texture-side", "width and height of a texture, in pixels",
                               1u << 24),
    row<&Limits::texture_bytes>("texture-bytes", "all textures, decoded", any_size, true),
    row<&Limits::mesh_triangles>("mesh-triangles", "triangles of all meshes", any32),
    row<&Limits::mesh_bytes>("mesh-bytes", "all meshes, in memory", any_size, true),
    row<&Limits::instance_nesting>("instance-nesting", "templates inside templates", 1u << 20),
    row<&Limits::image_side>("image-side", "width and height of a picture, in pixels", 1u << 20),
};

// The power of two of a suffix; 0 if it has none.
unsigned shift_of(char letter) {
  switch (letter) {
    case 'K':
    case 'k':
      return 10;
    case 'M':
      return 20;
    case 'G':
      return 30;
    default:
      return 0;
  }
}

std::vector<std::string_view> names() {
  std::vector<std::string_view> result;
  for (const LimitRow& limit : limit_rows) {
    result.push_back(limit.name);
  }
  return result;
}

std::string parse_count(const std::string& text, std::uint64_t max, std::uint64_t& count) {
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, count);
  if (error != std::errc() || rest != end || count == 0 || count > max) {
    return fmt::format("{} is not a whole number from 1 to {}", scenefile::quoted(text), max);
  }
  return {};
}

std::string shown(const LimitRow& limit, std::uint64_t value) {
  for (const auto& [letter, shift] : {std::pair('G', 30u), {'M', 20u}, {'K', 10u}}) {
    if (limit.bytes && value % (std::uint64_t{1} << shift) == 0) {
      return fmt::format("{}{}", value >> shift, letter);
    }
  }
  return fmt::format("{}", value);
}

}  // namespace

std::span<const LimitRow> limit_table() {
  return limit_rows;
}

std::string parse_bytes(const std::string& text, std::uint64_t min, std::uint64_t max,
                        std::uint64_t& bytes) {
  const unsigned shift = text.empty() ? 0 : shift_of(text.back());
  const char* const end = text.data() + text.size() - (shift == 0 ? 0 : 1);
  std::uint64_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end || number < (min + (1u << shift) - 1) >> shift ||
      number > max >> shift) {
    return fmt::format("{} is not a number of bytes from {} to {}, such as 1500000, 300M or 2G",
                       scenefile::quoted(text), min, max);
  }
  bytes = number << shift;
  return {};
}

std::string set_limit(Limits& limits, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    return fmt::format("{} is not NAME=VALUE, such as nesting=2000", scenefile::quoted(assignment));
  }
  const std::string name = assignment.substr(0, equals);
  const std::string value = assignment.substr(equals + 1);
  const auto* const limit = std::find_if(limit_rows.begin(), limit_rows.end(),
                                         [&](const LimitRow& row) { return row.name == name; });
  if (limit == limit_rows.end()) {
    return fmt::format("unknown limit {}{}; \"scenefile help limits\" lists them",
                       scenefile::quoted(name), did_you_mean(name, names()));
  }
  std::uint64_t number = 0;
  const std::string wrong = limit->bytes ? parse_bytes(value, 1, limit->most, number)
                                         : parse_count(value, limit->most, number);
  if (wrong.empty()) {
    limit->set(limits, number);
    return {};
  }
  return fmt::format("{}: {}", name, wrong);
}

std::string limits_text(std::size_t width) {
  std::string text =
      wrapped(
          "Limits keep a faulty or malicious file from using too much time or memory. A file that "
          "exceeds one is rejected with a message and exit status 4, except a texture, which is "
          "left out with a warning. Each is set by --limit NAME=VALUE; K, M and G after a number "
          "of bytes mean 2^10, 2^20 and 2^30.",
          0, 0, width) +
      "\n\n";
  for (const LimitRow& limit : limit_rows) {
    const std::string help = fmt::format("{}{}", limit.help, limit.bytes ? ", in bytes" : "");
    const std::size_t column = width >= 72 ? 32 : 6;
    text += fmt::format("  {:<18} {:>9}", limit.name, shown(limit, limit.get({})));
    text += fmt::format("{:<{}}{}\n", width >= 72 ? "" : "\n", width >= 72 ? 2 : column + 1,
                        wrapped(help, column, column, width));
  }
  return text + "\n" +
         wrapped(
             "See also: --max-memory for the memory of the whole run, --timeout for its time, "
             "--max-depth for rays.",
             0, 0, width) +
         "\n";
}

}  // namespace scenefile::app
