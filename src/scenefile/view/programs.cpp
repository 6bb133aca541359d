#include "scenefile/view/programs.h"

#include "scenefile/view/light_table.h"
#include "scenefile/view/shaders.h"
#include "scenefile/view/shadows.h"

#include <fmt/format.h>

#include <array>

namespace scenefile {

namespace {

// The only difference between the shaders of OpenGL and those of OpenGL ES.
std::string version_of(const gl::Functions& gl) {
  return gl.es ? "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                 "precision highp sampler2D;\n"
               : "#version 410 core\n";
}

std::string preamble(const gl::Functions& gl, const ProgramKey& key) {
  std::string text = version_of(gl);
  const auto define = [&](const char* name, int value) {
    text += fmt::format("#define {} {}\n", name, value);
  };
  define("MODE", static_cast<int>(key.output));
  define("TABLE_WIDTH", table_width);
  define("MATERIAL_TEXELS", material_texels);
  define("EMITTER_TEXELS", emitter_texels);
  define("SHADOW_TEXELS", shadow_texels);
  if (key.output == Output::nothing) {
    define("DEPTH_ONLY", 1);
  }
  if (key.shadowed) {
    define("SHADOWED", 1);
  }
  if (key.bumped) {
    define("BUMPED", 1);
  }
  if (key.textured) {
    define("TEXTURED", 1);
  }
  return text;
}

}  // namespace

Programs::~Programs() {
  if (filter_) {
    gl_.DeleteProgram(filter_->name);
  }
  for (const auto& [key, program] : programs_) {
    gl_.DeleteProgram(program.name);
  }
}

gl::Name Programs::compile(gl::Enum stage, const std::string& text) {
  const gl::Name shader = gl_.CreateShader(stage);
  const char* const data = text.c_str();
  gl_.ShaderSource(shader, 1, &data, nullptr);
  gl_.CompileShader(shader);
  int compiled = 0;
  gl_.GetShaderiv(shader, gl::COMPILE_STATUS, &compiled);
  if (compiled == 0) {
    std::array<char, 1024> log{};
    gl_.GetShaderInfoLog(shader, log.size(), nullptr, log.data());
    error_ = log.data();
  }
  return shader;
}

gl::Name Programs::link(const std::string& vertex_text, const std::string& fragment_text) {
  const gl::Name name = gl_.CreateProgram();
  const gl::Name vertex = compile(gl::VERTEX_SHADER, vertex_text);
  const gl::Name fragment = compile(gl::FRAGMENT_SHADER, fragment_text);
  gl_.AttachShader(name, vertex);
  gl_.AttachShader(name, fragment);
  gl_.LinkProgram(name);
  gl_.DeleteShader(vertex);
  gl_.DeleteShader(fragment);
  int linked = 0;
  gl_.GetProgramiv(name, gl::LINK_STATUS, &linked);
  if (linked != 0) {
    return name;
  }
  if (error_.empty()) {
    std::array<char, 1024> log{};
    gl_.GetProgramInfoLog(name, log.size(), nullptr, log.data());
    error_ = log.data();
  }
  gl_.DeleteProgram(name);
  return 0;
}

Program Programs::build(const ProgramKey& key) {
  const gl::Name name =
      link(preamble(gl_, key) + scene_vert,
           preamble(gl_, key) + (key.output == Output::nothing ? "void main() {}\n" : scene_frag));
  if (name == 0) {
    return {};
  }
  const auto location = [&](const char* uniform) { return gl_.GetUniformLocation(name, uniform); };
  gl_.UseProgram(name);
  gl_.Uniform1i(location("image"), unit_image);
  gl_.Uniform1i(location("materials"), unit_materials);
  gl_.Uniform1i(location("emitters"), unit_emitters);
  gl_.Uniform1i(location("shadow_table"), unit_shadow_table);
  gl_.Uniform1i(location("shadows"), unit_shadows);
  gl_.Uniform1i(location("bumps"), unit_bumps);
  return {name,
          location("clip_from_world"),
          location("emitter_count"),
          location("quadric"),
          location("transparent"),
          location("passing"),
          location("depth_axis"),
          location("lookup"),
          location("truncation")};
}

const Program& Programs::use(const ProgramKey& key) {
  const auto [found, fresh] = programs_.try_emplace(key);
  if (fresh) {
    found->second = build(key);
  }
  gl_.UseProgram(found->second.name);
  return found->second;
}

const FilterProgram& Programs::use_filter() {
  if (!filter_) {
    const std::string version = version_of(gl_);
    filter_.emplace();
    filter_->name = link(version + filter_vert, version + filter_frag);
    filter_->kind = gl_.GetUniformLocation(filter_->name, "kind");
    filter_->target_size = gl_.GetUniformLocation(filter_->name, "target_size");
  }
  gl_.UseProgram(filter_->name);
  return *filter_;
}

}  // namespace scenefile
