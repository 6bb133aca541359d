#include "scenefile/mistakes/realtime_hypotheses.h"

#include "scenefile/base/shape_traits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::array round_shapes{Shape::sphere, Shape::cylinder, Shape::cone};
static_assert([] {
  std::size_t count = 0;
  for (std::size_t i = 0; i < shape_count; ++i) {
    count += has_curved_side(static_cast<Shape>(i)) ? 1 : 0;
  }
  return count == round_shapes.size();
}());

std::string plural(Shape shape) {
  return std::string(word_of(shape)) + (shape == Shape::mesh ? "es" : "s");
}

class Maker {
 public:
  Maker(const RealtimeView& view, const RenderScene& lit, int width, int height)
      : view_(view),
        lit_(lit),
        picture_(width, height),
        window_(realtime_window(width, height)),
        width_(width),
        height_(height) {
    for (const RenderGroup& group : view.scene->groups) {
      for (const RenderPrimitive& p : group.primitives) {
        shapes_.insert(p.shape);
      }
    }
  }

  std::vector<RealtimeHypothesis> all() {
    add_flips();
    add_filters();
    add_viewports();
    add_tessellations();
    add_interpolations();
    add_culling();
    add_clipping();
    add_light_types();
    add_common();
    add_picture();
    return std::move(list_);
  }

 private:
  void add(Cause cause, std::string what, RealtimeStage stage,
           std::function<void(RealtimeTrial&)> draw) {
    list_.push_back({cause, std::move(what), stage, std::move(draw), {}, {}});
  }

  // Says of the last one that it is another way of drawing.
  void is_allowed() {
    list_.back().what += " (not a mistake by itself)";
    list_.back().mistake = false;
  }

  // Of the shapes with curved sides, or meshes.
  std::size_t curved_count() const {
    return static_cast<std::size_t>(std::count_if(round_shapes.begin(), round_shapes.end(),
                                                  [&](Shape s) { return shapes_.contains(s); })) +
           shapes_.count(Shape::mesh);
  }

  // ---- the finished picture ------------------------------------------------------------------

  void add_flips() {
    for (const Hypothesis& h : picture_hypotheses()) {
      if (h.cause == Cause::vertical_flip || h.cause == Cause::horizontal_flip) {
        list_.push_back({h.cause, h.what, RealtimeStage::picture, {}, h.turn, h.color});
      }
    }
  }

  // OpenGL clamps colors, so they never overflow.
  void add_picture() {
    for (const Hypothesis& h : picture_hypotheses()) {
      if (h.cause != Cause::vertical_flip && h.cause != Cause::horizontal_flip &&
          h.cause != Cause::overflow) {
        list_.push_back({h.cause, h.what, RealtimeStage::picture, {}, h.turn, h.color});
      }
    }
  }

  // ---- filters -------------------------------------------------------------------------------

  void add_filter(std::string what, const FilterSteps& steps) {
    add(Cause::filter, std::move(what), RealtimeStage::picture,
        [steps](RealtimeTrial& t) { t.filter = steps; });
  }

  static FilterSteps box(int columns, int rows, double weight) {
    FilterSteps steps;
    steps.columns = columns;
    steps.rows = rows;
    steps.weights.assign(std::size_t(columns) * rows, weight);
    return steps;
  }

  // The separable kernel: the outer product of one row of weights with itself.
  static FilterSteps product(const std::vector<double>& row) {
    const auto size = static_cast<int>(row.size());
    FilterSteps steps = box(size, size, 0);
    double sum = 0;
    for (const double w : row) {
      sum += w;
    }
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        steps.weights[std::size_t(y) * size + x] =
            row[std::size_t(y)] * row[std::size_t(x)] / (sum * sum);
      }
    }
    return steps;
  }

  static FilterSteps gaussian(int size, double sigma) {
    std::vector<double> row;
    for (int i = 0; i < size; ++i) {
      const double x = i - size / 2;
      row.push_back(std::exp(-x * x / (2 * sigma * sigma)));
    }
    return product(row);
  }

  static FilterSteps sharpening(double middle, double beside, double corner, double divisor) {
    FilterSteps steps = box(3, 3, corner / divisor);
    steps.weights[1] = steps.weights[3] = steps.weights[5] = steps.weights[7] = beside / divisor;
    steps.weights[4] = middle / divisor;
    return steps;
  }

  static FilterSteps gray(const dvec3& weights) {
    FilterSteps steps;
    steps.colors = glm::dmat3(dvec3(weights.x), dvec3(weights.y), dvec3(weights.z));
    return steps;
  }

  void add_filters() {
    const Filter right = view_.panel.filter;
    for (std::size_t i = 0; i < filter_words.size(); ++i) {
      const auto filter = static_cast<Filter>(i);
      if (filter == right) {
        continue;
      }
      add_filter(
          filter == Filter::none ? fmt::format("the filter {} is not applied", word_of(right))
          : right == Filter::none
              ? fmt::format("the filter {} is applied, but the reference has none", word_of(filter))
              : fmt::format("the filter {} is applied instead of {}", word_of(filter),
                            word_of(right)),
          steps_of(filter));
    }
    switch (right) {
      case Filter::none:
        break;
      case Filter::invert:
        add_inverted();
        break;
      case Filter::grayscale:
        add_gray();
        break;
      case Filter::blur:
        add_blurs();
        break;
      case Filter::sharpen:
        add_sharpenings();
        break;
    }
    if (right == Filter::blur || right == Filter::sharpen) {
      add_sampling(steps_of(right));
    }
  }

  void add_inverted() {
    FilterSteps steps = steps_of(Filter::invert);
    steps.background_left = true;
    add_filter("the filter inverts objects only: the background stays as it is", steps);
    steps = FilterSteps();
    steps.colors = glm::dmat3(-1);
    add_filter("the filter negates colors without adding 1: the picture is black", steps);
  }

  void add_gray() {
    add_filter("gray is the mean of the channels, not 0.299 r + 0.587 g + 0.114 b",
               gray(dvec3(1 / 3.0)));
    add_filter("gray is 0.2126 r + 0.7152 g + 0.0722 b, not 0.299 r + 0.587 g + 0.114 b",
               gray({0.2126, 0.7152, 0.0722}));
    add_filter("gray is the sum of the channels", gray(dvec3(1)));
    add_filter("gray is the red channel", gray({1, 0, 0}));
    add_filter("gray is the green channel", gray({0, 1, 0}));
    add_filter("gray is the blue channel", gray({0, 0, 1}));
    add_filter("the weights of gray are in the wrong order (red and blue exchanged)",
               gray({0.114, 0.587, 0.299}));
    FilterSteps steps;
    steps.colors = glm::dmat3(dvec3(0.299, 0, 0), dvec3(0, 0.587, 0), dvec3(0, 0, 0.114));
    add_filter("each channel is multiplied by its weight, but the products are not added", steps);
  }

  void add_blurs() {
    add_filter("the kernel of blur is not normalized: its weights are 1, not 1/25", box(5, 5, 1));
    for (const int size : {3, 7, 9, 11, 13, 15, 21}) {
      add_filter(fmt::format("the kernel of blur has {0} x {0} samples, not 5 x 5", size),
                 box(size, size, 1.0 / (size * size)));
    }
    for (const int divisor : {9, 5, 10, 16, 20, 24, 26, 50}) {
      add_filter(fmt::format("the kernel of blur is divided by {}, not by 25", divisor),
                 box(5, 5, 1.0 / divisor));
    }
    add_filter("blur only runs along rows: the pass along columns is missing", box(5, 1, 0.2));
    add_filter("blur only runs along columns: the pass along rows is missing", box(1, 5, 0.2));
    add_filter("the kernel of blur has 4 x 4 samples: its last row and column are missing",
               box(4, 4, 1 / 16.0));
    FilterSteps missing = box(5, 5, 1 / 25.0);
    for (std::size_t i = 0; i < 5; ++i) {
      missing.weights[4 + 5 * i] = missing.weights[20 + i] = 0;
    }
    add_filter("the last row and column of blur's kernel are missing, and it is divided by 25",
               missing);
    add_filter("blur is applied twice", product({1, 2, 3, 4, 5, 4, 3, 2, 1}));
    add_filter("the kernel of blur is a triangle (1 2 3 2 1), not a box", product({1, 2, 3, 2, 1}));
    add_filter("the kernel of blur is binomial (1 4 6 4 1), not a box", product({1, 4, 6, 4, 1}));
    add_filter("the kernel of blur is binomial of 3 x 3 samples (1 2 1), not a box of 5 x 5",
               product({1, 2, 1}));
    for (const double sigma : {0.8, 1.0, 1.4, 1.5, 2.0, 5 / 6.0}) {
      add_filter(fmt::format("the kernel of blur is a Gaussian with a standard deviation of "
                             "{:.2g}, not a box",
                             sigma),
                 gaussian(5, sigma));
    }
  }

  void add_sharpenings() {
    add_filter("the kernel of sharpen is not divided by 9", sharpening(17, -1, -1, 1));
    add_filter(
        "the kernel of sharpen is 5 in the center and -1 at its four neighbors, without the "
        "corners",
        sharpening(5, -1, 0, 1));
    add_filter("the kernel of sharpen is 9 in the center and -1 around it",
               sharpening(9, -1, -1, 1));
    add_filter("the kernel of sharpen finds edges: 8 in the center and -1 around it",
               sharpening(8, -1, -1, 1));
    add_filter("the kernel of sharpen finds edges: 4 in the center and -1 at its four neighbors",
               sharpening(4, -1, 0, 1));
    add_filter("the kernel of sharpen is divided by 17", sharpening(17, -1, -1, 17));
    add_filter("the kernel of sharpen is divided by 8", sharpening(17, -1, -1, 8));
    add_filter("the kernel of sharpen has 9 in its center, not 17", sharpening(9, -1, -1, 9));
    add_filter("the kernel of sharpen has the wrong signs around its center",
               sharpening(17, 1, 1, 9));
  }

  // Where the samples of a kernel are taken, and what they read beyond the frame.
  void add_sampling(const FilterSteps& right) {
    using B = FilterBorder;
    for (const auto& [border, what] :
         {std::pair(B::clamp,
                    "samples beyond the border repeat its pixels (clamp), and those of "
                    "the reference wrap around"),
          std::pair(B::black,
                    "samples beyond the border are black, but those of the reference "
                    "wrap around"),
          std::pair(B::mirror,
                    "samples beyond the border are mirrored, but those of the reference "
                    "wrap around")}) {
      FilterSteps steps = right;
      steps.border = border;
      add_filter(what, steps);
    }
    const RealtimeWindow framed = realtime_frame(view_.panel.milestone, width_, height_);
    const dvec2 frame(framed.width, framed.height);
    for (const auto& [step, what] :
         {std::pair(frame / picture_,
                    "samples are a pixel of the picture apart, not one of the "
                    "frame"),
          std::pair(dvec2(2), "samples are two pixels apart, not one"),
          std::pair(dvec2(0.5), "samples are half a pixel apart, not one"),
          std::pair(frame / frame.x,
                    "the height of the frame is used as its width in the distance of samples"),
          std::pair(frame / frame.y,
                    "the height is used as the width in the distance of samples")}) {
      if (step != dvec2(1)) {
        FilterSteps steps = right;
        steps.step = step;
        add_filter(what, steps);
      }
    }
    for (const dvec2 offset : {dvec2(0.5), dvec2(-0.5), dvec2(1, 0), dvec2(-1, 0), dvec2(0, 1),
                               dvec2(0, -1), dvec2(2), dvec2(-2), dvec2(1), dvec2(-1)}) {
      FilterSteps steps = right;
      steps.offset = offset;
      add_filter(fmt::format("the kernel is not centered: its samples are off by {}, {} pixels",
                             offset.x, offset.y),
                 steps);
    }
  }

  // ---- frames --------------------------------------------------------------------------------

  void add_frame(std::string what, const FrameMistakes& frame) {
    add(Cause::viewport, std::move(what), RealtimeStage::raster,
        [frame](RealtimeTrial& t) { t.frame = frame; });
  }

  void add_viewports() {
    const dvec2 window(window_.width, window_.height);
    const double of_picture = picture_.x / picture_.y;
    if (view_.panel.milestone == Milestone::action) {
      add_frame(
          "the scene fills the picture; in the reference the viewport is smaller than the "
          "frame",
          {window, window, {}});
      is_allowed();
      add_frame(
          "the scene fills the picture, with its aspect ratio; in the reference the viewport "
          "is smaller than the frame",
          {picture_, picture_, of_picture});
      is_allowed();
      add_frame(
          "the scene fills the picture; the frame is as large as the picture, not as the "
          "window",
          {picture_, picture_, {}});
      is_allowed();
      add_frame("the camera has the aspect ratio of the picture, not that of the window",
                {{}, {}, of_picture});
    } else {
      add_frame(fmt::format("the camera has the aspect ratio of the picture, {}:{}, and that of "
                            "the reference has that of its window",
                            width_, height_),
                {{}, {}, of_picture});
      is_allowed();
      add_frame("the viewport is smaller than the frame: the scene is at the lower left",
                {picture_, window, {}});
    }
    add_frame(
        "the viewport covers the lower left quarter: its size is in points, and the frame "
        "has twice as many pixels",
        {picture_, 2.0 * picture_, {}});
    add_frame(
        "the viewport is twice as large as the frame: the lower left quarter fills the "
        "picture",
        {picture_, picture_ / 2.0, {}});
    add_frame("width and height of the viewport are swapped",
              {dvec2(picture_.y, picture_.x), picture_, {}});
    add_frame("the viewport is a square: as wide as high", {dvec2(picture_.y), picture_, {}});
    add_frame("the viewport is always 800 x 600", {dvec2(800, 600), picture_, {}});
    add_frame("the viewport is always 640 x 480", {dvec2(640, 480), picture_, {}});
  }

  // ---- tessellation --------------------------------------------------------------------------

  void add_mesh(Cause cause, std::string what, bool MeshMistakes::*member) {
    add(cause, std::move(what), RealtimeStage::raster,
        [member](RealtimeTrial& t) { t.mesh.*member = true; });
  }

  void add_parameters(const std::string& whose, const TessellationParameters& p,
                      std::string_view why, std::optional<Shape> shape) {
    const TessellationParameters& right = view_.panel.tessellation;
    if (p == right || p.parameter1 < 1 || p.parameter2 < 1) {
      return;
    }
    add(Cause::tessellation,
        fmt::format("{} drawn with the parameters {}, but the reference has {}{}{}", whose,
                    parameters_text(p), parameters_text(right), why.empty() ? "" : ": ", why),
        RealtimeStage::raster, [p, shape](RealtimeTrial& t) {
          if (shape) {
            t.tessellation[static_cast<std::size_t>(*shape)] = p;
          } else {
            t.panel.tessellation = p;
          }
        });
  }

  void add_tessellations() {
    if (curved_count() == shapes_.count(Shape::mesh)) {
      return;
    }
    const TessellationParameters right = view_.panel.tessellation;
    const int a = right.parameter1;
    const int b = right.parameter2;
    add_parameters("shapes are", {b, a}, "the two are swapped", {});
    add_parameters("shapes are", {a, a}, "the first one is used for both", {});
    add_parameters("shapes are", {b, b}, "the second one is used for both", {});
    add_parameters("shapes are", {1, 1}, "the sliders are not used", {});
    add_parameters("shapes are", {5, 5}, "the sliders are not used", {});
    for (const auto& [p1, p2] :
         {std::pair(a + 1, b), std::pair(a - 1, b), std::pair(a, b + 1), std::pair(a, b - 1),
          std::pair(a + 1, b + 1), std::pair(a - 1, b - 1)}) {
      add_parameters("shapes are", {p1, p2}, "off by one", {});
    }
    for (const int n : {2, 3, 4, 8, 10, 15, 20, 25, 30, 40, 50}) {
      add_parameters("shapes are", {n, n}, "", {});
    }
    for (const Shape shape : round_shapes) {
      if (!shapes_.contains(shape)) {
        continue;
      }
      const std::string whose = plural(shape) + " are";
      if (curved_count() > 1) {
        add_parameters(whose, {b, a}, "the two are swapped", shape);
        add_parameters(whose, {5, 5}, "the sliders are not used", shape);
        add_parameters(whose, {a + 1, b}, "off by one", shape);
        add_parameters(whose, {a - 1, b}, "off by one", shape);
        add_parameters(whose, {a, b + 1}, "off by one", shape);
        add_parameters(whose, {a, b - 1}, "off by one", shape);
      }
    }
    const auto turned = [&](std::string what, int quarters, bool half, bool clockwise) {
      add(Cause::tessellation, std::move(what), RealtimeStage::raster, [=](RealtimeTrial& t) {
        t.mesh.quarter_turns = quarters;
        t.mesh.half_wedge = half;
        t.mesh.clockwise = clockwise;
      });
    };
    turned("wedges follow each other from the x axis toward +z, not toward -z", 0, false, true);
    turned("the first wedge begins half a wedge off the x axis", 0, true, false);
    turned("the first wedge begins at the -z axis, not at the x axis", 1, false, false);
    turned("the first wedge begins at the z axis, not at the x axis", 3, false, false);
    turned("the first wedge begins at the -x axis, not at the x axis", 2, false, false);
    turned("wedges follow each other from the z axis toward x", 3, false, true);
    turned("wedges follow each other from the -z axis toward -x, clockwise", 1, false, true);
    turned("wedges follow each other from the -x axis toward -z, clockwise", 2, false, true);
    add_mesh(Cause::tessellation, "quads are split along their other diagonal",
             &MeshMistakes::other_diagonal);
    is_allowed();
    add_mesh(Cause::tessellation, "the last wedge is missing", &MeshMistakes::seam_missing);
    add_mesh(Cause::tessellation, "the lowest row of quads is missing",
             &MeshMistakes::last_row_missing);
    add_mesh(Cause::tessellation, "shapes have a radius of 1, not of 0.5",
             &MeshMistakes::radius_one);
    if (shapes_.contains(Shape::cone)) {
      add_mesh(Cause::normals, "the normal at the tip of cones points up", &MeshMistakes::tip_up);
      add_mesh(Cause::normals,
               "the normal at the tip of cones is that of the wedge's edge, not of its center line",
               &MeshMistakes::tip_of_first);
    }
  }

  // ---- shading -------------------------------------------------------------------------------

  void add_interpolation(Cause cause, std::string what, Interpolation value,
                         std::optional<Shape> shape = {}) {
    add(cause, std::move(what), RealtimeStage::shading, [value, shape](RealtimeTrial& t) {
      t.interpolation = value;
      if (shape) {
        t.interpolated_shapes.fill(false);
        t.interpolated_shapes[static_cast<std::size_t>(*shape)] = true;
      }
    });
  }

  void add_interpolations() {
    using I = Interpolation;
    add_interpolation(
        Cause::facets,
        "shapes have flat facets: each triangle has one normal, instead of interpolated normals",
        I::flat);
    if (curved_count() > 1) {
      for (const Shape shape : round_shapes) {
        if (shapes_.contains(shape)) {
          add_interpolation(
              Cause::facets,
              fmt::format("{} have flat facets: each triangle has one normal", plural(shape)),
              I::flat, shape);
        }
      }
    }
    add_interpolation(Cause::facets,
                      "normals are not interpolated: each triangle has that of its last corner "
                      "(flat in the shader)",
                      I::last_corner);
    add_interpolation(Cause::facets,
                      "normals are not interpolated: each triangle has that of its first corner",
                      I::first_corner);
    add_interpolation(Cause::facets,
                      "lighting is computed for each vertex, and colors are interpolated",
                      I::colors);
    add_interpolation(Cause::normals,
                      "normals are not normalized after their interpolation (in the fragment "
                      "shader)",
                      I::not_normalized);
  }

  // ---- rasterization -------------------------------------------------------------------------

  void add_inside_out(std::string what, const InsideOut& inside_out) {
    add(Cause::culling, std::move(what), RealtimeStage::raster,
        [inside_out](RealtimeTrial& t) { t.inside_out = inside_out; });
  }

  void add_culling() {
    add(Cause::culling, "back faces are not culled: the inside of shapes is visible",
        RealtimeStage::raster, [](RealtimeTrial& t) { t.culling = Culling::none; });
    add(Cause::culling, "front faces are culled: the inside of shapes is visible, not the outside",
        RealtimeStage::raster, [](RealtimeTrial& t) { t.culling = Culling::front; });
    for (const Shape shape : shapes_) {
      if (shape == Shape::mesh) {
        continue;
      }
      InsideOut sides;
      sides.sides[static_cast<std::size_t>(shape)] = true;
      const bool capped = shape == Shape::cylinder || shape == Shape::cone;
      if (capped) {
        add_inside_out(fmt::format("the sides of {} have the wrong winding order, and are culled",
                                   plural(shape)),
                       sides);
        InsideOut caps;
        caps.caps[static_cast<std::size_t>(shape)] = true;
        add_inside_out(fmt::format("the caps of {} have the wrong winding order, and are culled",
                                   plural(shape)),
                       caps);
      }
      sides.caps[static_cast<std::size_t>(shape)] = true;
      if (shapes_.size() > 1) {
        add_inside_out(fmt::format("triangles of {} have the wrong winding order, and are culled",
                                   plural(shape)),
                       sides);
      }
    }
    add(Cause::nearest_hit, "there is no depth test: later triangles cover earlier ones",
        RealtimeStage::raster, [](RealtimeTrial& t) { t.depth = DepthTest::none; });
    add(Cause::nearest_hit, "there is no depth test, and back faces are not culled",
        RealtimeStage::raster, [](RealtimeTrial& t) {
          t.depth = DepthTest::none;
          t.culling = Culling::none;
        });
    add(Cause::nearest_hit, "the depth test is reversed: the farthest triangle is visible",
        RealtimeStage::raster, [](RealtimeTrial& t) { t.depth = DepthTest::reversed; });
  }

  void add_planes(std::string what, double near, double far) {
    if (near < far && (near != view_.panel.near || far != view_.panel.far)) {
      add(Cause::clipping, std::move(what), RealtimeStage::raster, [near, far](RealtimeTrial& t) {
        t.panel.near = near;
        t.panel.far = far;
      });
    }
  }

  void add_clipping() {
    const RealtimeOptions defaults;
    const double n = view_.panel.near;
    const double f = view_.panel.far;
    add_planes("near and far are ignored", defaults.near, defaults.far);
    if (n != defaults.near) {
      add_planes("near is ignored", defaults.near, f);
    }
    if (f != defaults.far) {
      add_planes("far is ignored", n, defaults.far);
    }
    if (n != defaults.near || f != defaults.far) {
      add_planes("far is measured from the near plane", n, n + f);
      add_planes("near is twice as far as it should be", 2 * n, f);
      add_planes("near is half as far as it should be", n / 2, f);
    }
    for (const double near : {0.5, 1.0, 2.0, 5.0}) {
      add_planes(fmt::format("near is {}, not {}", near, n), near, f);
    }
    for (const double far : {5.0, 10.0, 20.0, 50.0}) {
      add_planes(fmt::format("far is {}, not {}", far, f), n, far);
    }
  }

  // ---- lights and the rest -------------------------------------------------------------------

  void add_light_types() {
    for (std::size_t i = 0; i < light_type_count; ++i) {
      const auto type = static_cast<LightType>(i);
      const bool any = std::any_of(view_.scene->lights.begin(), view_.scene->lights.end(),
                                   [&](const RenderLight& l) { return l.type == type; });
      if (any && !has_light(view_.panel.milestone, type)) {
        add_lights(fmt::format("{} lights are drawn, but the milestone {} has none", word_of(type),
                               word_of(view_.panel.milestone)),
                   [type](LightType t) { return t == type; });
      }
    }
    if (view_.panel.milestone == Milestone::lights_camera) {
      add_lights("point lights and spotlights are drawn, but the milestone lights-camera has none",
                 [](LightType t) { return has_light(Milestone::action, t); });
    } else {
      add(Cause::lights, "only directional lights are drawn, as in the milestone lights-camera",
          RealtimeStage::shading, [](RealtimeTrial& t) {
            std::erase_if(t.scene.scene.lights, [](const RenderLight& l) {
              return !has_light(Milestone::lights_camera, l.type);
            });
          });
    }
  }

  // Lights other than those of the milestone.
  template <typename Drawn>
  void add_lights(const std::string& what, const Drawn& drawn) {
    std::vector<RenderLight> more;
    for (const RenderLight& light : view_.scene->lights) {
      if (drawn(light.type) && !has_light(view_.panel.milestone, light.type)) {
        more.push_back(light);
      }
    }
    if (!more.empty()) {
      add(Cause::lights, what, RealtimeStage::shading, [more](RealtimeTrial& t) {
        t.scene.scene.lights.insert(t.scene.scene.lights.end(), more.begin(), more.end());
      });
    }
  }

  static bool is_for_realtime(const Hypothesis& h) {
    switch (h.cause) {
      case Cause::ambient:
      case Cause::diffuse:
      case Cause::specular:
      case Cause::blinn:
      case Cause::attenuation:
      case Cause::normals:
      case Cause::spot_falloff:
      case Cause::camera:
      case Cause::transforms:
      case Cause::shapes:
        return true;
      case Cause::lights:
        return h.what.find("shadow") == std::string::npos;
      case Cause::features:
        return h.what.find("without lighting") != std::string::npos;
      case Cause::vertical_flip:
      case Cause::horizontal_flip:
      case Cause::gamma:
      case Cause::rounding:
      case Cause::swapped_channels:
      case Cause::half_pixel_shift:
      case Cause::shadows:
      case Cause::acne:
      case Cause::texture:
      case Cause::recursion_depth:
      case Cause::nearest_hit:
      case Cause::reflection:
      case Cause::refraction:
      case Cause::overflow:
      case Cause::background:
      case Cause::brightness:
      case Cause::black:
      case Cause::samples:
      case Cause::scene_edited:
      case Cause::tessellation:
      case Cause::facets:
      case Cause::culling:
      case Cause::clipping:
      case Cause::viewport:
      case Cause::light_samples:
      case Cause::scattering:
      case Cause::path_length:
      case Cause::specular_paths:
      case Cause::filter:
        return false;
    }
    return false;
  }

  // Whether the mistake is one in the equations of shapes, which meshes do not have.
  static bool is_of_equations(const Hypothesis& h) {
    if (h.cause != Cause::shapes || h.stage == Stage::shapes) {
      return false;
    }
    Trial trial;
    h.draw(trial);
    return !occurs_in_meshes(trial.mistakes.shape);
  }

  // Makes the axes act as the rows of a view matrix: those that rays are made of are the columns of
  // its inverse.
  static void make_rows(RenderCamera& camera) {
    const glm::dmat3 axes = glm::inverse(glm::transpose(glm::dmat3(camera.u, camera.v, camera.w)));
    camera.u = axes[0];
    camera.v = axes[1];
    camera.w = axes[2];
  }

  // Mistakes of ray tracers that also occur in OpenGL programs.
  void add_common() {
    RenderOptions options;
    options.features = {false, false, false, false, false, false, false};
    const SceneView view{&lit_, view_.assets, options, view_.written, {}, {}, {}, 1, view_.sources};
    for (Hypothesis& h : drawing_hypotheses(view, window_.width, window_.height)) {
      if (!is_for_realtime(h) || is_of_equations(h)) {
        continue;
      }
      RealtimeStage stage = RealtimeStage::shading;
      switch (h.stage) {
        case Stage::picture:
        case Stage::shading:
          break;
        case Stage::hits:
        case Stage::camera:
          stage = RealtimeStage::raster;
          break;
        case Stage::shapes:
          stage = RealtimeStage::shapes;
          break;
      }
      // Normals of shapes are mistakes of the mesh.
      if (h.cause == Cause::shapes && stage == RealtimeStage::shading) {
        stage = RealtimeStage::raster;
      }
      if (h.what.starts_with("rays are transformed by")) {
        h.what = "shapes are placed by the inverse of their matrix";
      }
      add(h.cause, h.what, stage, [draw = h.draw, axes = h.axes](RealtimeTrial& t) {
        draw(t.scene);
        if (axes) {
          make_rows(t.scene.scene.camera);
        }
      });
      list_.back().mistake = h.mistake;
    }
  }

  const RealtimeView& view_;
  const RenderScene& lit_;
  dvec2 picture_;
  RealtimeWindow window_;
  int width_;
  int height_;
  std::set<Shape> shapes_;
  std::vector<RealtimeHypothesis> list_;
};

}  // namespace

std::string parameters_text(const TessellationParameters& parameters) {
  return fmt::format("{},{}", parameters.parameter1, parameters.parameter2);
}

std::vector<RealtimeHypothesis> realtime_hypotheses(const RealtimeView& view,
                                                    const RenderScene& lit, int width, int height) {
  return Maker(view, lit, width, height).all();
}

}  // namespace scenefile
