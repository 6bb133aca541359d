#include "app/command.h"
#include "app/grade_files.h"
#include "app/load_picture.h"
#include "app/output.h"
#include "app/progress.h"
#include "scenefile/base/text.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/grade/gradebook.h"
#include "scenefile/io/file.h"
#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

namespace scenefile::app {

namespace {

namespace fs = std::filesystem;

// What holds where nobody says otherwise: float against double is at 40 dB and more.
constexpr double default_min_psnr_db = 40;

const std::vector<std::string_view> picture_endings{".png", ".jpg", ".jpeg",
                                                    ".gif", ".tga", ".bmp"};
const std::vector<std::string_view> scene_endings{".xml", ".json"};

// A folder for each student, or one folder with the pictures of one.
std::vector<fs::path> student_folders(const std::string& folder) {
  std::vector<fs::path> students;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory(error) && !name.starts_with(".") && name != "__MACOSX") {
      students.push_back(entry->path());
    }
  }
  std::sort(students.begin(), students.end());
  const bool layout = std::all_of(students.begin(), students.end(), [](const fs::path& path) {
    return is_layout_folder(path.filename().string());
  });
  if (layout) {
    students = {fs::path(folder)};
  }
  return students;
}

struct Reference {
  std::string name;
  LoadedPicture picture;
  std::optional<LoadedScene> scene;
};

class Grader {
 public:
  /// `by_causes`: a picture passes by what is wrong with it, not by a threshold alone.
  Grader(const Options& options, bool by_causes, Context& context)
      : options_(options),
        settings_(compare_settings(options)),
        by_causes_(by_causes),
        context_(context) {
    if (by_causes) {
      settings_.look = LookForCauses::always;
    }
  }

  std::size_t matched() const { return matched_; }

  // What was looked for and what there is, for a class of which no picture has the right name.
  std::string nothing_matches() const {
    return fmt::format(
        "none of {} pictures in {} is one of the {} references in {}: looked for {}.png, "
        "{}_gen.png "
        "and FOLDER_{}.png, and so on, in all folders",
        seen_, quoted(options_.arguments.front(), 400), references_.size(),
        quoted(options_.references, 400), escaped(references_.front().name),
        escaped(references_.front().name), escaped(references_.front().name));
  }

  // Says what went wrong.
  ExitCode load_references() {
    const std::vector<FoundFile> scenes =
        files_below(options_.scenes.empty() ? options_.references : options_.scenes, scene_endings);
    files_ = files_below(options_.references, picture_endings);
    const std::vector<std::string> names = reference_names(files_);
    const std::vector<int> scene_of = match_scenes(scenes);
    for (std::size_t i = 0; i < files_.size(); ++i) {
      Reference reference{names[i], load_picture(files_[i].path, context_), std::nullopt};
      if (!reference.picture.error.empty()) {
        say_error(reference.picture.error);
        return reference.picture.status;
      }
      if (scene_of[i] >= 0) {
        reference.scene = load_scene_of_pictures(scenes[static_cast<std::size_t>(scene_of[i])].path,
                                                 options_, context_);
      }
      references_.push_back(std::move(reference));
    }
    if (references_.empty()) {
      say_error(fmt::format("{} contains no pictures", quoted(options_.references, 400)));
      return ExitCode::environment;
    }
    return ExitCode::fine;
  }

  Gradebook run() {
    Gradebook book;
    const std::vector<fs::path> folders = student_folders(options_.arguments.front());
    ProgressBar bar(!options_.quiet && !options_.json && wants_progress());
    const double all = static_cast<double>(folders.size() * references_.size());
    double done = 0;
    for (const fs::path& folder : folders) {
      const std::vector<FoundFile> pictures = files_below(folder.string(), picture_endings);
      const std::vector<int> matches = match_pictures(files_, pictures);
      seen_ += pictures.size();
      StudentResult& student = book.students.emplace_back();
      const fs::path named = fs::path(folder).lexically_normal();
      student.name = (named.has_filename() ? named : named.parent_path()).filename().string();
      for (std::size_t i = 0; i < references_.size(); ++i) {
        matched_ += matches[i] >= 0 ? 1 : 0;
        const std::string path =
            matches[i] < 0 ? std::string() : pictures[static_cast<std::size_t>(matches[i])].path;
        student.pictures.push_back(grade(references_[i], path, [&](double part) {
          bar.update((done + part) / all);
          return true;
        }));
        bar.update(++done / all);
      }
    }
    return book;
  }

 private:
  // One scene may be that of several references: intersect and illuminate.
  std::vector<int> match_scenes(const std::vector<FoundFile>& scenes) const {
    std::vector<int> result;
    for (const FoundFile& file : files_) {
      result.push_back(match_pictures({file}, scenes).front());
    }
    return result;
  }

  // `path` of the picture; empty: there is none.
  PictureResult grade(const Reference& reference, const std::string& path,
                      const std::function<bool(double)>& progress) {
    PictureResult result;
    result.name = reference.name;
    if (path.empty()) {
      result.verdict = Verdict::missing;
      result.reasons = {"there is no picture of that name"};
      return result;
    }
    // It would lead to the reference, or to the work of another student.
    if (std::error_code error; fs::is_symlink(path, error)) {
      result.verdict = Verdict::unreadable;
      result.reasons = {"a symbolic link is handed in, not a picture"};
      return result;
    }
    const LoadedPicture picture = load_picture(path, context_);
    if (!picture.error.empty()) {
      result.verdict = Verdict::unreadable;
      result.reasons = {picture.error};
      return result;
    }
    context_.phase = "comparing the pictures";
    const PictureComparison compared =
        compare_pictures(reference.picture.picture, picture.picture,
                         reference.scene ? &*reference.scene : nullptr, settings_, progress);
    result.measures = compared.measures;
    result.reasons = compared.broken;
    result.causes = compared.causes.claims;
    result.verdict = compared.broken.empty() ? Verdict::passed : Verdict::differs;
    if (by_causes_ && compared.measures.same_size) {
      follow_causes(compared, result);
    }
    if (result.verdict == Verdict::differs && !options_.report.empty()) {
      result.png = thumbnail(reference.picture.picture, picture.picture);
    }
    return result;
  }

  // Where nobody gave thresholds, what is wrong decides: a known mistake fails at any PSNR, edges
  // and rounding alone pass.
  static void follow_causes(const PictureComparison& compared, PictureResult& result) {
    const CauseReport& report = compared.causes;
    const bool mistake = std::any_of(report.claims.begin(), report.claims.end(),
                                     [](const Claim& c) { return c.cause != Cause::rounding; });
    if (mistake) {
      result.verdict = Verdict::differs;
      if (result.reasons.empty()) {
        result.reasons = {
            fmt::format("PSNR is {:.2f} dB, and a known mistake explains what differs",
                        compared.measures.difference.psnr_db)};
      }
    } else if (report.partial.empty() && report.share_different < 0.001) {
      result.verdict = Verdict::passed;
      result.reasons.clear();
    }
  }

  static std::string thumbnail(const Texture& reference, const Texture& picture) {
    constexpr int width = 320;
    const Texture heat = reduced(heat_map(reference, picture), width);
    const Texture a = reduced(reference, width);
    const Texture b = reduced(picture, width);
    const std::array<const Texture*, 3> pictures{&a, &b, &heat};
    std::string none;  // at this size
    return png_of(side_by_side(pictures), none);
  }

  const Options& options_;
  CompareSettings settings_;
  bool by_causes_;
  Context& context_;
  std::vector<FoundFile> files_;  // of the references
  std::vector<Reference> references_;
  std::size_t seen_ = 0;     // pictures that were handed in
  std::size_t matched_ = 0;  // those of a reference's name
};

std::string json_text(const Gradebook& book) {
  Json json;
  begin_document(json, "grade");
  json.add("passed", book.all_passed());
  json.begin_array("students");
  for (const StudentResult& student : book.students) {
    json.begin_object();
    json.add("name", student.name);
    json.add("passed", student.passed());
    json.begin_array("pictures");
    for (const PictureResult& picture : student.pictures) {
      json.begin_object();
      json.add("name", picture.name);
      json.add("verdict", name_of(picture.verdict));
      if (picture.verdict == Verdict::passed || picture.verdict == Verdict::differs) {
        add_measures(json, picture.measures);
      }
      add_clauses(json, "reasons", picture.reasons);
      add_claims(json, "causes", picture.causes);
      json.end_object();
    }
    json.end_array();
    json.end_object();
  }
  json.end_array();
  json.end_object();
  return json.text();
}

// Lines may hold names of files.
std::string safe_lines(const std::string& text) {
  std::string result;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    result += escaped(text.substr(start, end - start), 4096) + "\n";
    start = end == std::string::npos ? text.size() : end + 1;
  }
  return result;
}

ExitCode write_text(const std::string& path, const std::string& text) {
  if (path.empty()) {
    return ExitCode::fine;
  }
  const Result<void> written = write_file(path, text);
  if (!written) {
    say_error(written.error().text);
  }
  return written ? ExitCode::fine : ExitCode::environment;
}

ExitCode check_places(const Options& options) {
  for (const std::string& folder : {options.arguments.front(), options.references,
                                    options.scenes.empty() ? options.references : options.scenes}) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) {
      say_error(fmt::format("{} is not a folder that can be read", quoted(folder, 400)));
      return ExitCode::environment;
    }
  }
  for (const std::string& target : {options.report, options.junit}) {
    if (const Result<void> writable = target.empty() ? Result<void>() : check_writable(target);
        !writable) {
      say_error(writable.error().text);
      return ExitCode::environment;
    }
  }
  return ExitCode::fine;
}

}  // namespace

ExitCode run_grade(const Options& given, Context& context) {
  Options options = given;
  const bool by_causes = options.thresholds == Thresholds{};
  if (by_causes) {
    options.thresholds.min_psnr_db = default_min_psnr_db;
  }
  if (const ExitCode status = check_places(options); status != ExitCode::fine) {
    return status;
  }
  Grader grader(options, by_causes, context);
  if (const ExitCode status = grader.load_references(); status != ExitCode::fine) {
    return status;
  }
  const Gradebook book = grader.run();
  if (grader.matched() == 0) {
    say_error(grader.nothing_matches());
    return ExitCode::environment;
  }
  ExitCode status = book.all_passed() ? ExitCode::fine : ExitCode::findings;
  // All is ready before something is written, so that nothing can fail afterwards.
  context.phase = "making the report";
  const std::string page =
      options.report.empty() ? std::string() : gradebook_html(book, "Ray tracer grades");
  const std::string junit = options.junit.empty() ? std::string() : gradebook_junit(book);
  const std::string text = options.json    ? json_text(book)
                           : options.quiet ? std::string()
                                           : safe_lines(gradebook_text(book));
  context.phase = "writing the report";
  status = worse(status, write_text(options.report, page));
  status = worse(status, write_text(options.junit, junit));
  return text.empty() ? status : worse(status, answer(text));
}

}  // namespace scenefile::app
