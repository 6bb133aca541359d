#pragma once
// The references of a class, with their scenes and how they may have been drawn. Internal to verbs.

#include "scenefile/base/hash.h"
#include "scenefile/verbs/grade_class.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A picture that the class was to draw.
struct ClassReference {
  std::string name;
  DecodedPicture picture;
  std::optional<LoadedScene> scene;
  std::vector<DrawnWay> ways;  ///< how it was drawn, found with the first picture
  std::vector<DrawnWay> ways_to_try = {};
  std::uint64_t fingerprint = 0;                     ///< of the file
  std::optional<RenderOptions> path = std::nullopt;  ///< of a path-traced picture
  std::optional<PathTruth> truth = std::nullopt;     ///< drawn with the first picture
};

struct ClassReferences {
  std::vector<FoundFile> files;  ///< of each reference
  std::vector<ClassReference> all;
  Hash fingerprint;                ///< of what results depend on
  std::vector<UsedFile> inputs;    ///< all files, used or not
  std::vector<std::string> notes;  ///< about configurations, ClassGrader::notes()
};

/// Loads the pictures with their scenes, or in mode path the configurations. Textures next to the
/// scenes are no references.
Result<ClassReferences> load_references(const GradeRequest& request,
                                        const LoadShownScene& load_scene,
                                        const std::function<void(const char* phase)>& entering);

/// A reference of another scene that the picture shows instead, nearly without a difference; null:
/// none. A reference that is nearly of one color is not recognized: an empty picture would match
/// it.
const ClassReference* shown_instead(const ClassReferences& references,
                                    const ClassReference& reference, const Texture& picture);

UsedFile input_file(std::string_view role, const std::string& path);
void add_number(Hash& hash, std::uint64_t number);

}  // namespace scenefile
