#include "scenefile/io/checkpoint.h"

#include "scenefile/base/hash.h"

#include <fmt/format.h>

#include <cstring>

namespace scenefile {

namespace {

// The number is the version of the layout.
constexpr std::string_view first_line = "scenefile checkpoint 1\n";

// The header after the first line. Numbers are in native byte order: builds for other machines have
// other fingerprints.
struct Head {
  CheckpointKey key;
  std::uint64_t length = 0;    // of the state
  std::uint64_t checksum = 0;  // of key, length and state
};
static_assert(sizeof(Head) == 6 * sizeof(std::uint64_t));

constexpr std::size_t head_bytes = first_line.size() + sizeof(Head);

std::uint64_t checksum(Head head, std::string_view state) {
  head.checksum = 0;
  Hash hash;
  hash.add({reinterpret_cast<const char*>(&head), sizeof head});
  hash.add(state);
  return hash.value();
}

std::string foreign(const CheckpointKey& found, const CheckpointKey& wanted) {
  const char* const what = found.scene != wanted.scene
                               ? "from another scene, or the scene was changed"
                           : found.assets != wanted.assets   ? "with other textures or meshes"
                           : found.options != wanted.options ? "with other options"
                                                             : "by another build of the program";
  return fmt::format("the checkpoint was written {}", what);
}

}  // namespace

std::string encode_checkpoint(const CheckpointKey& key, std::string_view state) {
  Head head{key, state.size(), 0};
  head.checksum = checksum(head, state);
  std::string bytes;
  bytes.reserve(head_bytes + state.size());
  bytes += first_line;
  bytes.append(reinterpret_cast<const char*>(&head), sizeof head);
  bytes += state;
  return bytes;
}

std::string decode_checkpoint(std::string_view bytes, const CheckpointKey& key,
                              std::string& state) {
  state.clear();
  if (!bytes.starts_with(first_line.substr(0, bytes.size())) || bytes.empty()) {
    return bytes.empty() ? "the file is empty" : "the file is not a checkpoint of this version";
  }
  if (bytes.size() < head_bytes) {
    return "the checkpoint is truncated";
  }
  Head head;
  std::memcpy(&head, bytes.data() + first_line.size(), sizeof head);
  bytes.remove_prefix(head_bytes);
  if (head.length != bytes.size()) {
    return fmt::format("the checkpoint is {}",
                       bytes.size() < head.length ? "truncated" : "longer than its header says");
  }
  if (head.checksum != checksum(head, bytes)) {
    return "the checkpoint is damaged: its checksum is wrong";
  }
  if (head.key != key) {
    return foreign(head.key, key);
  }
  state = bytes;
  return {};
}

}  // namespace scenefile
