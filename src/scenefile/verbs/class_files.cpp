#include "scenefile/verbs/class_files.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/base/ascii.h"
#include "scenefile/io/archive.h"
#include "scenefile/io/folder.h"
#include "scenefile/verbs/list_class.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace scenefile {

namespace {

// Of entries with the same path, the last one counts.
void drop_overwritten(std::vector<ClassItem>& items) {
  std::map<std::pair<std::string, std::vector<std::string>>, std::size_t> last;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!items[i].file.entries.empty()) {
      const auto [at, added] = last.try_emplace({items[i].file.path, items[i].file.entries}, i);
      if (!added) {
        items[at->second].reason = "a later entry of the archive has the same name";
        at->second = i;
      }
    }
  }
}

// The first folder, or the name of a file directly in the class.
std::string top_of(const ClassItem& item) {
  return item.file.folders.empty() ? file_name(item.file) : item.file.folders.front();
}

bool is_loose(const ClassItem& item) {
  return item.file.folders.empty();
}

bool has_reference(const std::vector<FoundFile>& references, const FoundFile& file) {
  return std::any_of(references.begin(), references.end(), [&](const FoundFile& reference) {
    return best_named(reference, {file}) == 0;
  });
}

// The name in the form of a course system, if it has one and is not the name of a reference.
bool read_name(const std::string& name, const std::vector<FoundFile>& references,
               CourseSystemName& result) {
  return read_course_system_name(name, result) &&
         !(is_picture_name(name) && has_reference(references, file_of(name, {})));
}

// Archives of a whole class often have one folder that contains the rest; and the archive that a
// course system made may lie next to other files.
void unwrap(ClassListing& listing, const std::vector<FoundFile>& references, bool is_archive) {
  std::vector<ClassItem>& items = listing.items;
  const auto enter = [&](const std::string& top) {
    const auto enter_from = [&](std::vector<std::string>& folders) {
      if (!folders.empty() && folders.front() == top) {
        folders.erase(folders.begin());
      }
    };
    for (ClassItem& item : items) {
      enter_from(item.file.folders);
    }
    std::for_each(listing.folders.begin(), listing.folders.end(), enter_from);
    std::erase(listing.folders, std::vector<std::string>());
  };
  const auto in_first = [&](const std::vector<std::string>& folders) {
    return !folders.empty() && folders.front() == items.front().file.folders.front();
  };
  while (is_archive && !items.empty() && !is_loose(items.front()) &&
         !is_archive_name(items.front().file.folders.front()) &&
         std::all_of(items.begin(), items.end(),
                     [&](const ClassItem& item) { return in_first(item.file.folders); }) &&
         std::all_of(listing.folders.begin(), listing.folders.end(), in_first)) {
    enter(std::string(items.front().file.folders.front()));
  }
  std::set<std::string> packed;
  for (const ClassItem& item : items) {
    CourseSystemName name;
    if (item.file.folders.size() == 1 && is_archive_name(item.file.folders.front()) &&
        !read_name(item.file.folders.front(), references, name) &&
        read_name(file_name(item.file), references, name)) {
      packed.insert(item.file.folders.front());
    }
  }
  for (const std::string& top : packed) {
    enter(top);
  }
}

// The number of references that the pictures among the items show.
template <typename Take>
std::size_t shown(const std::vector<ClassItem>& items, const std::vector<FoundFile>& references,
                  const Take& take) {
  std::vector<FoundFile> pictures;
  for (const ClassItem& item : items) {
    if (item.reason.empty() && take(item)) {
      pictures.push_back(item.file);
    }
  }
  const std::vector<int> found = match_pictures(references, pictures).pictures;
  return static_cast<std::size_t>(
      std::count_if(found.begin(), found.end(), [](int picture) { return picture >= 0; }));
}

// A folder, an archive or a file directly in the class.
struct Top {
  std::string name;
  bool archive = false;
  bool folder = false;
  bool of_system = false;  // `system` is set
  CourseSystemName system = {};
  std::vector<const ClassItem*> items = {};
};

std::vector<Top> tops_of(const ClassListing& listing, const std::vector<FoundFile>& references) {
  std::map<std::string, Top> tops;
  for (const std::vector<std::string>& folder : listing.folders) {
    tops[folder.front()].folder = true;
  }
  for (const ClassItem& item : listing.items) {
    Top& top = tops[top_of(item)];
    top.folder = top.folder || !is_loose(item);
    top.items.push_back(&item);
  }
  std::vector<Top> list;
  for (auto& [name, top] : tops) {
    top.name = name;
    top.folder = top.folder && !is_hidden_name(name);
    top.archive =
        !is_hidden_name(name) && (is_archive_name(name) || (!top.folder && is_other_archive(name)));
    top.of_system = read_name(name, references, top.system);
    list.push_back(std::move(top));
  }
  return list;
}

// Only one student: pictures are only in folders of layouts, or those next to folders show at least
// as many references as those in them. Folders without pictures say nothing: a repository has some
// with code. Not if most have names of a course system; a few pictures look as if they had, such as
// ball_640_480_final.png. `why`: set in the second case.
bool is_one_student(const std::vector<Top>& tops, const std::vector<ClassItem>& items,
                    const std::vector<FoundFile>& references, std::string& why) {
  std::size_t in_folders = 0;
  bool layout = true;
  std::size_t of_system = 0;
  std::size_t others = 0;
  for (const Top& top : tops) {
    of_system += top.of_system ? 1 : 0;
    others += !top.of_system && !top.folder && is_picture_name(top.name) ? 1 : 0;
    if (top.folder && std::any_of(top.items.begin(), top.items.end(),
                                  [](const ClassItem* item) { return item->reason.empty(); })) {
      layout = layout && is_layout_folder(without_archive_ending(top.name));
    }
  }
  if (of_system > others) {
    return false;
  }
  if (layout) {
    return true;
  }
  const std::size_t loose = shown(items, references, is_loose);
  for (const Top& top : tops) {
    if (loose > 0 && !is_layout_folder(without_archive_ending(top.name))) {
      in_folders += shown(items, references, [&](const ClassItem& item) {
        return !is_loose(item) && item.file.folders.front() == top.name;
      });
    }
  }
  if (loose == 0 || loose < in_folders) {
    return false;
  }
  if (in_folders > 0) {
    why = fmt::format(
        "it is taken for one student's folder, because at least as many pictures directly in it "
        "have the "
        "name of a reference ({}) as in its folders ({}); if it is a class, move them elsewhere",
        loose, in_folders);
  }
  return true;
}

// Blackboard's names say where the assignment ends and the user starts only together: all begin
// with the assignment.
void name_blackboard_users(std::vector<Top>& tops) {
  std::set<std::string> heads;
  for (const Top& top : tops) {
    if (top.of_system && !top.system.attempt.empty()) {
      heads.insert(top.system.student);
    }
  }
  if (heads.size() < 2) {
    return;
  }
  const auto& [first, last] = std::mismatch(heads.begin()->begin(), heads.begin()->end(),
                                            heads.rbegin()->begin(), heads.rbegin()->end());
  const std::size_t start =
      heads.begin()->rfind('_', static_cast<std::size_t>(first - heads.begin()->begin())) + 1;
  for (Top& top : tops) {
    if (top.of_system && !top.system.attempt.empty() && start < top.system.student.size()) {
      top.system.name = top.system.student.substr(start);
    }
  }
}

// "ball" and 2 for "ball-2.png": Canvas numbers files that are handed in again under one name.
std::pair<std::string, std::uint64_t> without_number(const std::string& name) {
  const std::string ending =
      is_archive_name(name) ? name.substr(without_archive_ending(name).size()) : ending_of(name);
  const std::string stem = name.substr(0, name.size() - ending.size());
  const std::size_t dash = stem.rfind('-');
  if (dash == std::string::npos || dash == 0 || dash + 1 == stem.size() || stem.size() - dash > 4 ||
      !std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(dash) + 1, stem.end(), is_digit)) {
    return {name, 0};
  }
  return {stem.substr(0, dash) + ending, std::stoull(stem.substr(dash + 1))};
}

class ClassBuilder {
 public:
  ClassBuilder(const std::string& folder, const std::vector<FoundFile>& references)
      : references_(references), folder_(folder) {}

  ClassFiles build(const std::vector<std::string>& other_folders, bool one_student) {
    ClassListing listing = list_class(folder_, other_folders);
    drop_overwritten(listing.items);
    const bool is_archive = !is_folder(folder_);
    std::set<std::string> paths;
    // In the archive of a class, their folders do not say whose they are.
    std::erase_if(listing.items, [&](const ClassItem& item) {
      const bool unknown = is_archive && item.outside && item.file.entries.size() == 1;
      if (unknown) {
        paths.insert(item.file.path);
        result_.ignored.push_back({item.file.entries.front(), {}, item.reason});
      }
      return unknown;
    });
    paths.insert(listing.gradescope_path);
    for (const ClassItem& item : listing.items) {
      paths_.push_back(path_below(item.file));
      if (item.reason != not_a_picture) {
        paths.insert(item.file.path);
      }
    }
    result_.paths.assign(paths.begin(), paths.end());
    unwrap(listing, references_, is_archive);
    first_ = listing.items.data();
    std::vector<Top> tops = tops_of(listing, references_);
    if (one_student || is_one_student(tops, listing.items, references_, result_.one_student)) {
      StudentFiles& student = result_.students.emplace_back();
      student.name = name_of_class(folder_);
      for (const ClassItem& item : listing.items) {
        add(student, item, item.file);
      }
      return std::move(result_);
    }
    name_blackboard_users(tops);
    add_students(tops, read_gradescope_names(listing.gradescope));
    return std::move(result_);
  }

 private:
  // Submissions of a student, in the order in which their pictures are preferred.
  struct Student {
    std::string name;
    std::string id;
    std::vector<Top*> tops = {};
  };

  const std::string& path_of(const ClassItem& item) const {
    return paths_[static_cast<std::size_t>(&item - first_)];
  }

  void add(StudentFiles& student, const ClassItem& item, FoundFile file) const {
    if (item.reason.empty()) {
      student.pictures.push_back(std::move(file));
    } else {
      student.ignored.push_back({path_of(item), student.name, item.reason});
    }
  }

  void ignore(StudentFiles& student, const Top& top, const std::string& reason) const {
    // The path of the folder or archive, not of all files in it.
    std::string path;
    if (!top.items.empty()) {
      const FoundFile& file = top.items.front()->file;
      path = path_of(*top.items.front());
      path.resize(path.size() - path_below(file).size());
    }
    student.ignored.push_back({path + top.name, student.name, reason});
  }

  void add_students(std::vector<Top>& tops, const std::map<std::string, std::string>& gradescope) {
    std::map<std::string, Student> students;
    for (Top& top : tops) {
      std::string key = "/" + top.name;
      Student student{top.name, {}};
      if (top.of_system) {
        key = top.system.student;
        student = {top.system.name, top.system.id};
      } else if (const auto name = gradescope.find(top.name); name != gradescope.end()) {
        student = {name->second, top.name};
      } else if (top.archive) {
        // gina.zip, gina.tar.xz and the folder gina belong to one student.
        std::string_view name = top.name;
        name.remove_suffix(is_archive_name(name) ? 0 : ending_of(name).size());
        student.name = without_archive_ending(name);
        key = "/" + student.name;
      } else if (!top.folder) {
        for (const ClassItem* item : top.items) {
          result_.ignored.push_back(
              {path_of(*item),
               {},
               item->reason.empty() ? "its name does not say whose picture it is" : item->reason});
        }
        continue;
      }
      students.try_emplace(key, std::move(student)).first->second.tops.push_back(&top);
    }
    std::map<std::string, int> namesakes;
    for (const auto& [key, student] : students) {
      ++namesakes[student.name];
    }
    std::set<std::string> names;
    for (auto& [key, student] : students) {
      StudentFiles files;
      files.name = namesakes[student.name] > 1 && !student.id.empty()
                       ? fmt::format("{} ({})", student.name, student.id)
                       : student.name;
      if (!names.insert(files.name).second) {
        files.name += fmt::format(" ({})", key);
        names.insert(files.name);
      }
      add_submissions(student, files);
      result_.students.push_back(std::move(files));
    }
    std::sort(result_.students.begin(), result_.students.end(),
              [](const StudentFiles& a, const StudentFiles& b) { return a.name < b.name; });
  }

  // Of files that replace each other, the last one.
  void add_submissions(Student& student, StudentFiles& files) const {
    std::string attempt;
    std::set<std::string> originals;
    for (const Top* top : student.tops) {
      attempt = std::max(attempt, top->system.attempt);
      originals.insert(top->system.original);
    }
    // Without the number, if there is such a file, too.
    const auto original_of = [&](const Top& top) {
      std::pair<std::string, std::uint64_t> numbered = without_number(top.system.original);
      return originals.contains(numbered.first) && !shows(top.system.original)
                 ? numbered
                 : std::pair(top.system.original, std::uint64_t{0});
    };
    const auto order = [&](const Top& top) {
      return std::tuple(top.system.number, original_of(top).second, !top.archive);
    };
    std::stable_sort(student.tops.begin(), student.tops.end(),
                     [&](const Top* a, const Top* b) { return order(*a) > order(*b); });
    std::map<std::string, const Top*> latest;
    for (const Top* top : student.tops) {
      if (top->system.attempt != attempt) {
        ignore(files, *top, "superseded by a later attempt");
        continue;
      }
      const std::string original = original_of(*top).first;
      if (!original.empty()) {
        const auto [at, added] = latest.try_emplace(original, top);
        if (!added) {
          ignore(files, *top, fmt::format("{} replaces it", at->second->name));
          continue;
        }
      }
      for (const ClassItem* item : top->items) {
        FoundFile file = item->file;
        file.late = top->system.late;
        if (is_loose(*item) && top->of_system) {
          file.stem = stem_of(top->system.original);
        } else if (!is_loose(*item)) {
          file.folders.erase(file.folders.begin());
        }
        add(files, *item, std::move(file));
      }
    }
  }

  bool shows(const std::string& name) const {
    return is_picture_name(name) && has_reference(references_, file_of(name, {}));
  }

  // The name of the student's picture, without Canvas's number unless a reference has it.
  std::string stem_of(const std::string& original) const {
    return file_of(shows(original) ? original : without_number(original).first, {}).stem;
  }

  const std::vector<FoundFile>& references_;
  const std::string& folder_;
  const ClassItem* first_ = nullptr;
  std::vector<std::string> paths_;  // of the items, below the class
  ClassFiles result_;
};

}  // namespace

std::string name_of_class(const std::string& folder) {
  const std::string whole = absolute_path(folder);
  std::string_view path = whole;
  while (path.size() > 1 && (path.ends_with('/') || path.ends_with("/."))) {
    path.remove_suffix(1);
  }
  const std::string name(path.substr(path.rfind('/') + 1));
  return is_folder(folder) ? name : std::string(without_archive_ending(name));
}

ClassFiles find_class_files(const std::string& folder, const std::vector<FoundFile>& references,
                            const std::vector<std::string>& other_folders, bool one_student) {
  return ClassBuilder(folder, references).build(other_folders, one_student);
}

}  // namespace scenefile
