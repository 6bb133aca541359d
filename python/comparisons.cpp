// Comparing pictures and scenes, and grading a class.

#include "interruptible.h"
#include "pictures.h"
#include "render_options.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/gradebook/gradebook.h"
#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/compare_scenes.h"
#include "scenefile/verbs/findings.h"
#include "scenefile/verbs/grade_class.h"
#include "state.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <utility>
#include <vector>

namespace scenefile::python {

namespace {

struct Comparison {
  DecodedPicture reference;
  DecodedPicture test;
  PictureComparison found;
};

struct Differences {
  SceneDiff diff;
  std::string text;
};

CompareSettings settings_of(std::optional<double> min_psnr, std::optional<double> max_mean,
                            std::optional<double> max_difference, std::optional<double> max_share,
                            std::optional<double> min_ssim, std::optional<double> max_flip,
                            int pixel_threshold, const py::dict& options) {
  if (asks_for_paths(options)) {
    throw py::value_error("mode: path is for render and explain");
  }
  if (max_share && !(*max_share >= 0 && *max_share < 1)) {
    throw py::value_error("max_share: a share from 0 to below 1 is expected; 0.02 is 2 %");
  }
  std::vector<RenderOptions> profiles;
  if (options.contains("profile")) {
    profiles = {render_options(options)};
  } else {
    for (const Profile profile : {Profile::course, Profile::fine}) {
      options["profile"] = std::string(profile_word(profile));
      profiles.push_back(render_options(options));
    }
  }
  return {.thresholds = {.min_psnr_db = min_psnr,
                         .max_mean = max_mean,
                         .max_difference = max_difference,
                         .max_share = max_share,
                         .min_ssim = min_ssim,
                         .max_flip = max_flip},
          .pixel_threshold = pixel_threshold,
          .ways = possible_ways(profiles, options.contains("features"))};
}

// The scene in that file, or the given scene; drawn without missing meshes.
std::shared_ptr<const LoadedScene> shown_scene(const py::object& scene) {
  if (scene.is_none()) {
    return nullptr;
  }
  if (py::isinstance<SceneState>(scene)) {
    return usable(scene.cast<SceneState&>());
  }
  const auto path = scene.cast<FilePath>();
  auto loaded = std::make_shared<LoadedScene>();
  {
    const py::gil_scoped_release release;
    LoadSettings settings;
    settings.allow_missing = true;
    *loaded = load_scene_file(path.text, settings);
  }
  if (!loaded->usable()) {
    raise_unusable(*loaded);
  }
  return loaded;
}

Comparison compare(const py::object& reference, const py::object& picture, const py::object& scene,
                   std::optional<double> min_psnr, std::optional<double> max_mean,
                   std::optional<double> max_difference, std::optional<double> max_share,
                   std::optional<double> min_ssim, std::optional<double> max_flip,
                   int pixel_threshold, const std::string& layer, const py::object& progress,
                   const py::kwargs& given) {
  Comparison comparison{picture_of(reference, layer), picture_of(picture, layer), {}};
  round_alike(comparison.reference, comparison.test);
  const CompareSettings settings = settings_of(min_psnr, max_mean, max_difference, max_share,
                                               min_ssim, max_flip, pixel_threshold, given);
  const std::shared_ptr<const LoadedScene> shown = shown_scene(scene);
  run_interruptible(
      [&](const std::function<bool(double)>& go_on) {
        comparison.found =
            compare_pictures(comparison.reference, comparison.test, shown.get(), settings, go_on);
      },
      progress);
  return comparison;
}

Differences diff(const py::object& a, const py::object& b) {
  const auto of = [](const py::object& scene) {
    if (scene.is_none()) {
      throw py::type_error("a scene must be a file name or a Scene");
    }
    return shown_scene(scene);
  };
  const std::shared_ptr<const LoadedScene> first = of(a);
  const std::shared_ptr<const LoadedScene> second = of(b);
  const py::gil_scoped_release release;
  Differences result{compare_scenes(*first, *second), {}};
  result.text = compare_scenes_text(*first, *second, result.diff);
  return result;
}

Gradebook grade(const FilePath& handed_in, const FilePath& references,
                const std::optional<FilePath>& scenes, std::optional<double> min_psnr,
                std::optional<double> max_mean, std::optional<double> max_difference,
                std::optional<double> max_share, std::optional<double> min_ssim,
                std::optional<double> max_flip, int pixel_threshold, const std::string& layer,
                const py::object& progress, const py::kwargs& given) {
  const GradeRequest request{.handed_in = handed_in.text,
                             .references = references.text,
                             .scenes = scenes ? scenes->text : std::string(),
                             .compare = settings_of(min_psnr, max_mean, max_difference, max_share,
                                                    min_ssim, max_flip, pixel_threshold, given),
                             .layer = layer,
                             .thumbnails = true};
  const auto load_scene = [](const std::string& path) {
    LoadSettings settings;
    settings.allow_missing = true;
    return load_scene_file(path, settings);
  };
  std::optional<Result<Gradebook>> graded;
  run_interruptible(
      [&](const std::function<bool(double)>& go_on) {
        graded = grade_class(request, load_scene, go_on);
      },
      progress);
  if (!*graded) {
    raise_error(graded->error());
  }
  return **std::move(graded);
}

template <typename T>
py::tuple tuple_of(const std::vector<T>& list) {
  return py::tuple(py::cast(list));
}

// The measures of a picture, if it exists.
template <typename Class, typename Get>
void bind_measures(Class& c, Get get) {
  using Owner = typename Class::type;
  c.def_property_readonly("psnr_db", [get](const Owner& o) { return get(o).difference.psnr_db; })
      .def_property_readonly("mean", [get](const Owner& o) { return get(o).difference.mean; })
      .def_property_readonly("max", [get](const Owner& o) { return get(o).difference.max; })
      .def_property_readonly("share_over",
                             [get](const Owner& o) { return get(o).difference.share_over; })
      .def_property_readonly("linear", [get](const Owner& o) { return get(o).linear; })
      .def_property_readonly("ssim", [get](const Owner& o) { return get(o).ssim; })
      .def_property_readonly("flip", [get](const Owner& o) { return get(o).flip_mean; })
      .def_property_readonly("same_size", [get](const Owner& o) { return get(o).same_size(); });
}

void bind_gradebook(py::module_& m) {
  py::class_<PictureResult> picture(m, "GradedPicture");
  bind_measures(picture,
                [](const PictureResult& r) -> const PictureMeasures& { return r.measures; });
  picture.def_readonly("name", &PictureResult::name)
      .def_property_readonly("verdict", [](const PictureResult& r) { return name_of(r.verdict); })
      .def_property_readonly("passed",
                             [](const PictureResult& r) { return r.verdict == Verdict::passed; })
      .def_property_readonly("reasons", [](const PictureResult& r) { return tuple_of(r.reasons); })
      .def_property_readonly("causes", [](const PictureResult& r) { return tuple_of(r.causes); })
      .def_property_readonly("rivals", [](const PictureResult& r) { return tuple_of(r.rivals); })
      .def_property_readonly("partial", [](const PictureResult& r) { return tuple_of(r.partial); })
      .def_property_readonly("notes", [](const PictureResult& r) { return tuple_of(r.notes); })
      .def("_repr_png_",
           [](const PictureResult& r) -> py::object {
             return r.png.empty() ? py::object(py::none()) : py::object(py::bytes(r.png));
           })
      .def("__repr__", [](const PictureResult& r) {
        return fmt::format("<GradedPicture {}: {}>", r.name, name_of(r.verdict));
      });
  py::class_<StudentResult>(m, "Student")
      .def_readonly("name", &StudentResult::name)
      .def_property_readonly("passed", &StudentResult::passed)
      .def_property_readonly("pictures",
                             [](const StudentResult& s) { return tuple_of(s.pictures); })
      .def("__repr__", [](const StudentResult& s) {
        return fmt::format("<Student {}: {} of {} passed>", s.name, s.passed(), s.pictures.size());
      });
  py::class_<IgnoredFile>(m, "IgnoredFile", "A file of the class that was not graded.")
      .def_readonly("path", &IgnoredFile::path)
      .def_property_readonly("student",
                             [](const IgnoredFile& f) {
                               return f.student.empty() ? std::optional<std::string>()
                                                        : std::optional(f.student);
                             })
      .def_readonly("reason", &IgnoredFile::reason)
      .def("__repr__", [](const IgnoredFile& f) {
        return fmt::format("<IgnoredFile {}: {}>", f.path, f.reason);
      });
  py::class_<Gradebook>(m, "Gradebook", "The graded pictures of a class.")
      .def_property_readonly("students", [](const Gradebook& b) { return tuple_of(b.students); })
      .def_property_readonly("ignored", [](const Gradebook& b) { return tuple_of(b.ignored); })
      .def_property_readonly("notes", [](const Gradebook& b) { return tuple_of(b.notes); })
      .def_property_readonly("passed", &Gradebook::all_passed)
      .def(
          "html",
          [](const Gradebook& b, std::string_view title, std::string_view date) {
            return gradebook_html(b, title.empty() ? std::string_view(b.name) : title, date);
          },
          "The report as one self-contained HTML page; its title is the name of the class's folder "
          "if none is given.",
          py::arg("title") = "", py::arg("date") = "")
      .def("junit", &gradebook_junit)
      .def_property_readonly("data",
                             [](const Gradebook& b) {
                               return py::module_::import("json").attr("loads")(gradebook_json(b));
                             })
      .def("_repr_html_", [](const Gradebook& b) { return gradebook_html(b, b.name); })
      .def("__str__", &gradebook_text)
      .def("__repr__", [](const Gradebook& b) {
        return fmt::format("<Gradebook of {} students>", b.students.size());
      });
}

std::string text_of(const Comparison& c) {
  const PictureMeasures& m = c.found.measures;
  std::string text;
  if (m.comparable) {
    text = fmt::format("PSNR {:.2f} dB, mean difference {:.3f}/255, SSIM {:.4f}, FLIP {:.4f}\n",
                       m.difference.psnr_db, m.difference.mean, m.ssim, m.flip_mean);
  }
  for (const std::string& clause : c.found.broken) {
    text += fmt::format("different: {}\n", clause);
  }
  return text + (c.found.broken.empty() ? "the same\n" : causes_text(c.found));
}

py::bytes sheet_of(const Comparison& c) {
  const Texture& reference = c.found.reference_of(c.reference.texture);
  const Texture& test = c.found.test_of(c.test.texture);
  const Texture heat = heat_map(reference, test);
  const std::array<const Texture*, 3> pictures{&reference, &test, &heat};
  return png_of(side_by_side(pictures));
}

}  // namespace

void bind_comparisons(py::module_& m) {
  py::class_<Claim>(m, "Cause", "A known mistake that explains a difference.")
      .def_property_readonly("name", [](const Claim& c) { return name_of(c.cause); })
      .def_readonly("what", &Claim::what)
      .def_readonly("evidence", &Claim::evidence)
      .def_readonly("explained", &Claim::explained)
      .def_readonly("said", &Claim::said, "Of a rival: the cause's text already names it.")
      .def("__str__", [](const Claim& c) { return c.what; })
      .def("__repr__",
           [](const Claim& c) { return fmt::format("<Cause {}: {}>", name_of(c.cause), c.what); });

  py::class_<Comparison> comparison(m, "Comparison",
                                    "How much a picture differs from its reference.");
  bind_measures(comparison,
                [](const Comparison& c) -> const PictureMeasures& { return c.found.measures; });
  comparison
      .def_property_readonly("same", [](const Comparison& c) { return c.found.broken.empty(); })
      .def_property_readonly("broken", [](const Comparison& c) { return tuple_of(c.found.broken); })
      .def_property_readonly("causes",
                             [](const Comparison& c) { return tuple_of(c.found.causes.claims); })
      .def_property_readonly("rivals",
                             [](const Comparison& c) { return tuple_of(c.found.causes.rivals); })
      .def_property_readonly("partial",
                             [](const Comparison& c) { return tuple_of(c.found.causes.partial); })
      .def_property_readonly("notes",
                             [](const Comparison& c) { return tuple_of(c.found.causes.notes); })
      .def_property_readonly("place",
                             [](const Comparison& c) -> py::object {
                               if (!c.found.place) {
                                 return py::none();
                               }
                               const auto& [corner, size] = *c.found.place;
                               return py::make_tuple(corner.x, corner.y, size.x, size.y);
                             })
      .def_property_readonly("drawn_with", [](const Comparison& c) { return c.found.drawn_with; })
      .def_property_readonly("heat_map",
                             [](const Comparison& c) {
                               return array_of(heat_map(c.found.reference_of(c.reference.texture),
                                                        c.found.test_of(c.test.texture)));
                             })
      .def_property_readonly("flip_map",
                             [](const Comparison& c) {
                               const std::vector<float>& errors = c.found.flip_errors;
                               const bool any = !errors.empty();
                               const Texture& compared = c.found.test_of(c.test.texture);
                               return py::array_t<float>(
                                   {any ? compared.height : 0, any ? compared.width : 0},
                                   errors.data());
                             })
      .def("_repr_png_", &sheet_of)
      .def("__str__", &text_of)
      .def("__repr__", [](const Comparison& c) {
        return fmt::format("<Comparison: {:.2f} dB{}>", c.found.measures.difference.psnr_db,
                           c.found.broken.empty() ? ", the same" : "");
      });

  py::class_<SceneDifference>(m, "SceneDifference")
      .def_readonly("where", &SceneDifference::where)
      .def_readonly("a", &SceneDifference::a)
      .def_readonly("b", &SceneDifference::b)
      .def("__str__", &difference_text)
      .def("__repr__", [](const SceneDifference& d) {
        return fmt::format("<SceneDifference {}>", difference_text(d));
      });
  py::class_<Differences>(m, "SceneDifferences", "The differences between two scenes.")
      .def_property_readonly("equal", [](const Differences& d) { return d.diff.equal; })
      .def_property_readonly("same_meaning",
                             [](const Differences& d) { return d.diff.same_meaning; })
      .def_property_readonly("differences",
                             [](const Differences& d) { return tuple_of(d.diff.differences); })
      .def_property_readonly("left_out", [](const Differences& d) { return d.diff.left_out; })
      .def("__len__", [](const Differences& d) { return d.diff.differences.size(); })
      .def("__iter__", [](const Differences& d) { return py::iter(tuple_of(d.diff.differences)); })
      .def("__str__", [](const Differences& d) { return d.text; });

  bind_gradebook(m);

  m.def("diff", &diff, "The differences in meaning between two scenes.", py::arg("a"),
        py::arg("b"));
  m.def("compare", &compare,
        "How much a picture differs from its reference, and which mistake explains it.",
        py::arg("reference"), py::arg("picture"), py::arg("scene") = py::none(), py::kw_only(),
        py::arg("min_psnr") = py::none(), py::arg("max_mean") = py::none(),
        py::arg("max_difference") = py::none(), py::arg("max_share") = py::none(),
        py::arg("min_ssim") = py::none(), py::arg("max_flip") = py::none(),
        py::arg("pixel_threshold") = 8, py::arg("layer") = "", py::arg("progress") = py::none());
  m.def("grade", &grade, "Compares the pictures of a class with the references.",
        py::arg("handed_in"), py::arg("references"), py::arg("scenes") = py::none(), py::kw_only(),
        py::arg("min_psnr") = py::none(), py::arg("max_mean") = py::none(),
        py::arg("max_difference") = py::none(), py::arg("max_share") = py::none(),
        py::arg("min_ssim") = py::none(), py::arg("max_flip") = py::none(),
        py::arg("pixel_threshold") = 8, py::arg("layer") = "", py::arg("progress") = py::none());
}

}  // namespace scenefile::python
