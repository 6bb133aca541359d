// What `explain` says of a pixel when it knows what `diff` found, for pictures by the student's
// tracer.

#include "scenefile/asset/image_file.h"
#include "scenefile/trace/render.h"
#include "scenefile/verbs/explain.h"
#include "scenefile/verbs/load_file.h"
#include "student/student_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {
namespace {

constexpr int wide = 160;
constexpr int high = 120;

RenderOptions course_options() {
  RenderOptions options = default_options(Profile::course);
  options.width = wide;
  options.height = high;
  return options;
}

struct Homework {
  LoadedScene scene;
  Texture right;
  Texture mine;
};

Homework homework(const std::string& name, const std::string& mistake) {
  Homework h;
  h.scene =
      load_scene_file(std::string(SCENEFILE_SOURCE) + "/tests/student/scenes/" + name + ".xml");
  const RenderOptions options = course_options();
  h.right = quantize(render(h.scene.ready.scene, h.scene.assets, options).image,
                     rounding_of(options.profile));
  std::vector<std::string> names;
  for (const FileReference& file : h.scene.ready.scene.texture_files) {
    names.push_back(file.name);
  }
  student::Job job;
  job.width = wide;
  job.height = high;
  job.mistakes = {mistake};
  h.mine = student::draw(h.scene.written, h.scene.assets, names, job);
  return h;
}

// The answer for a pixel of `mine`; without one, for the pixel that diff shows.
struct Explained {
  ExplainReport report;
  glm::ivec2 pixel{0};
};

Explained explained(const Homework& h, const Texture& mine, std::optional<glm::ivec2> pixel = {}) {
  CompareSettings settings;
  settings.ways = possible_ways(std::array{course_options()}, false);
  if (!pixel) {
    const PictureComparison shown = compare_pictures(h.right, mine, nullptr, settings);
    EXPECT_TRUE(shown.where);
    pixel = shown.where ? glm::ivec2(shown.where->region.x, shown.where->region.y) : glm::ivec2(0);
  }
  settings.asked = pixel;
  PictureComparison found = compare_pictures(h.right, mine, &h.scene, settings);
  EXPECT_TRUE(found.asked);
  if (!found.asked) {
    return {};
  }
  RenderOptions options = found.drawn_options;
  options.width = found.asked_of.x;
  options.height = found.asked_of.y;
  Explained result{*explain_pixel(h.scene, options, found.asked->x, found.asked->y), *pixel};
  const std::uint8_t* const v = mine.texel(pixel->x, pixel->y);
  add_compared(h.scene, {v[0], v[1], v[2]}, std::move(found), result.report);
  return result;
}

struct CaseOfMistake {
  const char* scene;
  const char* mistake;
  bool drawn = true;  // whether a pixel can be drawn with it
};

class ExplainCompared : public testing::TestWithParam<CaseOfMistake> {};

TEST_P(ExplainCompared, AgreesWithDiff) {
  const auto& [name, mistake, drawn] = GetParam();
  const Homework h = homework(name, mistake);
  const ExplainReport report = explained(h, h.mine).report;
  ASSERT_TRUE(report.compared);
  const CauseReport& causes = report.compared->found.causes;
  ASSERT_FALSE(causes.claims.empty());
  const auto known = student::known_mistakes();
  const auto made = std::find_if(known.begin(), known.end(), [&mistake = mistake](const auto& one) {
    return one.name == mistake;
  });
  ASSERT_NE(made, known.end());
  EXPECT_NE(('|' + std::string(made->causes) + '|')
                .find('|' + std::string(name_of(causes.claims.front().cause)) + '|'),
            std::string::npos)
      << causes.claims.front().what;
  // One pixel names nothing else, and the text has the words of diff.
  EXPECT_TRUE(report.yours->fits.empty());
  const std::string text = explain_text(h.scene, report);
  EXPECT_NE(text.find(causes.claims.front().what), std::string::npos) << text;
  ASSERT_EQ(causes.asked.has_value(), drawn);
  if (drawn) {
    EXPECT_TRUE(report.compared->explained)
        << text << causes.asked->color.x << ' ' << causes.asked->color.y << ' '
        << causes.asked->color.z;
  }
  glm::dvec3 sum(0);
  glm::dvec3 ours(0);
  for (const TermWith& term : report.compared->terms) {
    sum += term.mistaken;
    ours += term.ours;
  }
  if (!report.compared->terms.empty()) {
    EXPECT_LT(glm::length(sum - causes.asked->color), 1) << text;
    EXPECT_LT(glm::length(ours - 255.0 * report.pixel.rays.front().sum), 1) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(StudentsMistakes, ExplainCompared,
                         testing::Values(CaseOfMistake{"mixed", "ambient-missing"},
                                         CaseOfMistake{"many-lights", "attenuation-none"},
                                         CaseOfMistake{"mirrors", "specular-blinn"},
                                         CaseOfMistake{"mixed", "shadow-none"},
                                         CaseOfMistake{"textures", "texture-flip-v"},
                                         CaseOfMistake{"mirrors", "mirror-color-ignored"},
                                         CaseOfMistake{"glass", "glass-eta-inverted"},
                                         CaseOfMistake{"heap", "hit-last"},
                                         CaseOfMistake{"robot", "transform-rotation-sign"},
                                         CaseOfMistake{"still-life", "output-upside-down"},
                                         CaseOfMistake{"still-life", "output-gamma"},
                                         CaseOfMistake{"still-life", "scene-moved-object"},
                                         CaseOfMistake{"mixed", "shadow-acne", false}),
                         [](const auto& info) {
                           std::string name = info.param.mistake;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ExplainCompared, SaysWhereTheMistakeIsNotAll) {
  Homework h = homework("mixed", "ambient-missing");
  const glm::ivec2 spot(80, 60);
  std::uint8_t* const rgb = &h.mine.rgb[std::size_t{3} * (spot.y * wide + spot.x)];
  rgb[1] = static_cast<std::uint8_t>(rgb[1] + 100);
  const ExplainReport report = explained(h, h.mine, spot).report;
  ASSERT_FALSE(report.compared->found.causes.claims.empty());
  EXPECT_FALSE(report.compared->explained);
  EXPECT_NE(explain_text(h.scene, report).find("which is not yours"), std::string::npos);
}

TEST(ExplainCompared, FindsThePixelOfAScreenshot) {
  const Homework h = homework("mixed", "specular-missing");
  const glm::ivec2 corner(37, 21);
  Texture screen{240, 190, std::vector<std::uint8_t>(std::size_t{3} * 240 * 190, 40)};
  for (int y = 0; y < high; ++y) {
    std::copy_n(h.mine.texel(0, y), 3 * wide,
                &screen.rgb[std::size_t{3} * ((y + corner.y) * screen.width + corner.x)]);
  }
  const Explained one = explained(h, screen);
  const PictureComparison& found = one.report.compared->found;
  EXPECT_EQ(*found.asked, one.pixel - corner);
  EXPECT_EQ(found.asked_of, glm::ivec2(wide, high));
  ASSERT_FALSE(found.causes.claims.empty());
  EXPECT_EQ(found.causes.claims.front().cause, Cause::specular);
  EXPECT_TRUE(one.report.compared->explained) << explain_text(h.scene, one.report);
  CompareSettings settings;
  settings.ways = possible_ways(std::array{course_options()}, false);
  settings.asked = glm::ivec2(3, 3);  // in the frame
  EXPECT_FALSE(compare_pictures(h.right, screen, &h.scene, settings).asked);
}

}  // namespace
}  // namespace scenefile
