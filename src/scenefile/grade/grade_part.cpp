#include "scenefile/grade/grade_part.h"

#include "scenefile/base/hash.h"

#include <concepts>
#include <cstring>
#include <type_traits>

namespace scenefile {

namespace {

constexpr std::string_view first_line = "scenefile grades 3\n";
// What files of all versions begin with.
constexpr std::string_view name_of_format = "scenefile grades ";

using Checksum = std::uint64_t;
using Length = std::uint64_t;

template <typename T, typename Struct>
concept ConstOrNot = std::same_as<std::remove_const_t<T>, Struct>;

// archive(x) for every member of a record, in the order of the file. With structured bindings, a
// missing member is a compile error.
template <ConstOrNot<GradePartHead> T, typename Archive>
void visit(T& head, Archive& archive) {
  auto& [whole, index, submissions] = head;
  auto& [key, count, students, pictures] = whole;
  auto& [program, names, references, options] = key;
  archive(program), archive(names), archive(references), archive(options);
  archive(count), archive(students), archive(pictures);
  archive(index), archive(submissions);
}

template <ConstOrNot<PictureMeasures> T, typename Archive>
void visit(T& measures, Archive& archive) {
  auto& [same_size, size, right_size, difference, linear, ssim, flip_mean, flip_max] = measures;
  auto& [psnr_db, mean, max, share_over] = difference;
  archive(same_size);
  archive(size.x), archive(size.y), archive(right_size.x), archive(right_size.y);
  archive(psnr_db), archive(mean), archive(max), archive(share_over);
  archive(linear), archive(ssim), archive(flip_mean), archive(flip_max);
}

template <ConstOrNot<Claim> T, typename Archive>
void visit(T& claim, Archive& archive) {
  auto& [cause, what, evidence, explained, said] = claim;
  archive(cause), archive(what), archive(evidence), archive(explained), archive(said);
}

template <ConstOrNot<PictureResult> T, typename Archive>
void visit(T& picture, Archive& archive) {
  auto& [name, verdict, measures, reasons, causes, rivals, partial, notes, png, png_file,
         fingerprint, identical] = picture;
  archive(name), archive(verdict), archive(measures), archive(reasons), archive(causes);
  archive(rivals), archive(partial), archive(notes);
  archive(png), archive(png_file), archive(fingerprint), archive(identical);
}

template <ConstOrNot<StudentResult> T, typename Archive>
void visit(T& student, Archive& archive) {
  auto& [name, pictures, unmatched] = student;
  archive(name), archive(pictures), archive(unmatched);
}

template <ConstOrNot<IgnoredFile> T, typename Archive>
void visit(T& file, Archive& archive) {
  auto& [path, student, reason] = file;
  archive(path), archive(student), archive(reason);
}

template <ConstOrNot<Gradebook> T, typename Archive>
void visit(T& book, Archive& archive) {
  auto& [students, ignored, name] = book;
  archive(students), archive(ignored), archive(name);
}

class Writer {
 public:
  void operator()(bool value) { bytes += value ? '\1' : '\0'; }
  template <typename T>
  requires((std::is_arithmetic_v<T> || std::is_enum_v<T>)&&!std::same_as<T, bool>) void operator()(
      const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(const std::string& text) {
    (*this)(Length{text.size()});
    bytes += text;
  }
  template <typename T>
  void operator()(const std::vector<T>& list) {
    (*this)(Length{list.size()});
    for (const T& item : list) {
      (*this)(item);
    }
  }
  template <typename T>
  requires std::is_class_v<T>
  void operator()(const T& record) { visit(record, *this); }

  std::string bytes;
};

// Reads what Writer wrote. After a failure, all further reads fail too.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  void operator()(bool& value) {
    char byte = 0;
    raw(&byte, 1);
    value = byte == '\1';
  }
  template <typename T>
  requires(std::is_arithmetic_v<T> && !std::same_as<T, bool>) void operator()(T& value) {
    raw(&value, sizeof value);
  }
  void operator()(Verdict& verdict) { enumerator(verdict, Verdict::unreadable); }
  void operator()(Cause& cause) { enumerator(cause, static_cast<Cause>(cause_count - 1)); }
  void operator()(std::string& text) {
    const Length length = length_of_items(1);
    text.assign(bytes_.substr(0, length));
    bytes_.remove_prefix(length);
  }
  template <typename T>
  void operator()(std::vector<T>& list) {
    // Each item takes at least the bytes that store the length of its first text.
    const Length length = length_of_items(sizeof(Length));
    list.clear();
    for (Length i = 0; i < length && good_; ++i) {
      (*this)(list.emplace_back());
    }
  }
  template <typename T>
  requires std::is_class_v<T>
  void operator()(T& record) { visit(record, *this); }

  bool good() const { return good_; }
  bool at_end() const { return bytes_.empty(); }

 private:
  void raw(void* to, std::size_t count) {
    good_ = good_ && count <= bytes_.size();
    if (good_) {
      std::memcpy(to, bytes_.data(), count);
      bytes_.remove_prefix(count);
    }
  }
  template <typename Enum>
  void enumerator(Enum& value, Enum last) {
    std::underlying_type_t<Enum> number{};
    (*this)(number);
    good_ = good_ && number <= static_cast<std::underlying_type_t<Enum>>(last);
    value = good_ ? static_cast<Enum>(number) : Enum{};
  }
  // The number of items in a list; 0 if the rest of the file is too short for it.
  Length length_of_items(std::size_t smallest) {
    Length length = 0;
    (*this)(length);
    good_ = good_ && length <= bytes_.size() / smallest;
    return good_ ? length : 0;
  }

  std::string_view bytes_;
  bool good_ = true;
};

Checksum checksum_of(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.value();
}

bool is_possible(const GradePartHead& head, std::size_t students) {
  const DividedClass& whole = head.whole;
  if (whole.count == 0 || head.index >= whole.count) {
    return false;
  }
  const StudentRange range = students_of(head.index, whole.count, whole.students);
  return students == range.end - range.begin;
}

}  // namespace

StudentRange students_of(std::uint32_t index, std::uint32_t count, std::size_t students) {
  return {students * index / count, students * (std::size_t{index} + 1) / count};
}

std::string encode_grade_part(const GradePartHead& head, const Gradebook& book) {
  Writer writer;
  writer(head);
  writer(book);
  Writer start;
  start.bytes = first_line;
  start(checksum_of(writer.bytes));
  return start.bytes + writer.bytes;
}

std::string decode_grade_part(std::string_view bytes, GradePartHead& head, Gradebook& book) {
  if (bytes.empty()) {
    return "the file is empty";
  }
  if (!bytes.starts_with(first_line)) {
    return is_grade_part(bytes) ? "the part was written by another version of the program"
                                : "the file is not a part of a class";
  }
  bytes.remove_prefix(first_line.size());
  Checksum checksum = 0;
  Reader start(bytes);
  start(checksum);
  if (!start.good()) {
    return "the part is truncated";
  }
  bytes.remove_prefix(sizeof checksum);
  if (checksum_of(bytes) != checksum) {
    return "the part is damaged: its checksum is wrong";
  }
  Reader reader(bytes);
  reader(head);
  reader(book);
  return reader.good() && reader.at_end() && is_possible(head, book.students.size())
             ? ""
             : "the part is damaged: such a part cannot exist";
}

bool is_grade_part(std::string_view first_bytes) {
  return first_bytes.starts_with(name_of_format);
}

std::string_view foreign_grade_part(const GradeKey& found, const GradeKey& wanted) {
  return found.students != wanted.students       ? "for another class, or its students have changed"
         : found.references != wanted.references ? "with other references or scenes"
         : found.options != wanted.options       ? "with other options"
         : found.program != wanted.program       ? "by another build of the program"
                                                 : "";
}

}  // namespace scenefile
