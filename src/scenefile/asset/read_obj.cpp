#include "scenefile/asset/read_obj.h"

#include "scenefile/asset/codes.h"
#include "scenefile/asset/obj_corner.h"
#include "scenefile/asset/obj_words.h"
#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

namespace scenefile {

namespace {

using Corners = std::array<std::uint32_t, 3>;
constexpr Corners no_corners = {mesh_no_index, mesh_no_index, mesh_no_index};

// Counts from a first pass over the file: limits are checked and memory is reserved before anything
// is read, and faces may come before their vertices.
struct Counts {
  std::uint64_t positions = 0;
  std::uint64_t uvs = 0;
  std::uint64_t normals = 0;
  std::uint64_t triangles = 0;  ///< at most
  std::uint64_t materials = 0;  ///< bytes of the names of materials and libraries

  std::uint64_t bytes() const {
    const std::uint64_t lists = 1 + (uvs > 0 ? 1 : 0) + (normals > 0 ? 1 : 0);
    const std::uint64_t material = materials > 0 ? sizeof(std::uint32_t) : 0;
    return positions * sizeof(glm::vec3) + uvs * sizeof(glm::vec2) + normals * sizeof(glm::vec3) +
           triangles * (sizeof(Corners) * lists + material) + materials;
  }
};

// The memory of a name, in a list and in a table.
std::uint64_t name_bytes(std::string_view name) {
  constexpr std::uint64_t node_bytes = 64;
  return sizeof(FileReference) + node_bytes + name.size();
}

Counts count_elements(std::string_view text, bool materials) {
  Counts counts;
  ObjWords words(text);
  while (words.next_statement()) {
    const std::string_view keyword = words.next_word();
    if (keyword == "v") {
      ++counts.positions;
    } else if (keyword == "vt") {
      ++counts.uvs;
    } else if (keyword == "vn") {
      ++counts.normals;
    } else if (keyword == "f") {
      std::uint64_t corners = 0;
      while (!words.next_word().empty()) {
        ++corners;
      }
      counts.triangles += corners > 2 ? corners - 2 : 0;
    } else if (materials && (keyword == "usemtl" || keyword == "mtllib")) {
      const std::string_view line = words.rest(words.next_word());
      counts.materials += name_bytes(line);
      for (ObjWords names(keyword == "mtllib" ? line : ""); names.next_statement();) {
        for (std::string_view name = names.next_word(); !name.empty(); name = names.next_word()) {
          counts.materials += name_bytes(name);
        }
      }
    }
  }
  return counts;
}

Counts counts_of(const Mesh& mesh, const ObjMaterials* materials) {
  Counts counts{mesh.positions.size(), mesh.uvs.size(), mesh.normals.size(), mesh.triangles.size()};
  if (materials != nullptr) {
    for (const FileReference& name : materials->names) {
      counts.materials += name_bytes(name.name);
    }
  }
  return counts;
}

// Statements that do not affect the picture.
bool is_skipped(std::string_view keyword) {
  constexpr std::string_view names[] = {"g",          "o",         "s",        "l",       "p",
                                        "mg",         "usemap",    "maplib",   "bevel",   "lod",
                                        "shadow_obj", "trace_obj", "c_interp", "d_interp"};
  return std::find(std::begin(names), std::end(names), keyword) != std::end(names);
}

bool is_free_form(std::string_view keyword) {
  constexpr std::string_view names[] = {"vp",    "cstype", "deg",  "bmat",  "step", "curv",
                                        "curv2", "surf",   "parm", "trim",  "hole", "scrv",
                                        "sp",    "end",    "con",  "ctech", "stech"};
  return std::find(std::begin(names), std::end(names), keyword) != std::end(names);
}

// Whether a word cannot come from a text format.
bool is_binary(std::string_view word) {
  while (!word.empty()) {
    const CodePoint c = first_code_point(word);
    if (c.bytes == 0 || c.value < 0x20 || c.value == 0x7f) {
      return true;
    }
    word.remove_prefix(c.bytes);
  }
  return false;
}

// Whether some line is a vertex, as in any mesh. Otherwise the file may be anything, and findings
// quote no word of it.
bool has_vertex(std::string_view text) {
  constexpr std::string_view numbers = "0123456789+-.";
  for (std::size_t at = 0; at < text.size(); at = text.find_first_of("\r\n", at)) {
    at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    const std::string_view line = text.substr(at, 80);
    const std::size_t number = line.find_first_not_of(" \t", 1);
    if (line.starts_with('v') && number > 1 && number != std::string_view::npos &&
        numbers.find(line[number]) != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

// Keeps only the triangles for which `keep` is true.
template <typename Keep>
void keep_triangles(Mesh& mesh, std::vector<std::uint32_t>& materials, Keep keep) {
  const auto for_each_list = [&](auto work) {
    work(mesh.triangles);
    work(mesh.triangle_uvs);
    work(mesh.triangle_normals);
    work(materials);
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (keep(mesh.triangles[i])) {
      for_each_list([&](auto& list) {
        if (!list.empty()) {
          list[kept] = list[i];
        }
      });
      ++kept;
    }
  }
  for_each_list([&](auto& list) { list.resize(list.empty() ? 0 : kept); });
}

bool has_area(const Mesh& mesh, const Corners& triangle) {
  const glm::dvec3 a(mesh.positions[triangle[0]]);
  const glm::dvec3 b(mesh.positions[triangle[1]]);
  const glm::dvec3 c(mesh.positions[triangle[2]]);
  return glm::cross(b - a, c - a) != glm::dvec3(0);
}

// Drops an index list that no triangle uses.
void drop_unused(std::vector<Corners>& list) {
  const bool used =
      std::any_of(list.begin(), list.end(), [](const Corners& c) { return c[0] != mesh_no_index; });
  if (!used) {
    list = {};
  }
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& file_name, const Limits& limits,
            Diagnostics& diagnostics, ObjMaterials* materials)
      : words_(text),
        counts_(count_elements(text, materials != nullptr)),
        may_quote_(has_vertex(text)),
        file_name_(file_name),
        limits_(limits),
        diagnostics_(diagnostics),
        materials_(materials) {}

  const Counts& counts() const { return counts_; }

  void report(const Code& code, Location location, std::string message,
              std::optional<Correction> correction = {}) {
    report(code, code.severity, location, std::move(message), std::move(correction));
  }
  void report(const Code& code, Severity severity, Location location, std::string message,
              std::optional<Correction> correction = {}) {
    errors_ += severity == Severity::error ? 1 : 0;
    diagnostics_.add(
        {&code, severity, location, file_name_, std::move(message), {}, std::move(correction)});
  }

  Mesh read() {
    reserve();
    bool is_obj = true;
    while (is_obj && errors_ < limits_.messages_per_code && words_.next_statement()) {
      is_obj = read_statement(words_.next_word());
    }
    if (!is_obj || (known_ == 0 && !unknown_.empty())) {
      const Location first = is_obj ? unknown_.front().second : Location{};
      report("mesh.not-obj"_code, first,
             "this is not an OBJ file: no line begins with v, f or another OBJ keyword");
    }
    if (errors_ == 0) {
      report_unknown();
      finish();
    }
    if (errors_ != 0) {
      return {};
    }
    if (materials_ != nullptr) {
      *materials_ = std::move(written_);
    }
    return std::move(mesh_);
  }

 private:
  void reserve() {
    mesh_.positions.reserve(counts_.positions);
    mesh_.uvs.reserve(counts_.uvs);
    mesh_.normals.reserve(counts_.normals);
    mesh_.triangles.reserve(counts_.triangles);
    mesh_.triangle_uvs.reserve(counts_.uvs > 0 ? counts_.triangles : 0);
    mesh_.triangle_normals.reserve(counts_.normals > 0 ? counts_.triangles : 0);
    written_.of_triangle.reserve(counts_.materials > 0 ? counts_.triangles : 0);
  }

  // False if the text cannot be OBJ.
  bool read_statement(std::string_view keyword) {
    ++known_;
    if (keyword == "v") {
      mesh_.positions.push_back(read_numbers(keyword, 3, 3));
    } else if (keyword == "f") {
      read_face(keyword);
    } else if (keyword == "vn") {
      read_normal(keyword);
    } else if (keyword == "vt") {
      mesh_.uvs.emplace_back(read_numbers(keyword, 1, 2));
    } else if (keyword == "usemtl") {
      use_material();
    } else if (keyword == "mtllib") {
      add_library();
    } else if (!is_skipped(keyword)) {
      known_ -= is_free_form(keyword) ? 0 : 1;
      return note_unknown(keyword);
    }
    return true;
  }

  // Reads all numbers of the statement; `least` are required, at most `most` are returned.
  glm::vec3 read_numbers(std::string_view keyword, int least, int most) {
    glm::vec3 result(0);
    int count = 0;
    while (true) {
      const std::string_view word = words_.next_word();
      if (word.empty()) {
        break;
      }
      const ParsedNumber number = parse_number(word);
      if (number.error != NumberError::none) {
        report_number(keyword, word, number.error);
        return result;
      }
      if (count < most) {
        result[count] = static_cast<float>(number.value);
      }
      ++count;
    }
    if (count < least) {
      report("mesh.number"_code, words_.location(keyword),
             fmt::format("{} needs {} numbers and has {}", keyword, least, count));
    }
    return result;
  }

  void report_number(std::string_view keyword, std::string_view word, NumberError error) {
    const char* what =
        error == NumberError::out_of_range ? "is too large for a number" : "is not a finite number";
    report("mesh.number"_code, words_.location(word),
           fmt::format("{} in {} {}", may_quote_ ? quoted(word) : "a word", keyword, what));
  }

  void read_normal(std::string_view keyword) {
    const Location location = words_.location(keyword);
    const glm::vec3 normal = read_numbers(keyword, 3, 3);
    mesh_.normals.push_back(normal);
    if (normal == glm::vec3(0)) {
      first_zero_normal_ = zero_normals_ == 0 ? location : first_zero_normal_;
      ++zero_normals_;
    }
  }

  void read_face(std::string_view keyword) {
    const Location location = words_.location(keyword);
    Corner first{}, previous{};
    std::uint64_t count = 0;
    while (true) {
      const std::string_view word = words_.next_word();
      if (word.empty() || errors_ >= limits_.messages_per_code) {
        break;
      }
      const Corner corner = read_corner(word);
      if (count == 0) {
        first = corner;
      } else if (count >= 2) {
        add_triangle(first, previous, corner);
      }
      previous = corner;
      ++count;
    }
    if (count < 3) {
      report("mesh.short-face"_code, location,
             fmt::format("a face with {} is left out: it needs three", counted(count, "corner")));
    }
  }

  // The rest of the statement.
  void use_material() {
    const std::string_view first = words_.next_word();
    if (materials_ == nullptr || first.empty()) {
      material_ = mesh_no_index;
      return;
    }
    const Location location = words_.location(first);
    FileReference name{std::string(words_.rest(first)), location};
    const auto [entry, is_new] =
        numbers_.try_emplace(name.name, static_cast<std::uint32_t>(written_.names.size()));
    material_ = entry->second;
    if (is_new) {
      written_.names.push_back(std::move(name));
    }
  }

  void add_library() {
    if (materials_ == nullptr) {
      return;
    }
    if (std::vector<FileReference> names = library_names(words_); !names.empty()) {
      written_.libraries.push_back(std::move(names));
    }
  }

  Corner read_corner(std::string_view word) {
    const CornerLists lists = {
        {"vertex", counts_.positions, mesh_.positions.size()},
        {"uv", counts_.uvs, mesh_.uvs.size()},
        {"normal", counts_.normals, mesh_.normals.size()},
    };
    std::string missing_normal;
    const Result<Corner> corner = parse_corner(word, lists, missing_normal);
    if (!corner) {
      report("mesh.index"_code, words_.location(word),
             may_quote_ ? corner.error().text : "this is not a corner of a face");
      return {};
    }
    if (!missing_normal.empty() && missing_normals_++ == 0) {
      first_missing_normal_ = words_.location(word);
      missing_normal_ = std::move(missing_normal);
    }
    return *corner;
  }

  void add_triangle(const Corner& a, const Corner& b, const Corner& c) {
    mesh_.triangles.push_back({a.position, b.position, c.position});
    if (counts_.materials > 0) {
      written_.of_triangle.push_back(material_);
    }
    if (counts_.uvs > 0) {
      const bool all = a.uv != mesh_no_index && b.uv != mesh_no_index && c.uv != mesh_no_index;
      mesh_.triangle_uvs.push_back(all ? Corners{a.uv, b.uv, c.uv} : no_corners);
    }
    if (counts_.normals > 0) {
      const bool all =
          a.normal != mesh_no_index && b.normal != mesh_no_index && c.normal != mesh_no_index;
      mesh_.triangle_normals.push_back(all ? Corners{a.normal, b.normal, c.normal} : no_corners);
    }
  }

  // Reported at the end, once it is certain that the file is OBJ.
  bool note_unknown(std::string_view keyword) {
    if (is_binary(keyword)) {
      return false;
    }
    const auto same = [&](const auto& noted) { return noted.first == keyword; };
    if (unknown_.size() < limits_.messages_per_code &&
        std::none_of(unknown_.begin(), unknown_.end(), same)) {
      unknown_.emplace_back(keyword, words_.location(keyword));
    }
    return true;
  }

  void report_unknown() {
    constexpr std::string_view known[] = {"v", "vt", "vn", "f", "usemtl", "mtllib"};
    for (const auto& [keyword, location] : unknown_) {
      if (is_free_form(keyword)) {
        report("mesh.unknown-keyword"_code, location,
               fmt::format("{} is skipped: curves and surfaces are not drawn", keyword));
        continue;
      }
      const std::string_view meant = nearest_name(keyword, known);
      report("mesh.unknown-keyword"_code, location,
             fmt::format("unknown keyword{} is skipped{}", may_quote_ ? " " + quoted(keyword) : "",
                         meant.empty() ? "" : fmt::format("; did you mean {}?", meant)),
             may_quote_ ? correction(keyword, meant, known) : std::nullopt);
    }
  }

  void finish() {
    if (zero_normals_ > 0) {
      make_flat();
    }
    if (missing_normals_ > 0) {
      report("mesh.index"_code, Severity::warning, first_missing_normal_,
             fmt::format("{}; {} corner{} without {} normal: the triangles are shaded flat",
                         missing_normal_, missing_normals_, missing_normals_ == 1 ? " is" : "s are",
                         missing_normals_ == 1 ? "its" : "their"));
    }
    if (written_.names.empty()) {
      written_.of_triangle.clear();
    }
    const std::size_t all = mesh_.triangles.size();
    keep_triangles(mesh_, written_.of_triangle,
                   [&](const Corners& triangle) { return has_area(mesh_, triangle); });
    drop_unused(mesh_.triangle_uvs);
    drop_unused(mesh_.triangle_normals);
    if (const std::size_t dropped = all - mesh_.triangles.size(); dropped > 0) {
      report("mesh.degenerate"_code, {},
             fmt::format("{} degenerate triangle{} without area {} left out", dropped,
                         dropped == 1 ? "" : "s", dropped == 1 ? "is" : "are"));
    }
    if (mesh_.triangles.empty()) {
      report("mesh.empty"_code, {},
             known_ == 0
                 ? "the file is empty: there is nothing to draw"
                 : fmt::format("there is nothing to draw: {} vertices, no face with an area",
                               mesh_.positions.size()));
    }
  }

  void make_flat() {
    for (Corners& corners : mesh_.triangle_normals) {
      for (const std::uint32_t corner : Corners(corners)) {
        if (corner != mesh_no_index && mesh_.normals[corner] == glm::vec3(0)) {
          corners = no_corners;
        }
      }
    }
    report("mesh.zero-normal"_code, first_zero_normal_,
           counted(zero_normals_, "normal") +
               " of length zero: triangles that use them are shaded flat");
  }

  ObjWords words_;
  Counts counts_;
  bool may_quote_;
  const std::string& file_name_;
  const Limits& limits_;
  Diagnostics& diagnostics_;
  Mesh mesh_;
  ObjMaterials* materials_;  // where they are wanted, or null
  ObjMaterials written_;
  std::unordered_map<std::string, std::uint32_t> numbers_;  // of materials, by name
  std::uint32_t material_ = mesh_no_index;
  std::uint64_t errors_ = 0;
  std::uint64_t known_ = 0;  // statements
  std::vector<std::pair<std::string_view, Location>> unknown_;
  std::uint64_t zero_normals_ = 0;
  Location first_zero_normal_;
  std::uint64_t missing_normals_ = 0;  // corners
  Location first_missing_normal_;
  std::string missing_normal_;  // why the first one does not exist
};

// Why a mesh of this size is rejected, or nothing.
std::string over_limits(const Counts& counts, std::uint64_t triangles, std::uint64_t bytes) {
  if (counts.triangles > triangles) {
    return fmt::format("{} triangles, and {} are left of the limit for all meshes",
                       counts.triangles, triangles);
  }
  const std::uint64_t most = std::max({counts.positions, counts.uvs, counts.normals});
  if (counts.bytes() > bytes || most >= mesh_no_index) {
    return fmt::format("it takes {} MB, and {} MB are left of the limit for all meshes",
                       counts.bytes() / 1'000'000, bytes / 1'000'000);
  }
  return {};
}

}  // namespace

Mesh read_obj(std::string_view text, const std::string& file_name, const Limits& limits,
              std::uint64_t& triangle_budget, std::uint64_t& byte_budget, Diagnostics& diagnostics,
              ObjMaterials* materials) {
  ObjReader reader(text, file_name, limits, diagnostics, materials);
  const std::string too_large = over_limits(reader.counts(), triangle_budget, byte_budget);
  if (!too_large.empty()) {
    reader.report("mesh.limit"_code, {}, too_large);
    return {};
  }
  Mesh mesh = reader.read();
  const Counts read = counts_of(mesh, materials);
  triangle_budget -= read.triangles;
  byte_budget -= read.bytes();
  return mesh;
}

}  // namespace scenefile
