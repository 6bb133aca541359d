#include "scenefile/io/archive.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/limits.h"
#include "scenefile/io/descriptor.h"
#include "scenefile/io/folder.h"

#include <archive.h>
#include <archive_entry.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <locale.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <memory>

namespace scenefile {

namespace {

// libarchive is loaded when the first archive is opened: linked, it would make every start of the
// program slower (decision 25).
#define SCENEFILE_ARCHIVE_FUNCTIONS(ROW) \
  ROW(read_new)                          \
  ROW(read_free)                         \
  ROW(read_support_filter_gzip)          \
  ROW(read_support_format_zip_seekable)  \
  ROW(read_support_format_tar)           \
  ROW(read_open_fd)                      \
  ROW(read_open_memory)                  \
  ROW(read_next_header)                  \
  ROW(read_data)                         \
  ROW(filter_bytes)                      \
  ROW(format)                            \
  ROW(error_string)                      \
  ROW(entry_pathname)                    \
  ROW(entry_filetype)                    \
  ROW(entry_hardlink)                    \
  ROW(entry_size)                        \
  ROW(entry_is_encrypted)

struct Library {
#define ROW(name) decltype(&::archive_##name) name = nullptr;
  SCENEFILE_ARCHIVE_FUNCTIONS(ROW)
#undef ROW
};

// Returns false if the library does not exist. It is never unloaded.
bool load(Library& library) {
  void* const file = ::dlopen("libarchive.so.13", RTLD_NOW | RTLD_LOCAL);
  if (file == nullptr) {
    return false;
  }
#define ROW(name)                                                                           \
  library.name = reinterpret_cast<decltype(library.name)>(::dlsym(file, "archive_" #name)); \
  if (library.name == nullptr) {                                                            \
    return false;                                                                           \
  }
  SCENEFILE_ARCHIVE_FUNCTIONS(ROW)
#undef ROW
  return true;
}

// libarchive converts the names of entries to the encoding of the thread's locale.
class Utf8Names {
 public:
  Utf8Names() : locale_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (locale_ != nullptr) {
      before_ = ::uselocale(locale_);
    }
  }
  ~Utf8Names() {
    if (locale_ != nullptr) {
      ::uselocale(before_);
      ::freelocale(locale_);
    }
  }
  Utf8Names(const Utf8Names&) = delete;
  Utf8Names& operator=(const Utf8Names&) = delete;

 private:
  locale_t locale_;
  locale_t before_ = nullptr;
};

constexpr int max_folders = 16;

// Without empty parts and ".".
void set_path(ArchiveEntry& entry, std::string_view written) {
  const bool drive = written.size() > 1 && written[1] == ':' && lower(written[0]) >= 'a' &&
                     lower(written[0]) <= 'z';
  entry.outside = drive || written.starts_with('/') || written.starts_with('\\');
  std::string& path = entry.path;
  int folders = 0;
  while (!written.empty()) {
    const std::size_t slash = std::min(written.find('/'), written.size());
    const std::string_view part = written.substr(0, slash);
    written.remove_prefix(std::min(slash + 1, written.size()));
    entry.outside = entry.outside || part == "..";
    if (!part.empty() && part != ".") {
      path += path.empty() ? "" : "/";
      path += part;
      folders += written.empty() ? 0 : 1;
    }
  }
  if (entry.outside) {
    entry.problem = "its path leads out of the archive";
  } else if (folders > max_folders) {
    entry.problem = fmt::format("nested more than {} folders deep", max_folders);
  }
}

// Where the first part that is junk starts, or npos.
std::size_t junk_in(std::string_view path) {
  for (std::size_t start = 0;;) {
    const std::size_t slash = path.find('/', start);
    const std::string_view part = path.substr(start, slash - start);
    if (part != ".." && is_junk_name(part)) {
      return start;
    }
    if (slash == std::string_view::npos) {
      return slash;
    }
    start = slash + 1;
  }
}

// The folder of an entry, or the folder that it is, up to junk.
std::string_view folder_in(std::string_view path, bool is_folder) {
  const std::size_t end = is_folder ? path.size() : path.find_last_of('/');
  const std::size_t junk = junk_in(path);
  if (junk == 0 || end == std::string_view::npos) {
    return {};
  }
  return path.substr(0, std::min(end, junk - 1));
}

// libarchive does not always have one, and some end with a line break.
std::string_view message(const Library& library, ::archive* archive) {
  const char* const given = library.error_string(archive);
  std::string_view text = given == nullptr ? "" : given;
  text = text.substr(0, text.find_last_not_of(blanks) + 1);
  return text.empty() ? "unknown error" : text;
}

// Goes through an archive that is open.
class Visitor {
 public:
  Visitor(const Library& library, ::archive* archive, ArchiveBudget& budget)
      : library_(library), archive_(archive), budget_(budget) {}

  std::string visit_all(const VisitEntry& visit, const VisitFolder& visit_folder) {
    for (::archive_entry* entry = nullptr;;) {
      const int status = library_.read_next_header(archive_, &entry);
      if (status == ARCHIVE_EOF) {
        return {};
      }
      if (status != ARCHIVE_OK && status != ARCHIVE_WARN) {
        return fmt::format("it cannot be read as an archive: {}", message(library_, archive_));
      }
      if (budget_.entries == 0) {
        return "it contains too many files";
      }
      --budget_.entries;
      if (!is_zip()) {
        // Skipping an entry unpacks it.
        const auto at = static_cast<std::uint64_t>(library_.filter_bytes(archive_, 0));
        const auto size =
            static_cast<std::uint64_t>(std::max<std::int64_t>(0, library_.entry_size(entry)));
        budget_.bytes -= std::min(budget_.bytes, at - std::min(at, position_));
        position_ = at;
        if (size > budget_.bytes) {
          return too_large;
        }
      }
      ArchiveEntry file;
      const bool visible = describe(entry, file);
      if (visit_folder && !file.outside) {
        const std::string_view folder =
            folder_in(file.path, library_.entry_filetype(entry) == AE_IFDIR);
        if (!folder.empty()) {
          visit_folder(folder);
        }
      }
      if (!visible) {
        continue;
      }
      bool exhausted = false;
      visit(file, [&](std::uint64_t max_bytes) -> Result<std::string> {
        return file.problem.empty() ? read(max_bytes, exhausted) : Error{file.problem};
      });
      if (exhausted) {
        return too_large;
      }
    }
  }

 private:
  static constexpr const char* too_large = "it is too large when unpacked";

  bool is_zip() const {
    return (library_.format(archive_) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_ZIP;
  }

  // Returns false for folders and junk.
  bool describe(::archive_entry* entry, ArchiveEntry& file) const {
    const char* const name = library_.entry_pathname(entry);
    const auto type = library_.entry_filetype(entry);
    if (name != nullptr) {
      set_path(file, name);
    }
    if (type == AE_IFDIR || junk_in(file.path) != std::string_view::npos) {
      return false;
    }
    if (library_.entry_hardlink(entry) != nullptr) {
      file.problem = "a hard link, not a file";
    } else if (type == AE_IFLNK) {
      file.problem = "a symbolic link, not a file";
    } else if (type != AE_IFREG) {
      file.problem = "not a regular file";
    } else if (file.problem.empty() && file.path.empty()) {
      file.problem = "its name cannot be read";
    } else if (file.problem.empty() && library_.entry_is_encrypted(entry) != 0) {
      file.problem = "protected by a password";
    }
    return true;
  }

  Result<std::string> read(std::uint64_t max_bytes, bool& exhausted) {
    std::string bytes;
    const std::size_t piece = std::size_t{1} << 16;
    for (std::size_t size = 0;;) {
      bytes.resize(size + piece);
      const auto got = library_.read_data(archive_, bytes.data() + size, piece);
      if (got < 0) {
        return Error{fmt::format("it is damaged: {}", message(library_, archive_))};
      }
      size += static_cast<std::size_t>(got);
      if (is_zip()) {
        exhausted = static_cast<std::uint64_t>(got) > budget_.bytes;
        budget_.bytes -= std::min(budget_.bytes, static_cast<std::uint64_t>(got));
      }
      if (exhausted || size > max_bytes) {
        return Error{too_large, ErrorKind::limit};
      }
      bytes.resize(size);
      if (got == 0) {
        return bytes;
      }
    }
  }

  const Library& library_;
  ::archive* archive_;
  ArchiveBudget& budget_;
  std::uint64_t position_ = 0;  // in the unpacked tar
};

// The record that ends a ZIP file. A ZIP file without entries is this record and a comment, which
// libarchive does not recognize.
constexpr std::size_t end_of_zip_size = 22;

// `start`: the first bytes of a file.
bool is_empty_zip(std::string_view start, std::uint64_t size) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(start[i]); };
  return start.size() >= end_of_zip_size && start.starts_with("PK\5\6") &&
         start.substr(4, 16).find_first_not_of('\0') == std::string_view::npos &&
         size == end_of_zip_size + byte(20) + 256U * byte(21);
}

// `open` gives the archive to libarchive, and returns its status.
template <typename Open>
std::string visit_opened(ArchiveBudget& budget, const VisitEntry& visit,
                         const VisitFolder& visit_folder, const Open& open) {
  static const Library library = [] {
    Library found;
    return load(found) ? found : Library();
  }();
  if (library.entry_is_encrypted == nullptr) {
    return "archives are read with libarchive.so.13, which cannot be loaded: install libarchive13";
  }
  const Utf8Names utf8_names;
  const std::unique_ptr<::archive, decltype(library.read_free)> archive(library.read_new(),
                                                                        library.read_free);
  if (archive == nullptr) {
    return "there is not enough memory to read it";
  }
  library.read_support_filter_gzip(archive.get());
  library.read_support_format_zip_seekable(archive.get());
  library.read_support_format_tar(archive.get());
  if (const int status = open(library, archive.get());
      status != ARCHIVE_OK && status != ARCHIVE_WARN) {
    return fmt::format("it cannot be read as an archive: {}", message(library, archive.get()));
  }
  return Visitor(library, archive.get(), budget).visit_all(visit, visit_folder);
}

}  // namespace

std::string visit_archive(const std::string& path, ArchiveBudget& budget, const VisitEntry& visit,
                          const VisitFolder& visit_folder) {
  const Result<OpenFile> file = open_regular(path, false, budget.bytes);
  if (!file) {
    const std::string& text = file.error().text;
    const std::string named = path + ": ";
    return text.starts_with(named) ? text.substr(named.size()) : text;
  }
  std::array<char, end_of_zip_size> start{};
  const ssize_t got = ::pread(file->descriptor.get(), start.data(), start.size(), 0);
  if (got > 0 && is_empty_zip({start.data(), static_cast<std::size_t>(got)}, file->size)) {
    return {};
  }
  return visit_opened(budget, visit, visit_folder, [&](const Library& library, ::archive* archive) {
    return library.read_open_fd(archive, file->descriptor.get(), std::size_t{1} << 16);
  });
}

std::string visit_archive_bytes(std::string_view bytes, ArchiveBudget& budget,
                                const VisitEntry& visit, const VisitFolder& visit_folder) {
  if (is_empty_zip(bytes, bytes.size())) {
    return {};
  }
  return visit_opened(budget, visit, visit_folder, [&](const Library& library, ::archive* archive) {
    return library.read_open_memory(archive, bytes.data(), bytes.size());
  });
}

}  // namespace scenefile
