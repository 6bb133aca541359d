#pragma once
// Reads what stream_blocks() (image_stream.h) writes: whole rows of a picture, in an OpenEXR file
// with ZIP compression.

#include "scenefile/asset/image.h"
#include "scenefile/base/result.h"

#include <memory>
#include <span>
#include <string>

namespace scenefile {

class ExrRows {
 public:
  /// An error (ErrorKind::input) if the bytes are damaged or not such a file. Its text is a phrase
  /// that follows "cannot decode: ", also below.
  static Result<ExrRows> open(std::string bytes);
  ExrRows(ExrRows&& other) noexcept;
  ExrRows& operator=(ExrRows&& other) noexcept;
  ~ExrRows();

  int width() const;
  int picture_height() const;
  /// Rows of the picture from first() up to, but not including, end(), counted from 0 at its top.
  int first() const;
  int end() const;

  /// Sets the values of these layers, all rows. An error if a channel is missing.
  Result<void> read(std::span<ImageLayer> layers) const;

  /// The packed bytes of the block of up to 16 rows that contains row y.
  Result<std::string> block(int y) const;

 private:
  struct State;
  explicit ExrRows(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scenefile
