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

/// Whether parts store the instances that they come from, which costs memory for each part.
enum class Instances : std::uint8_t { unnamed, named };

/// Limits on copying.
struct MergeLimits {
  std::size_t group_parts = 65536;    ///< of a group with copies of shared groups
  std::size_t copied_parts = 262144;  ///< added to the whole scene by copying
};

/// A distinct instance of a group: duplicates at the same place are dropped.
struct MergeEdge {
  Affine group_from_instance;
  std::uint32_t group = 0;
  std::uint32_t source = 0;
  bool merged = false;  ///< copied instead of referenced
};

/// What to do with each group of a scene.
struct MergePlan {
  std::vector<std::vector<MergeEdge>> edges;  ///< by group
  std::vector<bool> kept;                     ///< by group: has a separate structure
  std::uint32_t nesting = 0;                  ///< maximum nesting of kept groups
};

MergePlan plan_merge(const RenderScene& scene, const MergeLimits& limits = {});

/// A primitive or an instance in a kept group.
struct MergedPart {
  DAffine group_from_part;
  const RenderPrimitive* primitive = nullptr;  ///< null: an instance
  std::uint32_t group = no_index;              ///< of an instance
  /// If instances are named: `source` of the merged instances around the part, outermost first, and
  /// of the part itself if it is an instance.
  std::vector<std::uint32_t> instances;
};

/// All parts of a kept group, including those of merged groups, in the order of the file.
std::vector<MergedPart> merged_parts(const RenderScene& scene, const MergePlan& plan,
                                     std::uint32_t group, Instances instances = Instances::unnamed);

}  // namespace scenefile
