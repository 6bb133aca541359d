#include "manifest.h"

#include "scenefile/base/number.h"
#include "scenefile/trace/features.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace scenefile::conformance {

namespace {

std::vector<std::string> split_tabs(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '\t');) {
    cells.push_back(cell);
  }
  return cells;
}

bool parse_mode(const std::string& word, Mode& mode) {
  if (word == "ray") {
    mode = Mode::ray;
  } else if (word == "intersect") {
    mode = Mode::intersect;
  } else if (word == "normals") {
    mode = Mode::normals;
  } else {
    return false;
  }
  return true;
}

std::vector<std::string> read_lines(const std::string& path, std::string& error) {
  std::ifstream file(path);
  if (!file) {
    error = path + ": cannot open";
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

std::vector<Row> read_references(const std::string& path, std::string& error) {
  std::vector<Row> rows;
  const std::vector<std::string> lines = read_lines(path, error);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::vector<std::string> cells = split_tabs(lines[i]);
    cells.resize(std::max<std::size_t>(cells.size(), 4));
    Row row{cells[0], cells[1], Mode::ray, {}};
    if (!parse_mode(cells[2], row.mode) || !parse_features(cells[3], row.features).empty()) {
      error = path + ":" + std::to_string(i + 1) + ": unknown mode or feature";
      return {};
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Exception> read_exceptions(const std::string& path, std::string& error) {
  std::vector<Exception> all;
  const std::vector<std::string> lines = read_lines(path, error);
  for (const std::string& line : lines) {
    if (line.empty() || line[0] == '#') {
      continue;
    }
    const std::vector<std::string> cells = split_tabs(line);
    if (cells.size() != 3 || parse_number(cells[1]).error != NumberError::none) {
      error = path + ": not three cells with a number in the second: " + line;
      return {};
    }
    all.push_back({cells[0], parse_number(cells[1]).value, cells[2]});
  }
  return all;
}

const Exception* find_exception(const std::vector<Exception>& all, const std::string& reference) {
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const Exception& e) { return reference.ends_with(e.reference); });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace scenefile::conformance
