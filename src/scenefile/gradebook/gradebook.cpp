#include "scenefile/gradebook/gradebook.h"

#include "scenefile/base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// "PSNR is 31.20 dB, less than 40; cause: there are no shadows".
std::string reasons_text(const PictureResult& picture) {
  std::string text;
  for (const std::string& reason : picture.reasons) {
    text += (text.empty() ? "" : "; ") + reason;
  }
  for (const Claim& claim : picture.causes) {
    text += "; cause: " + claim.what;
  }
  for (const Claim& claim : picture.partial) {
    text += "; in part: " + claim.what;
  }
  return text;
}

// The columns of a terminal that fmt counts for the text when it pads; at most its bytes.
std::size_t columns_of(const std::string& text) {
  return 2 * text.size() - fmt::formatted_size("{:<{}}", text, text.size());
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  static constexpr std::array<std::string_view, 4> names{"passed", "differs", "missing",
                                                         "unreadable"};
  return names[static_cast<std::size_t>(verdict)];
}

std::size_t StudentResult::passed() const {
  return static_cast<std::size_t>(
      std::count_if(pictures.begin(), pictures.end(),
                    [](const PictureResult& p) { return p.verdict == Verdict::passed; }));
}

std::size_t Gradebook::count(Verdict verdict) const {
  std::size_t sum = 0;
  for (const StudentResult& student : students) {
    sum += static_cast<std::size_t>(
        std::count_if(student.pictures.begin(), student.pictures.end(),
                      [&](const PictureResult& p) { return p.verdict == verdict; }));
  }
  return sum;
}

bool Gradebook::all_passed() const {
  return std::all_of(students.begin(), students.end(), [](const StudentResult& student) {
    return student.passed() == student.pictures.size();
  });
}

std::vector<Cause> distinct_causes(const PictureResult& picture) {
  std::vector<Cause> causes;
  for (const Claim& claim : picture.causes) {
    if (std::find(causes.begin(), causes.end(), claim.cause) == causes.end()) {
      causes.push_back(claim.cause);
    }
  }
  return causes;
}

std::vector<CauseCount> count_causes(std::span<const StudentResult> students) {
  std::array<CauseCount, cause_count> counts;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    counts[i].cause = static_cast<Cause>(i);
  }
  for (const StudentResult& student : students) {
    std::array<bool, cause_count> of_student{};
    for (const PictureResult& picture : student.pictures) {
      for (const Cause cause : distinct_causes(picture)) {
        ++counts[static_cast<std::size_t>(cause)].pictures;
        of_student[static_cast<std::size_t>(cause)] = true;
      }
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
      counts[i].students += of_student[i] ? 1 : 0;
    }
  }
  std::vector<CauseCount> found;
  std::copy_if(counts.begin(), counts.end(), std::back_inserter(found),
               [](const CauseCount& c) { return c.pictures > 0 && c.cause != Cause::rounding; });
  std::stable_sort(found.begin(), found.end(), [](const CauseCount& a, const CauseCount& b) {
    return a.pictures > b.pictures;
  });
  return found;
}

std::string unmatched_text(const StudentResult& student) {
  constexpr std::size_t max_unmatched_listed = 8;
  const bool missing =
      std::any_of(student.pictures.begin(), student.pictures.end(),
                  [](const PictureResult& p) { return p.verdict == Verdict::missing; });
  if (!missing || student.unmatched.empty()) {
    return {};
  }
  const std::size_t count = student.unmatched.size();
  std::string text =
      fmt::format("{} no reference: ",
                  count == 1 ? "1 picture matches" : fmt::format("{} pictures match", count));
  for (std::size_t i = 0; i < std::min(count, max_unmatched_listed); ++i) {
    text += (i == 0 ? "" : ", ") + student.unmatched[i];
  }
  return text + (count > max_unmatched_listed
                     ? fmt::format(" and {} more", count - max_unmatched_listed)
                     : "");
}

void find_identical_files(Gradebook& book) {
  constexpr std::size_t max_names = 8;
  struct Group {
    std::string names;
    std::size_t count = 0;
  };
  // By the index of the picture and its fingerprint.
  std::map<std::pair<std::size_t, std::uint64_t>, Group> groups;
  const auto for_each = [&](const auto& visit) {
    for (StudentResult& student : book.students) {
      for (std::size_t i = 0; i < student.pictures.size(); ++i) {
        if (student.pictures[i].fingerprint != 0) {
          visit(student, student.pictures[i], groups[{i, student.pictures[i].fingerprint}]);
        }
      }
    }
  };
  for_each([](const StudentResult& student, const PictureResult&, Group& group) {
    if (group.count < max_names) {
      group.names += (group.count == 0 ? "" : ", ") + student.name;
    }
    ++group.count;
  });
  for_each([](const StudentResult&, PictureResult& picture, const Group& group) {
    picture.identical = group.count < 2 ? std::string()
                        : group.count > max_names
                            ? fmt::format("{} and {} more", group.names, group.count - max_names)
                            : group.names;
  });
}

std::vector<std::string> identical_lines(const Gradebook& book) {
  std::vector<std::string> lines;
  for (const StudentResult& student : book.students) {
    for (const PictureResult& picture : student.pictures) {
      std::string line = fmt::format("{}: {}", picture.name, picture.identical);
      if (!picture.identical.empty() &&
          std::find(lines.begin(), lines.end(), line) == lines.end()) {
        lines.push_back(std::move(line));
      }
    }
  }
  return lines;
}

std::vector<std::string> ignored_lines(const Gradebook& book) {
  std::vector<std::string> lines;
  std::vector<bool> told(book.ignored.size());
  for (std::size_t i = 0; i < book.ignored.size(); ++i) {
    const IgnoredFile& first = book.ignored[i];
    std::size_t more = 0;
    // Files of one student are adjacent.
    for (std::size_t j = i + 1; !told[i] && !first.student.empty() && j < book.ignored.size() &&
                                book.ignored[j].student == first.student;
         ++j) {
      if (!told[j] && book.ignored[j].reason == first.reason) {
        told[j] = true;
        ++more;
      }
    }
    if (!told[i]) {
      lines.push_back(fmt::format("{}{}: {}", first.path,
                                  more == 0 ? "" : fmt::format(" and {} more", more),
                                  first.reason));
    }
  }
  return lines;
}

std::vector<std::string> ignored_lines(const Gradebook& book, std::string_view student) {
  Gradebook own;
  std::copy_if(book.ignored.begin(), book.ignored.end(), std::back_inserter(own.ignored),
               [&](const IgnoredFile& file) { return file.student == student; });
  return ignored_lines(own);
}

std::string gradebook_text(const Gradebook& book) {
  constexpr std::size_t max_line = 4096;  // bytes
  std::size_t width = 0;
  for (const StudentResult& student : book.students) {
    width = std::max(width, columns_of(escaped(student.name)));
  }
  std::string text;
  for (const StudentResult& student : book.students) {
    text += fmt::format("{:<{}}  {} of {} passed\n", escaped(student.name), width, student.passed(),
                        student.pictures.size());
    std::vector<std::string> missing;
    for (const PictureResult& picture : student.pictures) {
      if (picture.verdict == Verdict::missing) {
        missing.push_back(escaped(picture.name));
      } else if (picture.verdict != Verdict::passed) {
        text += fmt::format("    {}: {}: {}\n", escaped(picture.name), name_of(picture.verdict),
                            escaped(reasons_text(picture), max_line));
      }
      for (const std::string& note : picture.notes) {
        text += fmt::format("    {}: note: {}\n", escaped(picture.name), escaped(note, max_line));
      }
    }
    if (!missing.empty()) {
      text += fmt::format("    missing: {}\n", fmt::join(missing, ", "));
    }
    if (const std::string unmatched = unmatched_text(student); !unmatched.empty()) {
      text += fmt::format("    {}; --map assigns other names\n", escaped(unmatched, max_line));
    }
  }
  const auto list = [&](std::string_view title, const std::vector<std::string>& lines) {
    text += lines.empty() ? std::string() : fmt::format("{}:\n", title);
    for (const std::string& line : lines) {
      text += fmt::format("    {}\n", escaped(line, max_line));
    }
  };
  list("identical files", identical_lines(book));
  list("ignored", ignored_lines(book));
  const std::size_t passed = book.count(Verdict::passed);
  const std::size_t differ = book.count(Verdict::differs);
  return text + fmt::format(
                    "{}: {} passed, {} differ{}, {} missing, {} "
                    "unreadable\n",
                    counted(book.students.size(), "student"), counted(passed, "picture"), differ,
                    differ == 1 ? "s" : "", book.count(Verdict::missing),
                    book.count(Verdict::unreadable));
}

}  // namespace scenefile
