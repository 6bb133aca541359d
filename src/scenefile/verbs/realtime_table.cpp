#include "scenefile/verbs/realtime_table.h"

#include "scenefile/base/number.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace scenefile {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

// The cells of a line by the names of their columns; empty cells are left out.
using Cells = std::map<std::string_view, std::string_view>;

bool read_number(const Cells& cells, std::string_view column, double least, double most,
                 double& value) {
  const auto cell = cells.find(column);
  if (cell == cells.end()) {
    return true;
  }
  const ParsedNumber number = parse_number(cell->second);
  value = number.value;
  return number.error == NumberError::none && value >= least && value <= most;
}

template <typename T, std::size_t count>
bool read_word(const Cells& cells, std::string_view column,
               const std::array<std::string_view, count>& words, T& value) {
  const auto cell = cells.find(column);
  if (cell == cells.end()) {
    return true;
  }
  const auto found = std::find(words.begin(), words.end(), cell->second);
  value = static_cast<T>(found - words.begin());
  return found != words.end();
}

// Empty: success.
std::string read_row(const Cells& cells, RealtimeRow& row) {
  const auto cell = [&](std::string_view column) {
    const auto found = cells.find(column);
    return found == cells.end() ? std::string() : std::string(found->second);
  };
  row.scene = cell("scene");
  row.reference = cell("reference");
  RealtimeOptions& panel = row.panel;
  double p1 = panel.tessellation.parameter1;
  double p2 = panel.tessellation.parameter2;
  if (!read_number(cells, "parameter1", 1, max_tessellation, p1) ||
      !read_number(cells, "parameter2", 1, max_tessellation, p2)) {
    return fmt::format("parameter1 and parameter2 are numbers from 1 to {}", max_tessellation);
  }
  panel.tessellation = {static_cast<int>(p1), static_cast<int>(p2)};
  if (!read_number(cells, "near", 1e-9, 1e9, panel.near) ||
      !read_number(cells, "far", 1e-9, 1e9, panel.far) || panel.near >= panel.far) {
    return "near and far are depths above 0, near less than far";
  }
  if (!read_word(cells, "filter", filter_words, panel.filter)) {
    return fmt::format("unknown filter {}", escaped(cell("filter"), 80));
  }
  if (!read_word(cells, "assignment", milestone_words, panel.milestone)) {
    return fmt::format("unknown assignment {}", escaped(cell("assignment"), 80));
  }
  return {};
}

std::string path_of(const FoundFile& file) {
  std::string path;
  for (const std::string& folder : file.folders) {
    path += folder + "/";
  }
  return path + file.stem;
}

// Whether the file's path ends with this path, ignoring the extension.
bool is_at(const FoundFile& file, std::string_view path) {
  const std::size_t slash = path.rfind('/');
  const std::size_t point = path.rfind('.');
  if (point != std::string_view::npos && (slash == std::string_view::npos || point > slash)) {
    path = path.substr(0, point);
  }
  const std::string whole = path_of(file);
  return !path.empty() && (whole == path || whole.ends_with("/" + std::string(path)) ||
                           std::string(path).ends_with("/" + whole));
}

}  // namespace

std::vector<RealtimeRow> read_realtime_table(std::string_view text, std::string& wrong) {
  std::vector<RealtimeRow> table;
  std::vector<std::string_view> columns;
  std::size_t number = 0;
  for (std::string_view line : split(text, '\n')) {
    ++number;
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    if (line.empty()) {
      continue;
    }
    if (columns.empty()) {
      columns = split(line, '\t');
      if (std::find(columns.begin(), columns.end(), "parameter1") == columns.end() ||
          std::find(columns.begin(), columns.end(), "reference") == columns.end()) {
        return {};
      }
      continue;
    }
    Cells cells;
    const std::vector<std::string_view> values = split(line, '\t');
    for (std::size_t i = 0; i < std::min(values.size(), columns.size()); ++i) {
      if (!values[i].empty()) {
        cells[columns[i]] = values[i];
      }
    }
    RealtimeRow row;
    if (const std::string why = read_row(cells, row); !why.empty()) {
      wrong = fmt::format("line {}: {}", number, why);
      return {};
    }
    table.push_back(std::move(row));
  }
  return table;
}

const RealtimeRow* row_of(const std::vector<RealtimeRow>& table, const FoundFile& reference) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const RealtimeRow& row) {
    return is_at(reference, row.reference);
  });
  return found == table.end() ? nullptr : &*found;
}

int file_named(const std::vector<FoundFile>& files, std::string_view path) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const FoundFile& file) { return is_at(file, path); });
  return found == files.end() ? -1 : static_cast<int>(found - files.begin());
}

int scene_of_variant(const FoundFile& reference, const std::vector<FoundFile>& scenes) {
  int best = -1;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const std::string& stem = scenes[i].stem;
    if (stem.size() > longest && reference.stem.starts_with(stem + "_")) {
      longest = stem.size();
      best = static_cast<int>(i);
    }
  }
  return best;
}

}  // namespace scenefile
