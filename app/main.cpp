// The program: a table of commands. Commands parse nothing, print through output.h, and return a
// status.

#include "app/command.h"
#include "app/course_program.h"
#include "app/help.h"
#include "app/json.h"
#include "app/named_files.h"
#include "app/option_table.h"
#include "app/output.h"
#include "scenefile/base/text.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/io/memory.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>

namespace scenefile::app {

namespace {

constexpr std::array command_rows{
    Command{
        "render", for_render, "SCENE -o OUT", "draw a scene with the ray tracer",
        "Draws the scene to a picture. The file is written completely or not at all. The "
        "picture does not depend on the number of threads. FILE.ini, a configuration of the "
        "course's programs, supplies the scene and options; options on the command line override "
        "those of the configuration.",
        "scenefile render chess.xml -o chess.png\n"
        "scenefile render chess.xml -o chess.png --size 1920x1080 --samples 64\n"
        "scenefile render chess.xml -o chess.png --profile course --features shadows,reflect\n"
        "scenefile render chess.xml -o chess.png --engine gl\n"
        "scenefile render chess.xml -o chess.png --size 7680x4320 --store bands\n"
        "scenefile render chess.xml --size 7680x4320 --store bands --part 3/64\n"
        "scenefile render glossy.ini --samples 400\n"
        "scenefile render chess.xml -o chess.exr --asset-root ~/course/data\n"
        "cat chess.xml | scenefile render - -o - > chess.png",
        run_render},
    Command{"frames", for_frames, "SCENE -o PATTERN", "draw numbered frames with a moving camera",
            "Draws a numbered picture for each frame of a full turn around the scene "
            "(--turntable), or of a path through given views (--path). Frames that already exist "
            "for the same scene and options are skipped, so an interrupted run continues where it "
            "stopped, and several machines can share the work.",
            "scenefile frames chess.xml -o frame%04d.png --turntable 96\n"
            "scenefile frames chess.xml -o frame%04d.png --turntable 96 --video turn.mp4\n"
            "scenefile frames chess.xml -o frame%04d.png --path cameras.json --range 49:96\n"
            "scenefile frames chess.xml --turntable 4 --write-scenes side%d.xml",
            run_frames},
    Command{"check", for_check, "SCENE...", "report every mistake with its line and column",
            "Reads each scene with its textures and meshes and reports all errors and suspicious "
            "content. A folder stands for the scenes in it and in its subfolders. The exit status "
            "is 0 if there are no errors.",
            "scenefile check *.xml\n"
            "scenefile check handed-in/\n"
            "scenefile check --deny warnings --allow xml.camera-default scene.xml\n"
            "scenefile check --compat course old.xml\n"
            "scenefile check --no-assets --json - < scene.json\n"
            "scenefile check --sarif *.xml > findings.sarif",
            run_check, one_or_more},
    Command{"info", for_info, "SCENE", "show what is in a scene",
            "Counts what the scene contains, before and after templates are expanded, and says "
            "where its textures and meshes were found.",
            "scenefile info chess.xml\n"
            "scenefile info --files --tree chess.xml\n"
            "scenefile info --json chess.xml",
            run_info},
    Command{"convert", for_convert, "IN OUT", "convert a scene to another format, or clean it up",
            "Reads a scene in any dialect and writes it as clean XML or JSON that means the same, "
            "or for other programs: glTF 2.0, Wavefront OBJ and POV-Ray. Reads glTF and OBJ "
            "models, too, and writes their meshes and textures next to the scene. Whatever the "
            "target format "
            "cannot express is listed. Comments are not carried over. Texture and mesh names are "
            "adjusted if OUT is in another folder.",
            "scenefile convert chess.xml chess.json\n"
            "scenefile convert old.xml new.xml\n"
            "scenefile convert --compat course old.xml new.xml\n"
            "scenefile convert - - --to json < chess.xml > chess.json\n"
            "scenefile convert chess.xml chess.glb\n"
            "scenefile convert model.glb scene.xml\n"
            "scenefile convert model.obj scene.xml\n"
            "scenefile convert chess.xml chess.pov && povray chess.pov File_Gamma=1.0",
            run_convert, two},
    Command{"diff", for_diff, "A [B]", "show how two scenes or two pictures differ",
            "Compares the meaning of two scenes in any format and shows, like diff -u, how they "
            "differ, with places in both files; or two pictures, the reference first: PSNR, SSIM, "
            "FLIP and, with the scene, the mistake that explains the "
            "difference. If --profile and --features are not given, those that fit the "
            "reference are found. The exit status is 0 if they are the same and 1 if they differ. "
            "A path-traced picture is compared with the truth, which is drawn from the scene; no "
            "reference is needed. The exit status is 0 if it is right within its noise.",
            "scenefile diff old.xml new.xml\n"
            "scenefile diff chess.xml chess.json\n"
            "scenefile diff --json a.json b.json\n"
            "scenefile diff reference.png mine.png --scene chess.xml\n"
            "scenefile diff reference.png mine.png --min-psnr 40 --sheet sheet.png\n"
            "scenefile diff mine.pfm --scene box.xml --mode path",
            run_diff, ArgumentCount{1, 2}},
    Command{
        "grade", for_grade, "DIR", "compare the pictures of a class with the references",
        "Each folder and each archive in DIR is a student; files that Canvas, Blackboard or Moodle "
        "named belong to the student in the name. Without them, or with --gradescope, DIR itself "
        "is a single student. DIR may be an archive. Compares the pictures with the references of "
        "the same names and, if the scenes are given, says which mistake explains a difference. "
        "If --profile and --features are not given, those that fit the references are found. The "
        "exit status is 1 if a picture did not pass.",
        "scenefile grade handed-in --references right\n"
        "scenefile grade handed-in --references right --scenes scenes --report report.html\n"
        "scenefile grade handed-in --references right --map names.csv --csv grades.csv\n"
        "scenefile grade mine --references right --gradescope results.json\n"
        "scenefile grade mine --references right --max-share 2 --junit results.xml\n"
        "scenefile grade handed-in --references right --store graded --report report.html\n"
        "scenefile grade handed-in --references right --store graded --part 3/16",
        run_grade},
    Command{"format", for_format, "FILE...", "format scene files in place",
            "Writes each file again with one element or member per line. Comments, values, their "
            "order and spelling, and the encoding do not change; broken files are reported and not "
            "changed. A file is replaced completely or not at all. A folder means the scenes in it "
            "and in its subfolders; other XML and JSON files are not changed. With -, standard "
            "input is written to standard output.",
            "scenefile format chess.xml\n"
            "scenefile format scenes/\n"
            "scenefile format --check *.xml *.json\n"
            "scenefile format - < chess.xml",
            run_format, one_or_more},
    Command{"explain", for_explain, "SCENE --pixel X,Y", "explain the color of a pixel",
            "Traces the samples of one pixel as render does with the same options, and shows how "
            "one of them is computed: the ray, the object, each light's terms, shadows, "
            "reflections and refractions. The numbers add up to the pixel.",
            "scenefile explain chess.xml --pixel 320,240 --size 640x480\n"
            "scenefile explain chess.xml --pixel 320,240 --profile course --sample 2\n"
            "scenefile explain chess.xml --pixel 320,240 --profile course --mine mine.png\n"
            "scenefile explain chess.xml --pixel 320,240 --reference right.png --mine mine.png\n"
            "scenefile explain chess.xml --pixel 320,240 --json",
            run_explain},
    Command{
        "view", for_view, "[SCENE [PICTURE]]", "look at a scene in a window",
        "Shows the scene, or the scenes of a folder, in a window: move through it, edit the "
        "file and see the change, select objects, trace rays, compare with a picture. A picture "
        "without a role is the reference if it equals ours, else mine. Without a scene, the "
        "window shows recent files and folders. F1 in the window lists all keys.",
        "scenefile view\n"
        "scenefile view chess.xml\n"
        "scenefile view chess.xml mine.png\n"
        "scenefile view chess.xml --reference reference.png --mine mine.png\n"
        "scenefile view scenes/\n"
        "scenefile view chess.xml --profile course --trace\n"
        "xvfb-run -a scenefile view chess.xml --screenshot window.png",
        run_view, at_most_two},
    Command{"lsp",
            for_lsp,
            "",
            "serve an editor while scenes are written",
            "The language server, which editors start: docs/editors.md has a line to paste for "
            "each. Shows the findings of check while a scene is edited, completes and explains "
            "words, corrects what is misspelled, formats, lists the parts of the scene, finds and "
            "renames templates, and shows colors.",
            "scenefile lsp\n"
            "scenefile lsp --asset-root ~/course/data",
            run_lsp,
            {0, 0}},
    Command{"help", for_help, "[TOPIC]", "explain a command, a code, a cause or a word",
            "Explains a command, the code in brackets after a finding, a cause that diff or "
            "grade names, or a word of the format: an element of XML or a key of JSON. codes, "
            "causes, limits and vocabulary list all of them; codes FAMILY lists the codes that "
            "start with a word.",
            "scenefile help render\n"
            "scenefile help codes\n"
            "scenefile help codes render\n"
            "scenefile help camera.up-parallel-to-look\n"
            "scenefile help shadows\n"
            "scenefile help rotate",
            run_help, at_most_two},
    Command{"version",
            for_version,
            "",
            "print the version",
            "Prints the version, how the program was built, and what it uses to trace rays on this "
            "machine: the version of Embree and the instruction set.",
            "scenefile version\nscenefile --version",
            run_version,
            {0, 0}},
};

// The precedence of exit statuses.
constexpr std::array ranking{ExitCode::interrupted, ExitCode::terminated, ExitCode::environment,
                             ExitCode::limit,       ExitCode::findings,   ExitCode::usage,
                             ExitCode::fine};

ExitCode complain(std::string_view what, std::string_view topic) {
  say_error(what);
  say(fmt::format("\"scenefile help{}{}\" says more.\n", topic.empty() ? "" : " ", topic));
  return ExitCode::usage;
}

// The error for an unknown command.
std::string unknown_command(std::string_view name) {
  if (name.starts_with('-')) {
    return fmt::format("the command comes first, then options such as {}: scenefile COMMAND ...",
                       quoted(name));
  }
  if (is_scene_name(name)) {
    return fmt::format("{} is a file, not a command; a command comes first: scenefile check {}",
                       quoted(name), escaped(name));
  }
  return fmt::format("unknown command {}{}", quoted(name), did_you_mean(name, command_names()));
}

void bound(const Options& options, Context& context) {
  context.max_memory = options.max_memory.value_or(0);
  limit_memory(options.max_memory.value_or(default_memory_limit()));
  if (options.timeout.has_value()) {
    const std::string reason =
        fmt::format("stopped: not finished within {} s (--timeout)", *options.timeout);
    end_after(*options.timeout, "scenefile: " + reason,
              options.json ? failure_json(context.json_command, reason) : std::string());
  }
}

ExitCode run_command(const Command& command, std::span<const char* const> words, Context& context,
                     const Configured& configured) {
  Options options;
  if (const std::string wrong = parse_options(command, words, options, configured);
      !wrong.empty()) {
    const ExitCode status = complain(wrong, command.name);
    if (!configured.words.empty()) {
      const std::string output = configured_output(command, configured);
      say(fmt::format("The configuration stands for: scenefile {} {}{}{} {}\n", command.name,
                      escaped(configured.scene, 4096), output.empty() ? "" : " -o ",
                      escaped(output, 4096), fmt::join(configured.words, " ")));
    }
    return status;
  }
  if (options.help) {
    return answer(command_text(command));
  }
  if (const Result<void> added = add_named_files(command, options, context.files); !added) {
    return fail(ExitCode::usage, added.error().text);
  }
  bound(options, context);
  if (configured.scene.empty()) {
    return command.run(options, context);
  }
  say(findings_text(configured.file, options.quiet ? Verbosity::errors : Verbosity::warnings,
                    wants_color(Stream::chatter)));
  if (configured.kind == ConfigKind::path) {
    make_output_folder(options);
  }
  const ExitCode status = command.run(options, context);
  std::error_code ignored;
  if (status == ExitCode::environment && !configured.scene.starts_with('/') &&
      !std::filesystem::exists(configured.scene, ignored)) {
    say("Relative paths of a configuration start at the working directory.\n");
  }
  return status;
}

ExitCode run(std::span<const char* const> words, Context& context) {
  if (words.empty()) {
    say(overview_text());
    return ExitCode::usage;
  }
  std::string_view name = words.front();
  if (name == "--help" || name == "-h") {
    name = "help";
  } else if (name == "--version") {
    name = "version";
  }
  const Command* const command = find_command(name);
  if (command == nullptr) {
    return complain(unknown_command(name), {});
  }
  words = words.subspan(1);
  if (asks_for_json(*command, words)) {
    context.json_command = command->name;
  }
  Configured configured;
  if (const std::string path = config_argument(*command, words); !path.empty()) {
    if (const ExitCode status = read_configuration(path, context, configured);
        status != ExitCode::fine) {
      if (const std::optional<Error>& unreadable = configured.file.unreadable) {
        keep_error(unreadable->text);
      } else if (!context.json_command.empty()) {
        say_error("the configuration cannot be used");
      }
      context.broken_configuration = scene_json(configured.file);
      return status;
    }
  }
  return run_command(*command, words, context, configured);
}

// Under the name of one of the course's programs.
ExitCode run_course_program(ConfigKind program, std::span<const char* const> words,
                            Context& context) {
  Configured configured;
  const ExitCode status = read_course_arguments(program, words, context, configured);
  return status != ExitCode::fine || configured.scene.empty()
             ? status
             : run_command(*find_command("render"), words, context, configured);
}

// Without allocating.
ExitCode answer_failure_without_memory(const Context& context) {
  std::array<char, 300> text;
  const auto end = fmt::format_to_n(text.data(), text.size(),
                                    "{{\n  \"scenefile\": \"{}\",\n  \"command\": \"{}\",\n  "
                                    "\"error\": \"out of memory while {}\"\n}}\n",
                                    SCENEFILE_VERSION, context.json_command, context.phase);
  const bool written = std::fwrite(text.data(), 1, end.size, stdout) == end.size;
  return written && std::fflush(stdout) == 0 ? ExitCode::fine : ExitCode::environment;
}

// Every command that was asked for JSON answers in JSON: one that ends without an answer or another
// result on standard output failed, and this says why.
ExitCode answer_failure(ExitCode status, const Context& context) {
  if (status == ExitCode::fine || context.json_command.empty() || used_standard_output()) {
    return status;
  }
  try {
    const std::string& errors = kept_errors();
    return worse(
        status,
        answer(failure_json(context.json_command,
                            errors.empty() ? fmt::format("failed while {}", context.phase) : errors,
                            context.broken_configuration)));
  } catch (const std::bad_alloc&) {
    return worse(status, answer_failure_without_memory(context));
  }
}

// Like run(), but nothing is thrown.
ExitCode run_guarded(std::string_view program, std::span<const char* const> words,
                     Context& context) {
  try {
    const std::optional<ConfigKind> course = course_program(program);
    return course ? run_course_program(*course, words, context) : run(words, context);
  } catch (const std::bad_alloc&) {
    return out_of_memory(context);
  } catch (const std::exception& error) {
    say("scenefile: ");
    say(error.what());
    say(" while ");
    keep_error(error.what());
  }
  say(context.phase);
  say("\n");
  return ExitCode::environment;
}

}  // namespace

std::span<const Command> commands() {
  return command_rows;
}

ExitCode worse(ExitCode a, ExitCode b) {
  return *std::find_if(ranking.begin(), ranking.end(),
                       [&](ExitCode code) { return code == a || code == b; });
}

ExitCode out_of_memory(const Context& context) {
  std::array<char, 200> line;
  const auto end =
      context.max_memory == 0
          ? fmt::format_to_n(line.data(), line.size(), "out of memory while {}", context.phase)
          : fmt::format_to_n(line.data(), line.size(),
                             "more memory than --max-memory {} is needed for {}",
                             context.max_memory, context.phase);
  say_error({line.data(), std::min(end.size, line.size())});
  return context.max_memory == 0 ? ExitCode::environment : ExitCode::limit;
}

}  // namespace scenefile::app

int main(int argc, char** argv) {
  using namespace scenefile::app;
  scenefile::handle_signals();
  begin_output();
  Context context;
  context.command_line = argv;
  const std::span<const char* const> words{argv + std::min(argc, 1),
                                           static_cast<std::size_t>(std::max(argc - 1, 0))};
  const ExitCode status = run_guarded(argc > 0 ? argv[0] : "", words, context);
  return static_cast<int>(answer_failure(status, context));
}
