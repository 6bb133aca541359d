#pragma once
// The assignment Realtime as a student would write it, for tests: matrices, a vertex and a fragment
// stage, a rasterizer with fixed-point edges, and filters of the finished frame. Shares nothing
// with the project's tessellation, rasterizer and OpenGL engine, so that their agreement is
// evidence. Makes common mistakes on request.

#include "scenefile/asset/image.h"
#include "scenefile/scene/render_scene.h"
#include "student/student_tracer.h"

#include <set>
#include <span>
#include <string>

namespace scenefile::student {

std::span<const KnownMistake> known_realtime_mistakes();

struct RealtimeJob {
  int width = 1024;
  int height = 768;
  int parameter1 = 5;
  int parameter2 = 5;
  double near = 0.1;
  double far = 100;
  std::string filter = "none";
  bool action = false;  ///< the milestone
  std::set<std::string, std::less<>> mistakes;
};

/// Draws no meshes.
Texture draw_realtime(const RenderScene& scene, const RealtimeJob& job);

}  // namespace scenefile::student
