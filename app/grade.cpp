#include "app/command.h"
#include "app/diff_paths.h"
#include "app/grade_results.h"
#include "app/item_key.h"
#include "app/load.h"
#include "app/load_picture.h"
#include "app/named_files.h"
#include "app/output.h"
#include "app/progress.h"
#include "scenefile/base/hash.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/io/item.h"
#include "scenefile/verbs/grade_class.h"
#include "scenefile/verbs/json_writer.h"
#include "scenefile/verbs/scene_json.h"
#include "scenefile/verbs/student_item.h"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

Result<std::vector<NamePair>> load_map(const Options& options) {
  if (options.name_map.empty()) {
    return std::vector<NamePair>();
  }
  const Result<std::string> text = read_file(options.name_map, Limits{}.file_bytes);
  if (!text) {
    return text.error();
  }
  std::string wrong;
  std::vector<NamePair> map = read_name_map(*text, wrong);
  if (!wrong.empty()) {
    return Error{fmt::format("{}: {}", quoted(options.name_map, 400), wrong), ErrorKind::input};
  }
  return map;
}

// The words of a key for what results depend on, in addition to the pictures.
std::string grading_words(const Options& options, std::span<const NamePair> map) {
  // Lists all members, so that adding one is a compile error until it is part of the key.
  const auto& [psnr, mean, difference, share, ssim, flip] = options.thresholds;
  std::string text = option_words(options);
  const auto add = [&](std::string_view name, const auto& value) {
    if (value) {
      text += fmt::format(" {}={}", name, *value);
    }
  };
  add("min_psnr", psnr);
  add("max_mean", mean);
  add("max_difference", difference);
  add("max_share", share);
  add("min_ssim", ssim);
  add("max_flip", flip);
  Hash names;
  names.add(options.layer);
  for (const NamePair& pair : map) {
    names.add(pair.handed_in);
    names.add(pair.reference);
  }
  if (options.seconds > 0) {
    text += fmt::format(" seconds={}", options.seconds);
  }
  // What is not given is found in the references.
  for (const char* const name :
       {"profile", "features", "parameters", "near", "far", "filter", "milestone"}) {
    text += fmt::format(" {}_given={}", name, was_given(options, fmt::format("--{}", name)));
  }
  return fmt::format("{} pixel_threshold={} layer_and_map={:x}", text, options.pixel_threshold,
                     names.value());
}

// The results of students: in memory, or with --store in files.
class StudentStore {
 public:
  StudentStore(const Options& options, ClassGrader& grader, std::span<const NamePair> map)
      : folder_(options.store) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < grader.students(); ++i) {
      names.push_back(grader.student(i));
    }
    files_ = student_file_names(names);
    there_.resize(names.size());
    if (!folder_.empty()) {
      const std::string words = program_word() + " " + grading_words(options, map) + " ";
      for (std::size_t i = 0; i < names.size(); ++i) {
        keys_.push_back(words + grader.key_of(i));
      }
    }
  }

  // Looks which results exist. An error if a file is one of another class, or no result at all.
  Outcome open(Context& context) {
    context.phase = "reading the store";
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      if (Outcome refused =
              outcome_of(context.files.write(named_file("result of a student", path_of(i))));
          refused.status != ExitCode::fine) {
        return refused;
      }
      std::error_code error;
      if (!std::filesystem::exists(path_of(i), error) && !error) {
        continue;
      }
      const Result<std::string> bytes = read_file(path_of(i), max_bytes);
      if (!bytes) {
        return {exit_code(bytes.error().kind), bytes.error().text};
      }
      const Item item = read_item(*bytes);
      const bool other = item.state == ItemState::intact && item.key != keys_[i];
      if (other || (item.state == ItemState::none && !bytes->empty())) {
        return foreign_item(path_of(i), other ? "it was graded " + key_mismatch(item.key, keys_[i])
                                              : "it is not the result of a student");
      }
      there_[i] = item.state == ItemState::intact;
    }
    return {};
  }

  bool has(std::size_t student) const { return there_[student]; }

  Outcome write(std::size_t student, const StudentResult& result) {
    if (Outcome made = make_store(folder_); made.status != ExitCode::fine) {
      return made;
    }
    std::string bytes = encode_student(result, item_text(keys_[student]));
    seal_item(bytes);
    there_[student] = true;
    return outcome_of(write_file(path_of(student), bytes));
  }

  Outcome read(std::size_t student, StudentResult& result) const {
    const Result<std::string> bytes = read_file(path_of(student), max_bytes);
    if (!bytes) {
      return {exit_code(bytes.error().kind), bytes.error().text};
    }
    return read_item(*bytes).key == keys_[student] && decode_student(*bytes, result)
               ? Outcome()
               : Outcome{ExitCode::environment,
                         fmt::format("{}: the file was changed while it was used",
                                     escaped(path_of(student), 400))};
  }

 private:
  static constexpr std::uint64_t max_bytes = std::uint64_t{1} << 32;

  std::string path_of(std::size_t student) const {
    return fmt::format("{}/{}.json", folder_, files_[student]);
  }

  std::string folder_;  // empty: nothing is stored
  std::vector<std::string> files_;
  std::vector<std::string> keys_;
  std::vector<bool> there_;
};

// The students of share `index` of `count`.
struct StudentShare {
  std::size_t first = 0;
  std::size_t end = 0;
};
StudentShare share_of_students(std::size_t students, std::uint32_t index, std::uint32_t count) {
  return {students * index / count, students * (std::size_t{index} + 1) / count};
}

std::string store_json(const std::vector<std::uint32_t>* missing, std::size_t found,
                       std::size_t graded) {
  Json json;
  begin_document(json, "grade");
  json.begin_object("store");
  json.add({{"found", found}, {"graded", graded}});
  if (missing != nullptr) {
    json.add("missing", *missing);
  }
  json.end_object();
  json.end_object();
  return json.text();
}

// Prints the shares with students to grade; status 1 if there are any.
ExitCode answer_missing_shares(const Options& options, const StudentStore& store,
                               std::size_t students) {
  std::vector<std::uint32_t> missing;
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < *options.missing; ++i) {
    const StudentShare share = share_of_students(students, i, *options.missing);
    bool complete = true;
    for (std::size_t s = share.first; s < share.end; ++s) {
      complete = complete && store.has(s);
      found += store.has(s) ? 1 : 0;
    }
    if (!complete) {
      missing.push_back(i + 1);
    }
  }
  if (!options.json) {
    return answer_missing(missing);
  }
  return worse(missing.empty() ? ExitCode::fine : ExitCode::findings,
               answer(store_json(&missing, found, 0)));
}

ExitCode answer_share(const Options& options, std::size_t found, std::size_t graded) {
  if (options.json) {
    return answer(store_json(nullptr, found, graded));
  }
  if (!options.quiet) {
    say_afterwards([&] {
      return fmt::format("{}: share {} of {}: {} graded, {} found\n", escaped(options.store),
                         options.part->index + 1, options.part->count, counted(graded, "student"),
                         found);
    });
  }
  return ExitCode::fine;
}

}  // namespace

ExitCode run_grade(const Options& options, Context& context) {
  Outcome refused = check_named_outputs(options);
  if (refused.status != ExitCode::fine) {
    return fail(refused);
  }
  Result<std::vector<NamePair>> map = load_map(options);
  if (!map) {
    return fail(map.error());
  }
  const GradeRequest request{
      .handed_in = options.arguments.front(),
      .references = options.references,
      .scenes = options.scenes,
      .compare = compare_settings(options),
      .layer = options.layer,
      .thumbnails = !options.store.empty() || !options.report.empty() || !options.pages.empty(),
      .map = *std::move(map),
      .path = options.render.mode == Mode::path ? std::optional(options.render) : std::nullopt,
      .seconds = seconds_of_truth(options),
      .one_student = !options.gradescope.empty(),
      .results = {options.store, options.pages, pictures_folder(options.report)}};
  const auto load_scene = [&](const std::string& path) {
    LoadedScene scene = load_scene_of_pictures(path, options, context);
    if (status_of(scene) == ExitCode::usage) {
      refused = {ExitCode::usage, options.json ? scene.unreadable->text : ""};  // else it is said
    }
    return scene;
  };
  std::optional<ProgressBar> bar(!options.quiet && !options.json && wants_progress());
  Result<ClassGrader> grader =
      ClassGrader::open(request, load_scene, [&](const char* phase) { context.phase = phase; });
  if (!grader) {
    bar.reset();
    return fail(grader.error());
  }
  if (refused.status == ExitCode::fine) {
    refused = claim_inputs(grader->inputs(), context);
  }
  if (refused.status == ExitCode::fine) {
    std::vector<std::string> students;
    for (std::size_t i = 0; i < grader->students(); ++i) {
      students.push_back(grader->student(i));
    }
    refused = claim_pages(options, students, grader->pictures(), context);
  }
  if (refused.status != ExitCode::fine) {
    bar.reset();
    if (!refused.error.empty()) {
      say_error(refused.error);
    }
    return refused.status;
  }
  if (!options.quiet && !options.json) {
    for (const std::string& note : grader->notes()) {
      say(fmt::format("note: {}\n", note));
    }
  }
  StudentStore store(options, *grader, request.map);
  Outcome outcome = store.open(context);
  if (outcome.status == ExitCode::fine && options.missing) {
    bar.reset();
    return answer_missing_shares(options, store, grader->students());
  }
  const StudentShare share =
      options.part ? share_of_students(grader->students(), options.part->index, options.part->count)
                   : StudentShare{0, grader->students()};
  Gradebook book = grader->empty_book();
  std::size_t found = 0;
  for (std::size_t s = share.first; s < share.end && outcome.status == ExitCode::fine; ++s) {
    StudentResult& result = book.students.emplace_back();
    if (store.has(s)) {
      ++found;
      outcome = options.part ? outcome : store.read(s, result);
      continue;
    }
    Result<StudentResult> graded = grader->grade(s, [&](double done) {
      bar->update((static_cast<double>(s - share.first) + done) /
                  static_cast<double>(share.end - share.first));
      return true;
    });
    if (!graded) {
      outcome = {exit_code(graded.error().kind), graded.error().text};
    } else {
      result = *std::move(graded);
      outcome = options.store.empty() ? outcome : store.write(s, result);
    }
  }
  bar.reset();
  if (outcome.status != ExitCode::fine) {
    return fail(outcome);
  }
  if (options.part) {
    return answer_share(options, found, share.end - share.first - found);
  }
  if (options.report.empty() && options.pages.empty()) {
    for (StudentResult& student : book.students) {
      for (PictureResult& picture : student.pictures) {
        picture.png = {};
      }
    }
  }
  find_identical_files(book);
  return write_results(options, std::move(book), context);
}

}  // namespace scenefile::app
