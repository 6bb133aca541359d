#pragma once
// Names for the objects that the tracer hit, as in the scene file.

#include "scenefile/scene/node_path.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/trace/explain.h"

#include <string>
#include <vector>

namespace scenefile {

/// A step on the path from the root to an object: an instance of a template, or the node of the
/// object itself.
struct WayPoint {
  std::string path;   ///< node_path(); inside an instance, the path in its template
  Location location;  ///< of the instance; of the object for the last step
};

class ObjectNames {
 public:
  /// `scene` and `sources` must outlive the result.
  ObjectNames(const Scene& scene, const std::vector<Source>& sources);

  /// The outermost instance first, the object last; never empty.
  std::vector<WayPoint> way(const ObjectRef& object) const;

  /// The path in one line: "root/board > board/#3/pawn > pawn/head".
  std::string text(const ObjectRef& object) const;

  /// For a `source` in the table; an empty place for any other value.
  WayPoint at(std::uint32_t source) const;

 private:
  const Scene& scene_;
  const std::vector<Source>& sources_;
  NodePaths paths_;
};

}  // namespace scenefile
