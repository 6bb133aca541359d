#pragma once
// The parts of a JSON scene: global data, camera, lights, primitives. Internal to format.

#include "scenefile/format/json_fields.h"
#include "scenefile/scene/scene.h"

#include <optional>

namespace scenefile {

// `key` is the key "globalData" or "cameraData".
void read_json_global(JsonContext& context, JsonIndex key, Scene& scene);
void read_json_camera(JsonContext& context, JsonIndex key, Scene& scene);

// Reads one element of "lights" or "primitives"; nullopt if it cannot be used. Adds the places of
// its values to `scene`.
std::optional<Light> read_json_light(JsonContext& context, JsonIndex item, Scene& scene);
std::optional<Primitive> read_json_primitive(JsonContext& context, JsonIndex item, Scene& scene);

}  // namespace scenefile
