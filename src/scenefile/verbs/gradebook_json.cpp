#include "scenefile/gradebook/gradebook.h"
#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/grade_class.h"
#include "scenefile/verbs/scene_json.h"

namespace scenefile {

std::string gradebook_json(const Gradebook& book) {
  Json json;
  begin_document(json, "grade");
  json.add("passed", book.all_passed());
  json.add_objects("students", book.students, [&](const StudentResult& student) {
    json.add({{"name", student.name}, {"passed", student.passed()}});
    json.add_objects("pictures", student.pictures, [&](const PictureResult& picture) {
      json.add({{"name", picture.name}, {"verdict", name_of(picture.verdict)}});
      if (picture.verdict == Verdict::passed || picture.verdict == Verdict::differs) {
        const PictureMeasures& m = picture.measures;
        json.add_object("size", {{"width", m.size.x}, {"height", m.size.y}});
        json.add_object("expected_size", {{"width", m.right_size.x}, {"height", m.right_size.y}});
        if (picture.path_traced) {
          json.add("path_traced", true);
        } else {
          add_measures(json, m);
        }
      }
      json.add("reasons", picture.reasons);
      add_claims(json, "causes", picture.causes);
      add_claims(json, "rivals", picture.rivals);
      add_claims(json, "partial", picture.partial);
      std::vector<std::string> notes = picture.notes;
      if (!picture.identical.empty()) {
        notes.push_back("identical files: " + picture.identical);
      }
      json.add("notes", notes);
    });
    json.add("unmatched", student.unmatched);
  });
  json.add_objects("ignored", book.ignored, [&](const IgnoredFile& file) {
    json.add("path", file.path);
    if (!file.student.empty()) {
      json.add("student", file.student);
    }
    json.add("reason", file.reason);
  });
  json.add("notes", book.notes);
  json.end_object();
  return json.text();
}

}  // namespace scenefile
