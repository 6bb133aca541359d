#include "scenefile/format/json_parser.h"

#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <cstring>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

// A tag in place of the library's allocator type, to select the stack below.
struct OnVector {};

// A stream for "in situ" parsing that is never written to: strings and numbers are passed on as
// places in the text, with escapes unresolved. Terminated by NUL.
class TextStream {
 public:
  using Ch = char;

  explicit TextStream(std::string_view text)
      : begin_(text.data()), at_(text.data()), end_(text.data() + text.size()) {}

  Ch Peek() const { return at_ == end_ ? '\0' : *at_; }
  Ch Take() { return at_ == end_ ? '\0' : *at_++; }
  std::size_t Tell() const { return static_cast<std::size_t>(at_ - begin_); }
  Ch* PutBegin() { return const_cast<Ch*>(at_); }
  void Put(Ch) {}
  std::size_t PutEnd(Ch* begin) { return static_cast<std::size_t>(at_ - begin); }

 private:
  const char* begin_;
  const char* at_;
  const char* end_;
};

}  // namespace

}  // namespace scenefile

namespace rapidjson {

// Lets the library work on a copy of the stream in registers. While a token is parsed, the original
// stays at its start.
template <>
struct StreamTraits<scenefile::TextStream> {
  enum { copyOptimization = 1 };
};

namespace internal {

// The library's stack does arithmetic on a null pointer when it is empty, which is undefined
// behavior, and its allocators do not check for failure. This replacement does neither.
template <>
class Stack<scenefile::OnVector> {
 public:
  Stack(scenefile::OnVector*, std::size_t capacity) : bytes_(capacity) {}

  template <typename T>
  T* Push(std::size_t count = 1) {
    const std::size_t end = top_ + sizeof(T) * count;
    if (end > bytes_.size()) {
      bytes_.resize(2 * end);
    }
    return at<T>(std::exchange(top_, end));
  }
  template <typename T>
  T* Pop(std::size_t count) {
    top_ -= sizeof(T) * count;
    return at<T>(top_);
  }
  template <typename T>
  T* Top() {
    return at<T>(top_ - sizeof(T));
  }
  void Clear() { top_ = 0; }

 private:
  template <typename T>
  T* at(std::size_t offset) {
    return reinterpret_cast<T*>(bytes_.data() + offset);
  }

  std::vector<char> bytes_;
  std::size_t top_ = 0;
};

}  // namespace internal

}  // namespace rapidjson

namespace scenefile {

namespace {

using StrictReader = rapidjson::GenericReader<rapidjson::UTF8<>, rapidjson::UTF8<>, OnVector>;

struct StringCatcher : rapidjson::BaseReaderHandler<rapidjson::UTF8<>, StringCatcher> {
  std::string value;
  bool String(const char* text, rapidjson::SizeType length, bool) {
    value.assign(text, length);
    return true;
  }
};

// `quoted` is a well-formed string with its quotes.
std::string decoded(std::string_view quoted) {
  rapidjson::MemoryStream stream(quoted.data(), quoted.size());
  StringCatcher catcher;
  StrictReader().Parse<rapidjson::kParseDefaultFlags>(stream, catcher);
  return std::move(catcher.value);
}

// The library accepts a low surrogate without a high one.
bool has_surrogate(std::string_view utf8) {
  for (std::size_t i = 0; i + 1 < utf8.size(); ++i) {
    if (utf8[i] == '\xed' && static_cast<unsigned char>(utf8[i + 1]) >= 0xa0) {
      return true;
    }
  }
  return false;
}

class TapeWriter : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, TapeWriter> {
 public:
  TapeWriter(JsonTape& tape, const TextStream& stream, std::uint32_t max_depth)
      : tape_(tape), stream_(stream), max_depth_(max_depth) {}

  bool Null() { return scalar(stream_.Tell() - 4, 4); }
  bool Bool(bool value) { return scalar(stream_.Tell() - (value ? 4 : 5), value ? 4 : 5); }
  bool RawNumber(const char* text, rapidjson::SizeType length, bool) {
    return scalar(static_cast<std::size_t>(text - tape_.text.data()), length);
  }
  bool String(const char* text, rapidjson::SizeType length, bool) {
    const auto offset = static_cast<std::size_t>(text - tape_.text.data()) - 1;
    const std::size_t bytes = std::size_t{length} + 2;
    if (std::memchr(text, '\\', length) != nullptr &&
        has_surrogate(decoded(tape_.text.substr(offset, bytes)))) {
      fault_ = JsonFault::surrogate;
      fault_offset_ = offset;
      return false;
    }
    return scalar(offset, bytes);
  }
  bool Key(const char* text, rapidjson::SizeType length, bool copy) {
    return String(text, length, copy);
  }
  bool StartObject() { return open(); }
  bool StartArray() { return open(); }
  bool EndObject(rapidjson::SizeType) { return close(); }
  bool EndArray(rapidjson::SizeType) { return close(); }

  /// Why the last call returned false.
  JsonFault fault() const { return fault_; }
  std::size_t fault_offset() const { return fault_offset_; }
  const std::vector<JsonIndex>& open_items() const { return open_; }

 private:
  bool scalar(std::size_t offset, std::size_t bytes) {
    tape_.items.push_back({static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(bytes)});
    return true;
  }

  bool open() {
    if (open_.size() == max_depth_) {
      fault_ = JsonFault::too_deep;
      fault_offset_ = stream_.Tell();
      return false;
    }
    open_.push_back(static_cast<JsonIndex>(tape_.items.size()));
    return scalar(stream_.Tell(), 0);
  }

  bool close() {
    JsonItem& item = tape_.items[open_.back()];
    item.extent = static_cast<std::uint32_t>(tape_.items.size()) - open_.back() - 1;
    open_.pop_back();
    return true;
  }

  JsonTape& tape_;
  const TextStream& stream_;
  std::uint32_t max_depth_;
  std::vector<JsonIndex> open_;
  JsonFault fault_ = JsonFault::none;
  std::size_t fault_offset_ = 0;
};

JsonFault fault_of(rapidjson::ParseErrorCode code, std::string_view text, std::size_t offset) {
  switch (code) {
    case rapidjson::kParseErrorNone:
      return JsonFault::none;
    case rapidjson::kParseErrorDocumentEmpty:
      return JsonFault::empty;
    case rapidjson::kParseErrorDocumentRootNotSingular:
      return JsonFault::after_end;
    case rapidjson::kParseErrorObjectMissName:
      return JsonFault::key;
    case rapidjson::kParseErrorObjectMissColon:
      return JsonFault::colon;
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
      return JsonFault::object_comma;
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
      return JsonFault::array_comma;
    case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
      return JsonFault::escape;
    case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
      return JsonFault::surrogate;
    case rapidjson::kParseErrorStringEscapeInvalid:
      return offset < text.size() && text[offset] == '\\' ? JsonFault::escape
                                                          : JsonFault::control_character;
    case rapidjson::kParseErrorStringMissQuotationMark:
      return JsonFault::unclosed_string;
    case rapidjson::kParseErrorStringInvalidEncoding:
      return JsonFault::encoding;
    case rapidjson::kParseErrorNumberTooBig:
      return JsonFault::number_too_large;
    case rapidjson::kParseErrorNumberMissFraction:
    case rapidjson::kParseErrorNumberMissExponent:
      return JsonFault::number;
    case rapidjson::kParseErrorValueInvalid:
    case rapidjson::kParseErrorTermination:
    case rapidjson::kParseErrorUnspecificSyntaxError:
      return JsonFault::value;
  }
  return JsonFault::value;
}

}  // namespace

std::string_view JsonTape::raw(JsonIndex item) const {
  const std::string_view token = text.substr(items[item].offset, items[item].extent);
  return is_string(item) ? token.substr(1, token.size() - 2) : token;
}

std::string JsonTape::string(JsonIndex item) const {
  const std::string_view written = raw(item);
  if (written.find('\\') == std::string_view::npos) {
    return std::string(written);
  }
  return decoded(text.substr(items[item].offset, items[item].extent));
}

JsonError parse_json(std::string_view text, std::uint32_t max_depth, JsonTape& tape) {
  constexpr unsigned flags = rapidjson::kParseIterativeFlag | rapidjson::kParseInsituFlag |
                             rapidjson::kParseNumbersAsStringsFlag |
                             rapidjson::kParseValidateEncodingFlag;
  tape.text = text;
  tape.items.clear();
  // Items are rarely shorter, even in compact scenes. Reserved memory that is not used is never
  // touched.
  constexpr std::size_t bytes_of_an_item = 5;
  tape.items.reserve(text.size() / bytes_of_an_item + 16);
  TextStream stream(text);
  TapeWriter writer(tape, stream, max_depth);
  const rapidjson::ParseResult result = StrictReader().Parse<flags>(stream, writer);
  JsonError error;
  error.offset = result.Offset();
  error.fault = writer.fault();
  if (error.fault != JsonFault::none) {
    error.offset = writer.fault_offset();
  } else if (result.IsError()) {
    error.fault = fault_of(result.Code(), text, error.offset);
  } else if (stream.Tell() != text.size()) {
    error.fault = JsonFault::after_end;
    error.offset = stream.Tell();
  }
  for (const JsonIndex item : writer.open_items()) {
    error.open.push_back(tape.items[item].offset);
  }
  return error;
}

}  // namespace scenefile
