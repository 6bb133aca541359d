#include "scenefile/base/base64.h"
#include "scenefile/grade/gradebook.h"
#include "scenefile/grade/markup.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --ink: #1c1e21; --paper: #fff; --soft: #f1f3f5; --line: #c9ced6; --dim: #59606b;
  --good: #1d6b3a; --bad: #b3261e; --none: #7a5600; --link: #0b57a4; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e8eb; --paper: #15171a; --soft: #22262b; --line: #3f464f;
  --dim: #a8b0bb; --good: #6fd191; --bad: #ff8f85; --none: #f0c264; --link: #8ec5ff; } }
* { box-sizing: border-box; }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); margin: 0; }
main { max-width: 90rem; margin: 0 auto; padding: 1rem; }
a { color: var(--link); }
h1 { font-size: 1.6rem; margin: .5rem 0 0; } h2 { font-size: 1.2rem; } h3 { font-size: 1rem; margin: 1rem 0 .2rem; }
.sum, .dim, figcaption { color: var(--dim); }
.filters { display: flex; flex-wrap: wrap; align-items: center; gap: .5rem 1rem; margin: 1rem 0 .5rem; }
.filters label { display: flex; gap: .4rem; align-items: center; }
input, select { font: inherit; color: inherit; background: var(--soft); border: 1px solid var(--line); border-radius: 4px;
  padding: .2rem .4rem; max-width: 14rem; }
.wide { overflow: auto; width: fit-content; max-width: 100%; max-height: 85vh; border: 1px solid var(--line); border-radius: 4px; }
table { border-collapse: separate; border-spacing: 0; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .6rem; border-bottom: 1px solid var(--line); text-align: left; white-space: nowrap;
  background: var(--paper); }
thead th { position: sticky; top: 0; background: var(--soft); z-index: 2; vertical-align: bottom; white-space: normal;
  max-width: 12rem; overflow-wrap: break-word; }
thead th:nth-child(3), td:nth-child(3) { white-space: normal; min-width: 20rem; max-width: 30rem; }
.tag { display: inline-block; white-space: nowrap; margin-right: .8rem; }
tbody th { position: sticky; left: 0; z-index: 1; font-weight: 600; max-width: 16rem; overflow: hidden;
  text-overflow: ellipsis; }
thead th:first-child { left: 0; z-index: 3; }
th button { font: inherit; font-weight: 600; color: inherit; background: none; border: 0; padding: 0; cursor: pointer;
  text-align: left; max-width: 100%; overflow-wrap: break-word; }
th[aria-sort=ascending] button::after { content: " ▲"; } th[aria-sort=descending] button::after { content: " ▼"; }
td a { color: inherit; }
.passed { color: var(--good); } .differs { color: var(--bad); font-weight: 600; }
.missing, .unreadable { color: var(--none); font-weight: 600; }
details { border-top: 1px solid var(--line); padding: .4rem 0; } summary { cursor: pointer; font-weight: 600; }
img { max-width: 100%; height: auto; border-radius: 4px; } figure { margin: .5rem 0 1.5rem; }
.cause { border-left: 3px solid var(--bad); padding-left: .6rem; margin: .4rem 0; }
.cause small { display: block; color: var(--dim); overflow-wrap: anywhere; }
li, p, h3 { overflow-wrap: anywhere; }
@media (max-width: 30rem) { main { padding: .5rem; } th, td { padding: .3rem .4rem; }
  tbody th { min-width: 6.5rem; max-width: 8.5rem; white-space: normal; overflow-wrap: anywhere; }
  thead th:nth-child(3), td:nth-child(3) { min-width: 12rem; max-width: 12rem; } .tag { white-space: normal; } }
)";

// Sorts by a column, filters the rows, and opens the targets of links in the table.
constexpr std::string_view script = R"(
const table = document.querySelector('table'), body = table && table.tBodies[0];
if (table) {
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => head.querySelector('button').addEventListener('click', () => {
    const down = head.getAttribute('aria-sort') === 'ascending';
    heads.forEach(h => h.removeAttribute('aria-sort'));
    head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
    const key = row => row.cells[column].dataset.key || row.cells[column].textContent;
    const rows = [...body.rows].sort((a, b) => key(a).localeCompare(key(b), undefined, {numeric: true}));
    (down ? rows.reverse() : rows).forEach(row => body.append(row));
  }));
  const name = document.getElementById('name'), cause = document.getElementById('cause');
  const state = document.getElementById('state'), shown = document.getElementById('shown');
  const filter = () => {
    let count = 0;
    for (const row of body.rows) {
      const all = row.dataset.passed === '1';
      const hidden = !row.cells[0].textContent.toLowerCase().includes(name.value.toLowerCase()) ||
        (cause.value && !(' ' + row.dataset.causes + ' ').includes(' ' + cause.value + ' ')) ||
        (state.value && (state.value === 'passed') !== all);
      row.hidden = hidden;
      count += hidden ? 0 : 1;
    }
    shown.textContent = count + ' of ' + body.rows.length + ' students';
  };
  [name, cause, state].forEach(e => e.addEventListener('input', filter));
  filter();
}
const open = () => {
  const target = location.hash && document.getElementById(location.hash.slice(1));
  const box = target && target.closest('details');
  if (box) { box.open = true; target.scrollIntoView(); }
};
addEventListener('hashchange', open);
open();
)";

// "1 picture", "2 pictures".
std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string names_of(const std::vector<Claim>& causes) {
  std::string text;
  for (const Claim& claim : causes) {
    if (claim.cause != Cause::rounding) {
      text += fmt::format("{}{}", text.empty() ? "" : ", ", name_of(claim.cause));
    }
  }
  return text;
}

// The text of a table cell: the cause if one is known.
std::string figure_of(const PictureResult& picture) {
  switch (picture.verdict) {
    case Verdict::passed:
    case Verdict::differs: {
      const std::string causes = names_of(picture.causes);
      if (picture.verdict == Verdict::differs && !causes.empty()) {
        return causes;
      }
      return picture.measures.size == picture.measures.right_size
                 ? fmt::format("{:.1f} dB", picture.measures.difference.psnr_db)
                 : "size";
    }
    case Verdict::missing:
    case Verdict::unreadable:
      return std::string(name_of(picture.verdict));
  }
  return {};
}

std::size_t failed(const StudentResult& student) {
  return student.pictures.size() - student.passed();
}

// "blinn in 5 of 5": of the pictures that differ, because a missing one has no cause. Each between
// `before` and `after`.
std::string causes_line(const StudentResult& student, std::string_view before = {},
                        std::string_view after = {}, std::string_view between = ", ") {
  const auto differ =
      std::count_if(student.pictures.begin(), student.pictures.end(),
                    [](const PictureResult& p) { return p.verdict == Verdict::differs; });
  std::string text;
  for (const CauseCount& count : count_causes({&student, 1})) {
    text += fmt::format("{}{}{} in {} of {}{}", text.empty() ? "" : between, before,
                        name_of(count.cause), count.pictures, differ, after);
  }
  return text;
}

// Paths may be broken after a slash.
std::string breakable(std::string_view name) {
  std::string html;
  for (const char c : markup(name)) {
    html += c;
    html += c == '/' ? "<wbr>" : "";
  }
  return html;
}

std::string header_cell(std::string_view name) {
  return fmt::format("<th scope=\"col\"><button type=\"button\">{}</button></th>", breakable(name));
}

std::string table_row(const StudentResult& student, std::size_t index) {
  std::string words;
  for (const CauseCount& count : count_causes({&student, 1})) {
    words += fmt::format("{}{}", words.empty() ? "" : " ", name_of(count.cause));
  }
  const std::string name =
      failed(student) == 0 ? markup(student.name)
                           : fmt::format("<a href=\"#s{}\">{}</a>", index, markup(student.name));
  std::string html = fmt::format(
      "<tr data-passed=\"{}\" data-causes=\"{}\"><th "
      "scope=\"row\">{}</th><td>{}/{}</td><td>{}</td>",
      failed(student) == 0 ? 1 : 0, words, name, student.passed(), student.pictures.size(),
      causes_line(student, "<span class=\"tag\">", "</span>", " "));
  for (std::size_t p = 0; p < student.pictures.size(); ++p) {
    const PictureResult& picture = student.pictures[p];
    html +=
        picture.verdict == Verdict::passed
            ? fmt::format("<td class=\"passed\" data-key=\"0\">{}</td>", figure_of(picture))
            : fmt::format("<td class=\"{0}\" data-key=\"1 {1}\"><a href=\"#p{2}-{3}\">{1}</a></td>",
                          name_of(picture.verdict), figure_of(picture), index, p);
  }
  return html + "</tr>\n";
}

std::string filters(const Gradebook& book) {
  std::string html =
      "<div class=\"filters\"><label>Student <input id=\"name\" type=\"search\"></label>\n"
      "<label>Cause <select id=\"cause\"><option value=\"\">any</option>";
  for (const CauseCount& count : count_causes(book.students)) {
    html += fmt::format("<option value=\"{0}\">{0}</option>", name_of(count.cause));
  }
  return html +
         "</select></label>\n<label>State <select id=\"state\"><option value=\"\">any</option>"
         "<option value=\"failed\">something failed</option><option value=\"passed\">all passed"
         "</option></select></label>\n<span id=\"shown\" class=\"dim\" "
         "role=\"status\"></span></div>\n";
}

std::string table(const Gradebook& book) {
  std::string html = filters(book) +
                     "<div class=\"wide\" role=\"region\" aria-label=\"Results\" tabindex=\"0\">"
                     "<table>\n<thead><tr>" +
                     header_cell("student") + header_cell("passed") + header_cell("causes");
  if (!book.students.empty()) {
    for (const PictureResult& picture : book.students.front().pictures) {
      html += header_cell(picture.name);
    }
  }
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t s = 0; s < book.students.size(); ++s) {
    html += table_row(book.students[s], s);
  }
  return html + "</tbody>\n</table></div>\n";
}

std::string causes_of_class(const Gradebook& book) {
  const std::vector<CauseCount> counts = count_causes(book.students);
  if (counts.empty()) {
    return {};
  }
  std::string html = "<h2>Causes</h2>\n<ul>\n";
  for (const CauseCount& count : counts) {
    html +=
        fmt::format("<li>{}: {} of {}, {}</li>\n", name_of(count.cause), count.students,
                    counted(book.students.size(), "student"), counted(count.pictures, "picture"));
  }
  return html + "</ul>\n";
}

std::string measures_line(const PictureMeasures& m) {
  if (!m.same_size) {
    return "not measured";
  }
  return fmt::format("PSNR {:.2f} dB · SSIM {:.4f} · FLIP {:.4f} · maximum difference {:.6g}/255",
                     m.difference.psnr_db, m.ssim, m.flip_mean, m.difference.max);
}

std::string notes_of(const PictureResult& picture) {
  std::string html;
  for (const std::string& note : picture.notes) {
    html += fmt::format("<p class=\"dim\">Not a mistake: {}</p>\n", markup(note));
  }
  return html;
}

std::string details(const PictureResult& picture) {
  std::string html = "<ul>";
  for (const std::string& reason : picture.reasons) {
    html += fmt::format("<li>{}</li>", markup(reason));
  }
  html += "</ul>\n";
  for (const Claim& claim : picture.causes) {
    html += fmt::format("<div class=\"cause\">{} [{}]<small>{}</small></div>\n", markup(claim.what),
                        name_of(claim.cause), markup(claim.evidence));
  }
  html += notes_of(picture);
  const std::string source = !picture.png_file.empty() ? markup(picture.png_file)
                             : picture.png.empty()     ? std::string()
                                                   : "data:image/png;base64," + base64(picture.png);
  if (!source.empty()) {
    html += fmt::format(
        "<figure><img loading=\"lazy\" alt=\"reference, picture and difference of {}\" src=\"{}\">"
        "<figcaption>reference · picture · difference: {}</figcaption></figure>\n",
        markup(picture.name), source, measures_line(picture.measures));
  }
  return html;
}

// The pictures that were not handed in, in one line.
std::string missing(const StudentResult& student, std::size_t index) {
  std::string names;
  std::size_t count = 0;
  for (std::size_t p = 0; p < student.pictures.size(); ++p) {
    if (student.pictures[p].verdict == Verdict::missing) {
      names += fmt::format("{}<span id=\"p{}-{}\">{}</span>", names.empty() ? "" : ", ", index, p,
                           markup(student.pictures[p].name));
      ++count;
    }
  }
  return names.empty()
             ? std::string()
             : fmt::format("<h3><span class=\"missing\">missing</span>: {}</h3>\n<p>{}</p>\n",
                           counted(count, "picture"), names);
}

// The pictures that did not pass. `index`: of the student in the table.
std::string failures(const StudentResult& student, std::size_t index) {
  std::string html;
  for (std::size_t p = 0; p < student.pictures.size(); ++p) {
    const PictureResult& picture = student.pictures[p];
    if (picture.verdict != Verdict::passed && picture.verdict != Verdict::missing) {
      html +=
          fmt::format("<h3 id=\"p{}-{}\">{}: <span class=\"{}\">{}</span></h3>\n", index, p,
                      markup(picture.name), name_of(picture.verdict), name_of(picture.verdict)) +
          details(picture);
    }
  }
  html += missing(student, index);
  if (const std::string unmatched = unmatched_text(student); !unmatched.empty()) {
    html += fmt::format("<p>{}.</p>\n", markup(unmatched));
  }
  return html;
}

std::string list_of(std::string_view title, const std::vector<std::string>& lines) {
  std::string html = lines.empty() ? std::string() : fmt::format("<h2>{}</h2>\n<ul>\n", title);
  for (const std::string& line : lines) {
    html += fmt::format("<li>{}</li>\n", markup(line));
  }
  return html + (lines.empty() ? "" : "</ul>\n");
}

std::string page(std::string_view title, const std::string& sum, const std::string& content,
                 bool with_script) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n<p class=\"sum\">{2}</p>\n{3}"
      "</main>\n{4}</body>\n</html>\n",
      markup(title), style, sum, content,
      with_script ? fmt::format("<script>{}</script>\n", script) : std::string());
}

}  // namespace

std::string gradebook_html(const Gradebook& book, std::string_view title) {
  const std::string sum = fmt::format(
      "{} · {} passed · {} {} · {} missing · {} unreadable",
      counted(book.students.size(), "student"), counted(book.count(Verdict::passed), "picture"),
      book.count(Verdict::differs), book.count(Verdict::differs) == 1 ? "differs" : "differ",
      book.count(Verdict::missing), book.count(Verdict::unreadable));
  std::string html = table(book) + causes_of_class(book);
  bool any = false;
  for (std::size_t s = 0; s < book.students.size(); ++s) {
    const StudentResult& student = book.students[s];
    if (failed(student) == 0) {
      continue;
    }
    html += any ? "" : "<h2>What did not pass</h2>\n";
    any = true;
    const std::string causes = causes_line(student);
    html += fmt::format("<details id=\"s{}\"><summary>{}: {} of {} passed{}</summary>\n", s,
                        markup(student.name), student.passed(), student.pictures.size(),
                        causes.empty() ? "" : "; " + causes) +
            failures(student, s) + "</details>\n";
  }
  html += list_of("Identical files", identical_lines(book)) +
          list_of("Ignored files", ignored_lines(book));
  return page(title, sum, html, true);
}

std::string student_html(const StudentResult& student, std::string_view title) {
  const std::string causes = causes_line(student);
  std::string html;
  for (const PictureResult& picture : student.pictures) {
    if (picture.verdict == Verdict::passed) {
      html += fmt::format("<h3>{}: <span class=\"passed\">passed</span> ({})</h3>\n",
                          markup(picture.name), figure_of(picture)) +
              notes_of(picture);
    }
  }
  const std::string sum =
      fmt::format("{}: {} of {} passed{}", markup(student.name), student.passed(),
                  counted(student.pictures.size(), "picture"), causes.empty() ? "" : "; " + causes);
  return page(title, sum,
              (failed(student) == 0 ? std::string() : "<h2>What did not pass</h2>\n") +
                  failures(student, 0) + (html.empty() ? "" : "<h2>Passed</h2>\n") + html,
              false);
}

}  // namespace scenefile
