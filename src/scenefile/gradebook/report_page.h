#pragma once
// The frame of the HTML reports: style, script, and the dialog that enlarges pictures. Internal to
// grade.

#include <string>
#include <string_view>

namespace scenefile {

/// A whole page. `title` and `date` are plain text; without a date, the page does not mention it.
/// `content` is HTML. The script works on these parts of it, and does without any of them:
///
/// - `table.results`, with a button in each column heading, `data-causes` (names of causes) in each
///   row, and cells of the classes passed, differs, missing and unreadable;
/// - the fields `#name`, `#cause` and `#state`, which filter its rows, `#shown` for their number,
/// and
///   `button[data-cause]`, which choose a cause;
/// - `button.shot` with the strip of a picture (PictureResult::png), in `.student`, which contains
///   its name as `.who`. Its own name is the first bdi in it, or in the `.card` around it; the card
///   may also contain `.why` and `.measures`.
std::string report_page(std::string_view title, std::string_view date, std::string_view content);

}  // namespace scenefile
