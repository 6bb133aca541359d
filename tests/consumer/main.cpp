#include <scenefile/asset/image_file.h>
#include <scenefile/io/file.h>
#include <scenefile/trace/render.h>
#include <scenefile/verbs/findings.h>
#include <scenefile/verbs/load_file.h>

#include <iostream>

int main(int, char** argv) {  // arguments: a scene, the picture to write
  using namespace scenefile;
  LoadedScene scene = load_scene_file(argv[1]);
  std::cerr << findings_text(scene);
  if (!scene.usable()) return 1;

  RenderScene& ready = scene.ready.scene;
  ready.camera.position.y += 2;

  const RenderResult result = render(ready, scene.assets, {.width = 320, .height = 240});
  const Result<std::string> png = encode_image(result.image, ImageFormat::png8, Rounding::nearest);
  const Result<void> written = png ? write_file(argv[2], *png) : png.error();
  if (!written) std::cerr << written.error().text << '\n';
  return written ? 0 : 3;
}
