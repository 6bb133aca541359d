// Visiting the fields of RenderOptions.

#include "scenefile/trace/visit_options.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace scenefile {

namespace {

// Changes a value of any type.
void change(bool& value) {
  value = !value;
}
void change(std::optional<PixelRegion>& value) {
  value = PixelRegion{1, 2, 3, 4};
}
void change(std::vector<Layer>& value) {
  value.push_back({LayerKind::light, 1});
}
template <typename T>
void change(T& value) {
  if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(1 - static_cast<int>(value));
  } else {
    value += 1;
  }
}

// Calls visit(field, value) for the members of nested structs instead of the structs.
template <typename Visit>
struct Leaves {
  Visit visit;
  template <typename T>
  void operator()(const OptionField& field, T& value) {
    if constexpr (std::is_same_v<T, Features>) {
      visit_options(value, *this);
    } else {
      visit(field, value);
    }
  }
};
template <typename Visit>
Leaves(Visit) -> Leaves<Visit>;

// The options with the n-th leaf changed, and its field; an empty name if there is none.
std::pair<RenderOptions, OptionField> with_changed(int n) {
  std::pair<RenderOptions, OptionField> result;
  visit_options(result.first, Leaves{[&](const OptionField& field, auto& value) {
                  if (n-- == 0) {
                    change(value);
                    result.second = field;
                  }
                }});
  return result;
}

TEST(Options, TheKeyDistinguishesPictures) {
  std::set<std::string> keys{picture_key({})};
  for (int n = 0;; ++n) {
    const auto [options, field] = with_changed(n);
    if (field.name.empty()) {
      EXPECT_GE(n, 20);
      break;
    }
    EXPECT_EQ(keys.insert(picture_key(options)).second, field.changes_pixels) << field.name;
  }
}

TEST(Options, TheKeyDistinguishesLayersAndRegions) {
  RenderOptions a;
  RenderOptions b;
  a.crop = {0, 0, 5, 5};
  b.crop = {0, 0, 5, 6};
  EXPECT_NE(picture_key(a), picture_key(b));
  b.crop = a.crop;
  EXPECT_EQ(picture_key(a), picture_key(b));
  a.layers = {{LayerKind::light, 0}};
  b.layers = {{LayerKind::light, 1}};
  EXPECT_NE(picture_key(a), picture_key(b));
}

TEST(Options, OnlyThreadsDoNotAffectThePicture) {
  const RenderOptions options;
  visit_options(options, [](const OptionField& field, const auto&) {
    EXPECT_EQ(field.changes_pixels, field.name != "threads") << field.name;
  });
}

TEST(Options, EnginesAndProfilesOfEachOption) {
  EXPECT_TRUE(supports_option(Engine::gl, support_of("samples")));
  EXPECT_FALSE(supports_option(Profile::course, support_of("samples")));
  EXPECT_FALSE(supports_option(Engine::gl, support_of("seed")));
  EXPECT_FALSE(supports_option(Engine::gl, support_of("min_samples")));
  EXPECT_FALSE(supports_option(Profile::course, support_of("min_samples")));
  EXPECT_TRUE(supports_option(Profile::course, support_of("max_depth")));
  EXPECT_TRUE(supports_option(Engine::gl, support_of("no such field")));
}

}  // namespace

}  // namespace scenefile
