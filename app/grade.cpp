#include "app/command.h"
#include "app/json.h"
#include "app/judgement.h"
#include "app/load_picture.h"
#include "app/output.h"
#include "app/progress.h"
#include "scenefile/base/text.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/grade/gradebook.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>

namespace scenefile::app {

namespace {

namespace fs = std::filesystem;

// What holds where nobody says otherwise: float against double is at 40 dB and more.
constexpr double default_min_psnr_db = 40;

constexpr std::array<std::string_view, 6> picture_endings{".png", ".jpg", ".jpeg",
                                                          ".gif", ".tga", ".bmp"};
constexpr std::array<std::string_view, 2> scene_endings{".xml", ".json"};

// Names without endings, and the files that bear them.
using Files = std::map<std::string, std::string>;

template <std::size_t n>
Files files_in(const std::string& folder, const std::array<std::string_view, n>& endings) {
  Files files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& path = entry->path();
    if (std::find(endings.begin(), endings.end(), path.extension().string()) != endings.end()) {
      files.emplace(path.stem().string(), path.string());
    }
  }
  return files;
}

// A folder for each student, or one folder with the pictures of one.
std::vector<fs::path> student_folders(const std::string& folder) {
  std::vector<fs::path> students;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->is_directory(error) && !entry->path().filename().string().starts_with(".")) {
      students.push_back(entry->path());
    }
  }
  std::sort(students.begin(), students.end());
  if (students.empty()) {
    students.emplace_back(folder);
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
  Grader(const Options& options, Context& context) : options_(options), context_(context) {}

  // Says what went wrong.
  ExitCode load_references() {
    const Files scenes =
        files_in(options_.scenes.empty() ? options_.references : options_.scenes, scene_endings);
    for (const auto& [name, path] : files_in(options_.references, picture_endings)) {
      Reference reference{name, load_picture(path, context_), std::nullopt};
      if (!reference.picture.error.empty()) {
        say_error(reference.picture.error);
        return reference.picture.status;
      }
      if (const auto scene = scenes.find(name); scene != scenes.end()) {
        reference.scene = load_scene_of_pictures(scene->second, options_, context_);
      }
      references_.push_back(std::move(reference));
    }
    if (references_.empty()) {
      say_error(fmt::format("{} holds no pictures", quoted(options_.references, 400)));
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
      const Files pictures = files_in(folder.string(), picture_endings);
      StudentResult& student = book.students.emplace_back();
      student.name = fs::path(folder).lexically_normal().filename().string();
      for (const Reference& reference : references_) {
        student.pictures.push_back(grade(reference, pictures, [&](double part) {
          bar.update((done + part) / all);
          return true;
        }));
        bar.update(++done / all);
      }
    }
    return book;
  }

 private:
  PictureResult grade(const Reference& reference, const Files& pictures,
                      const std::function<bool(double)>& progress) {
    PictureResult result;
    result.name = reference.name;
    const auto found = pictures.find(reference.name);
    if (found == pictures.end()) {
      result.verdict = Verdict::missing;
      result.reasons = {"there is no picture of that name"};
      return result;
    }
    // It would lead to the reference, or to the work of another student.
    if (std::error_code error; fs::is_symlink(found->second, error)) {
      result.verdict = Verdict::unreadable;
      result.reasons = {"a symbolic link is handed in, not a picture"};
      return result;
    }
    const LoadedPicture picture = load_picture(found->second, context_);
    if (!picture.error.empty()) {
      result.verdict = Verdict::unreadable;
      result.reasons = {picture.error};
      return result;
    }
    context_.phase = "comparing the pictures";
    const Judgement judgement =
        judge(reference.picture.picture, picture.picture,
              reference.scene ? &*reference.scene : nullptr, options_, progress);
    result.measures = judgement.measures;
    result.reasons = judgement.broken;
    result.causes = judgement.causes.claims;
    result.verdict = judgement.broken.empty() ? Verdict::passed : Verdict::differs;
    if (!judgement.broken.empty() && !options_.report.empty()) {
      result.png = thumbnail(reference.picture.picture, picture.picture);
    }
    return result;
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
  Context& context_;
  std::vector<Reference> references_;
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
  const IoError error = write_file(path, text);
  if (!error.empty()) {
    say_error(error.text);
  }
  return error.empty() ? ExitCode::fine : ExitCode::environment;
}

ExitCode check_places(const Options& options) {
  for (const std::string& folder :
       {options.arguments.front(), options.references,
        options.scenes.empty() ? options.references : options.scenes}) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) {
      say_error(fmt::format("{} is not a folder that can be read", quoted(folder, 400)));
      return ExitCode::environment;
    }
  }
  for (const std::string& target : {options.report, options.junit}) {
    if (const IoError error = target.empty() ? IoError{} : check_writable(target); !error.empty()) {
      say_error(error.text);
      return ExitCode::environment;
    }
  }
  return ExitCode::fine;
}

}  // namespace

ExitCode run_grade(const Options& given, Context& context) {
  Options options = given;
  if (options.thresholds == Thresholds{}) {
    options.thresholds.min_psnr_db = default_min_psnr_db;
  }
  if (const ExitCode status = check_places(options); status != ExitCode::fine) {
    return status;
  }
  Grader grader(options, context);
  if (const ExitCode status = grader.load_references(); status != ExitCode::fine) {
    return status;
  }
  const Gradebook book = grader.run();
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
