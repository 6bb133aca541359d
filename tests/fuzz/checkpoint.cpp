// Tests bytes as a checkpoint file, as the state inside one, and as a file with those bytes
// changed.

#include "scenefile/io/checkpoint.h"

#include "law.h"
#include "scenefile/trace/picture_state.h"
#include "target.h"

namespace {

using namespace scenefile;
using fuzz::require;

constexpr CheckpointKey key{1, 2, 3, 4};

void read_as_file(std::string_view bytes) {
  std::string state;
  const std::string why = decode_checkpoint(bytes, key, state);
  require(why.empty() || state.empty(), "what is refused gives no state");
  require(!why.empty() || encode_checkpoint(key, state) == bytes,
          "what is taken is what was written");
}

// A picture of 17 x 2 pixels: profile course takes one pass, fine two.
PictureState fresh_state(Profile profile) {
  RenderOptions options = default_options(profile);
  options.width = 17;
  options.height = 2;
  return make_state(RenderScene{}, options);
}

// Any state with the right length can be resumed, and is written as it was read.
void read_as_state(std::string_view bytes) {
  for (const Profile profile : {Profile::course, Profile::fine}) {
    PictureState picture = fresh_state(profile);
    const std::string before = encode_state(picture);
    if (!decode_state(bytes, picture)) {
      require(encode_state(picture) == before, "a refused state changes nothing");
      continue;
    }
    PictureState again = fresh_state(profile);
    const std::string taken = encode_state(picture);
    require(decode_state(taken, again), "a state that was taken is taken again");
    require(encode_state(again) == taken, "and is the same");
  }
}

void change_a_byte(std::string_view bytes) {
  std::string file = encode_checkpoint(key, bytes);
  const std::size_t at = bytes.empty() ? 0 : static_cast<unsigned char>(bytes[0]) % file.size();
  file[at] = static_cast<char>(file[at] ^ (bytes.size() < 2 || bytes[1] == 0 ? 1 : bytes[1]));
  std::string state;
  require(!decode_checkpoint(file, key, state).empty(), "a changed byte is found");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  read_as_file(bytes);
  read_as_state(bytes);
  change_a_byte(bytes);
  return 0;
}
