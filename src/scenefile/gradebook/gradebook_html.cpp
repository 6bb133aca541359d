#include "scenefile/base/base64.h"
#include "scenefile/base/text.h"
#include "scenefile/gradebook/gradebook.h"
#include "scenefile/gradebook/markup.h"
#include "scenefile/gradebook/report_page.h"
#include "scenefile/mistakes/cause_help.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace scenefile {

namespace {

std::string_view sign_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "✓";
    case Verdict::differs:
      return "✗";
    case Verdict::missing:
      return "–";
    case Verdict::unreadable:
      break;
  }
  return "!";
}

// Names come from students, and may be written from right to left.
std::string name_html(std::string_view name) {
  return "<bdi>" + markup(name) + "</bdi>";
}

// The claim with a capital letter, unless it begins with the name of a variable.
std::string sentence(std::string_view what) {
  std::string text(what);
  const std::size_t end = std::min(text.find(' '), text.size());
  const bool word = end > 1 && std::all_of(text.begin(), text.begin() + static_cast<int>(end),
                                           [](char c) { return c >= 'a' && c <= 'z'; });
  if (word) {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return markup(text);
}

std::string code(Cause cause) {
  return fmt::format("<code>{}</code>", name_of(cause));
}

std::size_t failed(const StudentResult& student) {
  return student.pictures.size() - student.passed();
}

// A mistake of a student, and its pictures.
struct Mistake {
  Cause cause = Cause::rounding;
  struct Shown {
    std::string what;
    std::vector<std::string> instead;  // what gives all these pictures, too
    std::vector<std::size_t> pictures;
  };
  std::vector<Shown> shown;           // in different words
  std::vector<std::size_t> pictures;  // each once
};

using ClaimsOf = std::vector<Claim> PictureResult::*;

// The mistakes of a student, the most frequent first.
std::vector<Mistake> mistakes_of(const StudentResult& student, ClaimsOf claims) {
  std::vector<Mistake> mistakes;
  for (std::size_t p = 0; p < student.pictures.size(); ++p) {
    for (const Claim& claim : student.pictures[p].*claims) {
      if (claim.cause == Cause::rounding || student.pictures[p].verdict == Verdict::passed) {
        continue;
      }
      auto mistake = std::find_if(mistakes.begin(), mistakes.end(),
                                  [&](const Mistake& m) { return m.cause == claim.cause; });
      if (mistake == mistakes.end()) {
        mistake = mistakes.insert(mistakes.end(), Mistake{claim.cause, {}, {}});
      }
      std::vector<std::string> instead = claim.alternatives;
      const std::string what = instead.empty() ? claim.what : instead.front();
      instead.erase(instead.begin(), instead.begin() + (instead.empty() ? 0 : 1));
      auto shown = std::find_if(mistake->shown.begin(), mistake->shown.end(),
                                [&](const Mistake::Shown& s) { return s.what == what; });
      if (shown == mistake->shown.end()) {
        shown = mistake->shown.insert(mistake->shown.end(), {what, std::move(instead), {}});
      } else {
        std::erase_if(shown->instead, [&](const std::string& other) {
          return std::find(instead.begin(), instead.end(), other) == instead.end();
        });
      }
      for (std::vector<std::size_t>* const pictures : {&shown->pictures, &mistake->pictures}) {
        if (pictures->empty() || pictures->back() != p) {
          pictures->push_back(p);
        }
      }
    }
  }
  for (Mistake& mistake : mistakes) {
    std::stable_sort(mistake.shown.begin(), mistake.shown.end(), [](const auto& a, const auto& b) {
      return a.pictures.size() > b.pictures.size();
    });
  }
  std::stable_sort(mistakes.begin(), mistakes.end(), [](const Mistake& a, const Mistake& b) {
    return a.pictures.size() > b.pictures.size();
  });
  return mistakes;
}

std::string measures_line(const PictureMeasures& m) {
  if (!m.comparable) {
    return "not measured";
  }
  return fmt::format("PSNR {:.2f} dB · SSIM {:.4f} · FLIP {:.4f} · maximum difference {:.6g}/255",
                     m.difference.psnr_db, m.ssim, m.flip_mean, m.difference.max);
}

// "There are no shadows".
std::string short_sentence(const Mistake& mistake) {
  const Mistake::Shown& shown = mistake.shown.front();
  return sentence(shown.what) + (shown.instead.empty() ? "" : ", or another mistake");
}

// Why there is no picture of the student; empty if there is one.
std::string_view why_nothing(const Gradebook& book, const StudentResult& student) {
  if (std::any_of(student.pictures.begin(), student.pictures.end(),
                  [](const PictureResult& p) { return p.verdict != Verdict::missing; })) {
    return {};
  }
  const bool other_files =
      !student.unmatched.empty() ||
      std::any_of(book.ignored.begin(), book.ignored.end(),
                  [&](const IgnoredFile& file) { return file.student == student.name; });
  return other_files ? "Nothing to grade" : "Nothing handed in";
}

// In the table: what is wrong, the first mistakes one below the other.
std::string mistakes_cell(const Gradebook& book, const StudentResult& student) {
  constexpr std::size_t max_listed = 3;
  std::vector<std::string> lines;
  const auto add = [&](std::string_view what, std::size_t pictures) {
    lines.push_back(
        fmt::format("<span>{} <small>· {}</small></span>", what, counted(pictures, "picture")));
  };
  for (const Mistake& mistake : mistakes_of(student, &PictureResult::causes)) {
    add(short_sentence(mistake), mistake.pictures.size());
  }
  const auto wrong_size = static_cast<std::size_t>(
      std::count_if(student.pictures.begin(), student.pictures.end(),
                    [](const PictureResult& p) { return !p.measures.same_size(); }));
  if (wrong_size > 0) {
    add("Wrong size", wrong_size);
  }
  if (const std::string_view nothing = why_nothing(book, student); !nothing.empty()) {
    lines.push_back(fmt::format("<span>{}</span>", nothing));
  }
  std::string html;
  for (std::size_t i = 0; i < std::min(max_listed, lines.size()); ++i) {
    html += lines[i];
  }
  return lines.size() <= max_listed
             ? html
             : html + fmt::format("<small>and {} more</small>", lines.size() - max_listed);
}

std::string table_row(const Gradebook& book, std::size_t index) {
  const StudentResult& student = book.students[index];
  std::string causes;
  for (const CauseCount& count : count_causes({&student, 1})) {
    causes += fmt::format("{}{}", causes.empty() ? "" : " ", name_of(count.cause));
  }
  std::string html = fmt::format(
      "<tr data-causes=\"{}\"><th scope=\"row\"><a href=\"#s{}\">{}</a></th><td>{}/{}</td>"
      "<td class=\"mistakes\">{}</td>",
      causes, index, name_html(student.name), student.passed(), student.pictures.size(),
      mistakes_cell(book, student));
  for (std::size_t p = 0; p < student.pictures.size(); ++p) {
    const PictureResult& picture = student.pictures[p];
    html += picture.verdict == Verdict::passed
                ? fmt::format("<td class=passed>{}</td>", sign_of(picture.verdict))
                : fmt::format("<td class={}><a href=#p{}-{}>{}</a></td>", name_of(picture.verdict),
                              index, p, sign_of(picture.verdict));
  }
  return html + "</tr>\n";
}

std::string filters(const std::vector<CauseCount>& causes) {
  std::string html =
      "<div class=\"filters\"><label>Student <input id=\"name\" type=\"search\"></label>\n"
      "<label>Mistake <select id=\"cause\"><option value=\"\">any</option>";
  for (const CauseCount& count : causes) {
    html += fmt::format("<option value=\"{}\">{}</option>", name_of(count.cause),
                        markup(help_of(count.cause).title));
  }
  return html +
         "</select></label>\n<label>State <select id=\"state\"><option value=\"\">any</option>"
         "<option value=\"failed\">needs attention</option><option value=\"passed\">all passed"
         "</option></select></label>\n<span id=\"shown\" class=\"dim\" "
         "role=\"status\"></span></div>\n";
}

std::string head_cell(std::string_view name, std::string_view attributes = {}) {
  return fmt::format("<th scope=\"col\"{}><button type=\"button\">{}</button></th>", attributes,
                     markup(name));
}

std::string table(const Gradebook& book, const std::vector<CauseCount>& causes) {
  std::string html = filters(causes) +
                     "<div class=\"wide\" role=\"region\" aria-label=\"Results\" tabindex=\"0\">"
                     "<table class=\"results\">\n<thead><tr>" +
                     head_cell("Student") + head_cell("Passed") +
                     head_cell("Mistakes", " class=\"mistakes\"");
  if (!book.students.empty()) {
    for (const PictureResult& picture : book.students.front().pictures) {
      html += head_cell(picture.name,
                        fmt::format(" class=\"picture\" title=\"{}\"", markup(picture.name)));
    }
  }
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t s = 0; s < book.students.size(); ++s) {
    html += table_row(book, s);
  }
  return html + "</tbody>\n</table></div>\n";
}

// `lead`, and how many pictures passed.
std::string summary(const Gradebook& book, std::string_view lead) {
  std::string bar;
  std::string key;
  for (const Verdict verdict :
       {Verdict::passed, Verdict::differs, Verdict::missing, Verdict::unreadable}) {
    const std::size_t count = book.count(verdict);
    const std::string_view name = name_of(verdict);
    bar += fmt::format("<i class=\"{}\" style=\"flex-grow:{}\"></i>", name, count);
    key += fmt::format("<li><b class=\"{}\">{} {}</b> {}</li>", name, sign_of(verdict), count,
                       verdict == Verdict::differs && count != 1 ? "differ" : name);
  }
  return fmt::format(
      "<p class=\"lead\">{}</p>\n<div class=\"bar\" aria-hidden=\"true\">{}</div>\n"
      "<ul class=\"key\" aria-label=\"Pictures\">{}</ul>\n",
      lead, bar, key);
}

std::string lead_of_class(const Gradebook& book, const std::vector<CauseCount>& causes) {
  const std::size_t all = book.students.size();
  const auto attention = static_cast<std::size_t>(std::count_if(
      book.students.begin(), book.students.end(), [](const auto& s) { return failed(s) != 0; }));
  std::string html =
      fmt::format("<b>{} of {}</b> passed everything", all - attention, counted(all, "student"));
  if (attention != 0) {
    html += fmt::format("; <b>{}</b> need{} <a href=\"#attention\">attention</a>", attention,
                        attention == 1 ? "s" : "");
  }
  html += ".";
  if (!causes.empty() && causes.front().students > 1) {
    html +=
        fmt::format(" Most common mistake: {} ({}).", markup(help_of(causes.front().cause).title),
                    counted(causes.front().students, "student"));
  }
  return html;
}

std::string where_to_look(Cause cause) {
  return fmt::format("<p><b>Where to look:</b> {}</p>", markup(help_of(cause).where));
}

std::string mistakes_of_class(const std::vector<CauseCount>& causes, std::size_t students) {
  if (causes.empty()) {
    return {};
  }
  std::string html = "<section class=\"common\"><h2>Mistakes in this class</h2>\n";
  for (const CauseCount& count : causes) {
    const CauseHelp& help = help_of(count.cause);
    html += fmt::format(
        "<details><summary><b>{0}</b> {1} <span class=\"dim\">{2} of {3}, {4}</span></summary>"
        "<div class=\"body\"><p>{5}</p><p>{6}</p>{7}\n<p><button type=\"button\" class=\"push\" "
        "data-cause=\"{8}\">Show these students in the table</button></p></div></details>\n",
        markup(help.title), code(count.cause), count.students, counted(students, "student"),
        counted(count.pictures, "picture"), markup(help.looks), markup(help.why),
        where_to_look(count.cause), name_of(count.cause));
  }
  return html + "</section>\n";
}

// Links to the pictures.
std::string links(const StudentResult& student, std::size_t index,
                  const std::vector<std::size_t>& pictures) {
  std::string html;
  for (const std::size_t p : pictures) {
    html += fmt::format("{}<a href=#p{}-{}>{}</a>", html.empty() ? "" : ", ", index, p,
                        markup(student.pictures[p].name));
  }
  return html;
}

// Mistakes with where to look; `partly`: they explain only a part.
std::string mistakes_list(const StudentResult& student, std::size_t index, bool partly) {
  std::string html;
  for (const Mistake& mistake :
       mistakes_of(student, partly ? &PictureResult::partial : &PictureResult::causes)) {
    html += partly ? "<li class=\"part\">" : "<li>";
    for (const Mistake::Shown& shown : mistake.shown) {
      html += fmt::format("<p>{}<b>{}</b> {}", partly ? "In part: " : "", sentence(shown.what),
                          code(mistake.cause));
      for (const std::string& other : shown.instead) {
        html += fmt::format("<br>or {}", markup(other));
      }
      html +=
          fmt::format("<br><span class=\"dim\">{}</span> {}</p>",
                      !shown.instead.empty() ? "These give the same picture:"
                      : partly ? "Explains a part of the difference; something else is wrong, too:"
                               : "In",
                      links(student, index, shown.pictures));
    }
    html += where_to_look(mistake.cause) + "</li>\n";
  }
  return html;
}

// The <img> of the strip of a picture; empty if there is none. `attributes` follow its name.
std::string image(const PictureResult& picture, std::string_view attributes) {
  const std::string source = !picture.png_file.empty() ? link_to(picture.png_file)
                             : picture.png.empty()     ? std::string()
                                                   : "data:image/png;base64," + base64(picture.png);
  return source.empty() ? source
                        : fmt::format("<img loading=lazy {} src=\"{}\">", attributes, source);
}

std::string notes_of(const PictureResult& picture) {
  std::string html;
  for (const std::string& note : picture.notes) {
    html += fmt::format("<p class=\"dim\">Note: {}</p>\n", markup(note));
  }
  return html;
}

// `certainty`: what the sentences begin with.
std::string claims_html(const std::vector<Claim>& claims, std::string_view certainty) {
  std::string html;
  for (const Claim& claim : claims) {
    if (claim.cause != Cause::rounding && !claim.said) {
      html += fmt::format("<p><span class=why>{}{}</span> {}<small>{}</small></p>\n", certainty,
                          certainty.empty() ? sentence(claim.what) : markup(claim.what),
                          code(claim.cause), markup(claim.evidence));
    }
  }
  return html;
}

// A picture that did not pass, and is not missing.
std::string card(const PictureResult& picture, std::size_t index, std::size_t p) {
  std::string html = fmt::format(
      "<article class=card id=p{}-{}><h4><bdi>{}</bdi> <span class={}>{} {}</span></h4>\n", index,
      p, markup(picture.name), name_of(picture.verdict), sign_of(picture.verdict),
      name_of(picture.verdict));
  html += claims_html(picture.causes, "") + claims_html(picture.rivals, "Or: ") +
          claims_html(picture.partial, "In part: ");
  for (const std::string& reason : picture.reasons) {
    html += fmt::format("<p class=dim>{}</p>", sentence(reason));
  }
  html += notes_of(picture);
  const std::string strip = image(picture, fmt::format("alt=\"Enlarge {}\"", markup(picture.name)));
  if (!strip.empty()) {
    html +=
        fmt::format("<button class=shot>{}</button><small class=measures>{}</small>\n", strip,
                    picture.path_traced ? "truth · picture · significance: red is too bright, blue "
                                          "too dark, white is noise"
                                        : measures_line(picture.measures));
  }
  return html + "</article>\n";
}

// The pictures that were not handed in, in one line.
std::string missing(const StudentResult& student, std::size_t index) {
  std::string names;
  std::size_t count = 0;
  for (std::size_t p = 0; p < student.pictures.size(); ++p) {
    if (student.pictures[p].verdict == Verdict::missing) {
      names += fmt::format("{}<bdi id=\"p{}-{}\">{}</bdi>", names.empty() ? "" : ", ", index, p,
                           markup(student.pictures[p].name));
      ++count;
    }
  }
  return names.empty() ? std::string()
                       : fmt::format(
                             "<h3><span class=\"missing\">– {} missing</span></h3>\n"
                             "<p>{}</p>\n",
                             counted(count, "picture"), names);
}

// The pictures that passed, small.
std::string passed(const StudentResult& student) {
  constexpr int width = 96;
  std::string html;
  for (const PictureResult& picture : student.pictures) {
    if (picture.verdict != Verdict::passed) {
      continue;
    }
    const std::string name = fmt::format("<bdi>{}</bdi>", markup(picture.name));
    const glm::ivec2 size = picture.measures.right_size;
    const int height = size.x > 0 && size.y > 0 ? std::clamp(width * size.y / size.x, 24, 192) : 72;
    const std::string strip =
        image(picture, fmt::format("alt=\"\" width={} height={}", width, height));
    html +=
        strip.empty()
            ? fmt::format("<span>{}</span>\n", name)
            : fmt::format("<button class=shot title=\"{}\">{}{}</button>\n",
                          picture.path_traced
                              ? "right within its noise"
                              : fmt::format("PSNR {:.2f} dB", picture.measures.difference.psnr_db),
                          strip, name);
  }
  return html.empty() ? html
                      : fmt::format(
                            "<h3><span class=\"passed\">✓ {} passed</span></h3>\n"
                            "<div class=\"thumbs\">{}</div>\n",
                            counted(student.passed(), "picture"), html);
}

std::string list_html(const std::vector<std::string>& lines, std::string_view attribute = {}) {
  std::string html = fmt::format("<ul{}>\n", attribute);
  for (const std::string& line : lines) {
    html += fmt::format("<li>{}</li>\n", markup(line));
  }
  return html + "</ul>";
}

// Everything about a student. `index`: in the table. `ignored`: lines about their files.
std::string results(const StudentResult& student, std::size_t index,
                    const std::vector<std::string>& ignored) {
  std::string html = mistakes_list(student, index, false) + mistakes_list(student, index, true);
  html = html.empty() ? html
                      : "<h3>What to look at</h3>\n<ul class=\"mistakes-list\">" + html + "</ul>\n";
  std::string cards;
  for (std::size_t p = 0; p < student.pictures.size(); ++p) {
    const Verdict verdict = student.pictures[p].verdict;
    if (verdict != Verdict::passed && verdict != Verdict::missing) {
      cards += card(student.pictures[p], index, p);
    }
  }
  html += cards.empty() ? cards
                        : "<h3>What did not pass</h3>\n<div class=\"cards\">" + cards + "</div>\n";
  html += missing(student, index);
  if (const std::string unmatched = unmatched_text(student); !unmatched.empty()) {
    html += fmt::format("<p>{}.</p>\n", markup(unmatched));
  }
  html += ignored.empty() ? std::string() : "<h3>Not graded</h3>\n" + list_html(ignored) + "\n";
  html += passed(student);
  for (const PictureResult& picture : student.pictures) {
    if (picture.verdict == Verdict::passed && !picture.notes.empty()) {
      html += fmt::format("<h4>{}</h4>\n{}", name_html(picture.name), notes_of(picture));
    }
  }
  return html;
}

// Lines about the whole class that do not report mistakes.
std::string class_notes(std::string_view title, std::string_view remark,
                        const std::vector<std::string>& lines) {
  if (lines.empty()) {
    return {};
  }
  return fmt::format(
      "<section><h2>{}</h2>\n<details><summary>{} ({})</summary>{}</details></section>\n", title,
      remark, lines.size(), list_html(lines, " class=\"body\""));
}

std::string passed_of_all(const StudentResult& student) {
  return fmt::format("<b>{} of {}</b> passed", student.passed(),
                     counted(student.pictures.size(), "picture"));
}

std::string student_details(const Gradebook& book, std::size_t index) {
  const StudentResult& student = book.students[index];
  const std::vector<Mistake> mistakes = mistakes_of(student, &PictureResult::causes);
  const std::size_t more = mistakes.empty() ? 0 : mistakes.size() - 1;
  return fmt::format(
      "<details class=\"student\" id=\"s{}\"><summary><b class=\"who\">{}</b> {}{}</summary>\n"
      "<div class=\"body\">{}</div></details>\n",
      index, name_html(student.name),
      fmt::format("{} of {} passed", student.passed(), student.pictures.size()),
      mistakes.empty()
          ? std::string()
          : fmt::format(" <span class=\"dim\">· {}{}</span>", short_sentence(mistakes.front()),
                        more == 0 ? "" : fmt::format(", and {}", counted(more, "other mistake"))),
      results(student, index, ignored_lines(book, student.name)));
}

// The details of the students that passed everything, or of the others.
std::string students(const Gradebook& book, bool all_passed, std::string_view heading) {
  std::string html;
  for (std::size_t s = 0; s < book.students.size(); ++s) {
    if ((failed(book.students[s]) == 0) == all_passed) {
      html += student_details(book, s);
    }
  }
  return html.empty() ? html : fmt::format("<section>{}\n{}</section>\n", heading, html);
}

}  // namespace

std::string gradebook_html(const Gradebook& book, std::string_view title, std::string_view date) {
  const std::vector<CauseCount> causes = count_causes(book.students);
  return report_page(
      title, date,
      summary(book, lead_of_class(book, causes)) + table(book, causes) +
          mistakes_of_class(causes, book.students.size()) +
          class_notes("Identical files",
                      "The same bytes from several students, which may have many reasons",
                      identical_lines(book)) +
          class_notes("Ignored files", "Not graded, and why", ignored_lines(book)) +
          students(book, false, "<h2 id=\"attention\">Students who need attention</h2>") +
          students(book, true, "<h2>Students who passed everything</h2>"));
}

std::string student_html(const StudentResult& student, std::string_view title,
                         std::string_view date, const std::vector<std::string>& ignored) {
  return report_page(
      title, date,
      fmt::format("<div class=\"student\">\n<h2 class=\"who\">{}</h2>\n{}{}</div>\n",
                  name_html(student.name), summary({{student}}, passed_of_all(student)),
                  results(student, 0, ignored)));
}

}  // namespace scenefile
