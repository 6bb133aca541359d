// Numbers typed into the fields of the selection, in Dear ImGui without a screen.

#include "scenefile/viewer/gui.h"
#include "viewer/session_fixture.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

namespace scenefile::viewer {

namespace {

using ::testing::HasSubstr;

struct FieldsTest : testing::SessionFixture {
  FieldsTest() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {600, 600};
    io.DeltaTime = 1;  // two clicks are no double click
    io.IniFilename = nullptr;
    io.ConfigDragClickToInputText = true;
    io.Fonts->Build();
    session.settings.ray_tracing = false;
    settle();
  }
  ~FieldsTest() override { ImGui::DestroyContext(); }

  void frame() {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({600, 600});
    ImGui::Begin("fields");
    build_object(session);
    ImGui::End();
    ImGui::EndFrame();
  }
  void frames() {
    for (int i = 0; i < 3; ++i) {
      frame();
    }
  }
  void click_at(float x, float y) {
    ImGui::GetIO().MousePos = {x, y};
    for (const bool down : {false, true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      frames();
    }
  }
  void leave() { click_at(10, 590); }
  void type(const char* text) {
    ImGui::GetIO().AddInputCharactersUTF8(text);
    frames();
  }
  void select_label(const std::string& label) {
    const std::vector<OutlineRow>& rows = session.shown->outline.rows;
    for (std::uint32_t row = 0; row < rows.size(); ++row) {
      if (rows[row].label == label) {
        select(session, row);
      }
    }
    ASSERT_EQ(selected(), label);
  }
  // Starts to type into the first field at this x, from this y on.
  void start_typing(const std::string& label, float x, float from = 100) {
    select_label(label);
    frames();
    for (float y = from; y < 580; y += 6) {
      click_at(x, y);
      if (ImGui::GetIO().WantTextInput) {
        field_y = y;
        return;
      }
      leave();  // a list may have opened
    }
    FAIL() << "there is no field";
  }
  const std::string& text() const { return session.editing.text; }

  float field_y = 0;
};

constexpr float last_of_three = 500;

TEST_F(FieldsTest, ATypedNumberIsSavedAsItIs) {
  for (const auto& [typed, saved] :
       {std::pair("1234.567", "1234.567"), std::pair("12345678", "12345678"),
        std::pair("-0.1234567", "-0.1234567"), std::pair("2,5", "2.5")}) {
    start_typing("camera", last_of_three);
    type(typed);
    leave();
    EXPECT_THAT(text(), HasSubstr(fmt::format(R"(<pos x="0" y="0" z="{}"/>)", saved)));
    EXPECT_FALSE(session.notice) << typed;
    settle();
  }
  perform(session, Action::undo);
  EXPECT_THAT(text(), HasSubstr(R"(z="-0.1234567"/>)")) << "each number is one step";
}

TEST_F(FieldsTest, TypingStartsWithTheNumberOfTheFile) {
  rewrite(R"(z="6"/>)", R"(z="1234.5678"/>)");
  const std::string before = text();
  start_typing("camera", last_of_three);
  leave();
  EXPECT_EQ(text(), before);
  start_typing("camera", last_of_three);
  click_at(last_of_three + 70, field_y);  // after its last digit
  type("9");
  leave();
  EXPECT_THAT(text(), HasSubstr(R"(z="1234.56789"/>)"));
}

TEST_F(FieldsTest, AColorHasTheDigitsThatWereTyped) {
  start_typing("point light", last_of_three);
  leave();
  start_typing("point light", last_of_three, field_y + 20);  // the first one is its id
  type("0.123456");
  leave();
  EXPECT_THAT(text(), HasSubstr(R"(<color r="0" g="1" b="0.123456"/>)"));
}

TEST_F(FieldsTest, WhatIsNotANumberBringsTheOldValueBack) {
  for (const auto& [typed, why] :
       {std::pair("1/3", "not a number"), std::pair("1+2", "not a number"),
        std::pair("1e999", "too large"), std::pair("7 m", "not a number")}) {
    start_typing("camera", last_of_three);
    type(typed);
    EXPECT_FALSE(session.notice) << "the rest may follow";
    leave();
    EXPECT_EQ(text(), testing::scene_text) << typed;
    ASSERT_TRUE(session.notice) << typed;
    EXPECT_THAT(session.notice->text, HasSubstr(why));
    session.notice.reset();
  }
  EXPECT_TRUE(session.editing.done.empty());
  start_typing("camera", last_of_three);
  type("1/3");
  leave();
  start_typing("camera", last_of_three);
  type("7");
  EXPECT_FALSE(session.notice) << "about an earlier edit";
}

}  // namespace

}  // namespace scenefile::viewer
