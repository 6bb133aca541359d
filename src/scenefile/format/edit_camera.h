#pragma once
// The camera of a scene file set to another one, as an author would do it by hand.

#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>

namespace scenefile {

struct CameraEdit {
  std::string bytes;    ///< the whole file; empty when refused
  std::string refused;  ///< why nothing was changed, one line in plain English; empty: done
};

/// The bytes of the scene file with position, look, up and height angle of `camera`. Numbers that
/// mean the same already stay as they are written; every other byte of the file stays: comments,
/// layout, order, spelling, encoding and line ends. A camera that says `focus` gets position + look
/// there. What the camera of the file lacks is added where it is needed, laid out like its
/// neighbors; an XML file without camera gets one behind its <globaldata>. Aperture and focal
/// length are left alone.
///
/// The result is read again and must be the same scene with that camera, else the edit is refused;
/// so are files with errors and those in UTF-16. `camera` is one that check() accepts; of `look`
/// the direction alone is sure to survive.
CameraEdit edit_camera(std::string_view bytes, const Camera& camera, const ReadOptions& options);

}  // namespace scenefile
