#pragma once
// From what the tracer met to what the author wrote.

#include "scenefile/scene/node_path.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/trace/explain.h"

#include <string>
#include <vector>

namespace scenefile {

/// A place on the way from the root to an object: a node that is a copy of a template, or the node
/// of the object itself.
struct WayPoint {
  std::string path;   ///< node_path(), of the template inside a copy
  Location location;  ///< of the copy; of the object at the end of the way
};

class ObjectNames {
 public:
  /// Scene and sources must outlive it.
  ObjectNames(const Scene& scene, const std::vector<Source>& sources);

  /// The outermost copy first, the object last; never empty.
  std::vector<WayPoint> way(const ObjectRef& object) const;

  /// The way in one line: "root/board > board/#3/pawn > pawn/head".
  std::string text(const ObjectRef& object) const;

  /// Of a `source` in the table; an empty place for any other.
  WayPoint at(std::uint32_t source) const;

 private:
  const std::vector<Source>& sources_;
  NodePaths paths_;
};

}  // namespace scenefile
