#include "scenefile/trace/backend.h"

#include "scenefile/trace/ray_scenes.h"
#include "scenefile/trace/wave.h"

namespace scenefile {

TraceBackend trace_backend() {
  return {embree_version(), wave_kernels().front()->name};
}

}  // namespace scenefile
