// Both engines draw our own scenes alike.

#include "view/build_scene.h"
#include "view/two_engines.h"

#include <gtest/gtest.h>

namespace scenefile {

namespace {

using namespace view_test;

class BothEngines : public Drawn {
 protected:
  void expect_alike(const std::string& name) {
    const testing_support::LoadedScene scene =
        testing_support::load_scene(std::string(SCENEFILE_SCENES) + "/" + name, false);
    ASSERT_EQ(scene.error, "");
    const Agreement agreement = two_engines(*device, scene, 640, 480);
    ASSERT_EQ(agreement.error, "");
    EXPECT_GE(agreement.whole_db, 32) << name;
    EXPECT_GE(agreement.inside_db, 40) << name;
  }
};

TEST_F(BothEngines, DrawHelloAlike) {
  expect_alike("hello.xml");
}

TEST_F(BothEngines, DrawTheShowcaseAlike) {
  expect_alike("showcase.xml");
}

}  // namespace

}  // namespace scenefile
