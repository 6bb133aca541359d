#pragma once
// Changes the camera in a scene file, as an author would by hand.

#include "scenefile/base/result.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>

namespace scenefile {

/// Returns the scene file with position, look, up and height angle of `camera`. Numbers whose value
/// does not change keep their spelling, and every other byte is preserved: comments, layout, order,
/// encoding and line ends. If the file's camera uses `focus`, it is set to position + look. Missing
/// values are added if needed, formatted like their neighbors; an XML file without a camera gets
/// one after <globaldata>. Aperture and focal length are unchanged.
///
/// The edit is refused unless reading the result gives the same scene with that camera. Files with
/// errors and files in UTF-16 are refused too. `camera` must be acceptable to check(); the length
/// of `look` may change.
Result<std::string> edit_camera(std::string_view bytes, const Camera& camera,
                                const ReadOptions& options);

}  // namespace scenefile
