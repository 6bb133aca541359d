#include "scenefile/format/xml_comments.h"

#include "scenefile/format/codes.h"
#include "scenefile/format/xml_tag.h"
#include "scenefile/format/xml_tokens.h"

#include <algorithm>
#include <utility>

namespace scenefile {

namespace {

class CommentMender {
 public:
  CommentMender(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics)
      : text_(text), options_(options), diagnostics_(diagnostics), places_(text) {}

  std::optional<std::string> run() {
    std::size_t at = 0;
    while ((at = text_.find('<', at)) != std::string_view::npos) {
      if (text_.substr(at).starts_with("<!--")) {
        at = mend_comment(at);
      } else if (text_.substr(at).starts_with("<--")) {
        at = mend_false_comment(at);
      } else {
        at = markup_end(text_, at);
      }
    }
    return std::move(mended_);
  }

 private:
  // Each of these returns the end of the comment.
  std::size_t mend_comment(std::size_t begin) {
    const std::size_t body = begin + 4;
    const std::size_t end = text_.find("-->", body);
    if (end == std::string_view::npos) {
      return text_.size();
    }
    bool reported = false;
    for (std::size_t at = body; at < end; ++at) {
      // A dash before another one, which may be the first of the comment's end.
      if (text_[at] != '-' || text_[at + 1] != '-') {
        continue;
      }
      if (!std::exchange(reported, true)) {
        const std::size_t next = text_.find_first_not_of(" \t\r\n", at + 2);
        report(at,
               next > at + 2 && text_[next] == '>'
                   ? broken_comment_end_text
                   : "-- is not allowed inside a comment; write - or == instead",
               "-- inside a comment, which XML does not allow, was taken as a part of it");
      }
      blank(at, at + 1);
    }
    return end + 3;
  }

  // Blanks everything up to its end, or up to the next tag if it has none.
  std::size_t mend_false_comment(std::size_t begin) {
    const std::size_t next = std::min(text_.find('<', begin + 1), text_.size());
    const std::size_t close = text_.substr(0, next).find("-->", begin + 3);
    const std::size_t end = close == std::string_view::npos ? next : close + 3;
    report(begin, "a comment starts with <!--, not with <--",
           "<-- was taken as the start of a comment, which is <!--");
    blank(begin, end);
    return end;
  }

  void report(std::size_t at, std::string_view refused, std::string_view accepted) {
    const Severity severity = options_.compat_course ? Severity::warning : Severity::error;
    diagnostics_.report(xml_comment, severity, places_.advance_to(text_.data() + at),
                        std::string(options_.compat_course ? accepted : refused));
  }

  // Keeps line ends.
  void blank(std::size_t from, std::size_t to) {
    if (!mended_) {
      mended_ = text_;
    }
    for (std::size_t at = from; at < to; ++at) {
      char& c = (*mended_)[at];
      c = c == '\n' || c == '\r' ? c : ' ';
    }
  }

  std::string_view text_;
  const ReadOptions& options_;
  Diagnostics& diagnostics_;
  TextCursor places_;
  std::optional<std::string> mended_;
};

}  // namespace

std::optional<std::string> mend_comments(std::string_view text, const ReadOptions& options,
                                         Diagnostics& diagnostics) {
  return CommentMender(text, options, diagnostics).run();
}

}  // namespace scenefile
