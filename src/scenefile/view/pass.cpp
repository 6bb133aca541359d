#include "scenefile/view/pass.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/view/light_table.h"
#include "scenefile/view/scene_buffers.h"
#include "scenefile/view/shadows.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace scenefile {

namespace {

// Instances with equal keys are drawn in one call.
struct BatchKey {
  bool see_through = false;
  Shape shape = Shape::cube;
  std::uint32_t mesh = no_index;
  std::size_t level = 0;
  std::uint32_t texture = no_index;
  std::uint32_t bumps = no_index;
  gl::Enum hidden_side = gl::NONE;  // the side of its triangles to cull

  auto operator<=>(const BatchKey&) const = default;
};

struct Batch {
  BatchKey key;
  std::size_t first = 0;  // first instance
  std::size_t count = 0;
};

struct Item {
  BatchKey key;
  double distance = 0;  // of the object's center
  double work = 0;      // in units of the time per pixel
  std::uint32_t object = 0;
};

// More than any scene written by hand needs; bounds the time for deeply nested templates.
constexpr double max_work = 6e8;
constexpr double work_of_triangle = 15;
// Between two looks at whether the drawing is interrupted.
constexpr std::size_t objects_per_check = 256;

// Opaque objects in batches, nearest first, to avoid lighting hidden pixels; then transparent ones,
// farthest first.
bool comes_before(const Item& a, const Item& b) {
  if (a.key.see_through) {
    return b.key.see_through && std::tie(b.distance, a.object) < std::tie(a.distance, b.object);
  }
  return b.key.see_through ||
         std::tie(a.key, a.distance, a.object) < std::tie(b.key, b.distance, b.object);
}

// Coefficients of the round side x^2 + z^2 + a y^2 + b y + c = 0; 0 for meshes.
glm::vec3 quadric_of(Shape shape) {
  switch (shape) {
    case Shape::sphere:
      return {1, 0, -0.25f};
    case Shape::cone:
      return {-0.25f, 0.25f, -0.0625f};
    case Shape::mesh:
      return {0, 0, 0};
    case Shape::cylinder:
    case Shape::cube:
      break;
  }
  return {0, 0, -0.25f};
}

class Pass {
 public:
  Pass(GlDevice::State& device, Drawing::State& drawing, const Frame& frame,
       const DrawOptions& options, Output output)
      : device_(device),
        gl_(device.gl),
        drawing_(drawing),
        frame_(frame),
        options_(options),
        output_(output),
        boxes_(output == Output::box),
        lines_(output == Output::flat_color),
        // All shadow maps together may take as long as the picture.
        max_work_(output == Output::nothing
                      ? max_work / double(std::max<std::size_t>(1, drawing.shadows.views.size()))
                      : max_work) {}

  DrawStats draw() {
    choose_objects();
    pack();
    bind_tables();
    gl_.Enable(gl::DEPTH_TEST);
    gl_.DepthFunc(options_.realtime ? gl::LESS : gl::LEQUAL);
    if (boxes_) {
      gl_.Disable(gl::DEPTH_TEST);
      gl_.Enable(gl::BLEND);
      gl_.BlendFunc(gl::ONE, gl::ONE);
    }
    std::size_t unchecked = 0;
    for (const Batch& batch : batches_) {
      if (batch.key.see_through) {
        draw_see_through(batch);
      } else {
        draw_batch(batch, 0);
      }
      unchecked += batch.count;
      if (unchecked >= objects_per_check) {
        unchecked = 0;
        if (is_interrupted()) {
          break;
        }
      }
    }
    gl_.BindVertexArray(0);
    gl_.Disable(gl::CULL_FACE);
    gl_.Disable(gl::BLEND);
    gl_.Disable(gl::DEPTH_TEST);
    return stats_;
  }

 private:
  bool is_interrupted() {
    if (device_.go_on) {
      gl_.Finish();
      device_.interrupted = !device_.go_on();
    }
    return device_.interrupted;
  }

  bool is_shown(std::uint32_t source) const {
    return source >= options_.objects.size() || options_.objects[source];
  }

  // Calls `test` with the sources of the object and its instances until one returns true.
  template <typename Test>
  bool any_source(const DrawnObject& name, const Test& test) const {
    if (test(name.source)) {
      return true;
    }
    for (std::uint32_t p = name.placement; p != no_index; p = drawing_.scene.placements[p].parent) {
      if (test(drawing_.scene.placements[p].source)) {
        return true;
      }
    }
    return false;
  }

  bool is_hidden(const DrawnObject& name) const {
    return !options_.objects.empty() &&
           any_source(name, [&](std::uint32_t source) { return !is_shown(source); });
  }

  BatchKey key_of(const WorldObject& object) const {
    BatchKey key;
    if (boxes_) {
      return key;
    }
    key.shape = object.shape;
    key.mesh = object.mesh;
    if (has_curved_side(object.shape) && !options_.realtime) {
      const double radius = radius_in_pixels(frame_, object);
      const int wanted = lines_ ? wires_for(radius) : segments_for(radius);
      while (key.level + 1 < levels && level_segments[key.level] < wanted) {
        ++key.level;
      }
    }
    key.hidden_side = hidden_side(object);
    if (output_ != Output::shaded) {
      return key;
    }
    const RenderMaterial& material = drawing_.materials[object.material];
    key.see_through = options_.transparency && material.transparent != glm::vec3(0) && kt() > 0;
    if (options_.textures && material.blend != 0 && material.texture.used() &&
        drawing_.textures[material.texture.file]) {
      key.texture = material.texture.file;
    }
    if (options_.textures && !options_.course && material.bump_map.used() &&
        drawing_.textures[material.bump_map.file]) {
      key.bumps = material.bump_map.file;
    }
    return key;
  }

  // Solids seen from outside only show front faces; a reflection swaps the sides. The assignment
  // culls OpenGL's back faces of everything.
  gl::Enum hidden_side(const WorldObject& object) const {
    if (options_.realtime) {
      return gl::BACK;
    }
    if (!is_behind_near(frame_, object) || object.shape == Shape::mesh) {
      return gl::NONE;
    }
    return glm::determinant(object.world_from_object.linear) < 0 ? gl::FRONT : gl::BACK;
  }

  bool shadowed() const {
    return output_ == Output::shaded && options_.shadows && !drawing_.shadows.views.empty();
  }

  // In the profile fine, glass transmits light; a material that transmits more than half casts no
  // shadow.
  bool throws_shadow(const WorldObject& object) const {
    const glm::vec3 through = kt() * drawing_.materials[object.material].transparent;
    return options_.course || !options_.transparency || through.r + through.g + through.b < 1.5f;
  }

  float kt() const { return drawing_.global.transparent.value_or(options_.course ? 0.0f : 0.5f); }

  void choose_objects() {
    double work = 0;
    for (std::uint32_t i = 0; i < drawing_.scene.objects.size(); ++i) {
      const WorldObject& object = drawing_.scene.objects[i];
      if (!may_be_seen(frame_, object) || is_hidden(drawing_.scene.names[i]) ||
          (output_ == Output::nothing && !throws_shadow(object))) {
        continue;
      }
      const glm::dvec3 middle = 0.5 * (glm::dvec3(object.box_min) + glm::dvec3(object.box_max));
      const BatchKey key = key_of(object);
      items_.push_back(
          {key, glm::length(middle - frame_.camera.position), work_of(object, key), i});
      work += items_.back().work;
    }
    if (work > max_work_) {
      leave_out_farthest();
    }
    if (options_.realtime) {  // at equal depth the first in the file is visible
      std::sort(items_.begin(), items_.end(),
                [](const Item& a, const Item& b) { return a.object < b.object; });
    } else {
      std::sort(items_.begin(), items_.end(), comes_before);
    }
  }

  double triangles_of(const WorldObject& object, const BatchKey& key) const {
    const double segments = level_segments[key.level];
    switch (object.shape) {
      case Shape::mesh:
        return double(drawing_.mesh_triangles[object.mesh].size()) / 3;
      case Shape::cube:
        return options_.realtime ? 12 * std::pow(options_.realtime->tessellation.parameter1, 2)
                                 : 12;
      case Shape::sphere:
      case Shape::cylinder:
      case Shape::cone:
        break;
    }
    return options_.realtime ? 4.0 * options_.realtime->tessellation.parameter1 *
                                   options_.realtime->tessellation.parameter2
                             : segments * segments;
  }

  double work_of(const WorldObject& object, const BatchKey& key) const {
    const double radius = radius_in_pixels(frame_, object);
    const double whole = double(frame_.height) * frame_.height * frame_.tan_x / frame_.tan_y;
    return std::min(2 * radius * radius, whole) + work_of_triangle * triangles_of(object, key);
  }

  void leave_out_farthest() {
    const auto nearer = [](const Item& a, const Item& b) {
      return std::tie(a.distance, a.object) < std::tie(b.distance, b.object);
    };
    const auto easier = [](const Item& a, const Item& b) { return a.work < b.work; };
    const double least = std::min_element(items_.begin(), items_.end(), easier)->work;
    const auto at_most = std::min(items_.size(), static_cast<std::size_t>(max_work_ / least));
    const auto end = items_.begin() + std::ptrdiff_t(at_most);
    std::nth_element(items_.begin(), end, items_.end(), nearer);
    std::sort(items_.begin(), end, nearer);
    double work = 0;
    std::size_t kept = 0;
    while (kept < at_most && work + items_[kept].work <= max_work_) {
      work += items_[kept++].work;
    }
    kept = std::max<std::size_t>(kept, 1);
    stats_.left_out = items_.size() - kept;
    items_.resize(kept);
  }

  InstanceRecord record_of(const Item& item) const {
    const WorldObject& object = drawing_.scene.objects[item.object];
    DAffine map(object.world_from_object);
    if (boxes_) {
      map = DAffine(glm::dmat3(1), glm::dvec3(0));
      map.offset = 0.5 * (glm::dvec3(object.box_min) + glm::dvec3(object.box_max));
      for (int axis = 0; axis < 3; ++axis) {
        map.linear[axis][axis] = double(object.box_max[axis]) - double(object.box_min[axis]);
      }
    }
    map.offset -= frame_.camera.position;
    InstanceRecord record;
    for (int row = 0; row < 3; ++row) {
      record.rows[row] =
          glm::vec4(map.linear[0][row], map.linear[1][row], map.linear[2][row], map.offset[row]);
    }
    record.object = {static_cast<float>(object.material), static_cast<float>(item.object), 0, 0};
    return record;
  }

  void pack() {
    std::vector<InstanceRecord> records;
    records.reserve(items_.size());
    for (const Item& item : items_) {
      // Transparent objects are drawn one by one, in order.
      const bool full =
          device_.go_on && !batches_.empty() && batches_.back().count == objects_per_check;
      if (batches_.empty() || batches_.back().key != item.key || item.key.see_through || full) {
        batches_.push_back({item.key, records.size(), 0});
      }
      ++batches_.back().count;
      records.push_back(record_of(item));
    }
    stats_.objects = records.size();
    gl_.BindBuffer(gl::ARRAY_BUFFER, drawing_.instances.name());
    gl_.BufferData(gl::ARRAY_BUFFER, std::ptrdiff_t(records.size() * sizeof(InstanceRecord)),
                   records.data(), gl::STREAM_DRAW);
  }

  void bind_texture(int unit, gl::Name texture) {
    gl_.ActiveTexture(gl::TEXTURE0 + unit);
    gl_.BindTexture(gl::TEXTURE_2D, texture);
  }

  void bind_tables() {
    emitter_count_ = static_cast<int>(drawing_.emitters.size());
    if (output_ == Output::shaded) {
      const std::vector<ShadowCode>& codes = drawing_.shadows.codes;
      std::vector<glm::vec4> rows;
      for (const Emitter& emitter : drawing_.emitters) {
        const bool shadow = options_.shadows && rows.size() / emitter_texels < codes.size();
        const auto row = emitter_row(emitter, frame_.camera.position,
                                     shadow ? codes[rows.size() / emitter_texels] : -1);
        rows.insert(rows.end(), row.begin(), row.end());
      }
      gl_.ActiveTexture(gl::TEXTURE0 + unit_emitters);
      fill_table(gl_, drawing_.emitter_table, emitter_texels, rows);
      if (shadowed()) {
        bind_shadows(gl_, drawing_.shadows, frame_.camera.position);
      }
    }
    bind_texture(unit_materials, drawing_.material_table.name());
  }

  const Program& use_program(const BatchKey& key) {
    const Program& program =
        device_.programs.use({output_, key.texture != no_index, shadowed(), key.bumps != no_index});
    const glm::mat4 clip = clip_from_world(frame_);
    gl_.UniformMatrix4fv(program.clip_from_world, 1, 0, &clip[0][0]);
    gl_.Uniform1i(program.emitter_count, emitter_count_);
    gl_.Uniform1f(program.transparent, kt());
    const bool truncated = options_.course && output_ != Output::object_number && !boxes_;
    gl_.Uniform1f(program.truncation, truncated ? 0.5f / 255 : 0.0f);
    const double reach = frame_.far - frame_.near;
    const glm::vec4 axis(glm::vec3(-frame_.camera.w / reach), -frame_.near / reach);
    gl_.Uniform4fv(program.depth_axis, 1, &axis[0]);
    gl_.Uniform1i(program.lookup, (options_.course ? 0 : 2) + (options_.texture_filter ? 1 : 0));
    return program;
  }

  void point_at_instances(std::size_t first) {
    gl_.BindBuffer(gl::ARRAY_BUFFER, drawing_.instances.name());
    for (gl::Name i = 0; i < 4; ++i) {
      const std::size_t offset = first * sizeof(InstanceRecord) + i * sizeof(glm::vec4);
      gl_.VertexAttribPointer(3 + i, 4, gl::FLOAT, 0, sizeof(InstanceRecord),
                              reinterpret_cast<const void*>(offset));
    }
  }

  void draw_batch(const Batch& batch, int passing) {
    const BatchKey& key = batch.key;
    const Geometry& geometry =
        options_.realtime && key.shape != Shape::mesh
            ? realtime_geometry_of(gl_, drawing_, key.shape, options_.realtime->tessellation,
                                   lines_)
            : geometry_of(gl_, drawing_, key.shape, key.mesh, key.level, lines_);
    const Program& program = use_program(key);
    const glm::vec3 quadric = quadric_of(key.shape);
    gl_.Uniform3f(program.quadric, quadric.x, quadric.y, quadric.z);
    gl_.Uniform1i(program.passing, passing);
    if (key.texture != no_index) {
      bind_texture(unit_image, drawing_.textures[key.texture].name());
    }
    if (key.bumps != no_index) {
      bind_texture(unit_bumps, drawing_.textures[key.bumps].name());
    }
    if (key.hidden_side == gl::NONE) {
      gl_.Disable(gl::CULL_FACE);
    } else {
      gl_.Enable(gl::CULL_FACE);
      gl_.CullFace(key.hidden_side);
    }
    gl_.BindVertexArray(geometry.array.name());
    point_at_instances(batch.first);
    const auto instances = static_cast<gl::Size>(batch.count);
    if (lines_) {
      gl_.BindBuffer(gl::ELEMENT_ARRAY_BUFFER, geometry.lines.name());
      gl_.DrawElementsInstanced(gl::LINES, geometry.line_indices, gl::UNSIGNED_INT, nullptr,
                                instances);
    } else {
      gl_.BindBuffer(gl::ELEMENT_ARRAY_BUFFER, geometry.triangles.name());
      gl_.DrawElementsInstanced(gl::TRIANGLES, geometry.triangle_indices, gl::UNSIGNED_INT, nullptr,
                                instances);
    }
    stats_.triangles += batch.count * static_cast<std::uint64_t>(geometry.triangle_indices / 3);
    ++stats_.draw_calls;
  }

  // First multiplies what is already drawn by the color of the object, then adds the object's
  // light. Only front faces count.
  void draw_see_through(const Batch& batch) {
    gl_.Enable(gl::BLEND);
    gl_.DepthMask(0);
    gl_.BlendFunc(gl::ZERO, gl::SRC_COLOR);
    draw_batch(batch, 1);
    gl_.BlendFunc(gl::ONE, gl::ONE);
    draw_batch(batch, 0);
    gl_.DepthMask(1);
    gl_.Disable(gl::BLEND);
  }

  GlDevice::State& device_;
  const gl::Functions& gl_;
  Drawing::State& drawing_;
  const Frame& frame_;
  const DrawOptions& options_;
  Output output_;
  bool boxes_;
  bool lines_;
  double max_work_;
  int emitter_count_ = 0;
  std::vector<Item> items_;
  std::vector<Batch> batches_;
  DrawStats stats_;
};

}  // namespace

DrawStats draw_objects(GlDevice::State& device, Drawing::State& drawing, const Frame& frame,
                       const DrawOptions& options, Output output) {
  return Pass(device, drawing, frame, options, output).draw();
}

}  // namespace scenefile
