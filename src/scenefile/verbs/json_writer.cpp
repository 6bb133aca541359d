#include "scenefile/verbs/json_writer.h"

#include "scenefile/base/text.h"

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include <cmath>
#include <cstdlib>
#include <new>

namespace scenefile {

namespace {

constexpr std::size_t indent = 2;

rapidjson::SizeType length(std::string_view text) {
  return static_cast<rapidjson::SizeType>(text.size());
}

// RapidJSON does not check whether its allocators return null.
struct ThrowingAllocator {
  static constexpr bool kNeedFree = true;

  static void* Malloc(std::size_t size) { return Realloc(nullptr, 0, size); }
  static void* Realloc(void* old, std::size_t /*old_size*/, std::size_t size) {
    if (size == 0) {
      Free(old);
      return nullptr;
    }
    void* const bytes = std::realloc(old, size);
    if (bytes == nullptr) {
      throw std::bad_alloc();
    }
    return bytes;
  }
  static void Free(void* bytes) { std::free(bytes); }
};

}  // namespace

struct Json::Library {
  using Buffer = rapidjson::GenericStringBuffer<rapidjson::UTF8<>, ThrowingAllocator>;
  Buffer buffer;
  rapidjson::PrettyWriter<Buffer, rapidjson::UTF8<>, rapidjson::ASCII<>, ThrowingAllocator> writer{
      buffer};
  std::size_t depth = 0;  // of open objects and arrays
};

Json::Json() : library_(std::make_unique<Library>()) {
  library_->writer.SetIndent(' ', indent);
}
Json::~Json() = default;

void Json::value(std::string_view text) {
  const std::string safe = valid_utf8(text);
  library_->writer.String(safe.data(), length(safe));
}
void Json::value(bool b) {
  library_->writer.Bool(b);
}
void Json::write_unsigned(std::uint64_t n) {
  library_->writer.Uint64(n);
}
void Json::write_signed(std::int64_t n) {
  library_->writer.Int64(n);
}
void Json::write_number(double d) {
  if (std::isfinite(d)) {
    library_->writer.Double(d);
  } else {
    library_->writer.Null();
  }
}
void Json::key(std::string_view name) {
  library_->writer.Key(name.data(), length(name));
}
void Json::raw(std::string_view json) {
  std::string shifted;
  for (const char c : json.substr(0, json.find_last_not_of('\n') + 1)) {
    shifted += c;
    if (c == '\n') {
      shifted.append(indent * library_->depth, ' ');
    }
  }
  library_->writer.RawValue(shifted.data(), shifted.size(), rapidjson::kObjectType);
}
void Json::begin_object() {
  ++library_->depth;
  library_->writer.StartObject();
}
void Json::begin_object(std::string_view name) {
  key(name);
  begin_object();
}
void Json::end_object() {
  --library_->depth;
  library_->writer.EndObject();
}
void Json::begin_array() {
  ++library_->depth;
  library_->writer.StartArray();
}
void Json::begin_array(std::string_view name) {
  key(name);
  begin_array();
}
void Json::end_array() {
  --library_->depth;
  library_->writer.EndArray();
}

std::string Json::text() const {
  return std::string(library_->buffer.GetString(), library_->buffer.GetSize()) + "\n";
}

}  // namespace scenefile
