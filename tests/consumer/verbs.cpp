// Uses the verbs like a web page or a language binding: a scene from memory, without files.

#include <scenefile/trace/render.h>
#include <scenefile/verbs/compare_pictures.h>
#include <scenefile/verbs/compare_scenes.h>
#include <scenefile/verbs/explain.h>
#include <scenefile/verbs/findings.h>
#include <scenefile/verbs/sarif.h>
#include <scenefile/verbs/scene_json.h>

#include <iostream>
#include <string>
#include <vector>

using namespace scenefile;

namespace {

int failures = 0;

void expect(bool good, const char* what) {
  if (!good) {
    std::cerr << "not so: " << what << '\n';
    ++failures;
  }
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A lit sphere with `material`.
std::string scene_text(const std::string& material) {
  return R"(<scenefile>
  <globaldata><ambientcoeff v="0.5"/><diffusecoeff v="0.5"/><specularcoeff v="0.5"/></globaldata>
  <cameradata><pos x="0" y="0" z="3"/><look x="0" y="0" z="-1"/><up x="0" y="1" z="0"/>
    <heightangle v="40"/></cameradata>
  <lightdata><id v="0"/><type v="directional"/><color r="1" g="1" b="1"/>
    <direction x="-1" y="-1" z="-1"/></lightdata>
  <object type="tree" name="root">
    <transblock><object type="primitive" name="sphere">)" +
         material + R"(</object></transblock>
  </object>
</scenefile>
)";
}

LoadedScene load(const std::string& material, const FetchFile& fetch = {}) {
  return load_scene("sphere.xml", scene_text(material), fetch);
}

Texture drawn(const LoadedScene& scene) {
  const RenderOptions options{.width = 32, .height = 24};
  return quantize(render(scene.ready.scene, scene.assets, options).image, Rounding::nearest);
}

void loads_and_checks() {
  const LoadedScene good = load(R"(<diffuse r="1" g="0.5" b="0"/>)");
  expect(good.usable() && !failure_of(good), "the scene can be used");
  expect(verdict_of(good) == SceneVerdict::fine, "it is fine");
  expect(holds(check_json({scene_json(good)}), R"("verdict": "fine")"), "and its JSON says so");

  LoadedScene bad = load(R"(<difuse r="1" g="0.5" b="0"/>)");
  expect(!bad.usable() && failure_of(bad) == ErrorKind::input, "an unknown element is an error");
  expect(holds(findings_text(bad), "did you mean <diffuse>?"), "which the report explains");
  SarifLog log;
  log.add(bad);
  expect(holds(log.text(1), R"("ruleId": "xml.misspelled-element")"), "and SARIF, too");
}

void fetches_textures() {
  std::vector<std::string> asked;
  const LoadedScene scene =
      load(R"(<texture file="wood.png" u="1" v="1"/><blend v="1"/>)", [&](const std::string& name) {
        asked.push_back(name);
        return Error{"there are no files here"};
      });
  expect(asked == std::vector<std::string>{"wood.png"}, "the callback is asked for the texture");
  expect(scene.usable(), "without which the scene can be drawn");
  expect(holds(findings_text(scene), "there are no files here"), "and the report says why");
}

void explains() {
  const LoadedScene scene = load(R"(<diffuse r="1" g="0.5" b="0"/>)");
  const RenderOptions options{.width = 32, .height = 24};
  const Result<ExplainReport> pixel = explain_pixel(scene, options, 16, 12);
  expect(bool(pixel), "a pixel is explained");
  if (pixel) {
    expect(holds(explain_text(scene, *pixel), "hits sphere"), "as a text");
    expect(holds(explain_json(scene, options, &*pixel), R"("shape": "sphere")"), "and as JSON");
  }
  const Result<ExplainReport> none = explain_pixel(scene, options, 16, 12, 100000);
  expect(!none && none.error().kind == ErrorKind::usage, "there is no such sample");
}

void compares() {
  const LoadedScene a = load(R"(<diffuse r="1" g="0.5" b="0"/>)");
  const LoadedScene b = load(R"(<diffuse r="1" g="0.25" b="0"/>)");
  const SceneDiff diff = compare_scenes(a, b);
  expect(!diff.same_meaning, "the scenes differ");
  expect(holds(compare_scenes_text(a, b, diff), "1 difference"), "in one place");
  expect(holds(compare_scenes_json(a, b, &diff), R"("same_meaning": false)"), "JSON says so");

  const Texture reference = drawn(a);
  expect(compare_pictures(reference, drawn(a)).broken.empty(), "a picture is itself");
  Texture upside_down = reference;
  for (int y = 0; y < reference.height; ++y) {
    for (int x = 0; x < 3 * reference.width; ++x) {
      upside_down.rgb[std::size_t(y) * 3 * reference.width + x] =
          reference.rgb[std::size_t(reference.height - 1 - y) * 3 * reference.width + x];
    }
  }
  const PictureComparison flipped = compare_pictures(reference, upside_down, &a);
  expect(!flipped.broken.empty(), "upside down it differs");
  expect(holds(causes_text(flipped), "[vertical-flip]"), "and the cause is named");
}

}  // namespace

int main() {
  loads_and_checks();
  fetches_textures();
  explains();
  compares();
  return failures == 0 ? 0 : 1;
}
