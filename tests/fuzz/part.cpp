// Tests bytes as a part file, as the header inside one, and as a file with those bytes changed.

#include "law.h"
#include "scenefile/base/hash.h"
#include "scenefile/trace/part_file.h"
#include "target.h"

#include <string>
#include <vector>

namespace {

using namespace scenefile;
using fuzz::require;

constexpr std::string_view first_line = "scenefile part 1\n";

template <typename T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// A file with a valid checksum of its header.
std::string with_checksum(std::string_view body) {
  std::string file(first_line);
  append(file, static_cast<std::uint32_t>(body.size()));
  file += body;
  Hash hash;
  hash.add(body);
  append(file, hash.value());
  return file;
}

// The rows of the part are copied to their place, and nowhere else.
void place(const PartHead& head) {
  const PixelRegion part = head.region();
  const PixelRegion& whole = head.picture.region;
  if (part.height() <= 0 || whole.width() > 4096 || head.picture.layers.size() > 64) {
    return;
  }
  std::vector<ImageLayer> band{{"", {"R", "G", "B"}, false, {}}};
  for (const Layer& layer : head.picture.layers) {
    band.push_back(layer_without_values(layer));
  }
  for (ImageLayer& layer : band) {
    layer.values.resize(layer.channels.size() * static_cast<std::size_t>(whole.width()));
  }
  const std::string row(part_row_bytes(head.picture, part.width()), '\x7f');
  place_part_rows(head, row, part.y0, part.y0, band);
}

void read(std::string_view bytes) {
  PartHead head;
  std::size_t before_rows = 0;
  const std::string why = decode_part_head(bytes, head, before_rows);
  if (!why.empty()) {
    require(head == PartHead{}, "what is refused gives nothing");
    return;
  }
  require(encode_part_head(head) == bytes.substr(0, before_rows),
          "what is taken is what was written");
  require(part_file_bytes(head, before_rows) >= before_rows, "rows do not take less than nothing");
  place(head);
}

void change_a_byte(std::string_view bytes) {
  PartHead head;
  head.picture.region = {0, 0, 32, 32};
  head.checksum = bytes.size();
  std::string file = encode_part_head(head);
  const std::size_t at = bytes.empty() ? 0 : static_cast<unsigned char>(bytes[0]) % file.size();
  file[at] = static_cast<char>(file[at] ^ (bytes.size() < 2 || bytes[1] == 0 ? 1 : bytes[1]));
  std::size_t before_rows = 0;
  require(!decode_part_head(file, head, before_rows).empty(), "a changed byte is found");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);
  read(with_checksum(bytes));
  change_a_byte(bytes);
  return 0;
}
