#pragma once

#include "app/band_store.h"

namespace scenefile::app {

/// Writes the files of a picture from the bands of its store, which must have all rows: the same
/// bytes as write_pictures() (pictures.h), a band at a time.
Outcome assemble(const Options& options, BandStore& store, Context& context);

}  // namespace scenefile::app
