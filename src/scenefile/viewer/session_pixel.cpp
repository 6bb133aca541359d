// The clicked pixel.

#include "scenefile/base/number.h"
#include "scenefile/viewer/hidden.h"
#include "scenefile/viewer/session.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile::viewer {

namespace {

std::shared_ptr<const OpenedScene> opened_of(const Session& session) {
  return {session.shown, &session.shown->opened};
}

void ask_for_terms(Session& session) {
  PixelReadout& readout = session.readout;
  readout.asked = true;
  if (!session.setup.explain_pixel) {
    return;
  }
  PixelQuestion question{
      opened_of(session),
      without_hidden(session.shown->opened.ready.scene, session.hidden, session.only_light),
      trace_options(session),
      {},
      readout.pixel,
      readout.values[static_cast<std::size_t>(Role::mine)],
      session.cause.answer.nothing};
  if (traces_paths(session)) {
    question.options.samples = session.traced->samples;
  }
  question.drawn.camera = render_camera(session.camera);
  if (session.realtime) {
    question.realtime = session.realtime_panel;
  }
  readout.explaining.start([question = std::move(question),
                            explain = session.setup.explain_pixel] { return explain(question); },
                           session.setup.wake);
}

// Whether the window draws what the file says, apart from the camera.
bool draws_whole_scene(const Session& session) {
  return session.hidden.empty() && !session.only_light && session.mode == DrawMode::shaded;
}

bool wants_cause(const Session& session) {
  // For the assignment Realtime, only a picture that the comparison has drawn can be compared.
  const bool drawn =
      !session.realtime ||
      (session.compared != nullptr && draws_whole_scene(session) && session.camera == session.home);
  return session.readout.at && session.mine.exists() && session.setup.find_cause &&
         !session.cause.asked && !session.cause.finding.busy() && drawn;
}

void ask_for_cause(Session& session) {
  CauseSearch& cause = session.cause;
  cause.asked = true;
  cause.stopped = std::make_shared<std::atomic<bool>>(false);
  CauseQuestion question{.scene = opened_of(session),
                         .options = trace_options(session),
                         .reference_path = session.reference.path,
                         .reference = session.reference.decoded,
                         .mine = session.mine.decoded};
  if (session.realtime) {
    question.realtime = session.realtime_panel;
    question.ours = session.compared;
  }
  cause.finding.start(
      [question = std::move(question), find = session.setup.find_cause, stopped = cause.stopped] {
        return find(question, [&] { return !*stopped; });
      },
      session.setup.wake);
}

double aspect_of(const Session& session) {
  const glm::dvec2 size = picture_size(session);
  return size.x / size.y;
}

}  // namespace

// The height angle of the camera is fixed, so in a picture of another aspect ratio, what was
// clicked is at another fraction of the width.
void keep_place(Session& session) {
  PixelReadout& readout = session.readout;
  const double aspect = aspect_of(session);
  if (!readout.at || aspect == readout.aspect) {
    return;
  }
  // In Realtime, the middle of the camera's view is not that of the picture.
  const double middle =
      0.5 * camera_view(session).box.size.x / whole_picture(session, session.picture).size.x;
  readout.at->x = middle + (readout.at->x - middle) * readout.aspect / aspect;
  readout.aspect = aspect;
  if (readout.at->x < 0 || readout.at->x >= 1) {
    read_pixel(session, std::nullopt);
    say(session, "the picture no longer contains the pixel that was clicked; click again");
  }
}

bool tick_pixel(Session& session) {
  PixelReadout& readout = session.readout;
  CauseSearch& cause = session.cause;
  bool news = false;
  if (std::optional<std::string> terms = readout.explaining.take()) {
    if (readout.asked) {
      readout.terms = std::move(*terms);
      news = true;
    }
  }
  if (std::optional<CauseAnswer> answer = cause.finding.take()) {
    if (cause.asked && !*cause.stopped) {
      cause.answer = std::move(*answer);
      readout.asked = readout.asked && !cause.answer.nothing;
      news = true;
    }
  }
  if (session.shown == nullptr || !readout.at) {
    return news;
  }
  // In mode path, the answer is about the samples that the picture has.
  const bool drawn = !traces_paths(session) || (session.traced && session.traced->samples > 0);
  if (!readout.asked && !readout.explaining.busy() && at_rest(session) && drawn) {
    locate_pixel(session);
    ask_for_terms(session);
    news = true;
  }
  if (wants_cause(session) && at_rest(session)) {
    ask_for_cause(session);
    news = true;
  }
  return news;
}

void read_pixel(Session& session, const std::optional<glm::dvec2>& at) {
  session.readout.at = at;
  session.readout.aspect = aspect_of(session);
  session.explaining = session.explaining || at;
  session.readout.asked = false;
  session.readout.terms.clear();
  if (!at) {
    forget_cause(session);
  } else if (session.shown != nullptr) {
    locate_pixel(session);
  }
}

void locate_pixel(Session& session) {
  PixelReadout& readout = session.readout;
  const RenderOptions options = trace_options(session);
  readout.size = {options.width, options.height};
  readout.pixel = glm::clamp(glm::ivec2(glm::floor(*readout.at * glm::dvec2(readout.size))),
                             glm::ivec2(0), readout.size - 1);
  readout.values = {};
  const auto read = [&](Role role, const Texture& picture) {
    if (glm::ivec2(picture.width, picture.height) == readout.size) {
      const std::uint8_t* const v = picture.texel(readout.pixel.x, readout.pixel.y);
      readout.values[static_cast<std::size_t>(role)] = PixelValue{v[0], v[1], v[2]};
    }
  };
  if (shows_traced(session) && session.traced->complete) {
    read(Role::ours, session.traced->picture);
  }
  for (const Role role : {Role::reference, Role::mine}) {
    const OtherPicture* const picture = picture_of(session, role);
    if (picture != nullptr && is_comparable(session)) {
      read(role, picture->decoded->texture);
    }
  }
}

std::optional<std::uint32_t> row_named_in(const Session& session, std::string_view line) {
  constexpr std::string_view mark = " (line ";
  const std::size_t at = line.rfind(mark);
  if (at == std::string_view::npos || session.shown == nullptr) {
    return std::nullopt;
  }
  const std::string_view name = line.substr(0, at);
  const double number =
      parse_number(line.substr(at + mark.size(), line.find(')', at) - at - mark.size())).value;
  const OpenedScene& opened = session.shown->opened;
  const std::vector<OutlineRow>& rows = session.shown->outline.rows;
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    const OutlineRow& row = rows[i];
    if (row.location.line != number || row.source == no_index) {
      continue;
    }
    const Source& source = opened.ready.sources[row.source];
    const std::string own =
        row.kind == RowKind::light
            ? fmt::format("{} light",
                          word_of(opened.written.nodes[source.node].lights[source.index].type))
            : session.shown->names->at(row.source).path;
    if (name.ends_with(own)) {
      return i;
    }
  }
  return std::nullopt;
}

void forget_cause(Session& session) {
  session.cause.stop();
  session.cause.asked = false;
  session.cause.answer = {};
}

std::string cause_text(const Session& session) {
  if (!session.cause.answer.text.empty()) {
    return session.cause.answer.text;
  }
  if (session.realtime && session.camera != session.home) {
    return "the cause is only determined at the scene's own camera: press Home\n";
  }
  if (session.realtime && !draws_whole_scene(session)) {
    return "the cause is only determined while all objects and lights are drawn, shaded\n";
  }
  if (session.realtime && session.compare == CompareView::off) {
    return "the cause is determined while the pictures are compared: press X\n";
  }
  return traces_paths(session) ? "drawing the truth, to judge mine within its noise ...\n"
                               : "looking for the cause ...\n";
}

std::string readout_text(const Session& session) {
  const PixelReadout& readout = session.readout;
  if (!readout.at) {
    return {};
  }
  std::string text = fmt::format("pixel {},{} of {}x{}\n", readout.pixel.x, readout.pixel.y,
                                 readout.size.x, readout.size.y);
  if (!session.selected_path.empty()) {
    text += session.selected_path + '\n';
  }
  for (const Role role : {Role::reference, Role::mine}) {
    if (const auto& value = readout.values[static_cast<std::size_t>(role)]) {
      const auto& [r, g, b] = *value;
      text += fmt::format("{} has {} {} {}\n", role_name(session, role), r, g, b);
    }
  }
  text += readout.terms.empty() ? "" : '\n' + readout.terms;
  text += session.cause.answer.text.empty() ? "" : '\n' + session.cause.answer.text;
  return text;
}

}  // namespace scenefile::viewer
