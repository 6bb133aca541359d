#include "scenefile/viewer/editing.h"

#include "scenefile/base/text.h"
#include "scenefile/edit/fix.h"
#include "scenefile/format/recognize.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/placement/bounds.h"
#include "scenefile/viewer/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace scenefile::viewer {

void load_edited_text(Session& session);  // session_files.cpp

namespace {

// In bytes. The document of a shorter text is read in less than about 25 ms.
constexpr std::size_t long_text = std::size_t{1} << 20;

constexpr std::string_view first_scene = R"(<scenefile>
  <globaldata>
    <ambientcoeff v="0.5"/>
    <diffusecoeff v="0.5"/>
    <specularcoeff v="0.5"/>
  </globaldata>

  <cameradata>
    <pos x="3" y="2" z="5"/>
    <focus x="0" y="0" z="0"/>
    <up x="0" y="1" z="0"/>
    <heightangle v="30"/>
  </cameradata>

  <lightdata>
    <id v="0"/>
    <color r="1" g="1" b="1"/>
    <position x="3" y="5" z="4"/>
  </lightdata>

  <object type="tree" name="root">
    <transblock>
      <object type="primitive" name="cube">
        <ambient r="0.2" g="0.3" b="0.4"/>
        <diffuse r="0.4" g="0.6" b="0.8"/>
      </object>
    </transblock>
  </object>
</scenefile>
)";

std::string text_of_new_scene(const std::string& path) {
  if (!path.ends_with(".json")) {
    return std::string(first_scene);
  }
  Diagnostics none;
  return write_scene(read_scene(first_scene, {}, none), SceneFormat::json, {}, none);
}

void set_text(Session& session, std::string text) {
  Editing& editing = session.editing;
  editing.text = std::move(text);
  editing.differs = editing.text != editing.saved;
  ++editing.version;
  load_edited_text(session);
}

// Whether there is a text, which may be empty.
bool was_read(const Editing& editing) {
  return editing.version != editing.first_version;
}

// The file has these contents now.
void note_saved(Editing& editing, std::string text) {
  editing.saved = std::move(text);
  editing.differs = editing.text != editing.saved;
}

// Where the selection is after an edit.
void follow(std::optional<EditedPart>& part, const Edit& edit) {
  if (edit.select) {
    part = {ItemKind::group, *edit.select};
  } else if (part) {
    part->from = moved(part->from, edit);
  }
}

// Makes an edit, and returns the step that it is.
EditStep made(Session& session, const Edit& edit) {
  Editing& editing = session.editing;
  EditStep step{edit, inverse(editing.text, edit), editing.part, {}};
  follow(editing.part, edit);
  step.part_after = editing.part;
  set_text(session, applied(editing.text, edit));
  return step;
}

// Undoes or redoes the last of these steps, if there is one.
void move_last_step(Session& session, std::vector<EditStep>& from, std::vector<EditStep>& to,
                    Edit EditStep::*edit, std::optional<EditedPart> EditStep::*part) {
  finish_edit(session);
  if (from.empty()) {
    return;
  }
  to.push_back(std::move(from.back()));
  from.pop_back();
  made(session, to.back().*edit);
  session.editing.part = to.back().*part;
}

bool has_own_item(ItemKind kind) {
  return kind == ItemKind::globals || kind == ItemKind::camera;
}

ItemId item_of_kind(const Document& document, ItemKind kind) {
  const auto items = document.items();
  const auto found = std::find_if(items.begin(), items.end(),
                                  [&](const SceneItem& item) { return item.kind == kind; });
  return found == items.end() ? no_item : static_cast<ItemId>(found - items.begin());
}

std::optional<ItemId> item_of_part(const Document& document, const EditedPart& part) {
  if (has_own_item(part.kind)) {
    return item_of_kind(document, part.kind);
  }
  std::optional<ItemId> item = document.item_at(part.from);
  while (item && document[*item].range.from != part.from) {
    const ItemId parent = document[*item].parent;
    item = parent == no_item ? std::nullopt : std::optional(parent);
  }
  return item;
}

EditedPart part_of(const Document& document, ItemId item) {
  return {document[item].kind, document[item].range.from};
}

// The document must be of the text on show.
std::optional<ItemId> item_of_row(const Document& document, const OutlineRow& row) {
  switch (row.kind) {
    case RowKind::globals:
      return item_of_kind(document, ItemKind::globals);
    case RowKind::camera:
      return item_of_kind(document, ItemKind::camera);
    default:
      return row.location.known() ? document.item_of(row.location) : std::nullopt;
  }
}

// The edit that makes one text of another.
Edit change_to(const std::string& before, const std::string& after) {
  const auto first = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  const auto last = std::mismatch(before.rbegin(), std::make_reverse_iterator(first.first),
                                  after.rbegin(), std::make_reverse_iterator(first.second));
  return {{{static_cast<std::uint32_t>(first.first - before.begin()),
            static_cast<std::uint32_t>(last.first.base() - first.first),
            std::string(first.second, last.second.base())}},
          {}};
}

void keep_document(Editing& editing, Result<Document> document) {
  editing.opened = editing.version;
  editing.refusal = document ? "" : document.error().text;
  editing.document = document ? std::optional(*std::move(document)) : std::nullopt;
}

// By the text of another program.
void replace_edits(Session& session, const std::string& text) {
  start_editing(session, text);
  load_edited_text(session);
}

// As an answer to a question. What was to happen after saving, such as quitting, does not: the
// edits would be lost.
void read_instead(Session& session, const std::string& text) {
  session.after_saving = {};
  replace_edits(session, text);
}

std::string file_text(const Session& session, const std::string& path) {
  const Result<std::string> text = read_file(path, session.setup.read.limits.file_bytes);
  return text ? *text : "";
}

// Returns false if it fails.
bool write_text(Session& session, const std::string& path) {
  if (const Result<void> written = write_file(path, session.editing.text); !written) {
    say(session,
        fmt::format("cannot save the scene: {}; Ctrl+Shift+S saves it elsewhere",
                    written.error().text),
        true);
    return false;
  }
  note_saved(session.editing, session.editing.text);
  session.editing.new_file = false;
  session.editing.named = true;
  say(session, "saved: " + escaped(path));
  return true;
}

// Why a scene should not be saved at this path; empty: it can be.
std::string wrong_path(Session& session, const std::string& path) {
  if (is_folder(path)) {
    return escaped(path) + " is a folder";
  }
  if (!is_folder(folder_of(path))) {
    return "there is no folder " + escaped(folder_of(path));
  }
  if (!is_scene_name(path)) {
    return "the name of a scene ends with .xml or .json";
  }
  const Document* const document = edited_document(session);
  if (document != nullptr && document->is_xml() == path.ends_with(".json")) {
    return fmt::format("this scene is {}; \"scenefile convert\" translates it",
                       document->is_xml() ? "XML" : "JSON");
  }
  return {};
}

void move_to(Session& session, const std::string& path) {
  if (write_text(session, path) && session.path != path) {
    session.path = path;
    session.start.opening = true;
    load_edited_text(session);  // its textures and meshes are relative to the new place
  }
}

void save_at(Session& session, const std::string& path) {
  finish_edit(session);
  if (const std::string wrong = wrong_path(session, path); !wrong.empty()) {
    ask_where_to_save(session, path, wrong);
    return;
  }
  if (absolute_path(path) == absolute_path(session.path)) {
    session.editing.named = true;
    save_scene(session);
    return;
  }
  if (stamp_of(path).exists) {
    session.question = Question{
        fmt::format("{} exists.", escaped(file_name_of(path))),
        {{"Replace it", [path](Session& s, const auto&) { move_to(s, path); }}, {"Cancel", {}}}};
    return;
  }
  move_to(session, path);
}

}  // namespace

void forget_edits(Session& session) {
  const std::uint64_t version = session.editing.version + 1;
  session.editing = {};
  session.editing.version = version;
  session.editing.first_version = version;
}

void start_editing(Session& session, std::string text) {
  Editing& editing = session.editing;
  finish_edit(session);
  const bool read_before = was_read(editing);
  if (editing.text != text || !read_before) {
    if (read_before) {
      const Edit edit = change_to(editing.text, text);
      editing.done.push_back({edit, inverse(editing.text, edit), editing.part, {}});
      editing.undone.clear();
      editing.part.reset();  // the outline says where it is now
    }
    editing.text = std::move(text);
    ++editing.version;
  }
  note_saved(editing, editing.text);
  editing.new_file = false;
}

bool has_unsaved_edits(const Session& session) {
  const Editing& editing = session.editing;
  return editing.new_file || editing.progress ||
         (!(editing.done.empty() && editing.undone.empty()) && editing.differs);
}

bool shows_edited_scene(const Session& session) {
  return session.shown != nullptr && (session.shown->opened.path == session.path ||
                                      session.shown->text_version >= session.editing.first_version);
}

std::string refusal_to_edit(const Session& session) {
  return session.shown == nullptr || shows_edited_scene(session)
             ? session.editing.refusal
             : fmt::format("the picture still shows {}, not {}", shown_name(session),
                           scene_name(session));
}

bool shows_edited_text(const Session& session) {
  return session.shown != nullptr && session.shown->text_version == session.editing.version &&
         session.shown->opened.path == session.path;
}

const Document* edited_document(Session& session) {
  Editing& editing = session.editing;
  if (editing.opened != editing.version) {
    // Dragging a field or handle needs each new document.
    if (editing.text.size() < long_text || editing.progress) {
      keep_document(editing, Document::open(editing.text, session.setup.read));
    } else {
      editing.refusal = "its text is still being read";
      if (!session.reading_document.busy()) {
        session.reading_document.start(
            [text = editing.text, options = session.setup.read, version = editing.version,
             before = std::exchange(editing.document, std::nullopt)]() mutable {
              before.reset();  // takes long, too
              return ReadDocument{version, Document::open(text, options)};
            },
            session.setup.wake);
      }
      return nullptr;
    }
  }
  return editing.document ? &*editing.document : nullptr;
}

bool tick_document(Session& session) {
  std::optional<ReadDocument> read = session.reading_document.take();
  if (read && read->version == session.editing.version) {
    keep_document(session.editing, std::move(read->document));
  }
  return read.has_value();
}

std::optional<ItemId> selected_item(Session& session) {
  Editing& editing = session.editing;
  const bool selects = editing.part || (session.selected && shows_edited_text(session));
  const Document* const document = selects ? edited_document(session) : nullptr;
  if (document == nullptr) {
    return std::nullopt;
  }
  if (!editing.part) {
    const OutlineRow& row = session.shown->outline.rows[*session.selected];
    if (const std::optional<ItemId> item = item_of_row(*document, row)) {
      editing.part = part_of(*document, *item);
      // In XML, the group around an object is its transblock, which has only transforms.
      editing.part->block =
          row.kind == RowKind::group && (*document)[*item].kind != ItemKind::group;
    } else {
      return std::nullopt;
    }
  }
  if (editing.found_in != editing.version || editing.found_part != *editing.part) {
    editing.found_in = editing.version;
    editing.found_part = *editing.part;
    editing.found = item_of_part(*document, *editing.part);
  }
  return editing.found;
}

std::optional<std::uint32_t> row_of_selected_item(Session& session) {
  const std::optional<ItemId> item = selected_item(session);
  if (!item || !shows_edited_text(session)) {
    return std::nullopt;
  }
  const Document& document = *session.editing.document;
  const std::vector<OutlineRow>& rows = session.shown->outline.rows;
  // Most rows can be told by their line.
  const auto line_at = [&](std::uint32_t offset) {
    return 1 + std::count(document.text().begin(), document.text().begin() + offset, '\n');
  };
  const TextRange range = document[*item].range;
  const bool written = document[*item].written;
  const auto first = written ? line_at(range.from) : 0;
  const auto last = written ? line_at(range.to) : 0;
  const auto is_its = [&](const OutlineRow& row) {
    const bool near =
        !row.location.known() || (row.location.line >= first && row.location.line <= last);
    return near && item_of_row(document, row) == item;
  };
  if (session.selected && is_its(rows[*session.selected])) {
    return session.selected;
  }
  // In XML, the rows of an object and of its transblock: the object's is the last.
  if (session.editing.part->block) {
    const auto block = std::find_if(rows.begin(), rows.end(), is_its);
    return block == rows.end() ? std::nullopt
                               : std::optional(static_cast<std::uint32_t>(block - rows.begin()));
  }
  const auto found = std::find_if(rows.rbegin(), rows.rend(), is_its);
  return found == rows.rend() ? std::nullopt
                              : std::optional(static_cast<std::uint32_t>(rows.rend() - found) - 1);
}

Viewpoint viewpoint_of(const Session& session) {
  Viewpoint view{session.camera.position, session.camera.pivot};
  const OpenedScene& opened = session.shown->opened;
  const std::vector<Bounds> boxes = mesh_bounds(opened.ready.scene, opened.assets);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].empty()) {
      view.meshes[opened.ready.scene.mesh_files[i].name] = {boxes[i].min, boxes[i].max};
    }
  }
  return view;
}

void make_edit(Session& session, const Result<Edit>& edit) {
  finish_edit(session);
  if (!edit) {
    say(session, edit.error().text, true);
  } else if (!edit->changes.empty()) {
    session.editing.done.push_back(made(session, *edit));
    session.editing.undone.clear();
    session.notice.reset();  // about an earlier edit
  }
}

const EditInProgress* begin_edit(Session& session, int of) {
  Editing& editing = session.editing;
  if (editing.progress && editing.progress->of != of) {
    finish_edit(session);
  }
  if (!editing.progress) {
    if (const std::optional<ItemId> item = selected_item(session)) {
      editing.progress = EditInProgress{*editing.document, *item, of, editing.part};
    }
  }
  return editing.progress ? &*editing.progress : nullptr;
}

void continue_edit(Session& session, const Result<Edit>& edit) {
  Editing& editing = session.editing;
  if (!edit) {
    say(session, edit.error().text, true);
    return;
  }
  session.notice.reset();  // about an earlier edit
  if (*edit == editing.progress->edit) {
    return;
  }
  editing.progress->edit = *edit;
  editing.part = editing.progress->part;
  follow(editing.part, *edit);
  set_text(session, applied(editing.progress->before.text(), *edit));
}

Result<Edit> edit_of_field(Session& session, const Document& document, ItemId item,
                           const FieldView& field,
                           std::span<const std::optional<std::string>> typed) {
  if (document[item].kind != ItemKind::light || field.name != "type" || !typed[0]) {
    return set_values(document, item, field, typed);
  }
  std::vector<FieldView>& known = session.editing.light_fields;
  for (FieldView& now : document.fields(item)) {
    if (now.written) {
      std::erase_if(known, [&](const FieldView& old) { return old.name == now.name; });
      known.push_back(std::move(now));
    }
  }
  return set_light_type(document, item, field, *typed[0], known);
}

void finish_edit(Session& session) {
  Editing& editing = session.editing;
  if (editing.progress && !editing.progress->edit.changes.empty()) {
    const std::string& before = editing.progress->before.text();
    const Edit& edit = editing.progress->edit;
    editing.done.push_back({edit, inverse(before, edit), editing.progress->part, editing.part});
    editing.undone.clear();
  }
  editing.progress.reset();
  session.grasped.reset();
}

void cancel_edit(Session& session) {
  if (session.editing.progress) {
    continue_edit(session, Edit{});
    session.editing.progress.reset();
  }
  session.grasped.reset();
}

void correct_text(Session& session) {
  finish_edit(session);
  const std::string text = session.editing.text;
  const FixedText fixed = fix_text(text, session.setup.read);
  if (fixed.made.empty()) {
    say(session, "there is nothing to correct with certainty");
    return;
  }
  make_edit(session, change_to(text, fixed.text));
  say(session,
      fmt::format("corrected {}; Ctrl+Z takes it back", counted(fixed.made.size(), "mistake")));
}

void undo_edit(Session& session) {
  move_last_step(session, session.editing.done, session.editing.undone, &EditStep::back,
                 &EditStep::part_before);
}

void redo_edit(Session& session) {
  move_last_step(session, session.editing.undone, session.editing.done, &EditStep::made,
                 &EditStep::part_after);
}

void new_scene(Session& session, const std::string& path, bool ask) {
  before_losing_edits(session, [path, ask](Session& s) {
    s.path = path;
    forget_edits(s);
    start_editing(s, text_of_new_scene(path));
    note_saved(s.editing, {});
    s.editing.new_file = true;
    s.editing.named = !ask;
    s.start.opening = true;
    load_edited_text(s);
    say(s, ask ? "a new scene: Ctrl+S asks where to save it"
               : fmt::format("a new scene: Ctrl+S creates {}", escaped(absolute_path(path), 200)));
  });
}

void save_scene(Session& session) {
  finish_edit(session);
  if (session.path == "-" || !session.editing.named) {
    ask_where_to_save(session, session.path == "-" ? "scene.xml" : session.path);
    return;
  }
  if (!has_unsaved_edits(session) && stamp_of(session.path).exists) {
    say(session, scene_name(session) + " has no unsaved edits");
    return;
  }
  const std::string now = file_text(session, session.path);
  if (stamp_of(session.path).exists && now != session.editing.saved) {
    session.question = Question{
        scene_name(session) + " has been changed by another program.",
        {{"Replace its changes by mine", [](Session& s, const auto&) { write_text(s, s.path); }},
         {"Read it; Ctrl+Z brings my edits back",
          [now](Session& s, const auto&) { read_instead(s, now); }},
         {"Cancel", {}}}};
    return;
  }
  write_text(session, session.path);
}

void ask_where_to_save(Session& session, const std::string& path, const std::string& wrong) {
  session.question =
      Question{"Save the scene as" + (wrong.empty() ? "" : ": " + wrong),
               {{"Save", [](Session& s, const auto& path) { save_at(s, path); }}, {"Cancel", {}}},
               path};
}

void before_losing_edits(Session& session, std::function<void(Session&)> then) {
  finish_edit(session);
  const Editing& editing = session.editing;
  const bool untouched = editing.new_file && editing.done.empty() && editing.undone.empty();
  const bool edited = has_unsaved_edits(session);
  const bool gone = was_read(editing) && session.path != "-" && !stamp_of(session.path).exists;
  if (untouched || !(edited || gone)) {
    then(session);
    return;
  }
  session.after_saving = std::move(then);
  session.question = Question{
      scene_name(session) + (edited ? " has edits that are not saved." : " no longer exists."),
      {{"Save", [](Session& s, const std::string&) { save_scene(s); }},
       {"Discard", [](Session& s, const std::string&) { forget_edits(s); }},
       {"Cancel", {}}}};
}

void ask_about_changed_file(Session& session, const std::string& text) {
  const auto read = [text](Session& s, const std::string&) { read_instead(s, text); };
  const auto keep = [text](Session& s, const std::string&) { note_saved(s.editing, text); };
  const auto later = [](Session&, const std::string&) {};
  session.question = Question{scene_name(session) + " has been changed by another program.",
                              {{"Keep my edits: saving will replace its changes", keep},
                               {"Read it; Ctrl+Z brings my edits back", read},
                               {"Decide when I save", later}}};
}

void answer_question(Session& session, std::size_t answer) {
  const Question question = *std::exchange(session.question, std::nullopt);
  const bool acts = answer < question.answers.size() && question.answers[answer].act;
  if (acts) {
    question.answers[answer].act(session, question.path.value_or(""));
  }
  if (session.question) {
    return;  // it comes first
  }
  const std::function<void(Session&)> then = std::exchange(session.after_saving, {});
  if (acts && then) {
    before_losing_edits(session, then);  // asks again if there still are some
  }
}

}  // namespace scenefile::viewer
