#pragma once
// Decides which groups of a scene become separate acceleration structures, and what they contain.
//
// A structure for each template would give long chains of tiny structures. Therefore groups that
// are used once, and small ones, are copied into the group that uses them. The amount of copying is
// bounded, so a scene that expands to 10^40 objects stays as small as its file.

#include "scenefile/base/affine.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <vector>

namespace scenefile {

/// Whether objects store the instances that they come from, which costs memory for each object.
enum class Instances : std::uint8_t { unnamed, named };

/// Limits on copying.
struct FlattenLimits {
  std::size_t group_objects = 65536;    ///< of a group with copies of shared groups
  std::size_t copied_objects = 262144;  ///< added to the whole scene by copying
};

/// A distinct instance of a group: duplicates at the same place are dropped.
struct FlattenEdge {
  Affine group_from_instance;
  std::uint32_t group = 0;
  std::uint32_t source = 0;
  bool flattened = false;  ///< its contents are copied instead of referenced
};

/// What to do with each group of a scene.
struct FlattenPlan {
  std::vector<std::vector<FlattenEdge>> edges;  ///< by group
  std::vector<bool> kept;                       ///< by group: has a separate structure
  std::uint32_t nesting = 0;                    ///< maximum nesting of kept groups
};

FlattenPlan plan_flattening(const RenderScene& scene, const FlattenLimits& limits = {});

/// A primitive or an instance in a kept group.
struct FlatObject {
  DAffine group_from_object;
  const RenderPrimitive* primitive = nullptr;  ///< null: an instance
  std::uint32_t group = no_index;              ///< of an instance
  /// If instances are named: `source` of the flattened instances around the object, outermost
  /// first, and of the object itself if it is an instance.
  std::vector<std::uint32_t> instances;
};

/// All objects of a kept group, including those of flattened groups, in the order of the file.
std::vector<FlatObject> flat_objects(const RenderScene& scene, const FlattenPlan& plan,
                                     std::uint32_t group, Instances instances = Instances::unnamed);

}  // namespace scenefile
