#pragma once
// A scene with its findings as JSON, and the members that the answers of several verbs share.
// docs/formats.md describes the documents.

#include "scenefile/trace/render_options.h"
#include "scenefile/verbs/json_writer.h"
#include "scenefile/verbs/load_scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The version and the name of the verb; the document's object stays open.
void begin_document(Json& json, std::string_view verb);

/// The scene as a value of the open object or array: path, verdict, findings.
void add_scene(Json& json, const LoadedScene& scene);
/// The same as a text of its own, to be collected.
std::string scene_json(const LoadedScene& scene);

/// The document of scenes that were checked: texts of scene_json().
std::string check_json(const std::vector<std::string>& scenes);

/// Line and column, where they are known, into the open object.
void add_location(Json& json, Location location);

/// Size, profile, features and so on, into the open object.
void add_render_options(Json& json, const RenderOptions& options);

}  // namespace scenefile
