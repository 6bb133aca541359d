#pragma once
// The commands of the program.

#include "app/options.h"
#include "scenefile/io/used_files.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace scenefile::app {

/// The exit status. With several inputs, the first status in this order that occurs.
enum class ExitCode : int {
  interrupted = 130,  ///< by SIGINT
  terminated = 143,   ///< by SIGTERM
  environment = 3,    ///< something cannot be read or written, or out of memory
  limit = 4,          ///< the input is larger than the limits allow
  findings = 1,       ///< errors in the input
  usage = 2,
  fine = 0,
};

/// The status that comes first in the enumeration.
ExitCode worse(ExitCode a, ExitCode b);

/// What the program is doing, for the message about running out of memory.
struct Context {
  std::string_view phase = "starting";  ///< static text
  std::uint64_t max_memory = 0;         ///< by --max-memory, in bytes; 0: not given
  char* const* command_line =
      nullptr;      ///< of main(), for replacing this process by another program
  UsedFiles files;  ///< inputs and outputs of the command
  /// The name of the command, if it answers in JSON, even if it fails; otherwise empty.
  std::string_view json_command;
  std::string broken_configuration;  ///< scene_json(), if it is the reason of a failure
};

/// The number of arguments of a command.
struct ArgumentCount {
  std::size_t fewest = 1;
  std::size_t most = 1;
};
inline constexpr ArgumentCount at_most_one{0, 1};
inline constexpr ArgumentCount one_or_more{1, ~std::size_t{0}};
inline constexpr ArgumentCount at_most_two{0, 2};
inline constexpr ArgumentCount two{2, 2};
/// Reports that memory ran out. ExitCode::limit if the limit was explicit.
ExitCode out_of_memory(const Context& context);

struct Command {
  std::string_view name;
  unsigned bit;                ///< in OptionRow::commands
  std::string_view arguments;  ///< such as "SCENE..."
  std::string_view summary;    ///< one line
  std::string_view description;
  std::string_view examples;  ///< lines
  ExitCode (*run)(const Options&, Context&);
  ArgumentCount count = {};
};

/// All commands, in the order of the help.
std::span<const Command> commands();

ExitCode run_check(const Options& options, Context& context);
ExitCode run_convert(const Options& options, Context& context);
ExitCode run_diff(const Options& options, Context& context);
ExitCode run_grade(const Options& options, Context& context);
ExitCode run_format(const Options& options, Context& context);
ExitCode run_explain(const Options& options, Context& context);
ExitCode run_help(const Options& options, Context& context);
ExitCode run_lsp(const Options& options, Context& context);
ExitCode run_info(const Options& options, Context& context);
ExitCode run_render(const Options& options, Context& context);
ExitCode run_view(const Options& options, Context& context);
ExitCode run_frames(const Options& options, Context& context);
ExitCode run_version(const Options& options, Context& context);

}  // namespace scenefile::app
