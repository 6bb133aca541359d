#include "scenefile/grade/gradebook.h"
#include "scenefile/base/base64.h"
#include "scenefile/grade/markup.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --line: #8884; --good: #2a7d46; --bad: #c0392b; --none: #8a6d1b; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin-bottom: 0; }
.sum { opacity: .75; margin-top: .2rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 1.5rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .35rem .7rem; border-bottom: 1px solid var(--line); text-align: right; }
th:first-child, td:first-child { text-align: left; }
td a { color: inherit; text-decoration: none; }
.passed { color: var(--good); }
.differs { color: var(--bad); font-weight: 600; }
.missing, .unreadable { color: var(--none); font-weight: 600; }
section { margin: 2rem 0; padding-top: .5rem; border-top: 1px solid var(--line); }
h2 { font-size: 1.2rem; } h3 { font-size: 1rem; margin-bottom: .2rem; }
ul { margin: .2rem 0 .6rem; }
img { max-width: 100%; height: auto; border-radius: 4px; image-rendering: auto; }
figcaption { font-size: .85rem; opacity: .75; } figure { margin: .5rem 0 1.5rem; }
.cause { border-left: 3px solid var(--bad); padding-left: .6rem; margin: .4rem 0; }
.cause small { display: block; opacity: .75; }
)";

// What stands in a cell of the table.
std::string figure_of(const PictureResult& picture) {
  switch (picture.verdict) {
    case Verdict::passed:
    case Verdict::differs:
      return picture.measures.same_size
                 ? fmt::format("{:.1f} dB", picture.measures.difference.psnr_db)
                 : "size";
    case Verdict::missing:
    case Verdict::unreadable:
      return std::string(name_of(picture.verdict));
  }
  return {};
}

std::string table(const Gradebook& book) {
  std::string html = "<div class=\"wide\"><table>\n<tr><th>student</th><th>passed</th>";
  if (!book.students.empty()) {
    for (const PictureResult& picture : book.students.front().pictures) {
      html += fmt::format("<th>{}</th>", markup(picture.name));
    }
  }
  html += "</tr>\n";
  for (std::size_t s = 0; s < book.students.size(); ++s) {
    const StudentResult& student = book.students[s];
    html += fmt::format("<tr><td>{}</td><td>{}/{}</td>", markup(student.name), student.passed(),
                        student.pictures.size());
    for (std::size_t p = 0; p < student.pictures.size(); ++p) {
      const PictureResult& picture = student.pictures[p];
      html += picture.verdict == Verdict::passed
                  ? fmt::format("<td class=\"passed\">{}</td>", figure_of(picture))
                  : fmt::format("<td class=\"{}\"><a href=\"#p{}-{}\">{}</a></td>",
                                name_of(picture.verdict), s, p, figure_of(picture));
    }
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string measures_line(const PictureMeasures& m) {
  if (!m.same_size) {
    return "not measured";
  }
  return fmt::format("PSNR {:.2f} dB · SSIM {:.4f} · FLIP {:.4f} · greatest difference {}/255",
                     m.difference.psnr_db, m.ssim, m.flip_mean, m.difference.max);
}

std::string details(const PictureResult& picture) {
  std::string html = "<ul>";
  for (const std::string& reason : picture.reasons) {
    html += fmt::format("<li>{}</li>", markup(reason));
  }
  html += "</ul>\n";
  for (const Claim& claim : picture.causes) {
    html += fmt::format("<div class=\"cause\">{}<small>{}</small></div>\n", markup(claim.what),
                        markup(claim.evidence));
  }
  if (!picture.png.empty()) {
    html += fmt::format(
        "<figure><img alt=\"reference, picture, difference\" src=\"data:image/png;base64,{}\">"
        "<figcaption>reference · picture · difference — {}</figcaption></figure>\n",
        base64(picture.png), measures_line(picture.measures));
  }
  return html;
}

}  // namespace

std::string gradebook_html(const Gradebook& book, std::string_view title) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n<style>{1}</style>\n"
      "</head>\n<body>\n<h1>{0}</h1>\n<p class=\"sum\">{2} students · {3} pictures passed · {4} "
      "differ · {5} missing · {6} unreadable</p>\n",
      markup(title), style, book.students.size(), book.count(Verdict::passed),
      book.count(Verdict::differs), book.count(Verdict::missing), book.count(Verdict::unreadable));
  html += table(book);
  for (std::size_t s = 0; s < book.students.size(); ++s) {
    const StudentResult& student = book.students[s];
    if (student.passed() == student.pictures.size()) {
      continue;
    }
    html += fmt::format("<section>\n<h2>{}</h2>\n", markup(student.name));
    for (std::size_t p = 0; p < student.pictures.size(); ++p) {
      const PictureResult& picture = student.pictures[p];
      if (picture.verdict != Verdict::passed) {
        html +=
            fmt::format("<h3 id=\"p{}-{}\">{}: <span class=\"{}\">{}</span></h3>\n", s, p,
                        markup(picture.name), name_of(picture.verdict), name_of(picture.verdict)) +
            details(picture);
      }
    }
    html += "</section>\n";
  }
  return html + "</body>\n</html>\n";
}

}  // namespace scenefile
