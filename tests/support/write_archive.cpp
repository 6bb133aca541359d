#include "support/write_archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>

#include <stdexcept>

namespace scenefile::testing_support {

namespace {

void require(int status) {
  if (status != ARCHIVE_OK) {
    throw std::runtime_error("cannot write the archive");
  }
}

la_ssize_t append(archive*, void* to, const void* bytes, std::size_t size) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), size);
  return static_cast<la_ssize_t>(size);
}

void add(archive* out, const WrittenEntry& written) {
  using Kind = WrittenEntry::Kind;
  archive_entry* const entry = archive_entry_new();
  archive_entry_set_pathname_utf8(entry, written.path.c_str());
  archive_entry_set_perm(entry, 0644);
  archive_entry_set_filetype(entry, written.kind == Kind::folder          ? AE_IFDIR
                                    : written.kind == Kind::symbolic_link ? AE_IFLNK
                                    : written.kind == Kind::device        ? AE_IFCHR
                                                                          : AE_IFREG);
  if (written.kind == Kind::symbolic_link) {
    archive_entry_set_symlink(entry, written.bytes.c_str());
  } else if (written.kind == Kind::hard_link) {
    archive_entry_set_hardlink(entry, written.bytes.c_str());
  } else if (written.kind == Kind::file) {
    archive_entry_set_size(entry, static_cast<la_int64_t>(written.bytes.size()));
  }
  require(archive_write_header(out, entry));
  if (written.kind == Kind::file && !written.bytes.empty()) {
    archive_write_data(out, written.bytes.data(), written.bytes.size());
  }
  archive_entry_free(entry);
}

}  // namespace

std::string write_archive(std::string_view name, const std::vector<WrittenEntry>& entries,
                          const std::string& password, bool stored) {
  // libarchive converts names from the locale.
  static const locale_t utf8 = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  const locale_t before = ::uselocale(utf8);
  std::string bytes;
  archive* const out = archive_write_new();
  if (name.ends_with(".zip")) {
    require(archive_write_set_format_zip(out));
    if (stored) {
      require(archive_write_zip_set_compression_store(out));
    }
    if (!password.empty()) {
      require(archive_write_set_options(out, "zip:encryption=zipcrypt"));
      require(archive_write_set_passphrase(out, password.c_str()));
    }
  } else {
    require(archive_write_set_format_pax_restricted(out));
  }
  if (name.ends_with("gz")) {
    require(archive_write_add_filter_gzip(out));
  }
  archive_write_set_bytes_in_last_block(out, 1);
  require(archive_write_open(out, &bytes, nullptr, append, nullptr));
  for (const WrittenEntry& entry : entries) {
    add(out, entry);
  }
  require(archive_write_close(out));
  archive_write_free(out);
  ::uselocale(before);
  return bytes;
}

}  // namespace scenefile::testing_support
