#pragma once
// The store of render: a folder with bands of the picture, each an EXR file with its key.

#include "app/load.h"
#include "scenefile/asset/exr_rows.h"
#include "scenefile/trace/bands.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

class BandStore {
 public:
  /// `options`: with all options of the picture, and its folder.
  BandStore(const Options& options, const LoadedScene& scene);

  /// Checks all files with the name of a band. An error if one is a band of another picture or no
  /// band at all, or if it is an input of the command.
  Outcome open(Context& context);

  const RowRange& picture() const { return picture_; }
  int width() const { return width_; }
  /// Bands that exist and are intact.
  std::size_t current() const { return bands_.size(); }
  /// The rows of the picture that no band has.
  std::vector<RowRange> missing(const RowRange& rows) const { return rows_without(bands_, rows); }

  /// Adds the files of bands to context.files.
  Outcome claim(const std::vector<RowRange>& bands, Context& context) const;

  /// Writes a new band; makes the folder if necessary.
  Outcome write(const RowRange& band, RenderResult result);

  /// The picture itself without a name, then its layers, without values.
  std::vector<ImageLayer> layers() const;

  /// A band that contains row y, valid until the next call. There must be one.
  struct Band {
    RowRange rows;
    std::optional<ExrRows> file;
  };
  Result<const Band*> band_at(int y);

 private:
  enum class State { current, foreign, damaged };

  std::string path_of(const RowRange& band) const;
  std::string key_of(const RowRange& band) const;
  Result<std::string> read(const std::string& path) const;
  // `why`: for foreign files.
  State state_of(const RowRange& band, std::string_view bytes, std::string& why) const;

  const Options& options_;
  std::string key_;
  int width_ = 0;
  RowRange picture_;
  std::vector<RowRange> bands_;
  Band open_;
};

}  // namespace scenefile::app
