#include "scenefile/viewer/canvas.h"

#include "scenefile/view/draw_options.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scenefile::viewer {

namespace {

// If pictures take longer (in seconds) while the camera moves, they get coarser.
constexpr double slow_picture = 0.04;
constexpr int max_coarseness = 4;
// At rest, each picture is better than the one before by this many steps.
constexpr int refinement = 2;
// For scenes with more objects, the first picture is coarse, because its time is not known yet.
constexpr double many_objects = 5000;
constexpr int first_hurry = 4;
// How many texels of a large picture are uploaded for a frame.
constexpr std::size_t texels_at_once = std::size_t{1} << 20;
// The camera moves as long as it has moved within so many seconds.
constexpr double still_moving = 0.2;

PaintJob job_of(const Session& session, PaintRecipe recipe, bool refines) {
  return {std::move(recipe),
          {session.shown, &session.shown->opened},
          upload_options(session.setup.trace),
          refines};
}

// Of the picture that is compared with one from a file.
PaintRecipe recipe_to_compare(const Session& session) {
  DrawOptions options = draw_options(session);
  if (!options.course) {
    options.samples = 16;
  }
  const glm::ivec2 size = picture_size(session);
  return {session.version, render_camera(session.camera), std::move(options), size.x, size.y, 0};
}

}  // namespace

void Canvas::warm_up(const Session& session) {
  auto tiny = std::make_shared<OpenedScene>();
  RenderScene& scene = tiny->ready.scene;
  scene.lights.emplace_back().type = LightType::directional;
  scene.materials.emplace_back();
  scene.groups.emplace_back().primitives.emplace_back().shape = Shape::sphere;
  PaintRecipe recipe;
  recipe.options = draw_options(session.setup.trace);
  recipe.options.samples = 1;
  recipe.options.shadows = false;
  if (session.realtime) {
    recipe.options.realtime = session.realtime_panel;
  }
  recipe.camera.position = {0, 0, 2};
  recipe.width = recipe.height = 8;
  painter_->ask({std::move(recipe), std::move(tiny), upload_options(session.setup.trace), false},
                Painting::compared);
}

int Canvas::hurry_for(const Session& session, bool moving) const {
  if (painted_.recipe.version != session.version) {
    const bool many = count_virtual_primitives(session.shown->opened.ready.scene) > many_objects;
    return many ? first_hurry : 0;
  }
  return moving ? moving_coarseness_ : std::max(0, painted_.recipe.coarseness - refinement);
}

PaintRecipe Canvas::recipe_for(const Session& session, int coarseness) const {
  DrawOptions options = draw_options(session);
  if (coarseness > 0) {
    options.samples = 1;
    options.shadows = options.shadows && shadowed_ == session.version;
  } else if (!options.course) {
    options.samples = 4;  // fast enough while the camera moves
  }
  const int halvings = std::max(0, coarseness - 1);
  return {session.version,
          render_camera(session.camera),
          std::move(options),
          std::max(1, session.pixels.x >> halvings),
          std::max(1, session.pixels.y >> halvings),
          coarseness};
}

void Canvas::ask(const Session& session, PaintRecipe recipe, bool refines) {
  if (asked_ != recipe) {
    painter_->ask(job_of(session, recipe, refines));
    asked_ = std::move(recipe);
  }
}

void Canvas::draw(const Session& session) {
  const bool moving = session.now - session.moved_at < still_moving;
  const bool seen = painted_.recipe.version == session.version;
  ask(session, recipe_for(session, hurry_for(session, moving)), seen && !moving);
}

void Canvas::finish(Session& session) {
  if (needs_drawing(session)) {
    ask(session, recipe_for(session, 0), true);
    if (std::optional<Painted> painted = painter_->take(Painting::shown, true)) {
      accept(session, *std::move(painted));
    }
  }
}

bool Canvas::settled(const Session& session) const {
  return !asked_ || shows_traced(session) || (asked_->coarseness == 0 && painted_.recipe == asked_);
}

bool Canvas::take(Session& session) {
  if (std::optional<Painted> painted = painter_->take()) {
    accept(session, *std::move(painted));
    return true;
  }
  return false;
}

void Canvas::accept(Session& session, Painted painted) {
  const PaintRecipe& recipe = painted.recipe;
  if (recipe.coarseness == 0 && recipe.options.shadows) {
    shadowed_ = recipe.version;
  }
  // Better pictures, drawn at rest, say little about the time of coarser ones.
  if (recipe.version != painted_.recipe.version || recipe.coarseness == moving_coarseness_) {
    moving_coarseness_ = painted.seconds > slow_picture
                             ? std::min(recipe.coarseness + 1, max_coarseness)
                         : painted.seconds < slow_picture / 8 ? std::max(recipe.coarseness - 1, 0)
                                                              : recipe.coarseness;
  }
  if (recipe.version == session.version) {
    session.drawing_notes = painted.notes;
    session.drawn = std::exchange(painted.picture, {});
    drawn_.show(session.drawn, ++painted_count_);
  }
  painted.picture = {};
  painted_ = std::move(painted);
}

bool Canvas::update(Session& session, bool whole) {
  const std::size_t texels = whole ? ~std::size_t{0} : texels_at_once;
  // One after another, so that a frame stays short.
  bool done = !session.traced || traced_.show(session.traced->picture, session.traced_version,
                                              whole ? texels : 4 * texels);
  for (const auto& [shown, picture] :
       {std::pair(&reference_, &session.reference), {&mine_, &session.mine}}) {
    done = done &&
           (!picture->exists() || shown->show(picture->decoded->texture, picture->version, texels));
  }
  if (session.comparison) {
    const Comparison& found = *session.comparison;
    done = done && difference_.show(found.difference, session.comparison_version, texels);
    done = done && flip_.show(found.flip, session.comparison_version, texels);
  }
  return done;
}

void Canvas::describe(GuiFrame& frame) const {
  frame.renderer = painter_->renderer();
  frame.drawn = painted_.stats;
  frame.scene_seconds = painted_.seconds;
  frame.scene = drawn_.name();
  frame.traced = traced_.name();
  frame.reference = reference_.name();
  frame.mine = mine_.name();
  frame.difference = difference_.name();
  frame.flip = flip_.name();
}

void Canvas::ask_to_compare(const Session& session) {
  PaintRecipe recipe = recipe_to_compare(session);
  if (compared_asked_ != recipe) {
    painter_->ask(job_of(session, recipe, true), Painting::compared);
    compared_asked_ = std::move(recipe);
  }
}

std::optional<Texture> Canvas::take_to_compare(const Session& session) {
  std::optional<Painted> painted = painter_->take(Painting::compared);
  if (!painted) {
    return std::nullopt;
  }
  compared_asked_.reset();
  const bool wanted = session.shown != nullptr && painted->recipe == recipe_to_compare(session);
  return wanted ? std::optional(std::move(painted->picture)) : std::nullopt;
}

}  // namespace scenefile::viewer
