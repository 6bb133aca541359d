#pragma once
// Scene texts for the tests of the window.

#include "scenefile/format/read_scene.h"
#include "scenefile/io/file.h"
#include "scenefile/scene/check.h"
#include "scenefile/viewer/opened_scene.h"

#include <string>

namespace scenefile::viewer::testing {

/// How often tests look whether other threads are done, every 5 ms: a minute, for busy machines.
constexpr int patience = 12000;

/// A sphere at x = -1 and a cube at x = 1, seen from z = 6; a template with a cone, instantiated
/// twice below them; two lights.
inline const std::string scene_text = R"(<scenefile>
  <globaldata><ambientcoeff v="1"/><diffusecoeff v="1"/><specularcoeff v="1"/></globaldata>
  <cameradata>
    <pos x="0" y="0" z="6"/>  <!-- in front -->
    <look x="0" y="0" z="-1"/>
    <up x="0" y="1" z="0"/>
    <heightangle v="45"/>
  </cameradata>
  <lightdata><id v="0"/><color r="1" g="1" b="1"/><type v="directional"/><direction x="-1" y="-1" z="-1"/></lightdata>
  <lightdata><id v="1"/><color r="0" g="1" b="0"/><type v="point"/><position x="0" y="3" z="3"/><function v1="1" v2="0" v3="0"/></lightdata>
  <object type="tree" name="spike">
    <transblock>
      <object type="primitive" name="cone"><diffuse r="0" g="0" b="1"/></object>
    </transblock>
  </object>
  <object type="tree" name="root">
    <transblock>
      <translate x="-1" y="0" z="0"/>
      <object type="primitive" name="sphere"><diffuse r="1" g="0" b="0"/></object>
    </transblock>
    <transblock>
      <translate x="1" y="0" z="0"/>
      <object type="primitive" name="cube"><diffuse r="0" g="1" b="0"/></object>
    </transblock>
    <transblock><translate x="-1" y="-1.5" z="0"/><object type="master" name="spike"/></transblock>
    <transblock><translate x="1" y="-1.5" z="0"/><object type="master" name="spike"/></transblock>
  </object>
</scenefile>
)";

/// Opens a scene like the program does, for scenes without assets.
inline OpenedScene open_request(const SceneRequest& request) {
  OpenedScene opened;
  opened.path = request.path;
  const Result<std::string> text =
      request.text ? *request.text : read_file(request.path, Limits{}.file_bytes);
  if (!text) {
    opened.unreadable = text.error().text;
    return opened;
  }
  opened.text = *text;
  opened.written = read_scene(opened.text, {}, opened.diagnostics);
  if (!opened.diagnostics.has_errors()) {
    check(opened.written, {}, opened.diagnostics);
  }
  if (!opened.diagnostics.has_errors()) {
    opened.ready = prepare(opened.written, {});
  }
  return opened;
}
inline OpenedScene open_file(const std::string& path) {
  return open_request({path});
}

}  // namespace scenefile::viewer::testing
