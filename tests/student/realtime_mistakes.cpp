// Asks find_realtime_causes() for the causes of pictures that a student's program for the
// assignment Realtime (student_gl.h) drew with known mistakes, and counts right, wrong and missing
// answers. The references come from the software rasterizer of the tests, which shares only the
// tessellation with the search.
//
//   scenefile_realtime_mistakes SCENES [--only WORD] [--habits] [--strange] [--unknown]
//                               [--per-mistake N] [--size WxH] [--pair OUT_FOLDER]
//  SCENES: a folder with the scenes named below. --habits: correct programs with harmless
// differences, for which no mistake may be named; --strange: mistakes of no known family, for which
// no mistake may be named; --unknown: the settings must be found as well; --pair: writes the
// pictures of docs/mistakes.md.

#include "scenefile/asset/image_file.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/grade/evidence.h"
#include "scenefile/grade/realtime_causes.h"
#include "scenefile/io/file.h"
#include "student/student_gl.h"
#include "support/load_scene.h"
#include "view/software_realtime.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace scenefile;

struct Row {
  const char* scene;
  RealtimeOptions panel;
};

const std::array rows{
    Row{"mixed", {{5, 5}, 0.1, 100, Filter::none, Milestone::action}},
    Row{"still-life", {{4, 7}, 0.1, 100, Filter::none, Milestone::action}},
    Row{"scaled", {{3, 6}, 0.1, 100, Filter::none, Milestone::lights_camera}},
    Row{"robot", {{2, 5}, 0.1, 100, Filter::none, Milestone::lights_camera}},
    Row{"spots", {{6, 8}, 0.1, 100, Filter::none, Milestone::action}},
    Row{"many-lights", {{5, 5}, 0.1, 100, Filter::blur, Milestone::action}},
    Row{"textures", {{5, 5}, 4, 8, Filter::none, Milestone::lights_camera}},
    Row{"heap", {{3, 4}, 0.1, 100, Filter::grayscale, Milestone::action}},
    Row{"bright", {{8, 10}, 0.1, 100, Filter::sharpen, Milestone::action}},
    Row{"mirrors", {{5, 6}, 0.1, 100, Filter::invert, Milestone::action}},
    Row{"mixed", {{6, 9}, 5, 8.5, Filter::none, Milestone::action}},
    Row{"scaled", {{5, 5}, 0.1, 100, Filter::blur, Milestone::lights_camera}},
};

// The pictures of docs/mistakes.md: cause, row, mistake.
struct Pair {
  const char* cause;
  std::size_t row;
  const char* mistake;
};
constexpr std::array pairs{
    Pair{"tessellation", 1, "parameters-7-9"}, Pair{"facets", 0, "flat"},
    Pair{"culling", 10, "no-culling"},         Pair{"clipping", 10, "planes-ignored"},
    Pair{"filter", 5, "blur-unnormalized"},    Pair{"viewport", 2, "viewport-points"},
};

struct Settings {
  std::string folder;
  std::string only;
  std::string wanted;  // family; empty: mistakes that must be named
  bool unknown = false;
  int per_mistake = 0;  // scenes per mistake; 0: all
  int width = 512;
  int height = 384;
  std::string pairs;
};

struct DrawnRow {
  Row row;
  testing_support::LoadedScene scene;
  Texture reference;
  Texture clean;  // of the student, without mistakes
};

student::RealtimeJob job_of(const Row& row, const Settings& settings) {
  student::RealtimeJob job;
  job.width = settings.width;
  job.height = settings.height;
  job.parameter1 = row.panel.tessellation.parameter1;
  job.parameter2 = row.panel.tessellation.parameter2;
  job.near = row.panel.near;
  job.far = row.panel.far;
  job.filter = std::string(word_of(row.panel.filter));
  job.action = row.panel.milestone == Milestone::action;
  return job;
}

double share_off(const Texture& a, const Texture& b) {
  const Pixels pixels = sorted_pixels(a, b);
  return double(pixels.off.size()) / (double(a.width) * a.height);
}

std::vector<std::string> split(std::string_view words) {
  std::vector<std::string> result;
  for (std::size_t start = 0; start < words.size();) {
    const std::size_t end = std::min(words.find('|', start), words.size());
    result.emplace_back(words.substr(start, end - start));
    start = end + 1;
  }
  return result;
}

struct Answer {
  std::string verdict;
  std::string said;
};

Answer judge(const student::KnownMistake& mistake, const CauseReport& report) {
  const std::vector<std::string> right = split(mistake.causes);
  const auto is_right = [&](const Claim& claim) {
    return std::find(right.begin(), right.end(), name_of(claim.cause)) != right.end() ||
           claim.cause == Cause::black;
  };
  std::vector<Claim> claims = report.claims;
  std::erase_if(claims, [](const Claim& c) { return c.cause == Cause::rounding; });
  Answer answer;
  for (const Claim& claim : claims) {
    answer.said += claim.what + " | ";
  }
  for (const Claim& claim : report.partial) {
    answer.said += "[in part: " + claim.what + "]";
  }
  const bool foreign = !std::all_of(claims.begin(), claims.end(), is_right);
  if (right.empty()) {
    answer.verdict = claims.empty() ? "right" : "wrong";
  } else if (claims.empty()) {
    answer.verdict = "silent";
  } else if (!foreign) {
    answer.verdict = "right";
  } else {
    answer.verdict =
        claims.size() == 1 && std::any_of(report.rivals.begin(), report.rivals.end(), is_right)
            ? "tie"
            : "wrong";
  }
  return answer;
}

int write_pairs(const Settings& settings, const std::vector<std::unique_ptr<DrawnRow>>& prepared) {
  for (const Pair& pair : pairs) {
    const DrawnRow& p = *prepared[pair.row];
    student::RealtimeJob job = job_of(p.row, settings);
    job.mistakes.insert(pair.mistake);
    const Texture wrong = student::draw_realtime(p.scene.ready.scene, job);
    const std::array<const Texture*, 2> both{&p.clean, &wrong};
    const std::string bytes =
        *encode_image(to_float(side_by_side(both)), ImageFormat::png8, Rounding::nearest);
    if (!write_file(settings.pairs + "/" + pair.cause + ".png", bytes)) {
      return 3;
    }
  }
  return 0;
}

bool parse(int count, char** words, Settings& settings) {
  for (int i = 1; i < count; ++i) {
    const std::string_view word(words[i]);
    const bool more = i + 1 < count;
    if (word == "--habits" || word == "--strange") {
      settings.wanted = std::string(word.substr(2));
    } else if (word == "--unknown") {
      settings.unknown = true;
    } else if (word == "--only" && more) {
      settings.only = words[++i];
    } else if (word == "--per-mistake" && more) {
      settings.per_mistake = std::atoi(words[++i]);
    } else if (word == "--pair" && more) {
      settings.pairs = words[++i];
    } else if (word == "--size" && more) {
      if (std::sscanf(words[++i], "%dx%d", &settings.width, &settings.height) != 2) {
        return false;
      }
    } else {
      settings.folder = word;
    }
  }
  return !settings.folder.empty();
}

}  // namespace

int main(int count, char** words) {
  Settings settings;
  if (!parse(count, words, settings)) {
    std::fprintf(stderr, "usage: scenefile_realtime_mistakes SCENES [options]\n");
    return 2;
  }
  std::vector<std::unique_ptr<DrawnRow>> prepared;
  for (const Row& row : rows) {
    auto p = std::make_unique<DrawnRow>(
        DrawnRow{row,
                 testing_support::load_scene(settings.folder + "/" + row.scene + ".xml", true),
                 {},
                 {}});
    if (!p->scene.error.empty()) {
      std::fprintf(stderr, "%s\n", p->scene.error.c_str());
      return 1;
    }
    p->reference = view_test::software_realtime(p->scene.ready.scene, row.panel, settings.width,
                                                settings.height)
                       .picture;
    p->clean = student::draw_realtime(p->scene.ready.scene, job_of(row, settings));
    std::printf("%2zu %-12s the student's picture differs in %.4f %% of the pixels\n",
                prepared.size(), row.scene, 100 * share_off(p->reference, p->clean));
    prepared.push_back(std::move(p));
  }
  if (!settings.pairs.empty()) {
    return write_pairs(settings, prepared);
  }
  std::map<std::string, std::map<std::string, int>> table;
  double slowest = 0;
  std::size_t index = 0;
  for (const student::KnownMistake& mistake : student::known_realtime_mistakes()) {
    const std::string family(mistake.family);
    const bool unnamed = family == "habits" || family == "strange";
    if ((settings.wanted.empty() ? unnamed : family != settings.wanted) ||
        mistake.name.find(settings.only) == std::string_view::npos) {
      continue;
    }
    int asked = 0;
    for (std::size_t k = 0; k < prepared.size(); ++k) {
      const std::size_t number = (index + k) % prepared.size();
      const DrawnRow& p = *prepared[number];
      student::RealtimeJob job = job_of(p.row, settings);
      job.mistakes.insert(std::string(mistake.name));
      const Texture test = student::draw_realtime(p.scene.ready.scene, job);
      if (family != "habits" && share_off(p.clean, test) < 0.002) {
        continue;
      }
      ++asked;
      const auto start = std::chrono::steady_clock::now();
      RealtimeView view{&p.scene.ready.scene, &p.scene.assets, &p.scene.written, p.row.panel,
                        &p.scene.ready.sources};
      if (settings.unknown) {
        view.panel = find_realtime_settings(p.reference, {view.scene, view.assets, nullptr, {}},
                                            {true, true, true, true, true});
      }
      const Answer answer = judge(mistake, find_realtime_causes(p.reference, test, view));
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      slowest = std::max(slowest, spent.count());
      ++table[family][answer.verdict];
      ++table["~ all"][answer.verdict];
      if (answer.verdict != "right" || !settings.only.empty()) {
        std::printf("%-7s %2zu %-12s %-26s %5.1f s  %s\n", answer.verdict.c_str(), number,
                    p.row.scene, std::string(mistake.name).c_str(), spent.count(),
                    answer.said.c_str());
        std::fflush(stdout);
      }
      if (settings.per_mistake > 0 && asked >= settings.per_mistake) {
        break;
      }
    }
    if (asked == 0) {
      std::printf("never visible: %s\n", std::string(mistake.name).c_str());
    }
    ++index;
  }
  std::printf("\n%-14s %6s %6s %6s %6s\n", "family", "right", "tie", "wrong", "silent");
  for (auto& [family, counts] : table) {
    std::printf("%-14s %6d %6d %6d %6d\n", family.c_str(), counts["right"], counts["tie"],
                counts["wrong"], counts["silent"]);
  }
  std::printf("slowest %.1f s\n", slowest);
  std::map<std::string, int>& all = table["~ all"];
  const int answers = all["right"] + all["tie"] + all["wrong"] + all["silent"];
  const double most_wrong = settings.wanted == "habits" ? 0 : 0.02 * answers;
  return answers == 0 || all["wrong"] > most_wrong ? 1 : 0;
}
