#pragma once
// The sources in shaders/, embedded by the build. Internal to view.

namespace scenefile {

extern const char* const scene_vert;
extern const char* const scene_frag;
extern const char* const filter_vert;
extern const char* const filter_frag;

}  // namespace scenefile
