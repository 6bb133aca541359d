#pragma once
// Which lights the course's assignment Realtime draws.

#include "scenefile/base/shape.h"
#include "scenefile/view/realtime.h"

namespace scenefile {

/// Whether the assignment has lights of the type; its program skips others.
constexpr bool has_light(Milestone milestone, LightType type) {
  switch (type) {
    case LightType::directional:
      return true;
    case LightType::point:
    case LightType::spot:
      return milestone == Milestone::action;
    case LightType::area:
      return false;
  }
  return false;
}

}  // namespace scenefile
