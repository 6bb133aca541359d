#include "laws/law.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/trace/render.h"
#include "support/load_scene.h"

#include <fmt/format.h>

namespace scenefile::laws {

namespace {

std::string_view name_of(SceneFormat format) {
  return format == SceneFormat::xml ? "XML" : "JSON";
}

bool same_findings(const Diagnostics& a, const Diagnostics& b) {
  return a.list().size() == b.list().size() &&
         std::equal(a.list().begin(), a.list().end(), b.list().begin(),
                    [](const Diagnostic& x, const Diagnostic& y) {
                      return x.code == y.code && x.message == y.message;
                    });
}

std::vector<std::string> pictures(const std::string& path, const Scene& scene) {
  Diagnostics ignored;
  const RenderScene ready = prepare(scene, {}).scene;
  const Assets assets = testing_support::load_files(path, ready, ignored);
  std::vector<std::string> files;
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = default_options(profile);
    options.width = 64;
    options.height = 48;
    files.push_back(*encode_image(render(ready, assets, options).image, ImageFormat::png8,
                                  rounding_of(profile)));
  }
  return files;
}

class SceneLaws {
 public:
  SceneLaws(const std::string& path, const Scene& scene, Breaches& breaches)
      : path_(path), scene_(scene), breaches_(breaches) {}

  void run() {
    const Scene xml = written_and_read(scene_, SceneFormat::xml);
    const Scene json = written_and_read(scene_, SceneFormat::json);
    written_and_read(json, SceneFormat::xml);
    written_and_read(xml, SceneFormat::json);
    const Scene back = written_and_read(json, SceneFormat::xml);
    if (pictures(path_, scene_) != pictures(path_, back)) {
      breaches_.push_back("its pictures before and after XML -> JSON -> XML differ");
    }
  }

 private:
  std::string write(const Scene& scene, SceneFormat format) {
    Diagnostics diagnostics;
    std::string text = write_scene(scene, format, {}, diagnostics);
    if (diagnostics.has_errors()) {
      breach(format, "it cannot be written: " + diagnostics.list().front().message);
    }
    if (diagnostics.count(Severity::warning) != 0) {
      breach(format, "a part of it is lost: " + diagnostics.list().front().message);
    }
    return text;
  }

  Scene written_and_read(const Scene& scene, SceneFormat format) {
    const std::string text = write(scene, format);
    Diagnostics diagnostics;
    Scene read = read_scene(text, {}, diagnostics);
    if (diagnostics.count(Severity::error) + diagnostics.count(Severity::warning) != 0) {
      breach(format, "what was written is read with: " + diagnostics.list().front().message);
    }
    if (!same_meaning(scene, read)) {
      breach(format, "what was written means something else");
    }
    if (write(read, format) != text) {
      breach(format, "writing twice is not writing once");
    }
    return read;
  }

  void breach(SceneFormat format, const std::string& what) {
    breaches_.push_back(fmt::format("{}: {}", name_of(format), what));
  }

  const std::string& path_;
  const Scene& scene_;
  Breaches& breaches_;
};

}  // namespace

bool try_scene_laws(const std::string& path, std::string_view text, const ReadOptions& options,
                    Breaches& breaches) {
  Diagnostics reading;
  const Scene scene = read_scene(text, options, reading);
  Diagnostics once;
  check(scene, options.limits, once);
  Diagnostics twice;
  check(scene, options.limits, twice);
  if (!same_findings(once, twice)) {
    breaches.push_back("checking twice finds something else");
  }
  if (reading.has_errors() || once.has_errors()) {
    return false;
  }
  SceneLaws(path, scene, breaches).run();
  return true;
}

}  // namespace scenefile::laws
