#include "scenefile/asset/mtl_file.h"

#include "scenefile/asset/codes.h"
#include "scenefile/asset/obj_words.h"
#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

namespace scenefile {

namespace {

using MtlColor = std::optional<glm::vec3> MtlMaterial::*;
using Map = FileReference MtlMaterial::*;

constexpr std::pair<std::string_view, MtlColor> mtl_colors[] = {
    {"Ka", &MtlMaterial::ambient},      {"Kd", &MtlMaterial::diffuse},
    {"Ks", &MtlMaterial::specular},     {"Ke", &MtlMaterial::emission},
    {"Tf", &MtlMaterial::transmission}, {"Kt", &MtlMaterial::transmission}};

constexpr std::pair<std::string_view, Map> mtl_maps[] = {{"map_Kd", &MtlMaterial::diffuse_map},
                                                         {"map_Ks", &MtlMaterial::specular_map},
                                                         {"map_Ke", &MtlMaterial::emission_map}};

constexpr std::array<std::string_view, 6> mtl_other{"newmtl", "Ns", "Ni", "d", "Tr", "illum"};

// Statements of the format, of tinyobjloader and of common exporters that no picture shows.
constexpr std::string_view mtl_alpha_maps[] = {"map_d", "map_Tr", "map_opacity"};
constexpr std::string_view mtl_bump_maps[] = {"map_bump", "map_Bump", "bump",  "disp",
                                              "map_disp", "norm",     "map_Kn"};
constexpr std::string_view mtl_unused[] = {"map_Ka",   "map_Ns",  "decal",     "refl",   "map_Tf",
                                           "map_refl", "map_aat", "sharpness", "Km",     "Kr",
                                           "Pr",       "Pm",      "Ps",        "Pc",     "Pcr",
                                           "aniso",    "anisor",  "map_Pr",    "map_Pm", "map_Ps"};

// An option of a map and its values: up to `numbers` numbers, or one word. `neutral` has no effect:
// a digit for each number, or a word; empty if no value has an effect on colors.
struct MapOption {
  std::string_view name;
  std::size_t numbers;
  std::string_view neutral;
};
constexpr MapOption map_options[] = {
    {"-s", 3, "111"},   {"-o", 3, "000"},      {"-t", 3, "000"},   {"-mm", 2, "01"},
    {"-bm", 1, ""},     {"-boost", 1, ""},     {"-texres", 1, ""}, {"-clamp", 0, "off"},
    {"-type", 0, ""},   {"-imfchan", 0, "m"},  {"-cc", 0, "off"},  {"-blendu", 0, ""},
    {"-blendv", 0, ""}, {"-colorspace", 0, ""}};

template <typename List>
auto find_word(const List& list, std::string_view word) {
  const auto* const found = std::find_if(std::begin(list), std::end(list),
                                         [&](const auto& entry) { return entry.first == word; });
  return found == std::end(list) ? nullptr : found;
}

template <typename List>
bool contains(const List& list, std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

class MtlReader {
 public:
  MtlReader(std::string_view text, const std::string& file_name, const Limits& limits,
            std::uint64_t& byte_budget, Diagnostics& diagnostics)
      : words_(text),
        file_name_(file_name),
        limits_(limits),
        budget_(byte_budget),
        diagnostics_(diagnostics) {}

  std::vector<MtlMaterial> read() {
    bool fits = true;
    while (fits && words_.next_statement()) {
      fits = read_statement(words_.next_word());
    }
    if (fits && keep()) {
      finish();
    }
    return std::move(materials_);
  }

 private:
  void report(const Code& code, Location location, std::string message,
              std::optional<Correction> correction = {}) {
    diagnostics_.add({&code,
                      code.severity,
                      location,
                      file_name_,
                      std::move(message),
                      {},
                      std::move(correction)});
  }

  // False if the budget is spent.
  bool read_statement(std::string_view keyword) {
    if (keyword == "newmtl") {
      return start(keyword);
    }
    if (!draft_) {
      note_orphan(keyword);
    } else if (const auto* color = find_word(mtl_colors, keyword)) {
      read_color(keyword, (*draft_).*color->second);
    } else if (const auto* map = find_word(mtl_maps, keyword)) {
      read_map(keyword, (*draft_).*map->second);
    } else if (keyword == "Ns") {
      read_number(keyword, 0, std::numeric_limits<float>::max(), draft_->shininess);
    } else if (keyword == "Ni") {
      read_ior(keyword);
    } else if (keyword == "d" || keyword == "Tr") {
      read_opacity(keyword);
    } else if (keyword == "illum") {
      read_illum(keyword);
    } else if (contains(mtl_alpha_maps, keyword)) {
      draft_->has_alpha_map = true;
    } else if (contains(mtl_bump_maps, keyword)) {
      draft_->has_bump_map = true;
    } else if (!contains(mtl_unused, keyword)) {
      note_unknown(keyword);
    }
    return true;
  }

  bool start(std::string_view keyword) {
    if (!keep()) {
      return false;
    }
    const std::string_view first = words_.next_word();
    const std::string_view name = first.empty() ? first : words_.rest(first);
    draft_.emplace();
    draft_->name = name;
    draft_->location = words_.location(keyword);
    from_d_ = false;
    if (!names_.insert(name).second) {
      duplicate_ = true;
      report("mtl.duplicate"_code, draft_->location,
             fmt::format("the material {} is already defined; this definition is not used",
                         quoted(name)));
    }
    return true;
  }

  // Adds the finished material. False if the budget is spent.
  bool keep() {
    if (!draft_ || std::exchange(duplicate_, false)) {
      return true;
    }
    constexpr std::uint64_t node_bytes = 64;  // of names_
    std::uint64_t bytes = sizeof(MtlMaterial) + node_bytes + draft_->name.size();
    for (const auto& [keyword, map] : mtl_maps) {
      bytes += ((*draft_).*map).name.size();
    }
    if (bytes > budget_) {
      report("mtl.limit"_code, draft_->location,
             "the materials from here on are skipped: no memory is left of the limit for all "
             "meshes");
      return false;
    }
    budget_ -= bytes;
    materials_.push_back(*std::move(draft_));
    draft_.reset();
    return true;
  }

  std::optional<float> number(std::string_view keyword, std::string_view word) {
    const ParsedNumber parsed = parse_number(word);
    if (parsed.error != NumberError::none) {
      const char* what = parsed.error == NumberError::out_of_range ? "is too large for a number"
                                                                   : "is not a number";
      report("mtl.value"_code, words_.location(word.empty() ? keyword : word),
             word.empty() ? fmt::format("{} needs a number; it keeps its default", keyword)
                          : fmt::format("{} in {} {}; {} keeps its default", quoted(word), keyword,
                                        what, keyword));
      return std::nullopt;
    }
    const bool sign = word[0] == '-' || word[0] == '+';
    if (word.substr(sign ? 1 : 0).starts_with('.') && parsed.value != 0 && !point_.known()) {
      point_ = words_.location(word);
    }
    return static_cast<float>(parsed.value);
  }

  float in_range(std::string_view keyword, std::string_view word, float value, float least,
                 float most) {
    const float used = std::clamp(value, least, most);
    if (used != value) {
      report("mtl.range"_code, words_.location(word),
             fmt::format("{} {} is {}; {} is used", keyword, escaped(word, 40),
                         value < least ? "negative" : "above 1", number_text(used)));
    }
    return used + 0.0f;  // not -0
  }

  void read_number(std::string_view keyword, float least, float most, std::optional<float>& value) {
    const std::string_view word = words_.next_word();
    if (const auto read = number(keyword, word)) {
      value = in_range(keyword, word, *read, least, most);
    }
  }

  void read_color(std::string_view keyword, std::optional<glm::vec3>& color) {
    glm::vec3 read(0);
    int count = 0;
    for (; count < 3; ++count) {
      const std::string_view word = words_.next_word();
      if (word.empty() && count > 0) {
        break;
      }
      const auto value = number(keyword, word);
      if (!value) {
        return;
      }
      read[count] = in_range(keyword, word, *value, 0, std::numeric_limits<float>::max());
    }
    if (count < 3) {
      report("mtl.value"_code, words_.location(keyword),
             fmt::format("{} needs three numbers, r g b; the missing ones are taken to be {}, "
                         "and 0 by the course's program",
                         keyword, number_text(read.x)));
      read = glm::vec3(read.x, count > 1 ? read.y : read.x, read.x);
    }
    color = read;
  }

  void read_ior(std::string_view keyword) {
    const std::string_view word = words_.next_word();
    const auto value = number(keyword, word);
    if (value && *value > 0) {
      draft_->ior = value;
    } else if (value) {
      report("mtl.range"_code, words_.location(word),
             fmt::format("Ni {} is not above 0; it keeps its default", escaped(word, 40)));
    }
  }

  // d counts if both are given, because Tr is not part of the format.
  void read_opacity(std::string_view keyword) {
    const bool d = keyword == "d";
    std::optional<float> value;
    std::string_view word = words_.next_word();
    word = d && word == "-halo" ? words_.next_word() : word;
    if (const auto read = number(keyword, word)) {
      value = in_range(keyword, word, *read, 0, 1);
    }
    if (value && (d || !from_d_)) {
      draft_->opacity = d ? *value : 1 - *value;
      from_d_ = d;
    }
  }

  void read_illum(std::string_view keyword) {
    const std::string_view word = words_.next_word();
    const auto value = number(keyword, word);
    constexpr float most = 1000;  // the format has models 0 to 10
    if (value && std::abs(*value) <= most && std::floor(*value) == *value) {
      draft_->illum = static_cast<int>(*value);
    } else if (value) {
      report("mtl.value"_code, words_.location(word),
             fmt::format("illum {} is not the number of a model, 0 to 10; it keeps its default",
                         escaped(word, 40)));
    }
  }

  // Options and their values come before the name.
  void read_map(std::string_view keyword, FileReference& map) {
    std::string_view word = words_.next_word();
    for (const MapOption* option = option_of(word); option != nullptr; option = option_of(word)) {
      const Location location = words_.location(word);
      word = words_.next_word();
      if (!skip_values(*option, word)) {
        report("mtl.map-option"_code, location,
               fmt::format("{} of {} is not applied; the texture is drawn without it", option->name,
                           keyword));
      }
    }
    if (word.empty()) {
      report("mtl.value"_code, words_.location(keyword),
             fmt::format("{} needs the name of a file", keyword));
      return;
    }
    std::string_view name = words_.rest(word);
    if (name.size() > 2 && name.front() == '"' && name.back() == '"') {
      name = name.substr(1, name.size() - 2);
    }
    map = {std::string(name), words_.location(word)};
  }

  static const MapOption* option_of(std::string_view word) {
    const auto* const found =
        std::find_if(std::begin(map_options), std::end(map_options),
                     [&](const MapOption& option) { return option.name == word; });
    return found == std::end(map_options) ? nullptr : found;
  }

  // Moves `word` past the values of the option. Returns whether they have no effect.
  bool skip_values(const MapOption& option, std::string_view& word) {
    if (option.numbers == 0) {
      const bool neutral = option.neutral.empty() || option.neutral == word;
      word = words_.next_word();
      return neutral;
    }
    bool neutral = true;
    for (std::size_t i = 0; i < option.numbers; ++i) {
      const ParsedNumber number = parse_number(word);
      if (number.error != NumberError::none) {
        break;
      }
      neutral = neutral && (option.neutral.empty() || number.value == option.neutral[i] - '0');
      word = words_.next_word();
    }
    return neutral;
  }

  void note_orphan(std::string_view keyword) {
    if (!orphan_.second.known()) {
      orphan_ = {keyword, words_.location(keyword)};
    }
  }

  void note_unknown(std::string_view keyword) {
    const auto same = [&](const auto& noted) { return noted.first == keyword; };
    if (unknown_.size() < limits_.messages_per_code &&
        std::none_of(unknown_.begin(), unknown_.end(), same)) {
      unknown_.emplace_back(keyword, words_.location(keyword));
    }
  }

  void finish() {
    if (names_.empty()) {
      report("mtl.no-material"_code, {},
             orphan_.second.known() ? "this is not a material library: no line begins with newmtl"
                                    : "the material library is empty: no line begins with newmtl");
      return;
    }
    if (orphan_.second.known()) {
      report("mtl.before-newmtl"_code, orphan_.second,
             fmt::format("{} comes before any newmtl and belongs to no material",
                         quoted(orphan_.first)));
    }
    std::vector<std::string_view> known(mtl_other.begin(), mtl_other.end());
    for (const auto& entry : mtl_colors) {
      known.push_back(entry.first);
    }
    for (const auto& entry : mtl_maps) {
      known.push_back(entry.first);
    }
    for (const auto& [keyword, location] : unknown_) {
      const std::string_view meant = nearest_name(keyword, known);
      report("mtl.unknown-keyword"_code, location,
             fmt::format("unknown keyword {} is skipped{}", quoted(keyword),
                         meant.empty() ? "" : fmt::format("; did you mean {}?", meant)),
             correction(keyword, meant, known));
    }
    if (point_.known()) {
      report("mtl.leading-point"_code, point_,
             "the course's program reads a number without a digit before the point, such as .5, "
             "as 0; write 0.5");
    }
  }

  ObjWords words_;
  const std::string& file_name_;
  const Limits& limits_;
  std::uint64_t& budget_;
  Diagnostics& diagnostics_;
  std::vector<MtlMaterial> materials_;
  std::optional<MtlMaterial> draft_;
  std::unordered_set<std::string_view> names_;
  bool duplicate_ = false;  // the draft has the name of an earlier material
  bool from_d_ = false;     // the opacity of the draft was given by d
  std::pair<std::string_view, Location> orphan_;
  std::vector<std::pair<std::string_view, Location>> unknown_;
  Location point_;
};

}  // namespace

std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& file_name,
                                  const Limits& limits, std::uint64_t& byte_budget,
                                  Diagnostics& diagnostics) {
  return MtlReader(text, file_name, limits, byte_budget, diagnostics).read();
}

}  // namespace scenefile
