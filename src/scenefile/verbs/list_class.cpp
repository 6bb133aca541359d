#include "scenefile/verbs/list_class.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/text.h"
#include "scenefile/io/archive.h"
#include "scenefile/io/descriptor.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/verbs/class_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace scenefile {

namespace {

constexpr std::size_t max_class_files = 20'000;  // of a student
constexpr std::size_t max_class_folders = 16;
constexpr std::size_t max_archives = 3;  // in one another
constexpr std::string_view gradescope_table = "submission_metadata.yml";
constexpr std::string_view hidden = "hidden: its name begins with a dot";
constexpr std::string_view no_student =
    "it is, or contains, the folder of references, scenes or results";

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Why a file with this name is not read.
std::string why_unread(std::string_view name) {
  if (is_other_archive(name)) {
    return "archives of this kind are not read: use .zip, .tar or .tar.gz";
  }
  if (is_one_of(ending_of(name), {".webp", ".heic", ".heif", ".tif", ".tiff", ".avif", ".jxl",
                                  ".svg", ".pdf", ".psd"})) {
    return "pictures of this kind are not read: use .png";
  }
  return std::string(not_a_picture);
}

// Device and inode.
using FolderIdentity = std::pair<std::uint64_t, std::uint64_t>;

FolderIdentity identity_of(const std::string& folder) {
  const FileStamp stamp = stamp_of(folder);
  return {stamp.device, stamp.inode};
}

// The identities of the folders, as far as they exist, and of all that contain them.
std::set<FolderIdentity> identities_of(const std::vector<std::string>& folders) {
  std::set<FolderIdentity> identities;
  for (const std::string& folder : folders) {
    for (std::string path = real_folder_of(folder + "/file"); path != folder_of(path);
         path = folder_of(path)) {
      identities.insert(identity_of(path));
    }
  }
  identities.erase(FolderIdentity());
  return identities;
}

// Adds the names of a path in an archive.
void add_names(std::string_view path, std::vector<std::string>& names) {
  while (!path.empty()) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    names.emplace_back(path.substr(0, slash));
    path.remove_prefix(std::min(slash + 1, path.size()));
  }
}

// What an archive in another one may use.
ArchiveBudget inner_budget(const ArchiveBudget& outer) {
  const ArchiveBudget usual;
  return {std::min(usual.entries, outer.entries), std::min(usual.bytes, outer.bytes)};
}

// Visits an archive in another one, whose budget it shares.
template <typename Visit>
std::string visit_inner(const std::string& bytes, ArchiveBudget& outer, const Visit& visit) {
  const ArchiveBudget before = inner_budget(outer);
  ArchiveBudget inner = before;
  std::string why = visit_archive_bytes(
      bytes, inner,
      [&](const ArchiveEntry& entry, const ReadEntry& read) { visit(entry, read, inner); });
  outer.entries -= before.entries - inner.entries;
  outer.bytes -= before.bytes - inner.bytes;
  return why;
}

// Lists folders and archives.
class Lister {
 public:
  Lister(ClassListing& listing, const std::vector<std::string>& other_folders)
      : listing_(listing), others_(identities_of(other_folders)) {}

  void add_class(const std::string& folder) {
    if (!is_folder(folder)) {
      // The archive itself is not in a folder of the class. The user named it, so links to it are
      // followed.
      const FoundFile archive = file_of(follow_links(folder), {});
      left_ = class_archive_budget.entries;
      const std::string why = add_archive(archive, {}, class_archive_budget);
      if (!why.empty()) {
        listing_.items.push_back({archive, why});
      }
      return;
    }
    for (const FolderEntry& entry : entries_of(folder)) {
      left_ = max_class_files;
      if (is_hidden_name(entry.name)) {
        add(file_of(entry.path, {}), std::string(hidden));
      } else if (entry.folder && others_.contains(identity_of(entry.path))) {
        add(file_of(entry.path, {}), std::string(no_student));
      } else if (entry.folder) {
        listing_.folders.push_back({entry.name});
        add_folder(entry.path, {entry.name});
      } else {
        add_file(entry, {});
      }
    }
  }

 private:
  void add(FoundFile file, std::string reason, bool outside = false) {
    if (left_ == 0) {
      return;
    }
    --left_;
    listing_.items.push_back(
        {std::move(file), left_ > 0 ? std::move(reason) : "too many files: the rest are not read",
         outside});
  }

  void add_folder(const std::string& folder, const std::vector<std::string>& folders) {
    std::string problem;
    const std::vector<FolderEntry> entries = entries_of(folder, &problem);
    if (!problem.empty()) {
      add(file_of(folder, {folders.begin(), folders.end() - 1}),
          "the folder cannot be read: " + problem);
    }
    for (const FolderEntry& entry : entries) {
      if (is_hidden_name(entry.name)) {
        add(file_of(entry.path, folders), std::string(hidden));
      } else if (!entry.folder) {
        add_file(entry, folders);
      } else if (entry.link || folders.size() >= max_class_folders) {
        add(file_of(entry.path, folders),
            entry.link ? "links to folders are not followed"
                       : fmt::format("nested more than {} folders deep", max_class_folders));
      } else {
        std::vector<std::string> inside = folders;
        inside.push_back(entry.name);
        add_folder(entry.path, inside);
      }
    }
  }

  void add_file(const FolderEntry& entry, const std::vector<std::string>& folders) {
    FoundFile file = file_of(entry.path, folders);
    if (folders.empty() && entry.name == gradescope_table) {
      add_gradescope_table(std::move(file), read_file(entry.path, Limits{}.file_bytes));
      return;
    }
    if (is_picture_name(entry.name)) {
      add(std::move(file), {});
      return;
    }
    std::string why;
    if (!is_archive_name(entry.name)) {
      why = why_unread(entry.name);
    } else if (entry.link) {
      why = "a symbolic link, not a file";
    } else {
      std::vector<std::string> inside = folders;
      inside.push_back(entry.name);
      why = add_archive(file, inside, {});
    }
    if (!why.empty()) {
      add(std::move(file), std::move(why));
    }
  }

  void add_gradescope_table(FoundFile file, const Result<std::string>& text) {
    listing_.gradescope_path = file.path;
    if (text) {
      listing_.gradescope = *text;
    } else {
      add(std::move(file), text.error().text);
    }
  }

  // Returns what is wrong with the archive; its entries are in `folders`.
  std::string add_archive(const FoundFile& archive, const std::vector<std::string>& folders,
                          ArchiveBudget budget) {
    budget.entries = std::min<std::uint64_t>(budget.entries, left_);
    const std::size_t before = listing_.items.size();
    std::string why = visit_archive(
        archive.path, budget,
        [&](const ArchiveEntry& entry, const ReadEntry& read) {
          add_entry(archive, folders, entry, read, budget);
        },
        [&](std::string_view path) {
          std::vector<std::string> inside = folders;
          add_names(path, inside);
          if (listing_.folders.empty() || listing_.folders.back() != inside) {
            listing_.folders.push_back(std::move(inside));
          }
        });
    return why.empty() && listing_.items.size() == before ? "it contains no files" : why;
  }

  void add_entry(const FoundFile& archive, std::vector<std::string> folders,
                 const ArchiveEntry& entry, const ReadEntry& read, ArchiveBudget& budget) {
    add_names(entry.path, folders);
    std::string path;
    if (!entry.path.empty()) {
      path = std::move(folders.back());
      folders.pop_back();
    }
    std::vector<std::string> entries = archive.entries;
    entries.push_back(entry.path);
    FoundFile file = file_of(archive.path, folders, std::move(entries));
    if (folders.size() <= 1 && path == gradescope_table && entry.problem.empty()) {
      add_gradescope_table(std::move(file), read(Limits{}.file_bytes));
      return;
    }
    std::string why = entry.problem;
    if (why.empty() &&
        (is_hidden_name(path) || std::any_of(folders.begin(), folders.end(), is_hidden_name))) {
      why = hidden;
    } else if (why.empty() && is_archive_name(path)) {
      std::vector<std::string> inside = folders;
      inside.emplace_back(path);
      why = add_inner_archive(file, inside, read, budget);
      if (why.empty()) {
        return;
      }
    } else if (why.empty() && !is_picture_name(path)) {
      why = why_unread(path);
    }
    add(std::move(file), std::move(why), entry.outside);
  }

  std::string add_inner_archive(const FoundFile& archive, const std::vector<std::string>& folders,
                                const ReadEntry& read, ArchiveBudget& budget) {
    if (archive.entries.size() >= max_archives) {
      return fmt::format("archives nested more than {} deep", max_archives);
    }
    const Result<std::string> bytes = read(inner_budget(budget).bytes);
    if (!bytes) {
      return bytes.error().text;
    }
    const std::size_t before = listing_.items.size();
    std::string why = visit_inner(
        *bytes, budget,
        [&](const ArchiveEntry& entry, const ReadEntry& read_inner, ArchiveBudget& inner) {
          add_entry(archive, folders, entry, read_inner, inner);
        });
    return why.empty() && listing_.items.size() == before ? "it contains no files" : why;
  }

  ClassListing& listing_;
  std::set<FolderIdentity> others_;
  std::size_t left_ = max_class_files;
};

// Reads the files of `wanted` (indices), whose paths have `level` archives before this one.
void read_entries(const std::vector<FoundFile>& files, const std::vector<std::size_t>& wanted,
                  std::size_t level, const ArchiveEntry& entry, const ReadEntry& read,
                  ArchiveBudget& budget, std::vector<Result<std::string>>& results) {
  std::vector<std::size_t> here;
  std::vector<std::size_t> inside;
  for (const std::size_t i : wanted) {
    if (files[i].entries[level] == entry.path) {
      (files[i].entries.size() == level + 1 ? here : inside).push_back(i);
    }
  }
  if (here.empty() && inside.empty()) {
    return;
  }
  const Result<std::string> bytes =
      read(inside.empty() ? Limits{}.file_bytes : inner_budget(budget).bytes);
  for (const std::size_t i : here) {
    results[i] = bytes;
  }
  if (!inside.empty() && bytes) {
    visit_inner(*bytes, budget,
                [&](const ArchiveEntry& inner, const ReadEntry& read_inner, ArchiveBudget& left) {
                  read_entries(files, inside, level + 1, inner, read_inner, left, results);
                });
  }
}

}  // namespace

ClassListing list_class(const std::string& folder, const std::vector<std::string>& other_folders) {
  ClassListing listing;
  Lister(listing, other_folders).add_class(folder);
  return listing;
}

bool is_other_archive(std::string_view name) {
  return is_one_of(ending_of(name), {".rar", ".7z", ".gz", ".bz2", ".tbz", ".tbz2", ".xz", ".txz",
                                     ".zst", ".lz", ".lzma", ".z", ".zipx"});
}

FoundFile file_of(std::string path, std::vector<std::string> folders,
                  std::vector<std::string> entries) {
  FoundFile file{std::move(path), std::move(folders), {}, std::move(entries)};
  const std::string name = file_name(file);
  file.stem = name.substr(0, name.size() - ending_of(name).size());
  return file;
}

std::vector<Result<std::string>> read_archived(const std::vector<FoundFile>& files,
                                               const ArchiveBudget& budget) {
  std::vector<Result<std::string>> results(files.size(), Error{});
  std::map<std::string, std::vector<std::size_t>> archives;
  for (std::size_t i = 0; i < files.size(); ++i) {
    archives[files[i].path].push_back(i);
  }
  for (auto& [path, wanted] : archives) {
    // After damage, the rest of the archive may only be readable without the damaged entry.
    for (std::size_t before = wanted.size() + 1; !wanted.empty() && wanted.size() < before;) {
      before = wanted.size();
      ArchiveBudget left = budget;
      const std::string why = visit_archive(
          path, left, [&, &of_archive = wanted](const ArchiveEntry& entry, const ReadEntry& read) {
            read_entries(files, of_archive, 0, entry, read, left, results);
          });
      std::erase_if(wanted,
                    [&](std::size_t i) { return results[i] || !results[i].error().text.empty(); });
      for (const std::size_t i : wanted) {
        results[i] = Error{wanted.size() < before ? "" : why.empty() ? "it cannot be found" : why};
      }
    }
  }
  return results;
}

}  // namespace scenefile
