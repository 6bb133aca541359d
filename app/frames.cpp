// The command frames: numbered pictures of one scene from a moving camera. The acceleration
// structure is built once. Each file of a frame contains what it was drawn from: an existing frame
// is skipped. A frame of another scene, or any other file, is only replaced with --overwrite.

#include "app/command.h"
#include "app/gl_picture.h"
#include "app/item_key.h"
#include "app/load.h"
#include "app/named_files.h"
#include "app/output.h"
#include "app/pictures.h"
#include "app/progress.h"
#include "app/realtime.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/format/read_cameras.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/io/child.h"
#include "scenefile/io/file.h"
#include "scenefile/io/file_writer.h"
#include "scenefile/io/folder.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/io/item.h"
#include "scenefile/placement/bounds.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/trace/layers.h"
#include "scenefile/trace/trace_scene.h"
#include "scenefile/verbs/carry_files.h"
#include "scenefile/verbs/json_writer.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace scenefile::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double usual_fps = 24;
constexpr std::size_t max_frames = 1000000;

// All frames of the motion; frame number 1 has index 0.
struct Motion {
  std::vector<Camera> cameras;
  double fps = usual_fps;
};

// Why the camera cannot be used, if so.
Outcome check_camera(const Camera& camera, const std::string& whose, const Limits& limits) {
  Scene scene;
  scene.camera = camera;
  Diagnostics diagnostics(limits);
  check(scene, limits, diagnostics);
  for (const Diagnostic& finding : diagnostics.list()) {
    if (finding.severity == Severity::error) {
      return {ExitCode::findings, fmt::format("{}: {}", whose, finding.message)};
    }
  }
  return {};
}

Outcome read_path(const Options& options, const Camera& camera, Motion& motion) {
  const Result<std::string> text = read_file(options.path, options.load.limits.file_bytes);
  if (!text) {
    return {exit_code(text.error().kind), text.error().text};
  }
  const Result<CameraPath> path = read_cameras(*text, camera, options.load.limits);
  if (!path) {
    return {exit_code(path.error().kind),
            fmt::format("{}:{}", escaped(options.path, 400), path.error().text)};
  }
  motion.fps = options.fps.value_or(path->fps.value_or(usual_fps));
  const double start = path->views.front().time;
  const double frames = std::floor((path->views.back().time - start) * motion.fps + 1e-9) + 1;
  if (frames > static_cast<double>(max_frames)) {
    return {ExitCode::limit,
            fmt::format("{}: more than {} frames", escaped(options.path, 400), max_frames)};
  }
  for (const CameraView& view : path->views) {
    const auto number = &view - path->views.data() + 1;
    if (Outcome wrong = check_camera(view.camera,
                                     fmt::format("{}: view {}", escaped(options.path, 400), number),
                                     options.load.limits);
        !wrong.error.empty()) {
      return wrong;
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i) {
    motion.cameras.push_back(camera_at(path->views, start + static_cast<double>(i) / motion.fps));
  }
  return {};
}

// The camera circles the point on its line of sight that is closest to the center of the scene.
Motion turntable(const Options& options, const LoadedScene& scene, const Camera& camera) {
  Motion motion;
  motion.fps = options.fps.value_or(usual_fps);
  const glm::dvec3 position(camera.position);
  glm::dvec3 center(0);
  if (const Bounds bounds = scene_bounds(scene.ready.scene, scene.assets); !bounds.empty()) {
    center = 0.5 * (glm::dvec3(bounds.min) + glm::dvec3(bounds.max));
  }
  const glm::dvec3 look = glm::normalize(glm::dvec3(camera.look));
  const double ahead = glm::dot(center - position, look);
  center = ahead > 0 ? position + ahead * look : center;
  for (int i = 0; i < *options.turntable; ++i) {
    motion.cameras.push_back(
        camera_around(camera, center, static_cast<double>(i) / *options.turntable));
  }
  return motion;
}

// Why one of the cameras cannot be used; nullopt if all can.
Outcome check_cameras(const Motion& motion, const Limits& limits) {
  for (std::size_t i = 0; i < motion.cameras.size(); ++i) {
    if (Outcome wrong = check_camera(motion.cameras[i], fmt::format("frame {}", i + 1), limits);
        !wrong.error.empty()) {
      return wrong;
    }
  }
  return {};
}

// "f%04d.png" with %04d replaced by the number.
std::string frame_name(const std::string& pattern, std::size_t number) {
  const std::size_t begin = pattern.find('%');
  const std::size_t end = pattern.find('d', begin);
  const std::string width = pattern.substr(begin + 1, end - begin - 1);
  const int digits = width.empty() ? 0 : std::stoi(width);
  return fmt::format("{}{:0{}}{}", pattern.substr(0, begin), number, digits,
                     pattern.substr(end + 1));
}

// Copies a file to what may be a link, a pipe or a device.
Result<void> copy_file(const std::string& from, const std::string& to) {
  std::ifstream in(from, std::ios::binary);
  Result<FileWriter> out = FileWriter::create(to);
  if (!out) {
    return out.error();
  }
  std::vector<char> piece(std::size_t{1} << 20);
  while (in.read(piece.data(), std::streamsize(piece.size())) || in.gcount() > 0) {
    if (const Result<void> added =
            out->append({piece.data(), static_cast<std::size_t>(in.gcount())});
        !added) {
      return added;
    }
  }
  if (!in.eof()) {
    return Error{fmt::format("{}: cannot read it", escaped(from, 400))};
  }
  return out->commit();
}

// Whether a program wrote the file as it is: it is complete, and PNG's checksums are right.
bool is_intact_picture(const std::string& bytes) {
  if (!decode_picture(bytes)) {
    return false;
  }
  std::string renewed = bytes;
  renew_png_text(renewed);
  return renewed == bytes;
}

class Frames {
 public:
  Frames(const Options& options, LoadedScene& scene, const Motion& motion, Context& context)
      : options_(options),
        scene_(scene),
        motion_(motion),
        context_(context),
        painter_(options, scene),
        there_(motion.cameras.size()) {
    key_ = picture_key_of(options, scene);
    if (options.render.mode == Mode::path) {
      key_ += fmt::format(" tone={} exposure={}", static_cast<int>(options.tone), options.exposure);
    }
    range_ = options.range.value_or(FrameRange{1, static_cast<int>(motion.cameras.size())});
  }

  Outcome run() {
    const DeferredSignals deferred;
    Outcome outcome = claim_files();
    if (outcome.error.empty()) {
      outcome = check_existing();
    }
    for (int number = range_.first; number <= range_.last && outcome.error.empty(); ++number) {
      const auto index = static_cast<std::size_t>(number) - 1;
      if (!options_.write_scenes.empty()) {
        outcome = write_scene_of(index);
      }
      if (outcome.error.empty() && !options_.output.empty()) {
        outcome = there_[index] ? skip() : draw(index);
      }
      if (outcome.error.empty() && DeferredSignals::pending() != 0) {
        outcome = outcome_of(RenderStatus::cancelled, context_);
      }
    }
    if (outcome.error.empty() && !options_.video.empty()) {
      outcome = make_video();
    }
    return outcome;
  }

  int drawn() const { return drawn_; }
  int skipped() const { return skipped_; }

 private:
  std::string name(std::size_t index) const { return frame_name(options_.output, index + 1); }

  // The options that draw only this frame.
  Options options_of(std::size_t index) const {
    Options options = options_;
    options.output = name(index);
    return options;
  }

  std::string key_of(std::size_t index) const {
    return fmt::format("{} camera={}", key_, camera_key(motion_.cameras[index]));
  }

  std::string scene_name(std::size_t index) const {
    return frame_name(options_.write_scenes, index + 1);
  }

  // No file that is written may be an input or another output.
  Outcome claim_files() {
    std::vector<UsedFile> files;
    if (!options_.video.empty()) {
      files = {named_file("video", options_.video)};
    }
    for (int number = range_.first; number <= range_.last; ++number) {
      const auto index = static_cast<std::size_t>(number) - 1;
      if (!options_.output.empty()) {
        for (const std::string& file : picture_files(options_of(index))) {
          files.push_back(named_file("frame", file));
        }
      }
      if (!options_.write_scenes.empty()) {
        files.push_back(named_file("scene of a frame", scene_name(index)));
      }
    }
    for (const UsedFile& file : files) {
      if (const Result<void> added = context_.files.write(file); !added) {
        return outcome_of(added);
      }
    }
    return {};
  }

  // Looks which frames exist. Refuses to replace files that are not of this motion, before anything
  // is drawn, unless --overwrite is given.
  Outcome check_existing() {
    Outcome outcome;
    for (int number = range_.first; number <= range_.last && outcome.error.empty(); ++number) {
      const auto index = static_cast<std::size_t>(number) - 1;
      if (!options_.output.empty()) {
        outcome = check_frame(index);
      }
      if (outcome.error.empty() && !options_.write_scenes.empty() && !options_.overwrite) {
        outcome = check_existing_scene(index);
      }
    }
    return outcome;
  }

  // Sets whether all files of the frame exist. A damaged one is drawn again.
  Outcome check_frame(std::size_t index) {
    there_[index] = true;
    for (const std::string& file : picture_files(options_of(index))) {
      std::error_code ignored;
      if (!std::filesystem::exists(file, ignored)) {
        there_[index] = false;
        continue;
      }
      const Result<std::string> bytes = read_file(file, std::uint64_t{1} << 40);
      const Item item = bytes ? read_item(*bytes) : Item();
      there_[index] = there_[index] && item.key == key_of(index);
      const bool foreign = item.state == ItemState::intact && item.key != key_of(index);
      const bool other = item.state == ItemState::none && !(bytes && bytes->empty());
      const bool edited = item.state == ItemState::damaged && is_intact_picture(*bytes);
      if (!options_.overwrite && (foreign || other || edited)) {
        return refusal(file, "-o",
                       foreign  ? "the frame was drawn " + key_mismatch(item.key, key_of(index))
                       : edited ? "the frame was changed after it was drawn"
                                : "the file exists, and is not a frame");
      }
    }
    return {};
  }

  // A scene that would be written with the same bytes again is one of this motion.
  Outcome check_existing_scene(std::size_t index) const {
    const std::string file = scene_name(index);
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) {
      return {};
    }
    std::string text;
    const Outcome outcome = scene_text(index, text);
    const Result<std::string> kept = read_file(file, text.size());
    return !outcome.error.empty() || (kept && *kept == text)
               ? outcome
               : refusal(file, "--write-scenes",
                         "the file exists, and is not the scene of this frame");
  }

  static Outcome refusal(const std::string& file, std::string_view option, const std::string& why) {
    return {ExitCode::findings,
            fmt::format("{}: {}; --overwrite replaces it, or choose another name after {}",
                        escaped(file, 400), why, option)};
  }

  Outcome skip() {
    ++skipped_;
    return {};
  }

  Outcome trace(std::size_t index) {
    if (!traced_) {
      traced_.emplace(scene_.ready.scene, scene_.assets,
                      TraceSceneOptions{.threads = options_.render.threads});
    }
    ProgressBar bar(!options_.quiet && !options_.json && wants_progress());
    const double frames = range_.last - range_.first + 1;
    const double before = static_cast<double>(index) + 1 - range_.first;
    const Progress progress = [&](double done) {
      bar.update((before + done) / frames);
      return DeferredSignals::pending() == 0;
    };
    const RenderResult result =
        trace_picture(options_, options_.render, scene_, *traced_, progress);
    const Outcome outcome = outcome_of(result.status, context_);
    return outcome.error.empty()
               ? write_pictures(options_of(index), result, context_, key_of(index))
               : outcome;
  }

  Outcome paint(std::size_t index) {
    Image image;
    GlReport report;
    const Outcome outcome = painter_.draw(image, report, context_);
    return outcome.error.empty()
               ? write_8bit_picture(options_of(index), image, context_, key_of(index))
               : outcome;
  }

  Outcome draw(std::size_t index) {
    scene_.ready.scene.camera = ready_camera(motion_.cameras[index]);
    context_.phase = "tracing";
    const Outcome outcome = options_.engine == Engine::gl ? paint(index) : trace(index);
    if (outcome.error.empty()) {
      ++drawn_;
      there_[index] = true;
    }
    return outcome;
  }

  // The scene with the camera of the frame.
  Outcome scene_text(std::size_t index, std::string& text) const {
    context_.phase = "writing a scene";
    const std::string path = scene_name(index);
    Scene scene = scene_.written;
    scene.camera = motion_.cameras[index];
    const bool json = lower_case_extension(path) == ".json";
    Diagnostics diagnostics(options_.load.limits);
    text = write_scene(scene, json ? SceneFormat::json : SceneFormat::xml, options_.load.limits,
                       diagnostics);
    return diagnostics.has_errors()
               ? Outcome{ExitCode::findings,
                         fmt::format("{}: the scene cannot be written in this format",
                                     escaped(path, 400))}
               : Outcome();
  }

  Outcome write_scene_of(std::size_t index) {
    std::string text;
    const Outcome outcome = scene_text(index, text);
    return outcome.error.empty() ? outcome_of(write_file(scene_name(index), text)) : outcome;
  }

  Outcome make_video() {
    context_.phase = "making the video";
    for (std::size_t i = 0; i < motion_.cameras.size(); ++i) {
      if (!there_[i]) {
        check_frame(i);
      }
      if (!there_[i]) {
        return {
            ExitCode::findings,
            fmt::format(
                "--video: frame {} of {} does not exist yet; leave out --range to draw all frames",
                i + 1, motion_.cameras.size())};
      }
    }
    const Result<TemporaryFolder> folder = TemporaryFolder::create();
    if (!folder) {
      return outcome_of(folder.error(), context_);
    }
    const std::string extension = lower_case_extension(options_.video);
    const std::string made = folder->path() + "/video" + extension;
    // ffmpeg would take a part before a colon for a protocol.
    const std::string frames =
        options_.output.starts_with('/') ? options_.output : "./" + options_.output;
    std::vector<std::string> words{
        "ffmpeg",        "-y", "-loglevel", "error",  "-framerate", fmt::format("{}", motion_.fps),
        "-start_number", "1",  "-f",        "image2", "-i",         frames};
    if (extension != ".gif") {
      // Players require even sizes, and 4:2:0 chroma subsampling.
      words.insert(words.end(), {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"});
    }
    // Frames of a longer run may follow.
    words.insert(words.end(), {"-frames:v", fmt::format("{}", motion_.cameras.size()), made});
    const Outcome outcome = outcome_of(run_child(words));
    return outcome.error.empty() ? outcome_of(copy_file(made, options_.video)) : outcome;
  }

  const Options& options_;
  LoadedScene& scene_;
  const Motion& motion_;
  Context& context_;
  std::string key_;  // without the camera
  FrameRange range_;
  std::optional<TraceScene> traced_;
  GlPainter painter_;
  std::vector<bool> there_;  // by index: found or drawn
  int drawn_ = 0;
  int skipped_ = 0;
};

Outcome make_motion(const Options& options, const LoadedScene& scene, Motion& motion) {
  const Camera camera = scene.written.camera.value_or(Camera{});
  Outcome outcome;
  if (options.turntable) {
    motion = turntable(options, scene, camera);
  } else {
    outcome = read_path(options, camera, motion);
  }
  if (outcome.error.empty()) {
    outcome = check_cameras(motion, options.load.limits);
  }
  if (outcome.error.empty() && options.range &&
      options.range->last > static_cast<int>(motion.cameras.size())) {
    outcome = {ExitCode::usage, fmt::format("--range: there are {} frames, not {}",
                                            motion.cameras.size(), options.range->last)};
  }
  const std::string missing = missing_light(options.render.layers, scene.ready.scene.lights.size());
  if (outcome.error.empty() && !missing.empty()) {
    outcome = {ExitCode::usage, "--aov: " + missing};
  }
  return outcome;
}

}  // namespace

ExitCode run_frames(const Options& given, Context& context) {
  Options options = given;
  const Clock::time_point start = Clock::now();
  if (!options.video.empty() && !has_program("ffmpeg")) {
    return fail(ExitCode::environment, "--video: ffmpeg is not installed, or not in PATH");
  }
  std::vector<std::string> targets;
  for (const std::string* const pattern : {&options.output, &options.write_scenes}) {
    if (!pattern->empty()) {
      targets.push_back(frame_name(*pattern, 1));
    }
  }
  if (!options.video.empty()) {
    targets.push_back(options.video);
  }
  for (const std::string& target : targets) {
    if (const Result<void> writable = check_writable(target); !writable) {
      return fail(ExitCode::environment, writable.error().text);
    }
  }
  LoadedScene scene = load_for_tracing(options, context);
  if (!options.write_scenes.empty() && scene.usable()) {
    // All of them are in the folder of the first.
    carry_files(scene, frame_name(options.write_scenes, 1), options.access, options.load.limits);
  }
  const auto say_findings = [&] {
    if (!options.json) {
      say(findings_text(scene, options.quiet ? Verbosity::errors : Verbosity::warnings,
                        wants_color(Stream::chatter)));
    }
  };
  // Drawing with OpenGL adds to the findings.
  const bool said_before = options.engine == Engine::trace;
  if (said_before) {
    say_findings();
  }
  Outcome outcome = outcome_of(scene);
  if (const auto realtime = realtime_options(options);
      realtime && outcome.status == ExitCode::fine) {
    check_realtime(*realtime, scene);
  }
  Motion motion;
  if (outcome.status == ExitCode::fine) {
    outcome = make_motion(options, scene, motion);
  }
  int drawn = 0;
  int skipped = 0;
  std::optional<TemporaryFolder> folder;  // for the frames of a video that are not kept
  if (outcome.status == ExitCode::fine && options.output.empty() && !options.video.empty()) {
    if (Result<TemporaryFolder> made = TemporaryFolder::create()) {
      options.output = made->path() + "/%d.png";
      folder.emplace(*std::move(made));
    } else {
      outcome = outcome_of(made.error(), context);
    }
  }
  if (outcome.status == ExitCode::fine) {
    Frames frames(options, scene, motion, context);
    outcome = frames.run();
    drawn = frames.drawn();
    skipped = frames.skipped();
  }
  if (!said_before) {
    say_findings();
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (options.json) {
    Json json;
    begin_document(json, "frames");
    json.key("scene");
    add_scene(json, scene);
    json.add({{"output", given.output},
              {"frames", motion.cameras.size()},
              {"fps", motion.fps},
              {"drawn", drawn},
              {"skipped", skipped}});
    if (!outcome.error.empty()) {
      json.add("error", outcome.error);
    }
    json.add("seconds", seconds);
    json.end_object();
    return answer_json(outcome, json.text());
  }
  if (status_of(scene) == ExitCode::fine && !outcome.error.empty()) {
    say_error(outcome.error);
  }
  if (outcome.status == ExitCode::fine && !options.quiet) {
    say_afterwards([&] {
      const std::size_t frames = motion.cameras.size();
      if (options.output.empty()) {
        const std::size_t written =
            options.range ? static_cast<std::size_t>(options.range->last - options.range->first + 1)
                          : frames;
        return fmt::format("{}: {} written; {:.2f} s\n", escaped(given.write_scenes),
                           counted(written, "scene"), seconds);
      }
      return fmt::format("{}: {} of {} drawn, {} skipped; {:.2f} s\n",
                         escaped(given.output.empty() ? given.video : given.output), drawn,
                         counted(frames, "frame"), skipped, seconds);
    });
  }
  return outcome.status;
}

}  // namespace scenefile::app
