// Edits in the window: each is one change of the text, is undone and redone, and is saved only when
// asked; nothing is lost without a question.

#include "scenefile/viewer/editing.h"

#include "viewer/session_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace scenefile::viewer {

namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct EditingTest : testing::SessionFixture {
  EditingTest() {
    session.settings.ray_tracing = false;
    settle();
  }

  void select_label(const std::string& label) {
    const std::vector<OutlineRow>& rows = session.shown->outline.rows;
    for (std::uint32_t row = 0; row < rows.size(); ++row) {
      if (rows[row].label == label) {
        select(session, row);
        return;
      }
    }
    FAIL() << label;
  }
  static FieldView field(const Document& document, ItemId item, std::string_view name) {
    for (const FieldView& view : document.fields(item)) {
      if (view.name == name) {
        return view;
      }
    }
    ADD_FAILURE() << name;
    return {};
  }
  FieldView field(std::string_view name) {
    const std::optional<ItemId> item = selected_item(session);
    EXPECT_TRUE(item.has_value()) << name;
    return field(*session.editing.document, item.value_or(0), name);
  }
  // As the panel's widgets do it.
  void drag_value(std::string_view name, std::size_t part, const std::string& value) {
    const EditInProgress* const edit = begin_edit(session, 1);
    ASSERT_NE(edit, nullptr);
    const FieldView view = field(edit->before, edit->item, name);
    continue_edit(session, set_value(edit->before, edit->item, view, part, value));
  }
  const std::string& text() const { return session.editing.text; }
  std::string file() const { return folder.read("a.xml"); }
  std::size_t shapes() const { return session.shown->opened.ready.sources.size(); }
  void answer(const std::string& label) {
    ASSERT_TRUE(session.question.has_value());
    for (std::size_t i = 0; i < session.question->answers.size(); ++i) {
      if (session.question->answers[i].label.starts_with(label)) {
        answer_question(session, i);
        return;
      }
    }
    FAIL() << label;
  }
  // Hold the handle where it is nearest to `share` of its line, and drag it.
  void drag_line(int number, double share, const glm::dvec2& by) {
    const std::optional<HandleSet> set = handles_of(session);
    ASSERT_TRUE(set.has_value());
    for (const HandleLine& line : handle_lines(session, *set)) {
      if (line.number == number) {
        const auto last = static_cast<double>(line.points.size() - 1);
        const glm::dvec2 from = line.points.size() == 2
                                    ? glm::mix(line.points[0], line.points[1], share)
                                    : line.points[static_cast<std::size_t>(share * last)];
        pointer_moved(session, from);
        pointer_pressed(session, 0, {});
        ASSERT_EQ(session.pointer.drag, Drag::handle);
        for (int i = 1; i <= 8; ++i) {
          pointer_moved(session, from + by * (i / 8.0));
          settle();
        }
        pointer_released(session);
        settle();
        return;
      }
    }
    FAIL() << "no handle " << number;
  }
};

// It takes as long as opening the scene.
TEST_F(EditingTest, ASceneIsReadForEditingOnceSomethingIsSelected) {
  EXPECT_FALSE(session.editing.document);
  select_label("cube");
  EXPECT_TRUE(selected_item(session));
  EXPECT_TRUE(session.editing.document);
}

TEST_F(EditingTest, ALongTextIsReadOnAnotherThread) {
  open_scene(session, folder.write("long.xml", testing::scene_text + "<!--" +
                                                   std::string(std::size_t{1} << 20, ' ') + "-->"));
  settle();
  select_label("sphere");
  EXPECT_FALSE(selected_item(session));
  perform(session, Action::duplicate);
  EXPECT_THAT(session.notice->text, HasSubstr("still being read"));
  settle();
  EXPECT_TRUE(selected_item(session));
  const std::size_t before = shapes();
  perform(session, Action::duplicate);
  settle();
  EXPECT_EQ(shapes(), before + 1);
  EXPECT_EQ(selected(), "sphere");
  EXPECT_GT(session.shown->outline.rows[*session.selected].location.line, 19U) << "the copy";
  drag_value("diffuse", 0, "0.5");
  EXPECT_TRUE(selected_item(session)) << "its fields are needed while they are dragged";
}

TEST_F(EditingTest, ADragIsOneStepAndShownAtOnce) {
  select_label("sphere");
  for (const char* const value : {"0.9", "0.5", "0.25"}) {
    drag_value("diffuse", 0, value);
    settle();
  }
  finish_edit(session);
  EXPECT_THAT(text(), HasSubstr(R"(<diffuse r="0.25" g="0" b="0"/>)"));
  EXPECT_NEAR(scene().materials[0].diffuse.r, 0.25, 1e-6);
  EXPECT_EQ(file(), testing::scene_text) << "not saved";
  EXPECT_TRUE(has_unsaved_edits(session));
  EXPECT_EQ(selected(), "sphere");
  perform(session, Action::undo);
  settle();
  EXPECT_EQ(text(), testing::scene_text);
  EXPECT_FALSE(has_unsaved_edits(session));
  EXPECT_NEAR(scene().materials[0].diffuse.r, 1, 1e-6);
  perform(session, Action::redo);
  EXPECT_THAT(text(), HasSubstr(R"(r="0.25")"));
  perform(session, Action::redo);
  EXPECT_THAT(session.notice->text, HasSubstr("nothing to redo"));
}

TEST_F(EditingTest, EscapeTakesBackADrag) {
  select_label("cube");
  drag_value("diffuse", 2, "0.7");
  perform(session, Action::escape);
  EXPECT_EQ(text(), testing::scene_text);
  EXPECT_TRUE(session.editing.done.empty());
  EXPECT_EQ(selected(), "cube");
}

TEST_F(EditingTest, AnotherFieldBeginsAnotherStep) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  const EditInProgress* const edit = begin_edit(session, 2);
  ASSERT_NE(edit, nullptr);
  continue_edit(session, set_value(edit->before, edit->item,
                                   field(edit->before, edit->item, "translate"), 1, "0.25"));
  finish_edit(session);
  EXPECT_EQ(session.editing.done.size(), 2U);
  EXPECT_THAT(text(), HasSubstr(R"(<diffuse r="0.5" g="0" b="0"/>)"));
  EXPECT_THAT(text(), HasSubstr(R"(<translate x="-1" y="0.25" z="0"/>)"));
}

TEST_F(EditingTest, AnEditEndsTheDragOfAHandle) {
  select_label("cube");
  const std::optional<HandleSet> set = handles_of(session);
  ASSERT_TRUE(set.has_value());
  pointer_moved(session, handle_lines(session, *set).front().points.back());
  pointer_pressed(session, 0, {});
  pointer_moved(session, session.pointer.at + glm::dvec2(20, 0));
  perform(session, Action::remove);
  const std::string removed = text();
  EXPECT_THAT(removed, Not(HasSubstr("cube")));
  pointer_moved(session, session.pointer.at + glm::dvec2(20, 0));
  pointer_released(session);
  settle();
  EXPECT_EQ(text(), removed);
}

TEST_F(EditingTest, UndoSelectsWhatWasSelected) {
  select_label("cube");
  perform(session, Action::remove);
  settle();
  EXPECT_NE(selected(), "cube");
  perform(session, Action::undo);
  settle();
  EXPECT_EQ(selected(), "cube");
  perform(session, Action::duplicate);
  settle();
  perform(session, Action::undo);
  settle();
  EXPECT_EQ(selected(), "cube");
  EXPECT_TRUE(selected_item(session).has_value());
}

TEST_F(EditingTest, TheSelectionFollowsTheEdit) {
  const std::size_t before = shapes();
  select_label("sphere");
  perform(session, Action::duplicate);
  settle();
  EXPECT_EQ(shapes(), before + 1);
  EXPECT_EQ(selected(), "sphere");
  EXPECT_GT(session.shown->outline.rows[*session.selected].location.line, 19U) << "the copy";
  perform(session, Action::later);
  settle();
  const std::size_t cube = text().find("cube");
  EXPECT_GT(text().rfind("sphere"), cube) << "the copy is after the cube";
  perform(session, Action::remove);
  settle();
  perform(session, Action::undo);
  perform(session, Action::undo);
  perform(session, Action::undo);
  settle();
  EXPECT_EQ(text(), testing::scene_text);
}

TEST_F(EditingTest, WhatCannotBeDoneIsSaid) {
  perform(session, Action::duplicate);
  EXPECT_THAT(session.notice->text, HasSubstr("nothing is selected"));
  select_label("camera");
  perform(session, Action::remove);
  EXPECT_TRUE(session.notice->bad);
  EXPECT_EQ(text(), testing::scene_text);
  perform(session, Action::undo);
  EXPECT_THAT(session.notice->text, HasSubstr("nothing to undo"));
  perform(session, Action::remove);
  select_label("cube");
  perform(session, Action::remove);
  EXPECT_FALSE(session.notice.has_value()) << "it was about an earlier edit";
}

TEST_F(EditingTest, GlobalDataAndAnUnwrittenCameraHaveFields) {
  select_label("global data");
  drag_value("ambientcoeff", 0, "0.3");
  finish_edit(session);
  settle();
  EXPECT_NEAR(scene().global.ambient, 0.3, 1e-6);
  const std::size_t from = text().find("<cameradata>");
  const std::size_t to = text().find("<lightdata>");
  folder.write("b.xml", text().substr(0, from) + text().substr(to));
  perform(session, Action::save);
  open_scene(session, folder.path("b.xml"));
  settle();
  select_label("camera");
  EXPECT_FALSE(field("pos").written);
}

TEST_F(EditingTest, TheViewBecomesTheCamera) {
  perform(session, Action::use_view);
  EXPECT_THAT(session.notice->text, HasSubstr("already"));
  wheel_turned(session, 2);
  const double z = session.camera.position.z;
  perform(session, Action::use_view);
  settle();
  EXPECT_NEAR(session.shown->opened.camera().position.z, z, 1e-5);
  EXPECT_THAT(text(), HasSubstr("<!-- in front -->"));
  EXPECT_EQ(session.camera, session.home);
  perform(session, Action::save);
  EXPECT_EQ(file(), text());
  EXPECT_FALSE(has_unsaved_edits(session));
  settle();
  EXPECT_FALSE(session.question.has_value()) << "the window's own change of the file";
  perform(session, Action::undo);
  settle();
  EXPECT_TRUE(has_unsaved_edits(session)) << "the file has the new camera";
  EXPECT_EQ(text(), testing::scene_text);
}

TEST_F(EditingTest, AFileThatChangedIsNotOverwrittenWithoutAQuestion) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  finish_edit(session);
  folder.write("a.xml", testing::scene_text + "<!-- an hour of work -->");
  perform(session, Action::save);
  ASSERT_TRUE(session.question.has_value());
  perform(session, Action::escape);
  EXPECT_FALSE(session.question.has_value());
  EXPECT_THAT(file(), HasSubstr("an hour of work"));
  settle();
  ASSERT_TRUE(session.question.has_value()) << "the change was seen";
  answer("Keep my edits");
  perform(session, Action::save);
  EXPECT_THAT(file(), HasSubstr(R"(r="0.5")"));
  EXPECT_THAT(file(), Not(HasSubstr("an hour of work")));
}

TEST_F(EditingTest, AChangedFileReplacesTheEditsIfWanted) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  finish_edit(session);
  settle();
  folder.write("a.xml", testing::scene_text + "<!-- an hour of work -->");
  settle();
  answer("Read it");
  settle();
  EXPECT_EQ(text(), file());
  EXPECT_FALSE(has_unsaved_edits(session));
  EXPECT_NEAR(scene().materials[0].diffuse.r, 1, 1e-6);
  perform(session, Action::undo);
  settle();
  EXPECT_NEAR(scene().materials[0].diffuse.r, 0.5, 1e-6) << "the edits come back";
  EXPECT_TRUE(has_unsaved_edits(session));
}

TEST_F(EditingTest, EditsBeforeAChangeOfTheFileCanStillBeUndone) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  perform(session, Action::save);
  settle();
  const std::string before = file();
  rewrite("in front", "far in front");
  EXPECT_EQ(text(), file());
  perform(session, Action::undo);
  EXPECT_EQ(text(), before);
  perform(session, Action::undo);
  EXPECT_EQ(text(), testing::scene_text);
  EXPECT_TRUE(has_unsaved_edits(session));
  perform(session, Action::redo);
  perform(session, Action::redo);
  EXPECT_EQ(text(), file());
  EXPECT_FALSE(has_unsaved_edits(session));
}

TEST_F(EditingTest, AFileThatWasEmptyForAMomentIsTwoSteps) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  perform(session, Action::save);
  settle();
  const std::string before = file();
  folder.write("a.xml", "");
  settle();
  folder.write("a.xml", testing::scene_text + "<!-- rewritten -->");
  settle();
  EXPECT_EQ(text(), file());
  EXPECT_FALSE(has_unsaved_edits(session));
  for (const std::string& earlier : {std::string(), before, testing::scene_text}) {
    perform(session, Action::undo);
    EXPECT_EQ(text(), earlier);
  }
}

TEST_F(EditingTest, ADeletedFileIsSavedAgain) {
  std::filesystem::remove(path);
  settle();
  EXPECT_FALSE(has_unsaved_edits(session));
  perform(session, Action::quit);
  EXPECT_FALSE(session.quit);
  ASSERT_TRUE(session.question.has_value());
  EXPECT_THAT(session.question->text, HasSubstr("a.xml no longer exists"));
  answer("Cancel");
  perform(session, Action::save);
  EXPECT_EQ(file(), testing::scene_text);
  perform(session, Action::quit);
  EXPECT_TRUE(session.quit);
  session.quit = false;
  std::filesystem::remove(path);
  perform(session, Action::quit);
  answer("Discard");
  EXPECT_TRUE(session.quit);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(EditingTest, TheSceneOnShowDoesNotChangeTheFileWithErrors) {
  const std::string broken = testing::scene_text + "<difuse/>";
  select_label("sphere");
  open_scene(session, folder.write("b.xml", broken));
  settle();
  ASSERT_NE(session.broken, nullptr);
  wheel_turned(session, 2);
  for (const Action action : {Action::use_view, Action::collect_view, Action::drop_view,
                              Action::add, Action::duplicate, Action::remove, Action::wrap}) {
    session.notice.reset();
    perform(session, action);
    ASSERT_TRUE(session.notice.has_value());
    EXPECT_EQ(session.notice->text, "the picture still shows a.xml, not b.xml");
    EXPECT_EQ(text(), broken);
  }
  EXPECT_EQ(refusal_to_edit(session), session.notice->text) << "for the panel";
  EXPECT_FALSE(session.adding);
  EXPECT_FALSE(std::filesystem::exists("b-views.json"));
}

TEST_F(EditingTest, ALaterVersionWithErrorsCanBeEdited) {
  select_label("sphere");
  rewrite("<diffuse", "<difuse");
  ASSERT_NE(session.broken, nullptr);
  perform(session, Action::remove);
  EXPECT_THAT(session.notice->text, HasSubstr("not in the text"));
  wheel_turned(session, 2);
  const std::string before = text();
  perform(session, Action::use_view);
  EXPECT_NE(text(), before);
}

TEST_F(EditingTest, TheCopyOfATransblockIsSelectedAsOne) {
  select_label("sphere");
  const std::uint32_t block = session.shown->outline.rows[*session.selected].parent;
  select(session, block);
  perform(session, Action::duplicate);
  settle();
  ASSERT_TRUE(session.selected.has_value());
  EXPECT_NE(session.selected, block);
  EXPECT_EQ(session.shown->outline.rows[*session.selected].kind, RowKind::group);
}

TEST_F(EditingTest, ObjectsEnterAndLeaveGroupsByKeys) {
  select_label("sphere");
  perform(session, Action::enter_group);
  EXPECT_EQ(text(), testing::scene_text) << "there is no group";
  EXPECT_THAT(session.notice->text, HasSubstr("Ctrl+G makes one"));
  for (const char* const never : {"point light", "camera"}) {
    select_label(never);
    perform(session, Action::enter_group);
    EXPECT_THAT(session.notice->text, HasSubstr("only objects")) << never;
    EXPECT_TRUE(session.notice->bad);
  }
  select_label("sphere");
  perform(session, Action::wrap);
  settle();
  select_label("cube");
  perform(session, Action::enter_group);
  settle();
  EXPECT_EQ(selected(), "cube");
  const std::string inside = text();
  EXPECT_NE(inside, testing::scene_text);
  perform(session, Action::leave_group);
  settle();
  EXPECT_EQ(selected(), "cube");
  EXPECT_NE(text(), inside);
  perform(session, Action::undo);
  EXPECT_EQ(text(), inside);
}

TEST_F(EditingTest, QuittingGoesOnAfterAConflict) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  perform(session, Action::quit);
  folder.write("a.xml", testing::scene_text + "<!-- an hour of work -->");
  answer("Save");
  EXPECT_FALSE(session.quit) << "the file has changed";
  answer("Cancel");
  EXPECT_FALSE(session.quit);
  perform(session, Action::quit);
  answer("Save");
  answer("Replace its changes by mine");
  EXPECT_TRUE(session.quit);
  EXPECT_THAT(file(), HasSubstr(R"(r="0.5")"));
}

TEST_F(EditingTest, AChangeOfTheFileDoesNotReplaceTheQuestionBeforeQuitting) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  perform(session, Action::quit);
  folder.write("a.xml", testing::scene_text + "<!-- an hour of work -->");
  settle();
  answer("Decide when I save");
  EXPECT_FALSE(session.quit);
  answer("Discard");
  EXPECT_TRUE(session.quit);
  EXPECT_THAT(file(), HasSubstr("an hour of work"));
}

TEST_F(EditingTest, ReadingTheChangedFileBeforeQuittingDoesNotQuit) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  perform(session, Action::quit);
  folder.write("a.xml", testing::scene_text + "<!-- an hour of work -->");
  answer("Save");
  answer("Read it");
  EXPECT_FALSE(session.quit) << "the edits would be lost";
  settle();
  EXPECT_EQ(text(), file());
  perform(session, Action::undo);
  EXPECT_THAT(text(), HasSubstr(R"(r="0.5")"));
}

TEST_F(EditingTest, ALightThatGetsItsTypeBackGetsItsPositionBack) {
  select_label("point light");
  const auto set_type = [&](const std::string& type) {
    const EditInProgress* const edit = begin_edit(session, 1);
    ASSERT_NE(edit, nullptr);
    const FieldView view = field(edit->before, edit->item, "type");
    const std::vector<std::optional<std::string>> typed{type};
    continue_edit(session, edit_of_field(session, edit->before, edit->item, view, typed));
    finish_edit(session);
    settle();
  };
  set_type("directional");
  EXPECT_THAT(text(), Not(HasSubstr("<position")));
  set_type("spot");
  EXPECT_THAT(text(), HasSubstr(R"(<position x="0" y="3" z="3"/>)"));
  set_type("point");
  EXPECT_THAT(text(), HasSubstr(R"(<position x="0" y="3" z="3"/>)"));
  for (int i = 0; i < 3; ++i) {
    perform(session, Action::undo);
  }
  EXPECT_EQ(text(), testing::scene_text);
}

TEST_F(EditingTest, AFailureToSaveNamesAnotherWay) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  finish_edit(session);
  session.path = folder.path("none/a.xml");
  perform(session, Action::save);
  EXPECT_THAT(session.notice->text, HasSubstr("Ctrl+Shift+S saves it elsewhere"));
}

TEST_F(EditingTest, NothingIsLostWithoutAQuestion) {
  const std::string other = folder.write("b.xml", testing::scene_text);
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  open_scene(session, other);
  ASSERT_TRUE(session.question.has_value());
  EXPECT_EQ(session.path, path);
  EXPECT_TRUE(key_pressed(session, {"R"})) << "keys belong to the question";
  EXPECT_FALSE(session.settings.ray_tracing);
  key_pressed(session, {"Escape"});
  EXPECT_EQ(session.path, path);
  perform(session, Action::quit);
  EXPECT_FALSE(session.quit);
  key_pressed(session, {"1"});
  EXPECT_TRUE(session.question.has_value()) << "a digit alone may be meant for a field";
  key_pressed(session, {"1", true});
  EXPECT_TRUE(session.quit);
  EXPECT_THAT(file(), HasSubstr(R"(r="0.5")"));
  session.quit = false;
  perform(session, Action::quit);
  EXPECT_TRUE(session.quit) << "all is saved";
  drag_value("diffuse", 0, "0.75");
  open_scene(session, other);
  answer("Discard");
  settle();
  EXPECT_EQ(session.path, other);
  EXPECT_THAT(file(), HasSubstr(R"(r="0.5")"));
}

TEST_F(EditingTest, SavesUnderAnotherName) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  const std::string other = folder.write("b.xml", "someone's");
  perform(session, Action::save_as);
  session.question->path = other;
  answer("Save");
  ASSERT_TRUE(session.question.has_value()) << "it exists";
  answer("Cancel");
  EXPECT_EQ(folder.read("b.xml"), "someone's");
  for (const char* const wrong : {"c.png", "c.json", "none/c.xml"}) {
    perform(session, Action::save_as);
    session.question->path = folder.path(wrong);
    answer("Save");
    ASSERT_TRUE(session.question.has_value()) << "it can be mended";
    EXPECT_EQ(session.question->path, folder.path(wrong));
    answer("Cancel");
    EXPECT_FALSE(std::filesystem::exists(folder.path(wrong)));
  }
  session.open_rows = {*session.selected};
  const ViewCamera camera = zoomed(session.camera, 2, {0, 0, 0});
  set_camera(session, camera);
  perform(session, Action::save_as);
  session.question->path = folder.path("c.xml");
  answer("Save");
  settle();
  EXPECT_EQ(session.path, folder.path("c.xml"));
  EXPECT_EQ(session.shown->opened.path, session.path);
  EXPECT_EQ(selected(), "sphere");
  EXPECT_EQ(session.open_rows, (std::set<std::uint32_t>{*session.selected}));
  EXPECT_EQ(session.camera, camera);
  EXPECT_THAT(folder.read("c.xml"), HasSubstr(R"(r="0.5")"));
  EXPECT_EQ(file(), testing::scene_text);
  EXPECT_FALSE(has_unsaved_edits(session));
}

TEST_F(EditingTest, ANewSceneIsCreatedWhenItIsSaved) {
  for (const char* const name : {"new.xml", "new.json"}) {
    const std::string created = folder.path(name);
    new_scene(session, created);
    settle();
    EXPECT_EQ(session.shown->opened.path, created);
    EXPECT_TRUE(session.shown->opened.diagnostics.list().empty()) << name;
    EXPECT_TRUE(has_unsaved_edits(session));
    EXPECT_FALSE(std::filesystem::exists(created));
    perform(session, Action::save);
    EXPECT_FALSE(has_unsaved_edits(session));
    EXPECT_EQ(folder.read(name), text());
    settle();
  }
}

TEST_F(EditingTest, ANewSceneStaysWhileAPictureChanges) {
  new_scene(session, folder.path("new.xml"));
  open_picture(session, write_picture("mine.png", 40, 30), Role::mine);
  settle_files();
  write_picture("mine.png", 20, 15);
  settle_files();
  EXPECT_EQ(session.mine.decoded->texture.width, 20);
  EXPECT_EQ(session.broken, nullptr);
  EXPECT_TRUE(session.editing.new_file);
}

TEST_F(EditingTest, ANewSceneWithoutANameAsksForOne) {
  new_scene(session, folder.path("scene.xml"), true);
  settle();
  perform(session, Action::save);
  ASSERT_TRUE(session.question.has_value());
  EXPECT_FALSE(std::filesystem::exists(folder.path("scene.xml")));
  session.question->path = folder.path("a.xml");
  answer("Save");
  answer("Cancel");
  perform(session, Action::save);
  ASSERT_TRUE(session.question.has_value()) << "asks again";
  session.question->path = folder.path("mine.xml");
  answer("Save");
  EXPECT_EQ(folder.read("mine.xml"), text());
  settle();
  select_label("cube");
  drag_value("diffuse", 0, "0.25");
  perform(session, Action::save);
  EXPECT_FALSE(session.question.has_value());
  EXPECT_EQ(folder.read("mine.xml"), text());
}

TEST_F(EditingTest, EditsThatBreakTheSceneAreUndone) {
  select_label("sphere");
  drag_value("diffuse", 0, "0.5");
  make_edit(session, Edit{{{0, 1, "<scenefile><"}}, {}});
  settle();
  EXPECT_NE(session.broken, nullptr);
  perform(session, Action::undo);
  settle();
  EXPECT_EQ(session.broken, nullptr);
  EXPECT_NEAR(scene().materials[0].diffuse.r, 0.5, 1e-6);
}

TEST_F(EditingTest, CertainMistakesAreCorrected) {
  perform(session, Action::correct);
  EXPECT_THAT(session.notice->text, HasSubstr("nothing to correct"));
  std::string broken = testing::scene_text;
  for (const char* const name : {"diffuse r=\"1\"", "heightangle"}) {
    broken.insert(broken.find(name) + 1, "x");
  }
  open_scene(session, folder.write("b.xml", broken));
  settle();
  ASSERT_NE(session.broken, nullptr);
  perform(session, Action::correct);
  settle();
  EXPECT_EQ(session.broken, nullptr);
  EXPECT_EQ(text(), testing::scene_text);
  EXPECT_THAT(session.notice->text, HasSubstr("corrected 2 mistakes"));
  EXPECT_EQ(folder.read("b.xml"), broken) << "not saved";
  perform(session, Action::undo);
  settle();
  EXPECT_EQ(text(), broken);
}

TEST_F(EditingTest, HandlesMoveAlongOneAxis) {
  select_label("cube");
  drag_line(0, 0.9, {40, 17});
  EXPECT_EQ(field("translate").parts[1].value, "0");
  const double x = std::stod(field("translate").parts[0].value);
  // At z = 0 the picture is 4.97 high: 40 of 300 pixels are 0.66.
  EXPECT_NEAR(x, 1.66, 0.02);
  EXPECT_LE(field("translate").parts[0].value.size(), 4U) << "a short number";
  perform(session, Action::undo);
  EXPECT_EQ(text(), testing::scene_text) << "one step";
}

TEST_F(EditingTest, HandlesMoveInThePlaneOfThePicture) {
  select_label("sphere");
  drag_line(3, 0, {-30, 60});
  EXPECT_NEAR(std::stod(field("translate").parts[0].value), -1.5, 0.02);
  EXPECT_NEAR(std::stod(field("translate").parts[1].value), -0.99, 0.02);
}

TEST_F(EditingTest, HandlesTurnAndScale) {
  select_label("cube");
  perform(session, Action::handles);
  ASSERT_EQ(session.handles, Handles::turn);
  set_camera(session, moved(session.camera, {0, 0.01, 0}));
  // The ring about z is seen from the front; half of it is drawn.
  const std::optional<HandleSet> set = handles_of(session);
  ASSERT_TRUE(set.has_value());
  const glm::dvec2 middle = *point_in_window(session, set->at);
  for (const HandleLine& line : handle_lines(session, *set)) {
    if (line.number == 2) {
      const glm::dvec2 from = line.points[8] - middle;
      const double angle = glm::radians(-30.0);  // the window's y points down
      const glm::dvec2 to{from.x * std::cos(angle) - from.y * std::sin(angle),
                          from.x * std::sin(angle) + from.y * std::cos(angle)};
      drag_line(2, 8.0 / 24, to - from);
    }
  }
  EXPECT_EQ(field("rotate").parts[2].value, "1");
  EXPECT_EQ(field("rotate").parts[3].value, "30");
  perform(session, Action::undo);
  perform(session, Action::handles);
  drag_line(1, 1, {0, -85});
  EXPECT_NEAR(std::stod(field("scale").parts[1].value), 2, 0.05);
  EXPECT_EQ(field("scale").parts[0].value, "1");
  perform(session, Action::handles);
  EXPECT_FALSE(handles_of(session).has_value());
}

TEST_F(EditingTest, HandlesOfLightsAndTheCamera) {
  select_label("directional light");
  EXPECT_FALSE(handles_of(session).has_value()) << "it has no position";
  session.handles = Handles::turn;
  ASSERT_TRUE(handles_of(session).has_value());
  drag_line(2, 0.4, {0, -40});
  EXPECT_NE(field("direction").parts[0].value, "-1");
  EXPECT_EQ(field("direction").parts[2].value, "-1") << "it turned about z";
  session.handles = Handles::move;
  select_label("point light");
  drag_line(0, 0.9, {20, 0});
  EXPECT_GT(std::stod(field("position").parts[0].value), 0.1);
  select_label("camera");
  EXPECT_FALSE(handles_of(session).has_value()) << "the eye is there";
  set_camera(session, zoomed(session.camera, 3, {0, 0, 0}));
  set_camera(session, orbited(session.camera, 40, 20));
  drag_line(1, 0.9, {0, -20});
  EXPECT_GT(session.shown->opened.camera().position.y, 0.2);
  EXPECT_EQ(session.shown->opened.camera().position.z, 6);
}

TEST_F(EditingTest, HandlesOfTheConeOfASpotLight) {
  rewrite(R"(<type v="point"/><position x="0" y="3" z="3"/>)",
          R"(<type v="spot"/><position x="0" y="3" z="0"/><direction x="0" y="-2" z="0"/>)"
          R"(<angle v="30"/><penumbra v="0"/>)");
  const std::string before = text();
  select_label("spot light");
  set_camera(session, zoomed(session.camera, 2, {0, 0, 0}));
  const auto number = [&](std::string_view name) {
    return std::stod(field(std::string(name)).parts[0].value);
  };
  for (const Handles kind : {Handles::move, Handles::turn, Handles::scale}) {
    session.handles = kind;
    // The first quarter of a ring goes from the front to the left.
    drag_line(4, 1, {-30, 0});
    EXPECT_GT(number("angle"), 33);
    EXPECT_LT(number("angle"), 50);
    EXPECT_EQ(number("penumbra"), 0);
    EXPECT_NEAR(scene().lights[1].outer_angle, glm::radians(number("angle")), 1e-4);
    const double angle = number("angle");
    drag_line(5, 1, {20, 0});
    EXPECT_GT(number("penumbra"), 2);
    EXPECT_LT(number("penumbra"), 15);
    EXPECT_EQ(number("angle"), angle);
    // The outer edge cannot be within the inner one, nor the inner one outside.
    drag_line(5, 1, {-60, 0});
    EXPECT_EQ(number("penumbra"), 0);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NE(text(), before);
      perform(session, Action::undo);
      settle();
    }
    EXPECT_EQ(text(), before) << "each drag is one step";
  }
  session.handles = Handles::none;
  EXPECT_FALSE(handles_of(session).has_value());
}

TEST_F(EditingTest, TheConeOfAJsonLightHasHandles) {
  open_scene(session, folder.write("spot.json", R"({
  "globalData": {"ambientCoeff": 0.5, "diffuseCoeff": 0.5, "specularCoeff": 0.5},
  "cameraData": {"position": [0, 0, 12], "look": [0, 0, -1], "up": [0, 1, 0], "heightAngle": 45},
  "groups": [
    {"translate": [0, 3, 0], "lights": [
      {"type": "spot", "color": [1, 1, 1], "attenuationCoeff": [1, 0, 0],
       "direction": [0, -1, 0], "penumbra": 10, "angle": 30}]},
    {"primitives": [{"type": "cube", "diffuse": [1, 1, 1]}]}
  ]
})"));
  settle();
  select_label("spot light");
  drag_line(4, 1, {-20, 0});
  EXPECT_GT(std::stod(field("angle").parts[0].value), 32);
  EXPECT_EQ(field("penumbra").parts[0].value, "10");
  perform(session, Action::undo);
  settle();
  drag_line(4, 1, {400, 0});
  EXPECT_EQ(field("angle").parts[0].value, "10") << "not 10.000001";
}

TEST_F(EditingTest, PartsOfTemplatesMoveTheCopyThatWasClicked) {
  select_label("cone");
  EXPECT_FALSE(handles_of(session).has_value()) << "which one?";
  click(260, 240);
  EXPECT_EQ(selected(), "cone");
  drag_line(0, 0.9, {20, 0});
  EXPECT_THAT(text(), HasSubstr(R"(<translate x="-1" y="-1.5" z="0"/>)"));
  EXPECT_THAT(text(), Not(HasSubstr(R"(<translate x="1" y="-1.5" z="0"/>)")));
  EXPECT_EQ(selected(), "cone") << "it stays selected";
  drag_line(0, 0.9, {20, 0});
  EXPECT_EQ(session.editing.done.size(), 2U);
}

}  // namespace

}  // namespace scenefile::viewer
