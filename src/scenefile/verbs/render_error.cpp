#include "scenefile/verbs/render_error.h"

namespace scenefile {

std::optional<Error> render_error(RenderStatus status) {
  switch (status) {
    case RenderStatus::complete:
      return std::nullopt;
    case RenderStatus::cancelled:
      return Error{"interrupted", ErrorKind::cancelled};
    case RenderStatus::limit_reached:
      return Error{"templates are nested deeper than can be traced", ErrorKind::limit};
    case RenderStatus::failed:
      return Error{"out of memory while building the acceleration structure",
                   ErrorKind::environment};
  }
  return std::nullopt;
}

}  // namespace scenefile
