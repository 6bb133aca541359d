#include "scenefile/explain/object_names.h"

namespace scenefile {

ObjectNames::ObjectNames(const Scene& scene, const std::vector<Source>& sources)
    : scene_(scene), sources_(sources), paths_(scene) {}

WayPoint ObjectNames::at(std::uint32_t source) const {
  if (source >= sources_.size()) {
    return {};
  }
  return {paths_.path(sources_[source].node), place_of(scene_, sources_[source])};
}

std::vector<WayPoint> ObjectNames::way(const ObjectRef& object) const {
  std::vector<WayPoint> points;
  points.reserve(object.instances.size() + 1);
  for (const std::uint32_t source : object.instances) {
    points.push_back(at(source));
  }
  points.push_back(at(object.source));
  return points;
}

std::string ObjectNames::text(const ObjectRef& object) const {
  std::string text;
  for (const WayPoint& point : way(object)) {
    text += (text.empty() ? "" : " > ") + point.path;
  }
  return text;
}

}  // namespace scenefile
