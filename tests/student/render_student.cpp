// Draws a scene with the student's tracer: scenefile_student SCENE OUT.png WIDTHxHEIGHT FEATURES
// [MISTAKE]... With --pair before the scene, OUT.png shows the correct picture to the left of the
// student's. FEATURES: "all", "intersect", or a comma-separated list of names from the course's
// configuration. Without arguments: lists the mistakes, their families, and the causes that are
// correct answers.

#include "scenefile/asset/image_file.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/io/file.h"
#include "student/student_tracer.h"
#include "support/load_scene.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

int main(int count, char** words) {
  using namespace scenefile;
  const bool pair = count > 1 && std::string_view(words[1]) == "--pair";
  count -= pair ? 1 : 0;
  words += pair ? 1 : 0;
  if (count < 5) {
    for (const student::KnownMistake& m : student::known_mistakes()) {
      std::printf("%s\t%s\t%s\n", std::string(m.name).c_str(), std::string(m.family).c_str(),
                  std::string(m.causes).c_str());
    }
    return count == 1 ? 0 : 2;
  }
  const testing_support::LoadedScene scene = testing_support::load_scene(words[1], true);
  if (!scene.error.empty()) {
    std::fprintf(stderr, "%s\n", scene.error.c_str());
    return 1;
  }
  student::Job job;
  if (std::sscanf(words[3], "%dx%d", &job.width, &job.height) != 2) {
    return 2;
  }
  const std::string features = "," + std::string(words[4]) + ",";
  if (features != ",all,") {
    const auto on = [&](const char* word) {
      return features.find("," + std::string(word) + ",") != std::string::npos;
    };
    job.shadows = on("shadows");
    job.reflect = on("reflect");
    job.refract = on("refract");
    job.texture = on("texture");
    job.directional_alone = on("intersect");
  }
  std::vector<std::string> names;
  for (const FileReference& file : scene.ready.scene.texture_files) {
    names.push_back(file.name);
  }
  const auto drawn = [&] { return student::draw(scene.written, scene.assets, names, job); };
  const Texture right = pair ? drawn() : Texture();
  for (int i = 5; i < count; ++i) {
    job.mistakes.insert(words[i]);
  }
  const Texture wrong = drawn();
  const std::array<const Texture*, 2> both{&right, &wrong};
  const Texture picture = pair ? side_by_side(both) : wrong;
  const Result<std::string> bytes =
      encode_image(to_float(picture), ImageFormat::png8, Rounding::nearest);
  const Result<void> written = bytes ? write_file(words[2], *bytes) : bytes.error();
  if (!written) {
    std::fprintf(stderr, "%s\n", written.error().text.c_str());
    return 3;
  }
  return 0;
}
