#pragma once
// The file that keeps the state of a long work, so that it can go on after whatever ended it.

#include "scenefile/io/file.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

/// What a state belongs to, as fingerprints (base/hash.h). All must be equal for it to be of use.
struct CheckpointKey {
  std::uint64_t program = 0;  ///< the build
  std::uint64_t scene = 0;    ///< its bytes
  std::uint64_t assets = 0;   ///< names and bytes of its textures and meshes
  std::uint64_t options = 0;  ///< all that changes the result

  friend bool operator==(const CheckpointKey&, const CheckpointKey&) = default;
};

/// The bytes of a checkpoint file: a line that says what it is, key, length, checksum, state.
std::string encode_checkpoint(const CheckpointKey& key, std::string_view state);

/// The state in the bytes of a file, if they are a whole checkpoint with that key. Else returns
/// what is wrong, for a person; `state` is then empty.
std::string decode_checkpoint(std::string_view bytes, const CheckpointKey& key, std::string& state);

}  // namespace scenefile
