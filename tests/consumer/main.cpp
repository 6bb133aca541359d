#include <scenefile/asset/image_file.h>
#include <scenefile/format/read_scene.h>
#include <scenefile/io/file.h>
#include <scenefile/scene/check.h>
#include <scenefile/scene/prepare.h>
#include <scenefile/trace/render.h>

int main(int, char** argv) {  // arguments: a scene, the picture to write
  using namespace scenefile;
  std::string text, error;
  if (!read_file(argv[1], Limits{}.file_bytes, text).empty()) return 3;
  Diagnostics diagnostics;
  Scene scene = read_scene(text, {}, diagnostics);
  check(scene, {}, diagnostics);
  if (diagnostics.has_errors()) return 1;

  if (!scene.camera) scene.camera = Camera{};
  scene.camera->position += glm::vec3(0, 2, 0);

  const RenderScene ready = prepare(scene, {}).scene;
  const Assets assets = load_assets(ready.texture_files, ready.mesh_files, {}, {}, diagnostics);
  RenderOptions options;
  options.width = 320;
  options.height = 240;
  const RenderResult result = render(ready, assets, options);
  const std::string png = encode_image(result.image, ImageFormat::png8, Rounding::nearest, error);
  return write_file(argv[2], png).empty() ? 0 : 3;
}
