#pragma once
// JSON as nearly all scene files are, read in half of the time. Private to the room.

#include "scenefile/format/json_parser.h"

#include <cstdint>
#include <string_view>

namespace scenefile {

/// Fills the tape as parse_json() does, if the text is plain: an object or array without escapes in
/// strings, without positive exponents and numbers of very many digits, and within the limit.
/// False: something is unusual or wrong, and the tape is to be forgotten.
bool read_plain_json(std::string_view text, std::uint32_t max_depth, JsonTape& tape);

}  // namespace scenefile
