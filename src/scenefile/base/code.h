#pragma once
// Kinds of findings. Each room lists its own in an array in its `codes.h`, and code names them as
// users do: "camera.up-zero"_code.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace scenefile {

enum class Severity : std::uint8_t { note, warning, error };

/// Special treatment of the findings of a code.
enum class CodeKind : std::uint8_t {
  plain,
  dialect,  ///< a spelling of a dialect: an error under `--strict`
  limit,    ///< a limit was reached; as an error it has a separate exit status
  absence   ///< something is missing from the scene; not reported when parts of the scene could not
            ///< be read
};

/// A kind of finding. Its address is its identity, its name is stable across versions.
struct Code {
  std::string_view name;     ///< such as "camera.up-parallel-to-look"
  Severity severity;         ///< the default; a report may override it
  std::string_view summary;  ///< one line: what is wrong
  std::string_view help;     ///< why it matters and what to do
  CodeKind kind = CodeKind::plain;
  /// The other severity that some reports use; `help` says when.
  std::optional<Severity> otherwise = std::nullopt;
};

/// The place of the code with that name, or the number of codes. An index, because GCC 12 cannot
/// compare pointers to codes in constant expressions if it checks pointers (-fsanitize=undefined).
constexpr std::size_t code_index(std::span<const Code> codes, std::string_view name) {
  std::size_t i = 0;
  while (i < codes.size() && codes[i].name != name) {
    ++i;
  }
  return i;
}

/// The code with that name, or null.
constexpr const Code* find_code(std::span<const Code> codes, std::string_view name) {
  const std::size_t i = code_index(codes, name);
  return i == codes.size() ? nullptr : &codes[i];
}

/// The name of a code as a template argument. Each room has an `operator""_code` that takes only
/// the names of its own array, so a name that no included room knows does not compile. It is not
/// consteval, because clang 14 then leaves calls in conditional expressions to the linker.
template <std::size_t size>
struct CodeName {
  char text[size];

  consteval CodeName(const char (&literal)[size]) { std::copy_n(literal, size, text); }
  constexpr operator std::string_view() const { return {text, size - 1}; }
};

}  // namespace scenefile
