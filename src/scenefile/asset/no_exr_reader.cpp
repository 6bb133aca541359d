// Takes the place of exr_reader.cpp in builds without OpenEXR.

#include "scenefile/asset/codec.h"
#include "scenefile/asset/exr_rows.h"
#include "scenefile/asset/exr_signature.h"

namespace scenefile {

namespace {

bool recognizes_exr(std::string_view bytes) {
  return has_exr_signature(bytes);
}

Result<ImageHeader> read_exr_header(std::string_view) {
  return input_error("this build cannot read OpenEXR files; convert it to PFM or PNG");
}

Result<void> decode_exr(std::string_view, std::string_view, Image&) {
  return read_exr_header({}).error();
}

}  // namespace

struct ExrRows::State {};

ExrRows::ExrRows(ExrRows&& other) noexcept = default;
ExrRows& ExrRows::operator=(ExrRows&& other) noexcept = default;
ExrRows::~ExrRows() = default;

Result<ExrRows> ExrRows::open(std::string) {
  return read_exr_header({}).error();
}

// Nothing is ever open.
int ExrRows::width() const {
  return 0;
}
int ExrRows::picture_height() const {
  return 0;
}
int ExrRows::first() const {
  return 0;
}
int ExrRows::end() const {
  return 0;
}
Result<void> ExrRows::read(std::span<ImageLayer>) const {
  return read_exr_header({}).error();
}
Result<std::string> ExrRows::block(int) const {
  return read_exr_header({}).error();
}

const Codec exr_codec{{"EXR", ".exr"}, recognizes_exr, read_exr_header, nullptr, decode_exr};

}  // namespace scenefile
