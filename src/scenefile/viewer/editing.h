#pragma once
// Editing the scene: its text in memory, what undoes and redoes each edit, and what the file
// contains. Every edit (edit/edits.h) is one change of the text; the window reads the scene again
// from the text, as if it had been saved.

#include "scenefile/edit/edits.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scenefile::viewer {

struct Session;

/// The selected part of the scene: where it starts in the text. Global data and a camera that the
/// file lacks have only a kind.
struct EditedPart {
  ItemKind kind = ItemKind::group;  ///< only looked at for global data and the camera
  std::uint32_t from = 0;
  bool block = false;  ///< XML: the row of the <transblock> is selected, not that of its object

  friend bool operator==(const EditedPart&, const EditedPart&) = default;
};

/// An edit that was made, its inverse, and the selection before and after.
struct EditStep {
  Edit made;
  Edit back;
  std::optional<EditedPart> part_before;
  std::optional<EditedPart> part_after;
};

/// An edit that is not finished, such as dragging a slider: each new value replaces the last one,
/// and all together are one step.
struct EditInProgress {
  Document before;
  ItemId item = no_item;  ///< the selected one, of `before`
  int of = 0;             ///< what is edited: begin_edit()
  std::optional<EditedPart> part{};
  Edit edit{};  ///< so far; of `before`
};

struct Editing {
  std::string text;           ///< as edited
  std::string saved;          ///< the contents of the file, as last read or written
  bool differs = false;       ///< `text` from `saved`
  bool new_file = false;      ///< nothing has been read or written yet
  bool named = true;          ///< the user has chosen the path
  std::uint64_t version = 0;  ///< changes with `text`; SceneOnShow::text_version says what is shown
  std::uint64_t first_version = 0;  ///< of the texts since a scene was opened
  std::vector<EditStep> done;
  std::vector<EditStep> undone;  ///< redo_edit() takes the last
  std::optional<EditInProgress> progress;
  std::optional<EditedPart> part;  ///< the selection; empty: none, or not known yet
  // Cached: the document of the text, once someone asks for it.
  std::optional<Document> document;
  std::string refusal;       ///< why there is none
  std::uint64_t opened = 0;  ///< the version of the text that was tried
  // Cached: the item of a part of the document; of version 0, which no text has: none.
  EditedPart found_part;
  std::uint64_t found_in = 0;
  std::optional<ItemId> found;
  /// Fields that the selected light had before its type was changed; it may be changed back.
  std::vector<FieldView> light_fields;
};

/// A document that was read on another thread.
struct ReadDocument {
  std::uint64_t version = 0;  ///< Editing::version of its text
  Result<Document> document;
};

/// Something to decide before anything else is done. The last answer changes nothing: Escape.
struct Question {
  struct Answer {
    std::string label;
    /// Empty: nothing happens, also not Session::after_saving. `path`: the one that was asked for.
    std::function<void(Session&, const std::string& path)> act;
  };
  std::string text;
  std::vector<Answer> answers;
  std::optional<std::string> path{};  ///< asks for a path, with this proposal
};

// Text.

/// Takes over the text of the file. If it has been read before, what another program changed since
/// then is an edit, which can be undone.
void start_editing(Session& session, std::string text);
/// Forgets the text and all edits.
void forget_edits(Session& session);
/// Whether there are edits that have not been saved.
bool has_unsaved_edits(const Session& session);
/// Whether the picture is of the edited scene: of any version, or under another name.
bool shows_edited_scene(const Session& session);
/// Why the scene cannot be edited, as far as that is known; empty: it can.
std::string refusal_to_edit(const Session& session);
/// Whether the picture and the outline are of the current text.
bool shows_edited_text(const Session& session);

/// The current text as a document; null if it cannot be edited, for the reason in
/// Editing::refusal: also while a long text is being read on another thread.
const Document* edited_document(Session& session);
/// Takes a document that was read. Returns false if there is none.
bool tick_document(Session& session);
/// The selected item of edited_document(); nullopt: none.
std::optional<ItemId> selected_item(Session& session);
/// The row of the outline for the selected item; nullopt: none.
std::optional<std::uint32_t> row_of_selected_item(Session& session);

// Edits.

/// From where new objects are seen, and how large meshes are.
Viewpoint viewpoint_of(const Session& session);
/// Makes an edit of edited_document(), or shows the error.
void make_edit(Session& session, const Result<Edit>& edit);
/// Begins an edit of the selected item in several steps, unless one of the same number is in
/// progress: that of a widget, or edit_by_handle. Null if nothing is selected.
const EditInProgress* begin_edit(Session& session, int of);
inline constexpr int edit_by_handle = -1;
/// Replaces the edit in progress by this edit of its document `before`.
void continue_edit(Session& session, const Result<Edit>& edit);
/// The edit that sets some parts of a field, where a light that gets its type back gets its fields
/// back, too.
Result<Edit> edit_of_field(Session& session, const Document& document, ItemId item,
                           const FieldView& field,
                           std::span<const std::optional<std::string>> typed);
/// Ends the edit in progress, if there is one: it can be undone from now on.
void finish_edit(Session& session);
/// Reverts the edit in progress.
void cancel_edit(Session& session);

/// Corrects what is certain, also in a text with errors: fix_text() as one edit.
void correct_text(Session& session);

void undo_edit(Session& session);
void redo_edit(Session& session);

// Files.

/// Starts a new scene that will be saved at `path`; `ask`: after a question, which proposes it.
void new_scene(Session& session, const std::string& path, bool ask = false);
/// Saves the text, if there are unsaved edits or the file was deleted; asks first if the file has
/// been changed by another program.
void save_scene(Session& session);
/// Asks for a path, and saves the text there. `path`: a proposal; `wrong`: what was wrong with it.
void ask_where_to_save(Session& session, const std::string& path, const std::string& wrong = {});
/// Does `then` at once if there are no unsaved edits, and the file still exists; otherwise asks,
/// and maybe saves. Questions that come in between do not change that.
void before_losing_edits(Session& session, std::function<void(Session&)> then);
/// The file was read again, with other contents than were last read or written, while there are
/// unsaved edits: asks which to keep.
void ask_about_changed_file(Session& session, const std::string& text);

/// Gives an answer, by its index, and closes the question.
void answer_question(Session& session, std::size_t answer);

}  // namespace scenefile::viewer
