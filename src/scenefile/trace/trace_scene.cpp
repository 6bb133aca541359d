#include "scenefile/trace/trace_scene.h"

#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/once_flag.h"
#include "scenefile/trace/ray_scenes.h"
#include "scenefile/trace/texture_lookup.h"
#include "scenefile/trace/tiles.h"
#include "scenefile/trace/wavefront.h"

#include <chrono>
#include <utility>

namespace scenefile {

namespace {

using Clock = std::chrono::steady_clock;

AcceleratorOptions accelerator_options(const TraceSceneOptions& options) {
  return {options.instance_names ? Instances::named : Instances::unnamed, MeshDistance::of_world};
}

}  // namespace

struct TraceScene::Shared {
  Shared(const RenderScene& scene, const Assets& a, const TraceSceneOptions& options,
         const ThreadLimit& /*while it is built*/, Clock::time_point start)
      : assets(a),
        accelerator(scene, a, accelerator_options(options)),
        build_seconds(std::chrono::duration<double>(Clock::now() - start).count()) {}

  const Assets& assets;
  Accelerator accelerator;
  double build_seconds;
  mutable OnceFlag mip_maps_made;
  mutable std::vector<MipMap> mip_maps;
};

TraceScene::TraceScene(const RenderScene& scene, const Assets& assets,
                       const TraceSceneOptions& options)
    : shared_(std::make_shared<Shared>(scene, assets, options, ThreadLimit(options.threads),
                                       Clock::now())) {}

RenderStatus TraceScene::status() const {
  switch (shared_->accelerator.status()) {
    case AcceleratorStatus::ready:
      return RenderStatus::complete;
    case AcceleratorStatus::too_deep:
      return RenderStatus::limit_reached;
    case AcceleratorStatus::out_of_memory:
      break;
  }
  return RenderStatus::failed;
}

double TraceScene::build_seconds() const {
  return shared_->build_seconds;
}

const Assets& TraceScene::assets() const {
  return shared_->assets;
}

const Accelerator& TraceScene::accelerator() const {
  return shared_->accelerator;
}

const std::vector<MipMap>& TraceScene::mip_maps() const {
  shared_->mip_maps_made([&] {
    std::vector<MipMap> made;
    made.reserve(shared_->assets.textures.size());
    for (const Texture& texture : shared_->assets.textures) {
      made.emplace_back(texture);
    }
    shared_->mip_maps = std::move(made);
  });
  return shared_->mip_maps;
}

TraceBackend trace_backend() {
  return {embree_version(), wavefront_kernels().front()->name};
}

}  // namespace scenefile
