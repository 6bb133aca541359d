#include <scenefile/asset/image_file.h>
#include <scenefile/base/report.h>
#include <scenefile/format/read_scene.h>
#include <scenefile/io/asset_roots.h>
#include <scenefile/io/file.h>
#include <scenefile/scene/check.h>
#include <scenefile/scene/prepare.h>
#include <scenefile/trace/render.h>

#include <iostream>

int main(int, char** argv) {  // arguments: a scene, the picture to write
  using namespace scenefile;
  std::string text, error;
  if (!read_file(argv[1], Limits{}.file_bytes, text).empty()) return 3;
  Diagnostics found;
  Scene scene = read_scene(text, {}, found);
  check(scene, {}, found);

  if (!scene.camera) scene.camera = Camera{};
  scene.camera->position += glm::vec3(0, 2, 0);

  const RenderScene ready = prepare(scene, {}).scene;
  AssetRoots roots({.scene_path = argv[1]});
  const auto open = [&](const std::string& name) {
    FileContents file;
    file.error = roots.read(name, file.bytes).text;
    return file;
  };
  const Assets assets = load_assets(ready.texture_files, ready.mesh_files, open, {}, found);
  std::cerr << report_text(found, argv[1], text, {});
  if (found.has_errors()) return 1;

  const RenderResult result = render(ready, assets, {.width = 320, .height = 240});
  const std::string png = encode_image(result.image, ImageFormat::png8, Rounding::nearest, error);
  return write_file(argv[2], png).empty() ? 0 : 3;
}
