// Makes random edits of any text that is a scene, and takes them back.

#include "edit/edit_laws.h"
#include "law.h"
#include "target.h"

#include <cstdio>
#include <string>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scenefile;
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::uint32_t seed = 0;  // any text decides which edits are tried
  for (const char c : text) {
    seed = seed * 31 + static_cast<unsigned char>(c);
  }
  std::mt19937 chance(seed);
  ReadOptions options;
  options.compat_course = (seed & 1) != 0;
  options.limits.nesting = 100;
  const Result<Document> document = Document::open(text, options);
  if (!document) {
    return 0;
  }
  testing::EditCounts counts;
  const std::string series = testing::check_series(*document, 8, chance, counts);
  const std::string single =
      document->items().size() < 300 ? testing::check_edits(*document, 2, chance, counts) : "";
  for (const std::string& failure : {series, single}) {
    if (!failure.empty()) {
      std::fprintf(stderr, "%s\n", failure.c_str());
    }
    fuzz::require(failure.empty(), "laws of edits");
  }
  return 0;
}
