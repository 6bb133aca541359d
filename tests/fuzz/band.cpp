// Feeds bytes to the readers of bands in a store, as they are and sealed.

#include "law.h"
#include "scenefile/asset/exr_rows.h"
#include "scenefile/io/item.h"
#include "target.h"

#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace scenefile;
using fuzz::require;

void read_rows(const std::string& bytes) {
  const Result<ExrRows> file = ExrRows::open(bytes);
  if (!file) {
    require(!file.error().text.empty(), "a refusal says why");
    return;
  }
  require(0 <= file->first() && file->first() < file->end(), "there are rows");
  require(file->end() <= file->picture_height() && file->width() > 0, "they are in the picture");
  // Callers know the size from the key.
  if (file->width() > 256 || file->end() - file->first() > 256) {
    return;
  }
  std::vector<ImageLayer> layers{{"", {"R", "G", "B"}, false, {}}, {"object-id", {"ID"}, true, {}}};
  for (std::size_t count : {1, 2}) {
    (void)file->read(std::span(layers).first(count));
  }
  for (int y = file->first(); y < file->end(); y += 16) {
    (void)file->block(y);
  }
}

void read_key(std::string bytes) {
  const Item item = read_item(bytes);
  require(item.state == ItemState::intact || item.key.empty(), "only an intact item has a key");
  require(compare_keys(item.key, item.key).empty(), "a key equals itself");
  seal_item(bytes);
  const Item sealed = read_item(bytes);
  if (sealed.state == ItemState::none || bytes.empty()) {
    return;
  }
  if (sealed.state == ItemState::intact) {
    // Not the last, which may belong to the CRC of the text in a PNG file.
    bytes.front() = static_cast<char>(bytes.front() ^ 1);
    require(read_item(bytes).state != ItemState::intact, "a changed byte is found");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read_rows(bytes);
  read_key(bytes);
  read_key(item_text("scene=1") + bytes);
  return 0;
}
