#include "app/manual.h"

#include "app/command.h"
#include "app/option_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile::app {

namespace {

// Escapes text for man(7), where a backslash starts an escape, a hyphen may become a dash, and a
// point or an apostrophe at the start of a line makes it a request.
std::string plain(std::string_view text) {
  std::string result;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) {
      result += "\\&";
    }
    line_start = c == '\n';
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return result;
}

std::string page_start(std::string_view name, std::string_view summary) {
  return fmt::format(".TH {} 1 \"\" \"scenefile {}\" \"scenefile manual\"\n.SH NAME\n{} \\- {}\n",
                     plain(upper(name)), SCENEFILE_VERSION, plain(name), plain(summary));
}

std::string option_entry(const OptionRow& row) {
  return fmt::format(
      ".TP\n{}\\fB{}\\fR{}\n{}\n",
      row.letter.empty() ? "" : fmt::format("\\fB{}\\fR, ", plain(row.letter)), plain(row.name),
      row.value.empty() ? "" : fmt::format(" \\fI{}\\fR", plain(row.value)), plain(row.help));
}

constexpr std::string_view exit_status =
    ".SH EXIT STATUS\n"
    ".TP\n0\nSuccess; there may be warnings.\n"
    ".TP\n1\nErrors in the input, or differences were found.\n"
    ".TP\n2\nWrong usage.\n"
    ".TP\n3\nSomething cannot be read or written.\n"
    ".TP\n4\nA limit or the timeout was reached.\n"
    ".TP\n130, 143\nInterrupted by a signal.\n";

}  // namespace

std::string manual_page() {
  std::string page =
      page_start("scenefile", "read, check, explain, render, view and convert CS123 scene files");
  page +=
      ".SH SYNOPSIS\n\\fBscenefile\\fR \\fICOMMAND\\fR [\\fIARGUMENTS\\fR] [\\fIOPTIONS\\fR]\n"
      ".SH DESCRIPTION\n"
      "Scene files of the courses CS123 and CSCI1230 describe a camera, lights and a scene graph "
      "of "
      "simple shapes, in XML or JSON.\n"
      ".SH COMMANDS\n";
  for (const Command& command : commands()) {
    page += fmt::format(".TP\n\\fBscenefile {}\\fR {}\n{}. See \\fBscenefile\\-{}\\fR(1).\n",
                        plain(command.name), plain(command.arguments), plain(command.summary),
                        plain(command.name));
  }
  return page + std::string(exit_status) +
         ".SH ENVIRONMENT\n"
         ".TP\nCS123_DATA\nThe last folder that is searched for textures and meshes.\n"
         ".TP\nNO_COLOR\nMessages are not colored.\n";
}

std::string manual_page(const Command& command) {
  std::string page = page_start(fmt::format("scenefile-{}", command.name), command.summary);
  page += fmt::format(
      ".SH SYNOPSIS\n\\fBscenefile {}\\fR {} [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n{}\n.SH "
      "OPTIONS\n",
      plain(command.name), plain(command.arguments), plain(command.description));
  for (const OptionRow* row : options_of(command)) {
    page += option_entry(*row);
  }
  page += fmt::format(".SH EXAMPLES\n.nf\n{}\n.fi\n", plain(command.examples));
  return page + std::string(exit_status) + ".SH SEE ALSO\n\\fBscenefile\\fR(1)\n";
}

}  // namespace scenefile::app
