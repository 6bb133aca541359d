#pragma once
// Shader programs, compiled at first use. Internal to view.

#include "scenefile/view/gl_functions.h"

#include <glm/glm.hpp>

#include <compare>
#include <map>
#include <optional>
#include <string>

namespace scenefile {

/// The output of the fragment shader; the numbers must match shaders/scene.frag.
enum class Output : std::uint8_t {
  shaded,
  flat_color,
  normals,
  uv,
  depth,
  object_color,
  object_number,
  box,
  nothing  ///< only depth
};

struct ProgramKey {
  Output output = Output::shaded;
  bool textured = false;
  bool shadowed = false;
  bool bumped = false;

  auto operator<=>(const ProgramKey&) const = default;
};

struct Program {
  gl::Name name = 0;
  int clip_from_world = -1;
  int emitter_count = -1;
  int quadric = -1;
  int transparent = -1;
  int passing = -1;
  int depth_axis = -1;
  int lookup = -1;
  int truncation = -1;
};

/// The program of shaders/filter.frag.
struct FilterProgram {
  gl::Name name = 0;
  int kind = -1;
  int target_size = -1;
};

/// Texture units of the samplers.
inline constexpr int unit_image = 0;
inline constexpr int unit_materials = 1;
inline constexpr int unit_emitters = 2;
inline constexpr int unit_shadow_table = 3;
inline constexpr int unit_shadows = 4;
inline constexpr int unit_bumps = 5;

/// Texels per material, and the number of materials or emitters in a row of their table.
inline constexpr int material_texels = 5;
inline constexpr int table_width = 256;

class Programs {
 public:
  explicit Programs(const gl::Functions& functions) : gl_(functions) {}
  ~Programs();
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;

  /// Makes the program current. Its name is 0 if the driver rejects it; error() then says why.
  const Program& use(const ProgramKey& key);
  const FilterProgram& use_filter();
  const std::string& error() const { return error_; }

 private:
  Program build(const ProgramKey& key);
  gl::Name compile(gl::Enum stage, const std::string& text);
  gl::Name link(const std::string& vertex_text, const std::string& fragment_text);

  const gl::Functions& gl_;
  std::map<ProgramKey, Program> programs_;
  std::optional<FilterProgram> filter_;
  std::string error_;
};

}  // namespace scenefile
