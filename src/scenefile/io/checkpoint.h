#pragma once
// Checkpoint files: the state of a long computation, to resume it after an interruption.

#include "scenefile/io/file.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

/// Fingerprints (base/hash.h) of everything that a state depends on. All must match to resume.
struct CheckpointKey {
  std::uint64_t program = 0;  ///< the build
  std::uint64_t scene = 0;    ///< the scene file
  std::uint64_t assets = 0;   ///< names and bytes of textures and meshes
  std::uint64_t options = 0;  ///< all options that affect the result

  friend bool operator==(const CheckpointKey&, const CheckpointKey&) = default;
};

/// The contents of a checkpoint file: magic line, key, length, checksum, state.
std::string encode_checkpoint(const CheckpointKey& key, std::string_view state);

/// Extracts the state if `bytes` is a complete checkpoint with that key. Otherwise returns what is
/// wrong, and `state` is empty.
std::string decode_checkpoint(std::string_view bytes, const CheckpointKey& key, std::string& state);

}  // namespace scenefile
