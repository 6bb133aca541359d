#pragma once
// --checkpoint: saves the state of a render in a file.

#include "app/load.h"
#include "scenefile/io/checkpoint.h"
#include "scenefile/trace/render.h"

#include <cstdint>
#include <string>

namespace scenefile::app {

/// The fingerprints of everything that the picture depends on.
CheckpointKey picture_key_of(const Options& options, const LoadedScene& scene);

/// The fingerprints (base/hash.h) in such a key: of the program file, and of all options that
/// affect pixels.
std::uint64_t program_fingerprint();
std::uint64_t options_fingerprint(const Options& options);

/// Reads options.checkpoint, if it exists, into checkpoints.resume, and makes checkpoints.save
/// write it. A failed write is reported once and does not stop the render. An existing file that
/// cannot be used is an error.
Outcome open_checkpoint(const Options& options, const LoadedScene& scene, Checkpoints& checkpoints);

/// Removes the file when the render is complete.
void remove_checkpoint(const Options& options);

}  // namespace scenefile::app
