#include "app/checkpoint.h"
#include "app/command.h"
#include "app/grade_results.h"
#include "app/load.h"
#include "app/load_picture.h"
#include "app/named_files.h"
#include "app/output.h"
#include "app/part_files.h"
#include "app/progress.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/hash.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/text.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/archive.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/verbs/grade_class.h"
#include "scenefile/verbs/json_writer.h"
#include "scenefile/verbs/realtime_table.h"
#include "scenefile/verbs/scene_json.h"

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

// What the results of a part depend on, in addition to the pictures.
std::uint64_t options_of_grading(const Options& options, std::span<const NamePair> map) {
  // Lists all members, so that adding one is a compile error until it is part of the key.
  const auto& [psnr, mean, difference, share, ssim, flip] = options.thresholds;
  const auto number = [](const auto& value) {
    return value ? fmt::format("{:a}", static_cast<double>(*value)) : std::string("-");
  };
  std::string text = fmt::format("{:x} {} {} {} {} {} {} {} {} {}", options_fingerprint(options),
                                 was_given(options, "--profile"), was_given(options, "--features"),
                                 options.pixel_threshold, number(psnr), number(mean),
                                 number(difference), number(share), number(ssim), number(flip));
  Hash hash;
  hash.add(text);
  hash.add(options.layer);
  for (const NamePair& pair : map) {
    hash.add(pair.handed_in);
    hash.add(pair.reference);
  }
  return hash.value();
}

// Why this part is not the requested one; empty if it is.
std::string part_mismatch(const GradePartHead& found, const GradePartHead& wanted) {
  if (const std::string_view why = foreign_grade_part(found.whole.key, wanted.whole.key);
      !why.empty()) {
    return fmt::format("the part was graded {}", why);
  }
  if (found.index != wanted.index || found.whole.count != wanted.whole.count) {
    return fmt::format("it is part {} of {}, not {} of {}", found.index + 1, found.whole.count,
                       wanted.index + 1, wanted.whole.count);
  }
  return found.submissions == wanted.submissions ? "" : "the part was graded from other pictures";
}

// Checks the output file of the part. `exists`: it already contains the part.
Outcome find_part(const Options& options, const GradePartHead& wanted, bool& exists) {
  exists = false;
  std::error_code ignored;
  if (is_standard_output(options.output) ||
      !std::filesystem::is_regular_file(options.output, ignored) ||
      std::filesystem::file_size(options.output, ignored) == 0) {
    return {};
  }
  const Result<GradePart> found = read_grade_part(options.output);
  if (!found) {
    return {ExitCode::environment, found.error().text};
  }
  std::string why = found->damage;
  if (why.empty()) {
    why = part_mismatch(found->head, wanted);
    exists = why.empty();
  } else if (kind_of_part(options.output) == PartKind::of_class) {
    return {};  // damaged: will be written again
  }
  return why.empty() ? Outcome()
                     : Outcome{ExitCode::findings,
                               fmt::format("{}: {}; remove the file or choose another name",
                                           escaped(options.output, 400), why)};
}

std::string part_json(const Options& options, std::size_t students, bool skipped,
                      const std::string& error) {
  Json json;
  begin_document(json, "grade");
  json.key("part");
  json.begin_object();
  json.add("number", options.part->index + 1);
  json.add("count", options.part->count);
  json.add("skipped", skipped);
  json.add("students", students);
  json.end_object();
  json.add("output", options.output);
  if (!error.empty()) {
    json.add("error", error);
  }
  json.end_object();
  return json.text();
}

// Grades a part of the students into a file.
ExitCode grade_part(const Options& options, ClassGrader& grader, std::span<const NamePair> map,
                    const std::function<bool(double)>& go_on, Context& context) {
  const auto [index, count] = *options.part;
  const StudentRange range = students_of(index, count, grader.students());
  GradePartHead head;
  head.whole.key = {program_fingerprint(), grader.student_names(), grader.references(),
                    options_of_grading(options, map)};
  head.whole.count = count;
  head.whole.students = static_cast<std::uint32_t>(grader.students());
  head.whole.pictures = grader.pictures();
  head.index = index;
  head.submissions = grader.submissions(range);
  bool exists = false;
  context.phase = "checking the part";
  Outcome outcome = find_part(options, head, exists);
  if (outcome.status == ExitCode::fine && !exists) {
    const Result<Gradebook> graded = grader.grade(range, go_on);
    context.phase = "writing the part";
    outcome = !graded ? Outcome{exit_code(graded.error().kind), graded.error().text}
                      : outcome_of(write_file(options.output, encode_grade_part(head, *graded)));
  }
  const std::size_t students = range.end - range.begin;
  if (options.json) {
    return worse(outcome.status, answer(part_json(options, students, exists, outcome.error)));
  }
  if (outcome.status != ExitCode::fine) {
    say_error(outcome.error);
  } else if (!options.quiet) {
    say_afterwards([&] {
      return fmt::format("{}: part {} of {}{}, {} student{}\n", escaped(options.output),
                         head.index + 1, head.whole.count, exists ? " exists already" : "",
                         students, students == 1 ? "" : "s");
    });
  }
  return outcome.status;
}

// Adds the files that are read to context.files. An error if an output would replace one of them.
Result<void> add_graded_files(const Options& options, Context& context) {
  Result<void> added;
  const auto add = [&](std::string_view role, const std::string& folder,
                       bool (*wanted)(std::string_view)) {
    for (const FoundFile& file : files_below(folder, wanted)) {
      added = added ? context.files.read(named_file(role, file.path)) : added;
    }
  };
  add("reference", options.references, is_picture_name);
  add("scene of a reference", options.scenes.empty() ? options.references : options.scenes,
      is_scene_name);
  add("picture of a student", options.arguments.front(), is_picture_name);
  add("archive of a student", options.arguments.front(), is_archive_name);
  for (const std::string& folder : {options.references, options.references + "/.."}) {
    const std::string table = fmt::format("{}/{}", folder, realtime_table_name);
    if (added && stamp_of(table).exists) {
      added = context.files.read(named_file("table", table));
    }
  }
  return added;
}

}  // namespace

ExitCode run_grade(const Options& options, Context& context) {
  Outcome refused = outcome_of(add_graded_files(options, context));
  if (refused.status == ExitCode::fine) {
    refused = check_named_outputs(options);
  }
  if (refused.status != ExitCode::fine) {
    say_error(refused.error);
    return refused.status;
  }
  Result<std::vector<NamePair>> map = load_map(options);
  if (!map) {
    say_error(map.error().text);
    return exit_code(map.error().kind);
  }
  const GradeRequest request{
      .handed_in = options.arguments.front(),
      .references = options.references,
      .scenes = options.scenes,
      .compare = compare_settings(options),
      .layer = options.layer,
      // merge may need them.
      .thumbnails = options.part.has_value() || !options.report.empty() || !options.pages.empty(),
      .map = *std::move(map)};
  const auto load_scene = [&](const std::string& path) {
    LoadedScene scene = load_scene_of_pictures(path, options, context);
    if (status_of(scene) == ExitCode::usage) {
      refused = {ExitCode::usage, options.json ? scene.unreadable->text : ""};  // else it is said
    }
    return scene;
  };
  std::optional<ProgressBar> bar(!options.quiet && !options.json && wants_progress());
  const auto go_on = [&](double done) {
    bar->update(done);
    return true;
  };
  Result<ClassGrader> grader =
      ClassGrader::open(request, load_scene, [&](const char* phase) { context.phase = phase; });
  if (!grader) {
    bar.reset();
    say_error(grader.error().text);
    return exit_code(grader.error().kind);
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
  if (options.part) {
    return grade_part(options, *grader, request.map, go_on, context);
  }
  Result<Gradebook> graded = grader->grade({0, grader->students()}, go_on);
  bar.reset();
  if (!graded) {
    say_error(graded.error().text);
    return exit_code(graded.error().kind);
  }
  find_identical_files(*graded);
  return write_results(options, *std::move(graded), quoted(options.arguments.front(), 400),
                       context);
}

}  // namespace scenefile::app
