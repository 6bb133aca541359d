// Draws a scene without textures and meshes, and prints the color at the center of the picture.
#include <scenefile/asset/image_file.h>
#include <scenefile/format/read_scene.h>
#include <scenefile/scene/check.h>
#include <scenefile/scene/prepare.h>
#include <scenefile/trace/render.h>

#include <fstream>
#include <iostream>
#include <iterator>

int main(int, char** argv) {  // arguments: a scene, the PNG to write
  using namespace scenefile;
  std::ifstream file(argv[1], std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Diagnostics diagnostics;
  const Scene scene = read_scene(text, {}, diagnostics);
  check(scene, {}, diagnostics);
  if (diagnostics.has_errors()) return 1;

  const RenderScene ready = prepare(scene, {}).scene;
  const RenderResult result = render(ready, {}, {.width = 320, .height = 240});
  const float* center = &result.image.rgb[3 * (120 * 320 + 160)];
  std::cout << center[0] << ' ' << center[1] << ' ' << center[2] << '\n';
  const Result<std::string> png = encode_image(result.image, ImageFormat::png8, Rounding::nearest);
  return png && std::ofstream(argv[2], std::ios::binary) << *png ? 0 : 3;
}
