#include "scenefile/mistakes/hypothesis_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace scenefile {

namespace {

void edit_shapes(HypothesisList& list, std::string_view what,
                 std::function<void(RenderGroup&)> change) {
  list.add(
      Cause::shapes, what,
      [change = std::move(change)](Trial& t) {
        std::for_each(t.scene.groups.begin(), t.scene.groups.end(), change);
      },
      Stage::shapes);
}

std::string plural_stem(Shape shape) {
  return shape == Shape::mesh ? "meshe" : std::string(word_of(shape));
}

}  // namespace

void add_shapes(HypothesisList& list) {
  const bool cylinder = list.shapes.contains(Shape::cylinder);
  const bool cone = list.shapes.contains(Shape::cone);
  if (cylinder) {
    list.set(Cause::shapes, &ModelMistakes::no_cylinder_caps, true, "cylinders have no caps",
             Stage::hits);
  }
  if (cone) {
    list.set(Cause::shapes, &ModelMistakes::no_cone_cap, true, "cones have no cap", Stage::hits);
  }
  if (cone && cylinder) {
    list.add(
        Cause::shapes, "cylinders and cones have no caps",
        [](Trial& t) { t.mistakes.no_cylinder_caps = t.mistakes.no_cone_cap = true; }, Stage::hits);
  }
  using S = ShapeMistake;
  const auto put_shape = [&](std::initializer_list<Row<S>> rows, Stage stage) {
    list.set_each(Cause::shapes, &ModelMistakes::shape, rows, stage);
  };
  static constexpr double max_unbounded = 1000;  // shapes that are met without bounding boxes
  const bool few = count_virtual_primitives(list.scene) <= max_unbounded;
  if (cylinder) {
    put_shape({{S::no_top_cap, "cylinders have no top cap"},
               {S::no_cylinder_bottom, "cylinders have no bottom cap"}},
              Stage::hits);
    put_shape(
        {{S::cylinder_normal_like_sphere, "normals of cylinders are those of spheres: y is not 0"}},
        Stage::shading);
  }
  if (cylinder && cone) {
    put_shape({{S::no_bottom_cap, "cylinders and cones have no bottom cap"}}, Stage::hits);
  }
  const auto put_caps = [&](S value, const char* what) {
    list.set(Cause::shapes, &ModelMistakes::shape, value, fmt::format("caps {}", what),
             Stage::hits);
    for (const Shape shape : {Shape::cylinder, Shape::cone}) {
      if (cone && cylinder) {
        list.add(
            Cause::shapes, fmt::format("caps of {}s {}", word_of(shape), what),
            [=](Trial& t) {
              t.mistakes.shape = value;
              t.mistakes.caps_of = shape;
            },
            Stage::hits);
      }
    }
  };
  if (cone || cylinder) {
    put_caps(S::square_caps, "are squares: they are not cut to a disk");
    list.set(Cause::shapes, &ModelMistakes::cap_normals_down, true, "normals of caps are inverted");
    put_shape({{S::cap_normals_up, "normals of all caps point up"},
               {S::cap_normals_like_side, "normals of caps are those of the side"}},
              Stage::shading);
  }
  if ((cone || cylinder) && few) {
    put_caps(S::wide_caps, "are twice as wide as they should be: their radius is 1");
    put_caps(S::caps_square_half, "are too wide: the square of their radius is 0.5");
  }
  if (cone && few) {
    put_shape({{S::wide_cone, "cones are twice as wide as they should be: their radius is 1"}},
              Stage::hits);
  }
  if (cylinder && few) {
    put_shape(
        {{S::endless_cylinder, "cylinders have no ends: y is not limited"},
         {S::cylinder_square_half,
          "the sides of cylinders are too wide: the square of their radius is 0.5"},
         {S::cylinder_sides_wide,
          "the sides of cylinders are too wide: their radius is 1, that of the caps is right"}},
        Stage::hits);
  }
  if (cone && few) {
    put_shape({{S::double_cone, "cones continue above their apex: y is not limited there"},
               {S::deep_cone, "cones continue below their base: y is not limited there"},
               {S::endless_cone, "cones have no ends: y is not limited"}},
              Stage::hits);
  }
  if (cylinder && cone && few) {
    put_shape({{S::endless, "cylinders and cones have no ends: y is not limited"}}, Stage::hits);
  }
  if (list.shapes.contains(Shape::cube)) {
    put_shape({{S::cube_normals_positive,
                "normals of cubes point along the positive axes on opposite faces, too"},
               {S::cube_normals_like_sphere, "normals of cubes are those of spheres"},
               {S::cube_normals_inward, "normals of cubes point inward"}},
              Stage::shading);
  }
  if (list.shapes.contains(Shape::cube)) {
    static constexpr std::array<const char*, 6> faces{"x = 0.5",  "x = -0.5", "y = 0.5",
                                                      "y = -0.5", "z = 0.5",  "z = -0.5"};
    for (int face = 1; face <= 6; ++face) {
      list.set(Cause::shapes, &ModelMistakes::missing_face, face,
               fmt::format("cubes have no face at {}", faces[std::size_t(face) - 1]), Stage::hits);
    }
  }
  if ((cone || cylinder || list.shapes.contains(Shape::sphere)) && few) {
    put_shape({{S::precedence,
                "roots of quadratic equations are divided by 2, but multiplied by a: / 2 * a"},
               {S::roots_doubled, "roots of quadratic equations are divided by a, not by 2 a"}},
              Stage::hits);
  }
  if (list.shapes.size() > 1) {
    put_shape({{S::like_sphere, "normals of all shapes are those of spheres"}}, Stage::shading);
  }
  if (list.shapes.contains(Shape::sphere)) {
    edit_shapes(list, "spheres are too large: the square of their radius is 0.5",
                [](RenderGroup& g) {
                  for (RenderPrimitive& p : g.primitives) {
                    p.group_from_object.linear *=
                        p.shape == Shape::sphere ? std::numbers::sqrt2_v<float> : 1.0f;
                  }
                });
    put_shape({{S::sphere_normals_inward, "normals of spheres point inward"},
               {S::sphere_normals_by_matrix,
                "normals of spheres are vectors from their center in world space"}},
              Stage::shading);
  }
  if (cylinder) {
    put_shape({{S::cylinder_normals_inward, "normals of the sides of cylinders point inward"}},
              Stage::shading);
  }
  if (cone) {
    put_shape({{S::cone_normals_inward, "normals of the sides of cones point inward"}},
              Stage::shading);
  }
  if (cylinder && cone) {
    put_shape(
        {{S::side_normals_inward, "normals of the sides of cylinders and cones point inward"}},
        Stage::shading);
  }
  if (cone) {
    using C = ConeNormalMistake;
    const auto put = [&](std::initializer_list<Row<C>> rows) {
      list.set_each(Cause::shapes, &ModelMistakes::cone_normal, rows);
    };
    put({{C::level, "normals of cones are horizontal, like those of cylinders"},
         {C::like_sphere, "normals of cones are those of spheres"},
         {C::half_slope, "normals of cones rise too little"},
         {C::double_slope, "normals of cones rise too much"},
         {C::four_slopes, "normals of cones rise far too much"},
         {C::slope_down, "normals of cones point down"},
         {C::constant_y,
          "normals of cones have the same y everywhere: they are not scaled with "
          "the distance from the axis"},
         {C::half_constant_y, "normals of cones have the same y everywhere, and rise too little"},
         {C::from_apex, "normals of cones are vectors from the apex"}});
  }
  for (const Shape shape : list.shapes) {
    if (list.shapes.size() > 1) {
      edit_shapes(list, fmt::format("{}s are not drawn", plural_stem(shape)),
                  [shape](RenderGroup& g) {
                    std::erase_if(g.primitives,
                                  [shape](const RenderPrimitive& p) { return p.shape == shape; });
                  });
    }
    for (const float factor : {2.0f, 0.5f}) {
      edit_shapes(list,
                  fmt::format("{}s are {} as large as they should be", plural_stem(shape),
                              factor == 2 ? "twice" : "half"),
                  [shape, factor](RenderGroup& g) {
                    for (RenderPrimitive& p : g.primitives) {
                      p.group_from_object.linear *= p.shape == shape ? factor : 1.0f;
                    }
                  });
    }
    const bool round = shape == Shape::cylinder || shape == Shape::cone;
    for (const float factor : {2.0f, 0.5f}) {
      const char* const by = factor == 2 ? "twice" : "half";
      const auto stretched = [&](const char* along, const glm::vec3& scale) {
        edit_shapes(
            list, fmt::format("{}s are {} as {} as they should be", plural_stem(shape), by, along),
            [=](RenderGroup& g) {
              for (RenderPrimitive& p : g.primitives) {
                for (int axis = 0; axis < 3 && p.shape == shape; ++axis) {
                  p.group_from_object.linear[axis] *= scale[axis];
                }
              }
            });
      };
      if (round) {
        stretched("wide", {factor, 1, factor});
        stretched("high", {1, factor, 1});
      }
    }
    if (shape != Shape::mesh && shape != Shape::sphere) {
      const glm::vec3 by = round ? glm::vec3(0, 0.5f, 0) : glm::vec3(0.5f);
      edit_shapes(list,
                  fmt::format("{}s are from {} to 1, not from -0.5 to 0.5", plural_stem(shape),
                              round ? "y = 0" : "0"),
                  [=](RenderGroup& g) {
                    for (RenderPrimitive& p : g.primitives) {
                      if (p.shape == shape) {
                        p.group_from_object.offset += p.group_from_object.linear * by;
                      }
                    }
                  });
    }
    for (const Shape other : {Shape::sphere, Shape::cube}) {
      if (other != shape && shape != Shape::mesh) {
        edit_shapes(list,
                    fmt::format("{}s are drawn as {}s", plural_stem(shape), plural_stem(other)),
                    [shape, other](RenderGroup& g) {
                      for (RenderPrimitive& p : g.primitives) {
                        p.shape = p.shape == shape ? other : p.shape;
                      }
                    });
      }
    }
  }
  if (cone) {
    edit_shapes(list, "cones are upside down", [](RenderGroup& g) {
      for (RenderPrimitive& p : g.primitives) {
        if (p.shape == Shape::cone) {
          p.group_from_object.linear[1] *= -1.0f;
        }
      }
    });
  }
  edit_shapes(list, "all shapes are twice as large as they should be", [](RenderGroup& g) {
    for (RenderPrimitive& p : g.primitives) {
      p.group_from_object.linear *= 2.0f;
    }
  });
  edit_shapes(list, "all shapes are half as large as they should be", [](RenderGroup& g) {
    for (RenderPrimitive& p : g.primitives) {
      p.group_from_object.linear *= 0.5f;
    }
  });
  list.add(
      Cause::shapes, "only the first shape is drawn",
      [](Trial& t) {
        bool found = false;
        for (RenderGroup& g : t.scene.groups) {
          if (&g != &t.scene.groups[t.scene.root] || g.primitives.empty() || found) {
            continue;
          }
          g.primitives.resize(1);
          g.instances.clear();
          found = true;
        }
      },
      Stage::shapes);
  list.add(
      Cause::shapes, "the last shape is missing",
      [](Trial& t) {
        RenderGroup& root = t.scene.groups[t.scene.root];
        if (!root.primitives.empty()) {
          root.primitives.pop_back();
        }
      },
      Stage::shapes);
  list.add(
      Cause::shapes, "the first shape is missing",
      [](Trial& t) {
        RenderGroup& root = t.scene.groups[t.scene.root];
        if (!root.primitives.empty()) {
          root.primitives.erase(root.primitives.begin());
        }
      },
      Stage::shapes);
}

void add_nearest(HypothesisList& list) {
  using N = NearestMistake;
  const auto put = [&](std::initializer_list<Row<N>> rows) {
    list.set_each(Cause::nearest_hit, &ModelMistakes::nearest, rows, Stage::hits);
  };
  put({{N::first_of_ties,
        "where surfaces coincide, the first object of the file is shown, not the last"}});
  list.items.back().mistake = false;
  put({{N::last, "the last object that is hit is shown, not the nearest"},
       {N::first, "the first object that is hit is shown, not the nearest"},
       {N::farthest, "the farthest hit is shown, not the nearest"},
       {N::farthest_object, "the object whose hit is farthest is shown, not the nearest"},
       {N::object_distance, "distances are measured in object space"},
       {N::object_distance_compared, "distances are compared in object space"},
       {N::object_distance_everywhere,
        "distances are measured in object space, also along shadow rays"},
       {N::far_root, "the far side of each object is shown"}});
  const auto put_behind = [&](N value, const char* what) {
    for (const bool in_reflections : {false, true}) {
      if (!in_reflections || list.mirrors() || list.glass()) {
        list.add(
            Cause::nearest_hit,
            fmt::format("{}{}", what,
                        in_reflections ? ", and reflections show what lies behind them" : ""),
            [=](Trial& t) {
              t.mistakes.nearest = value;
              t.mistakes.behind_in_reflections = in_reflections;
            },
            Stage::hits);
      }
    }
  };
  put_behind(N::behind, "objects behind the camera are shown too");
  put_behind(N::behind_first, "objects behind the camera are shown first");
  put({{N::near_root_only, "objects are invisible from inside"}});
}

}  // namespace scenefile
