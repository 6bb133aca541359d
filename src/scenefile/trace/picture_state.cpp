#include "scenefile/trace/picture_state.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace scenefile {

namespace {

struct Head {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t pass = 0;
  std::uint32_t marks = 0;  // whether there are any

  friend bool operator==(const Head&, const Head&) = default;
};

constexpr std::size_t color_bytes = 3 * sizeof(float);

}  // namespace

PictureState::PictureState(int width, int height, bool two_passes, Image canvas)
    : image(canvas.width == width && canvas.height == height ? std::move(canvas)
                                                             : Image(width, height)),
      pieces(width, height),
      marked(two_passes ? std::size_t(width) * height : 0) {}

void PictureState::start_second_pass() {
  pass = 1;
  pieces.restart();
}

std::size_t PictureState::byte_count() const {
  const std::size_t pixels = std::size_t(image.width) * image.height;
  return sizeof(Head) + pieces.count() + marked.size() + color_bytes * pixels;
}

std::string PictureState::bytes() const {
  const Head head{std::uint32_t(image.width), std::uint32_t(image.height), pass, !marked.empty()};
  std::string result(byte_count(), '\0');
  char* to = result.data();
  std::memcpy(to, &head, sizeof head);
  to += sizeof head;
  // Flags are read once: a piece that gets done meanwhile counts as not done.
  std::vector<bool> done(pieces.count());
  for (std::size_t i = 0; i < done.size(); ++i) {
    done[i] = pieces.done(i);
    *to++ = char(done[i]);
  }
  const std::size_t pixels = std::size_t(image.width) * image.height;
  char* colors = to + marked.size();
  for (std::size_t i = 0; i < pixels; ++i) {
    // What no thread is writing: done pieces, and what the second pass leaves alone.
    const bool whole = done[pieces.at(int(i % image.width), int(i / image.width))];
    const bool settled = pass == 1 && marked[i] == 0;
    if (!marked.empty() && (whole || pass == 1)) {
      to[i] = char(marked[i]);
    }
    if (whole || settled) {
      std::memcpy(colors + color_bytes * i, image.rgb.data() + 3 * i, color_bytes);
    }
  }
  return result;
}

bool PictureState::restore(std::string_view bytes) {
  Head head;
  if (bytes.size() != byte_count()) {
    return false;
  }
  std::memcpy(&head, bytes.data(), sizeof head);
  const Head wanted{std::uint32_t(image.width), std::uint32_t(image.height), head.pass,
                    !marked.empty()};
  if (!(head == wanted) || head.pass > wanted.marks) {
    return false;
  }
  bytes.remove_prefix(sizeof head);
  pass = head.pass;
  pieces.restart();
  for (std::size_t i = 0; i < pieces.count(); ++i) {
    if (bytes[i] != 0) {
      pieces.finish(i);
    }
  }
  bytes.remove_prefix(pieces.count());
  std::copy_n(bytes.data(), marked.size(), marked.data());
  bytes.remove_prefix(marked.size());
  std::memcpy(image.rgb.data(), bytes.data(), bytes.size());
  return true;
}

}  // namespace scenefile
