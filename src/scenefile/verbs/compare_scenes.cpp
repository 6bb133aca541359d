#include "scenefile/verbs/compare_scenes.h"

#include "scenefile/base/line_diff.h"
#include "scenefile/base/text.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/scene/flatten.h"
#include "scenefile/scene/node_path.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace scenefile {

namespace {

constexpr std::size_t context_lines = 3;

// Both scenes in the same format, and the lines that differ.
struct Listings {
  SceneListing a;
  SceneListing b;
  bool grouped = true;
  std::vector<LineChange> changes = {};

  bool exact() const { return a.exact && b.exact; }
  std::size_t changed_lines() const {
    std::size_t count = 0;
    for (const LineChange& change : changes) {
      count += change.removed + change.added;
    }
    return count;
  }
};

// In blocks that follow each other, added or removed lines may begin at any line; moves them up to
// where they are nested least, so that they are whole blocks.
void settle(Listings& listings) {
  std::size_t end = 0;  // of the change before, in a
  for (LineChange& change : listings.changes) {
    if (change.removed == 0 || change.added == 0) {
      const SceneListing& listing = change.removed == 0 ? listings.b : listings.a;
      const std::size_t first = change.removed == 0 ? change.b : change.a;
      const std::size_t count = change.removed + change.added;
      const auto depth = [&](std::size_t up) {
        return listing.lines[first - up].depth + listing.lines[first - up + count - 1].depth;
      };
      std::size_t best = 0;
      for (std::size_t up = 1;
           up <= change.a - end && listing.line(first - up) == listing.line(first - up + count);
           ++up) {
        best = depth(up) < depth(best) ? up : best;
      }
      change.a -= best;
      change.b -= best;
    }
    end = change.a + change.removed;
  }
}

std::vector<std::string_view> lines_of(const SceneListing& listing) {
  std::vector<std::string_view> lines;
  for (std::size_t i = 0; i < listing.lines.size(); ++i) {
    lines.push_back(listing.line(i));
  }
  return lines;
}

Listings compare_listings(SceneListing a, SceneListing b, bool grouped) {
  Listings listings{std::move(a), std::move(b), grouped};
  const std::vector<std::string_view> lines_a = lines_of(listings.a);
  const std::vector<std::string_view> lines_b = lines_of(listings.b);
  listings.changes =
      line_changes(lines_a.size(), lines_b.size(),
                   [&](std::size_t i, std::size_t j) { return lines_a[i] == lines_b[j]; });
  settle(listings);
  return listings;
}

bool is_json(const LoadedScene& scene) {
  const std::size_t first = scene.text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && (scene.text[first] == '{' || scene.text[first] == '[');
}

// The listings with the fewest lines that differ.
Listings shortest_listings(const LoadedScene& a, const LoadedScene& b) {
  const auto listed = [](const Scene& first, const Scene& second, SceneFormat format,
                         bool grouped) {
    return compare_listings(list_scene(first, format), list_scene(second, format), grouped);
  };
  Listings best = listed(a.written, b.written,
                         is_json(a) && is_json(b) ? SceneFormat::json : SceneFormat::xml, true);
  if (!best.exact()) {
    return listed(a.written, b.written, SceneFormat::json, true);
  }
  if (best.changed_lines() <= 4) {
    return best;
  }
  Spellings spellings;
  const std::optional<Scene> flat_a = flattened(a.written, spellings);
  const std::optional<Scene> flat_b = flattened(b.written, spellings);
  if (flat_a && flat_b) {
    Listings flat = listed(*flat_a, *flat_b, SceneFormat::xml, false);
    if (flat.exact() && !flat.changes.empty() && 2 * flat.changed_lines() < best.changed_lines()) {
      return flat;
    }
  }
  return best;
}

// Says where lines come from.
class Places {
 public:
  Places(const LoadedScene& scene, const SceneListing& listing, bool grouped)
      : name_(escaped(shown_name(scene.path), 4096)),
        listing_(listing),
        paths_(listing.form),
        grouped_(grouped) {}

  std::string where(std::size_t index) const {
    const ListedLine& line = listing_.lines[index];
    if (line.node == ListedLine::no_group) {
      return std::string(line.what);
    }
    std::string path = paths_.path(line.node);
    if (!grouped_) {
      path.resize(std::min(path.size(), path.find('/')));
    }
    path = escaped(path, 4096);
    return line.what.empty() ? path : fmt::format("{}: {}", path, line.what);
  }

  // "a.xml:41:9 ", or empty.
  std::string place_text(std::size_t index) const {
    const Location place = listing_.lines[index].place;
    return place.known() ? fmt::format("{}:{}:{} ", name_, place.line, place.column)
                         : std::string();
  }

 private:
  std::string name_;
  const SceneListing& listing_;
  NodePaths paths_;
  bool grouped_;
};

std::string joined(const SceneListing& listing, std::size_t first, std::size_t count) {
  std::string text;
  for (std::size_t i = first; i < first + count; ++i) {
    const std::size_t depth = listing.lines[i].depth;
    text.append(i == first ? 0 : 1, '\n');
    text.append(2 * (depth - std::min<std::size_t>(depth, listing.lines[first].depth)), ' ');
    text += listing.line(i);
  }
  return text;
}

void describe(const LoadedScene& a, const LoadedScene& b, const Listings& found, SceneDiff& diff) {
  const Places places_a(a, found.a, found.grouped);
  const Places places_b(b, found.b, found.grouped);
  const auto where = [&](const LineChange& change) {
    return change.removed != 0 ? places_a.where(change.a) : places_b.where(change.b);
  };
  for (const LineChange& change : found.changes) {
    diff.differences.push_back({where(change), joined(found.a, change.a, change.removed),
                                joined(found.b, change.b, change.added),
                                change.removed != 0 ? found.a.lines[change.a].place : Location(),
                                change.added != 0 ? found.b.lines[change.b].place : Location()});
  }
  for (const std::span<const LineChange> hunk : hunks_of(found.changes, context_lines)) {
    const LineChange& first = hunk.front();
    // Where nothing changes, the line before is shown.
    const auto place = [](const Places& places, std::size_t line, bool changes) {
      return places.place_text(changes || line == 0 ? line : line - 1);
    };
    diff.text += fmt::format("@@ {}{}@@ {}\n", place(places_a, first.a, first.removed != 0),
                             place(places_b, first.b, first.added != 0), where(first));
    visit_hunk(hunk, context_lines, found.a.lines.size(),
               [&](char mark, std::size_t i, std::size_t j) {
                 const SceneListing& listing = mark == '+' ? found.b : found.a;
                 const std::size_t line = mark == '+' ? j : i;
                 diff.text += mark;
                 diff.text.append(2 * std::size_t{listing.lines[line].depth}, ' ');
                 diff.text += listing.line(line);
                 diff.text += '\n';
               });
  }
}

std::string verdict_text(const std::string& a, const std::string& b, const SceneDiff& diff) {
  const std::string both =
      fmt::format("{} and {}", escaped(shown_name(a), 4096), escaped(shown_name(b), 4096));
  const std::size_t count = diff.differences.size();
  if (diff.same_meaning) {
    return both + (diff.equal ? ": no difference\n" : ": same meaning, written differently\n");
  }
  return fmt::format("{}: {}{}\n", both, counted(count + diff.left_out, "difference"),
                     diff.left_out == 0 ? "" : fmt::format(", the first {} above", count));
}

// With colors as by git.
std::string colored(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::string_view color = line.starts_with("@@")  ? "\033[36m"
                                   : line.starts_with("-") ? "\033[31m"
                                   : line.starts_with("+") ? "\033[32m"
                                                           : "";
    result += color;
    result += line;
    result += color.empty() ? "\n" : "\033[0m\n";
    text.remove_prefix(line.size() + 1);
  }
  return result;
}

// One scene's side of a difference; omitted if the object does not exist in the scene.
void add_side(Json& json, std::string_view name, const std::string& text, Location location) {
  if (text.empty()) {
    return;
  }
  json.begin_object(name);
  json.add("text", text);
  add_location(json, location);
  json.end_object();
}

}  // namespace

SceneDiff compare_scenes(const LoadedScene& a, const LoadedScene& b, std::size_t most) {
  SceneDiff diff;
  diff.equal = a.written == b.written;
  diff.same_meaning = diff.equal || same_meaning(a.written, b.written);
  if (!diff.same_meaning) {
    Listings found = shortest_listings(a, b);
    if (found.changes.size() > most) {
      diff.left_out = found.changes.size() - most;
      found.changes.resize(most);
    }
    diff.text = fmt::format("--- {}\n+++ {}\n", escaped(shown_name(a.path), 4096),
                            escaped(shown_name(b.path), 4096));
    describe(a, b, found, diff);
  }
  return diff;
}

std::string difference_text(const SceneDifference& difference) {
  std::string text = difference.where;
  for (const auto& [mark, lines] : {std::pair('-', &difference.a), std::pair('+', &difference.b)}) {
    std::string_view rest = *lines;
    while (!rest.empty()) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      text += fmt::format("\n{}{}", mark, line);
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    }
  }
  return text;
}

std::string compare_scenes_text(const LoadedScene& a, const LoadedScene& b, const SceneDiff& diff,
                                bool color) {
  return (color ? colored(diff.text) : diff.text) + verdict_text(a.path, b.path, diff);
}

std::string compare_scenes_json(const LoadedScene& a, const LoadedScene& b, const SceneDiff* diff,
                                const std::string& error) {
  Json json;
  begin_document(json, "diff");
  json.key("a");
  add_scene(json, a);
  json.key("b");
  add_scene(json, b);
  if (!error.empty()) {
    json.add("error", error);
  }
  if (diff != nullptr) {
    json.add({{"equal", diff->equal}, {"same_meaning", diff->same_meaning}});
    json.add_objects("differences", diff->differences, [&](const SceneDifference& difference) {
      json.add("where", difference.where);
      add_side(json, "a", difference.a, difference.in_a);
      add_side(json, "b", difference.b, difference.in_b);
    });
    if (diff->left_out != 0) {
      json.add("differences_left_out", diff->left_out);
    }
  }
  json.end_object();
  return json.text();
}

}  // namespace scenefile
