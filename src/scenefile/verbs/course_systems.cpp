// What course systems call the files of students.

#include "scenefile/base/ascii.h"
#include "scenefile/verbs/class_files.h"

#include <algorithm>
#include <charconv>

namespace scenefile {

namespace {

// Not with a leading zero, as in a date.
bool is_number(std::string_view text) {
  return !text.empty() && text.size() < 19 && text[0] != '0' &&
         std::all_of(text.begin(), text.end(), is_digit);
}

std::uint64_t number_of(std::string_view text) {
  std::uint64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = text.find('_');
    parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(text.size(), end == std::string_view::npos ? end : end + 1));
  }
  return parts;
}

// Whether two numbers begin a date, as in Screenshot_2024_11_12_x.png and
// IMG_20241112_134500_x.png.
bool is_date(std::string_view first, std::string_view second) {
  const bool year = first.starts_with("19") || first.starts_with("20");
  const std::string_view month = first.size() == 8 ? first.substr(4, 2) : second;
  return year && (first.size() == 4 || first.size() == 8) && number_of(month) <= 12;
}

// NAME_[LATE_]USER_FILE_ORIGINAL, or NAME_[LATE_]USER_text.html for what was typed. The first two
// numbers are the user and the file, as Canvas itself reads these names. Without names:
// anon, and five letters and digits for the user.
bool read_canvas(std::string_view name, CourseSystemName& result) {
  const std::vector<std::string_view> parts = split(name);
  std::size_t user = 1;
  if (parts.front() == "anon") {
    user = parts.size() > 1 && parts[1] == "LATE" ? 2 : 1;
  } else {
    while (user < parts.size() && !is_number(parts[user])) {
      ++user;
    }
  }
  if (user + 1 >= parts.size()) {
    return false;
  }
  const bool typed =
      user + 2 == parts.size() && (parts.back() == "text.html" || parts.back() == "link.html");
  if (!typed && (user + 2 >= parts.size() || !is_number(parts[user + 1]))) {
    return false;
  }
  const bool late = parts[user - 1] == "LATE";
  const std::size_t names = user - (late ? 1 : 0);
  const auto start = [&](std::size_t part) {
    return static_cast<std::size_t>(parts[part].data() - name.data());
  };
  if (names == 0 || start(names) < 2 || is_number(name.substr(0, start(names) - 1)) ||
      (!typed && is_date(parts[user], parts[user + 1]))) {
    return false;
  }
  result.name = name.substr(0, start(names) - 1);
  result.id = parts[user];
  result.late = late;
  result.student = result.name + "_" + result.id;
  if (!typed) {
    result.number = number_of(parts[user + 1]);
    result.original = name.substr(start(user + 2));
  }
  return typed || !result.original.empty();
}

// ASSIGNMENT_USER_attempt_2024-03-01-12-00-00[_ORIGINAL]; a text file has no original name. A user
// may contain an underscore: the caller compares with other files.
bool read_blackboard(std::string_view name, CourseSystemName& result) {
  constexpr std::string_view mark = "_attempt_";
  constexpr std::string_view form = "0000-00-00-00-00-00";
  const std::size_t at = name.find(mark);
  if (at == std::string_view::npos) {
    return false;
  }
  const std::string_view head = name.substr(0, at);
  const std::string_view date = name.substr(at + mark.size(), form.size());
  const std::string_view rest = name.substr(std::min(name.size(), at + mark.size() + form.size()));
  const bool dated = date.size() == form.size() &&
                     std::equal(date.begin(), date.end(), form.begin(),
                                [](char c, char f) { return f == '0' ? is_digit(c) : c == f; });
  const std::size_t user = head.rfind('_');
  if (!dated || user == std::string_view::npos || user + 1 == head.size() ||
      !(rest.empty() || rest[0] == '_' || rest[0] == '.')) {
    return false;
  }
  result.student = head;
  result.name = head.substr(user + 1);
  result.attempt = date;
  result.original = rest.starts_with('_') ? rest.substr(1) : "";
  return true;
}

// FULL NAME_NUMBER_assignsubmission_file_[ORIGINAL]
bool read_moodle(std::string_view name, CourseSystemName& result) {
  constexpr std::string_view mark = "_assignsubmission_";
  const std::size_t at = name.find(mark);
  if (at == std::string_view::npos) {
    return false;
  }
  const std::string_view head = name.substr(0, at);
  const std::size_t number = head.rfind('_');
  if (number == std::string_view::npos || number == 0 || !is_number(head.substr(number + 1))) {
    return false;
  }
  result.student = head;
  result.name = head.substr(0, number);
  result.id = head.substr(number + 1);
  const std::string_view rest = name.substr(at + mark.size());
  result.original = rest.substr(std::min(rest.size(), rest.find('_') + 1));
  return true;
}

// A YAML scalar: plain, or in quotes. Empty if it has other escapes than those of quotes.
std::string scalar(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \t\r");
  text = text.substr(0, end == std::string_view::npos ? 0 : end + 1);
  if (text.size() < 2 || (text[0] != '"' && text[0] != '\'') || text.back() != text[0]) {
    return std::string(text);
  }
  const char escape = text[0] == '"' ? '\\' : '\'';
  std::string value;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == escape) {
      ++i;
      if (i + 1 >= text.size() || (text[i] != text[0] && text[i] != escape)) {
        return {};
      }
    }
    value += text[i];
  }
  return value;
}

}  // namespace

bool read_course_system_name(std::string_view name, CourseSystemName& result) {
  result = {};
  return read_blackboard(name, result) || read_moodle(name, result) || read_canvas(name, result);
}

// Of the form that Gradescope writes: a key at the start of a line for each folder, and below
// ":submitters:" a list of ":name:".
std::map<std::string, std::string> read_gradescope_names(std::string_view text) {
  std::map<std::string, std::string> names;
  std::string folder;
  bool submitters = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const std::string_view content = line.substr(indent);
    if (indent == 0 && content.starts_with("submission_")) {
      folder = content.substr(0, content.find(':'));
      submitters = false;
    } else if (indent <= 2 && content.starts_with(":")) {
      submitters = content.starts_with(":submitters:");
    } else if (submitters && !folder.empty()) {
      std::string_view item = content;
      item.remove_prefix(item.starts_with("- ") ? 2 : 0);
      if (item.starts_with(":name: ")) {
        std::string& name = names[folder];
        const std::string person = scalar(item.substr(7));
        name += (name.empty() || person.empty() ? "" : ", ") + person;
      }
    }
  }
  std::erase_if(names, [](const auto& entry) { return entry.second.empty(); });
  return names;
}

}  // namespace scenefile
