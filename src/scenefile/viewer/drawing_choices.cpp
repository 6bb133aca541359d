#include "scenefile/viewer/drawing_choices.h"

#include "scenefile/trace/features.h"

namespace scenefile::viewer {

namespace {

// The features with the two that keys switch.
Features effective(const Session& session) {
  Features features = session.setup.trace.features;
  features.shadows = features.shadows && session.settings.shadows;
  features.texture = features.texture && session.settings.textures;
  return features;
}

void set_features(Session& session, const Features& features) {
  session.setup.trace.features = features;
  session.settings.shadows = session.settings.shadows || features.shadows;
  session.settings.textures = session.settings.textures || features.texture;
}

void drawing_changed(Session& session) {
  forget_cause(session);
  picture_changed(session);
}

RenderOptions with_feature_set(RenderOptions options, std::string_view word) {
  options.mode = Mode::ray;
  parse_features(word, options);
  return options;
}

}  // namespace

DrawnAs drawn_as(const Session& session) {
  if (session.realtime) {
    return DrawnAs::realtime;
  }
  if (traces_paths(session)) {
    return DrawnAs::paths;
  }
  return session.setup.trace.profile == Profile::course ? DrawnAs::course : DrawnAs::fine;
}

void draw_as(Session& session, DrawnAs drawn) {
  session.realtime = drawn == DrawnAs::realtime;
  if (!session.realtime) {
    const int threads = session.setup.trace.threads;
    session.setup.trace =
        default_options(drawn == DrawnAs::course ? Profile::course : Profile::fine);
    session.setup.trace.threads = threads;
    session.setup.trace_paths = drawn == DrawnAs::paths;
    ++session.version;  // uploading depends on the profile
  }
  drawing_changed(session);
  const bool lights = session.shown != nullptr && !session.shown->opened.ready.scene.lights.empty();
  if (drawn == DrawnAs::paths && lights && session.path != "-") {
    open_scene(session, session.path);  // reads the materials of its mesh faces
  }
}

void draw_like(Session& session, const PictureFit& fit) {
  session.realtime = fit.realtime.has_value();
  if (fit.realtime) {
    session.realtime_panel = *fit.realtime;
  } else {
    const int threads = session.setup.trace.threads;
    session.setup.trace = fit.options;
    session.setup.trace.threads = threads;
    set_features(session, fit.options.features);
    ++session.version;  // uploading depends on the profile
  }
  drawing_changed(session);
}

bool has_feature(const Session& session, std::string_view word) {
  Features features = effective(session);
  const bool* const feature = find_feature(features, word);
  return feature != nullptr && *feature;
}

void toggle_feature(Session& session, std::string_view word) {
  Features features = effective(session);
  if (bool* const feature = find_feature(features, word)) {
    *feature = !*feature;
    set_features(session, features);
    drawing_changed(session);
  }
}

void use_feature_set(Session& session, std::string_view word) {
  const RenderOptions options = with_feature_set(session.setup.trace, word);
  session.setup.trace.mode = options.mode;
  set_features(session, options.features);
  drawing_changed(session);
}

bool is_feature_set(const Session& session, std::string_view word) {
  const RenderOptions options = with_feature_set(session.setup.trace, word);
  return options.mode == session.setup.trace.mode && options.features == effective(session);
}

}  // namespace scenefile::viewer
