// Feeds any text except JSON to read_scene(), check() and prepare().

#include "finding_laws.h"
#include "law.h"
#include "read_and_judge.h"
#include "scenefile/format/scene_text.h"
#include "support/plain_agreement.h"
#include "target.h"

#include <optional>
#include <string>
#include <string_view>

namespace {

using namespace scenefile;

void require_plain_alike(std::string_view bytes) {
  std::string storage;
  Diagnostics diagnostics;
  const std::optional<std::string_view> text = decode_text(bytes, storage, diagnostics);
  if (!text) {
    return;
  }
  for (const Limits& limits : {Limits(), fuzz::narrow_limits()}) {
    fuzz::require(testing::agrees_with_expat(*text, limits), "plain XML is read as Expat does");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != text.npos && (text[first] == '{' || text[first] == '[')) {
    return -1;
  }
  require_plain_alike(text);
  scenefile::fuzz::read_and_judge(text);
  return 0;
}
