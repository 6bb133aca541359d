#pragma once
// Which groups of a scene become acceleration structures of their own, and what is in them.
//
// A group per template would make long chains of tiny structures. Groups that are used once, and
// small ones, are therefore copied into the group that uses them. How much may be copied is
// bounded, so a scene that unfolds to 10^40 objects stays as small as its file.

#include "scenefile/base/affine.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <vector>

namespace scenefile {

/// Whether parts name the instances that they come from. Names cost memory for each part.
enum class Instances : std::uint8_t { unnamed, named };

/// Bounds of the copying.
struct MergeLimits {
  std::size_t group_parts = 65536;     ///< a group with copies of shared ones has at most so many
  std::size_t copied_parts = 262144;  ///< by which copies may exceed the file, in all
};

/// An instance of a group, once: repetitions at the same place are dropped.
struct MergeEdge {
  Affine group_from_instance;
  std::uint32_t group = 0;
  std::uint32_t source = 0;
  bool merged = false;  ///< copied instead of referred to
};

/// What to do with each group of a scene.
struct MergePlan {
  std::vector<std::vector<MergeEdge>> edges;  ///< by group
  std::vector<bool> kept;                     ///< by group: has a structure of its own
  std::uint32_t nesting = 0;                  ///< groups inside each other that stay, at most
};

MergePlan plan_merge(const RenderScene& scene, const MergeLimits& limits = {});

/// A primitive, or an instance of a kept group, in a kept group.
struct MergedPart {
  DAffine group_from_part;
  const RenderPrimitive* primitive = nullptr;  ///< null: an instance
  std::uint32_t group = no_index;              ///< of an instance
  /// Where they have names: `source` of the merged instances on the way to the part, the outermost
  /// first, and of the instance that it is.
  std::vector<std::uint32_t> instances;
};

/// All parts of a kept group, those of merged groups included, in the order of the file.
std::vector<MergedPart> merged_parts(const RenderScene& scene, const MergePlan& plan,
                                     std::uint32_t group, Instances instances = Instances::unnamed);

}  // namespace scenefile
