#pragma once
// The texts of shaders/, which the build puts into the program. Internal to the room.

namespace scenefile {

extern const char* const scene_vert;
extern const char* const scene_frag;
extern const char* const filter_vert;
extern const char* const filter_frag;

}  // namespace scenefile
