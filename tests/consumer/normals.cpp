#include <scenefile/asset/image_file.h>
#include <scenefile/io/file.h>
#include <scenefile/trace/layers.h>
#include <scenefile/trace/render.h>
#include <scenefile/verbs/findings.h>
#include <scenefile/verbs/load_file.h>

#include <iostream>

int main(int, char** argv) {  // arguments: a scene, the .exr and the .png to write
  using namespace scenefile;
  const LoadedScene scene = load_scene_file(argv[1]);
  std::cerr << findings_text(scene);
  if (!scene.usable()) return 1;

  RenderOptions options{.width = 320, .height = 240};
  options.layers = {{LayerKind::normal}};
  const RenderResult result = render(scene.ready.scene, scene.assets, options);

  const ImageLayer& normals = result.layers[0];  // channels X Y Z, row 0 at the top
  const float* center = &normals.values[3 * (120 * 320 + 160)];
  std::cout << center[0] << ' ' << center[1] << ' ' << center[2] << '\n';

  const Result<std::string> exr = encode_layers(320, 240, result.layers);  // floats
  const Image colors = layer_picture(options.layers[0], normals, 320, 240, options.max_depth);
  const Result<std::string> png = encode_image(colors, ImageFormat::png8, Rounding::nearest);
  return exr && png && write_file(argv[2], *exr) && write_file(argv[3], *png) ? 0 : 3;
}
