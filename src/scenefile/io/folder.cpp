#include "scenefile/io/folder.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"
#include "scenefile/io/descriptor.h"

#include <dirent.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

namespace scenefile {

namespace fs = std::filesystem;

namespace {

// Removes the digits at the start of `text`; returns them without leading zeros.
std::string_view take_digits(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

// The contents of a folder in natural order, as paths.
struct Listing {
  std::vector<std::string> files;
  std::vector<std::string> folders;
  std::error_code error;
};

Listing list(const std::string& folder) {
  Listing listing;
  listing.error = visit_entries(folder, [&](FolderEntry& entry) {
    std::string& path = folder == "." ? entry.name : entry.path;
    if (is_junk_name(entry.name) || is_hidden_name(entry.name)) {
      return true;
    }
    if (entry.folder && !entry.link) {
      listing.folders.push_back(std::move(path));
    } else if (entry.file || entry.missing) {
      listing.files.push_back(std::move(path));
    }
    return true;
  });
  std::sort(listing.files.begin(), listing.files.end(), natural_less);
  std::sort(listing.folders.begin(), listing.folders.end(), natural_less);
  return listing;
}

}  // namespace

FileStamp stamp_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    return {};
  }
  FileStamp stamp;
  stamp.exists = true;
  stamp.modified_ns = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
  stamp.size = static_cast<std::uint64_t>(status.st_size);
  stamp.inode = status.st_ino;
  stamp.device = status.st_dev;
  return stamp;
}

bool is_folder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string file_name_of(const std::string& path) {
  return fs::path(path).filename().string();
}

std::string absolute_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error);
  return error ? path : whole.string();
}

std::string real_folder_of(const std::string& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path, ignored), ignored).parent_path().string();
}

std::string path_from(const std::string& folder, const std::string& path) {
  return fs::path(path).lexically_relative(folder).string();
}

Result<void> remove_file(const std::string& path) {
  std::error_code error;
  std::filesystem::remove(path, error);
  return error ? system_error(path, "cannot remove", error.value()) : Result<void>();
}

std::error_code visit_entries(const std::string& folder,
                              const std::function<bool(FolderEntry&)>& visit) {
  const auto failed = [](int error) {
    if (error == ENOMEM) {
      throw std::bad_alloc();
    }
    return std::error_code(error, std::generic_category());
  };
  // Not std::filesystem: where memory runs out, iterators of GCC 12 end the process.
  const std::unique_ptr<DIR, int (*)(DIR*)> open(::opendir(folder.c_str()), ::closedir);
  if (open == nullptr) {
    return failed(errno);
  }
  const std::string prefix = folder.ends_with('/') ? folder : folder + "/";
  while (true) {
    errno = 0;
    const dirent* const entry = ::readdir(open.get());
    if (entry == nullptr) {
      return failed(errno);
    }
    const std::string_view name = entry->d_name;
    if (name == "." || name == "..") {
      continue;
    }
    FolderEntry found{std::string(name), prefix + std::string(name)};
    found.folder = entry->d_type == DT_DIR;
    found.file = entry->d_type == DT_REG;
    if (!found.folder && !found.file) {
      struct stat target {};
      found.link = is_link(found.path);
      found.missing = ::stat(found.path.c_str(), &target) != 0;
      found.folder = S_ISDIR(target.st_mode);
      found.file = S_ISREG(target.st_mode);
    }
    if (!visit(found)) {
      return {};
    }
  }
}

std::vector<FolderEntry> entries_of(const std::string& folder, std::string* problem) {
  std::vector<FolderEntry> entries;
  const std::error_code error = visit_entries(folder, [&](FolderEntry& entry) {
    if (!is_junk_name(entry.name)) {
      entries.push_back(std::move(entry));
    }
    return true;
  });
  if (error && problem != nullptr) {
    *problem = error.message();
  }
  std::sort(entries.begin(), entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) { return a.name < b.name; });
  return entries;
}

bool is_hidden_name(std::string_view name) {
  return name.starts_with('.');
}

bool is_junk_name(std::string_view name) {
  static constexpr std::string_view names[] = {
      "__MACOSX",    "Thumbs.db",       "desktop.ini", ".DS_Store", ".localized", ".Spotlight-V100",
      ".Trashes",    ".TemporaryItems", ".fseventsd",  ".git",      ".gitignore", ".gitattributes",
      ".gitmodules", ".gitkeep",        ".svn",        ".hg",       ".idea",      ".vscode"};
  return name.starts_with("._") ||
         std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool is_link(const std::string& path) {
  std::error_code error;
  return fs::is_symlink(path, error);
}

bool natural_less(const std::string& first, const std::string& second) {
  const std::string a_text = lower_case(first);
  const std::string b_text = lower_case(second);
  std::string_view a = a_text;
  std::string_view b = b_text;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view x = take_digits(a);
      const std::string_view y = take_digits(b);
      if (x != y) {
        return x.size() != y.size() ? x.size() < y.size() : x < y;
      }
    } else if (a.front() != b.front()) {
      return a.front() < b.front();
    } else {
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.empty() != b.empty() ? a.empty() : first < second;
}

std::vector<std::string> files_below(const std::string& folder, std::vector<Error>& errors) {
  std::vector<std::string> files;
  std::vector<std::string> waiting{folder};
  while (!waiting.empty()) {
    const std::string next = std::move(waiting.back());
    waiting.pop_back();
    const Listing listing = list(next);
    if (listing.error) {
      errors.push_back(io_error(next, "cannot list the folder: " + listing.error.message()));
    }
    files.insert(files.end(), listing.files.begin(), listing.files.end());
    waiting.insert(waiting.end(), listing.folders.rbegin(), listing.folders.rend());
  }
  return files;
}

Result<void> make_folder(const std::string& path) {
  std::error_code error;
  fs::path made;
  for (const fs::path& part : fs::path(path)) {
    made /= part;
    if (!fs::exists(made, error) && fs::create_directory(made, error)) {
      fs::permissions(made, fs::perms::owner_all, error);
    }
  }
  if (!is_folder(path)) {
    return Error{path + ": cannot create the folder: " + error.message()};
  }
  return {};
}

Result<TemporaryFolder> TemporaryFolder::create() {
  std::error_code error;
  std::string path = (fs::temp_directory_path(error) / "scenefile-XXXXXX").string();
  if (error || ::mkdtemp(path.data()) == nullptr) {
    return system_error(path, "cannot create a temporary folder", error ? error.value() : errno);
  }
  return TemporaryFolder(std::move(path));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) {
    fs::remove_all(path_, ignored);
  }
}

}  // namespace scenefile
