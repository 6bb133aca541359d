// Rendering, and explaining pixels.

#include "pictures.h"

#include "interruptible.h"
#include "render_options.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/path/render_path.h"
#include "scenefile/trace/layers.h"
#include "scenefile/trace/visit_options.h"
#include "scenefile/verbs/explain.h"
#include "scenefile/verbs/findings.h"
#include "scenefile/verbs/render_error.h"
#include "state.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace scenefile::python {

namespace {

// An array of height x width (x channels, if there are several) over the memory of `owner`.
py::array_t<float> view_of(std::vector<float>& values, int width, int height, std::size_t channels,
                           const py::object& owner) {
  std::vector<py::ssize_t> shape{height, width};
  if (channels != 1) {
    shape.push_back(static_cast<py::ssize_t>(channels));
  }
  return py::array_t<float>(shape, values.data(), owner);
}

Picture& picture_of(const py::object& self) {
  return self.cast<Picture&>();
}

py::array_t<float> pixels_of(const py::object& self) {
  Image& image = picture_of(self).result.image;
  return view_of(image.rgb, image.width, image.height, 3, self);
}

py::dict layers_of(const py::object& self) {
  Picture& picture = picture_of(self);
  const Image& image = picture.result.image;
  py::dict layers;
  for (std::size_t i = 0; i < picture.result.layers.size(); ++i) {
    ImageLayer& layer = picture.result.layers[i];
    layers[py::str(layer_name(picture.options.layers[i]))] =
        view_of(layer.values, image.width, image.height, layer.channels.size(), self);
  }
  return layers;
}

std::string bytes_of(Result<std::string> file) {
  if (!file) {
    throw py::value_error("cannot encode the picture: " + file.error().text);
  }
  return *std::move(file);
}

std::string encoded(const Image& image, ImageFormat format, Rounding rounding) {
  return bytes_of(encode_image(image, format, rounding));
}

void write(const std::string& path, const std::string& bytes) {
  if (const Result<void> done = write_file(path, bytes); !done) {
    raise_error(done.error());
  }
}

// What formats with 8 bits store.
Image tones_of(const Picture& picture) {
  return picture.options.mode == Mode::path
             ? tone_mapped(picture.result.image, picture.tone, picture.exposure)
             : picture.result.image;
}

Texture quantized(const Picture& picture) {
  return quantize(tones_of(picture), rounding_of(picture.options.profile));
}

// Like `scenefile render`: layers go into the same .exr, or into files next to a .png.
void save(const Picture& picture, const FilePath& path) {
  const std::optional<ImageFormat> format = image_format_of(path.text);
  if (!format) {
    throw py::value_error(fmt::format("cannot save a picture as {}: the name must end in {}",
                                      quoted(path.text, 400), image_extensions));
  }
  const LayerStorage storage = layer_storage(*format);
  const RenderResult& result = picture.result;
  const Rounding rounding = rounding_of(picture.options.profile);
  std::vector<UsedFile> files{{path.text, fmt::format("the picture {}", escaped(path.text))}};
  const std::size_t point = path.text.rfind('.');
  for (std::size_t i = 0; storage == LayerStorage::apart && i < result.layers.size(); ++i) {
    std::string file = fmt::format("{}.{}{}", path.text.substr(0, point),
                                   layer_name(picture.options.layers[i]), path.text.substr(point));
    std::string what = fmt::format("the layer {}", escaped(file));
    files.push_back({std::move(file), std::move(what)});
  }
  refuse_replacing(picture.inputs, files);
  if (storage == LayerStorage::together && !result.layers.empty()) {
    std::vector<ImageLayer> layers{{"", {"R", "G", "B"}, false, result.image.rgb}};
    layers.insert(layers.end(), result.layers.begin(), result.layers.end());
    return write(path.text,
                 bytes_of(encode_layers(result.image.width, result.image.height, layers)));
  }
  write(path.text, encoded(storage == LayerStorage::apart ? tones_of(picture) : result.image,
                           *format, rounding));
  for (std::size_t i = 1; i < files.size(); ++i) {
    const Layer& layer = picture.options.layers[i - 1];
    Image image = layer_picture(layer, result.layers[i - 1], result.image.width,
                                result.image.height, picture.options.max_depth);
    if (is_path_light(layer.kind)) {
      map_tones(image.rgb, picture.tone, picture.exposure,
                brightest(result.image.rgb, picture.exposure));
    }
    write(files[i].path, encoded(image, *format, Rounding::nearest));
  }
}

// With the materials of mesh faces, if the arguments ask for mode path.
std::shared_ptr<const LoadedScene> scene_to_draw(SceneState& state, const py::dict& given) {
  if (asks_for_paths(given)) {
    read_materials(state);
  }
  return usable(state);
}

struct FileOptions {
  Tone tone = Tone::course;
  double exposure = 0;
  double seconds = 0;  // 0: no limit
};

// Takes the options of mode path that only the drawing of pictures has.
FileOptions take_file_options(const py::dict& given, RenderOptions& options, bool samples_given) {
  FileOptions file;
  const auto take = [&](const char* name, const auto& set) {
    if (!given.contains(name)) {
      return;
    }
    if (options.mode != Mode::path) {
      throw py::value_error(
          fmt::format("{} is for path tracing: leave it out, or add mode=\"path\"", name));
    }
    try {
      set(name, py::handle(given[name]));
    } catch (const py::cast_error&) {
      throw py::type_error(
          fmt::format("{}: invalid value {}", name, py::repr(given[name]).cast<std::string>()));
    }
  };
  take("tone", [&](const char* name, const py::handle& value) {
    file.tone = from_word<Tone>(name, value.cast<std::string_view>(), tone_words);
  });
  take("exposure", [&](const char* name, const py::handle& value) {
    file.exposure = real_number(name, value, -64, 64);
  });
  take("time", [&](const char* name, const py::handle& value) {
    file.seconds = real_number(name, value, 0.001, 1e7);
    options.samples = samples_given ? options.samples : option_field("samples").most;
  });
  return file;
}

RenderResult draw_paths(const LoadedScene& loaded, Picture& picture, double seconds,
                        const Progress& go_on, std::uint64_t& dropped) {
  PathResult path = render_path(loaded.ready.scene, loaded.assets, picture.options,
                                {.progress = go_on, .seconds = seconds});
  picture.options.samples = static_cast<int>(path.samples);
  dropped = path.state.dropped;
  return std::move(static_cast<RenderResult&>(path));
}

std::unique_ptr<Picture> render_with(SceneState& state, const py::object& progress,
                                     const py::kwargs& given) {
  const std::shared_ptr<const LoadedScene> loaded = scene_to_draw(state, given);
  const py::dict of_picture = given.attr("copy")();
  for (const char* const name : {"tone", "exposure", "time"}) {
    of_picture.attr("pop")(name, py::none());
  }
  auto picture = std::make_unique<Picture>();
  picture->options = render_options(of_picture, lit_by_faces_only(*loaded));
  const FileOptions file = take_file_options(given, picture->options, given.contains("samples"));
  picture->tone = file.tone;
  picture->exposure = file.exposure;
  if (const std::string missing =
          missing_light(picture->options.layers, loaded->ready.scene.lights.size());
      !missing.empty()) {
    throw py::value_error("layers: " + missing);
  }
  picture->inputs = used_files(*loaded, state.access, state.settings.limits);
  std::uint64_t dropped = 0;
  run_interruptible(
      [&](const Progress& go_on) {
        picture->result = picture->options.mode == Mode::path
                              ? draw_paths(*loaded, *picture, file.seconds, go_on, dropped)
                              : render(loaded->ready.scene, loaded->assets, picture->options,
                                       {.progress = go_on});
      },
      progress);
  if (const std::optional<Error> error = render_error(picture->result.status)) {
    raise_error(*error);
  }
  if (dropped > 0 &&
      PyErr_WarnEx(
          PyExc_RuntimeWarning,
          fmt::format("{} samples were not finite; their light is missing", dropped).c_str(),
          1) != 0) {
    throw py::error_already_set();
  }
  return picture;
}

// For notebooks: small, with few samples.
py::object preview(SceneState& state) {
  const std::shared_ptr<const LoadedScene> loaded = look_at(state);
  if (!loaded->usable()) {
    return py::none();
  }
  const bool paths = lit_by_faces_only(*loaded);
  py::kwargs options;
  options["size"] = py::make_tuple(400, 300);
  options["samples"] = paths ? 16 : 4;
  options["denoise"] = paths;
  return png_of(quantized(*render_with(state, py::none(), options)));
}

struct Explanation {
  std::string text;
  std::string json;
};

Explanation explain(SceneState& state, int x, int y, std::optional<std::uint32_t> sample,
                    const py::kwargs& given) {
  const std::shared_ptr<const LoadedScene> loaded = scene_to_draw(state, given);
  const RenderOptions options = render_options(given, lit_by_faces_only(*loaded));
  if (x < 0 || y < 0 || x >= options.width || y >= options.height) {
    throw py::value_error(fmt::format("({}, {}) is not in the picture: (0, 0) to ({}, {})", x, y,
                                      options.width - 1, options.height - 1));
  }
  Explanation explanation;
  std::optional<Error> error;
  {
    const py::gil_scoped_release release;
    const Result<ExplainReport> report = explain_pixel(*loaded, options, x, y, sample);
    if (report) {
      explanation = {explain_text(*loaded, *report), explain_json(*loaded, options, &*report)};
    } else {
      error = report.error();
    }
  }
  if (error) {
    raise_error(*error);
  }
  return explanation;
}

std::uint8_t byte_of(std::uint8_t value) {
  return value;
}
std::uint8_t byte_of(float value) {
  return quantize(value, Rounding::nearest);
}

// Rows of colors with one, three or four channels.
template <typename T>
Texture texture_of_values(const py::array_t<T, py::array::c_style | py::array::forcecast>& array) {
  const int dimensions = static_cast<int>(array.ndim());
  const py::ssize_t channels = dimensions == 3 ? array.shape(2) : 1;
  if ((dimensions != 2 && dimensions != 3) || (channels != 1 && channels != 3 && channels != 4) ||
      array.shape(0) > 65536 || array.shape(1) > 65536) {
    throw py::value_error("a picture must be an array of height x width x 3");
  }
  Texture texture;
  texture.height = static_cast<int>(array.shape(0));
  texture.width = static_cast<int>(array.shape(1));
  texture.rgb.resize(std::size_t{3} * static_cast<std::size_t>(array.shape(0)) *
                     static_cast<std::size_t>(array.shape(1)));
  const T* from = array.data();
  for (std::size_t i = 0; i < texture.rgb.size(); i += 3, from += channels) {
    for (int c = 0; c < 3; ++c) {
      texture.rgb[i + static_cast<std::size_t>(c)] = byte_of(from[channels == 1 ? 0 : c]);
    }
  }
  return texture;
}

}  // namespace

DecodedPicture picture_of(const py::handle& picture, const std::string& layer) {
  if (py::isinstance<Picture>(picture)) {
    const auto& p = picture.cast<const Picture&>();
    return {.texture = quantized(p)};
  }
  if (py::isinstance<py::array>(picture)) {
    const auto array = py::reinterpret_borrow<py::array>(picture);
    switch (array.dtype().kind()) {
      case 'u':
        if (array.dtype().itemsize() == 1) {
          return {.texture = texture_of_values(
                      py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>(array))};
        }
        break;
      case 'f':
        return {.texture = texture_of_values(
                    py::array_t<float, py::array::c_style | py::array::forcecast>(array))};
      default:
        break;
    }
    throw py::type_error("a picture must contain floats from 0 to 1, or uint8");
  }
  FilePath path;
  try {
    path = picture.cast<FilePath>();
  } catch (const py::cast_error&) {
    throw py::type_error("a picture must be a file name, an array, or a Picture");
  }
  std::optional<Result<DecodedPicture>> loaded;
  {
    const py::gil_scoped_release release;
    loaded = load_picture_file(path.text, layer);
  }
  if (!*loaded) {
    raise_error(loaded->error());
  }
  return **std::move(loaded);
}

py::array_t<std::uint8_t> array_of(const Texture& picture) {
  return py::array_t<std::uint8_t>({picture.height, picture.width, 3}, picture.rgb.data());
}

py::bytes png_of(const Texture& picture) {
  return encoded(to_float(picture), ImageFormat::png8, Rounding::nearest);
}

void bind_pictures(py::module_& m) {
  py::class_<Picture>(m, "Picture", "A rendered picture.")
      .def_property_readonly("width", [](const Picture& p) { return p.result.image.width; })
      .def_property_readonly("height", [](const Picture& p) { return p.result.image.height; })
      .def_property_readonly("profile",
                             [](const Picture& p) { return profile_word(p.options.profile); })
      .def_property_readonly("mode", [](const Picture& p) { return mode_word(p.options.mode); })
      .def_property_readonly(
          "samples", [](const Picture& p) { return p.options.samples; },
          "per pixel: in mode path the number taken, otherwise the maximum")
      .def_property_readonly(
          "pixels", &pixels_of,
          "height x width x 3 floats, where 1 is full intensity; shares the picture's memory")
      .def_property_readonly("layers", &layers_of, "the requested layers, by name")
      .def_property_readonly(
          "quantized", [](const Picture& p) { return array_of(quantized(p)); },
          "height x width x 3 bytes, as stored in a .png")
      .def_property_readonly("rays",
                             [](const Picture& p) {
                               const RenderStats& s = p.result.stats;
                               return s.primary_rays + s.shadow_rays + s.secondary_rays;
                             })
      .def("save", &save,
           "Writes a .png, .exr or .pfm atomically. Never replaces the scene or its files.",
           py::arg("path"))
      .def("_repr_png_", [](const Picture& p) { return png_of(quantized(p)); })
      .def("__repr__", [](const Picture& p) {
        return fmt::format("<Picture {}x{}, {}>", p.result.image.width, p.result.image.height,
                           profile_word(p.options.profile));
      });

  py::class_<Explanation>(m, "Explanation", "How the color of a pixel is computed.")
      .def_property_readonly("text", [](const Explanation& e) { return e.text; })
      .def_property_readonly(
          "data",
          [](const Explanation& e) { return py::module_::import("json").attr("loads")(e.json); })
      .def("__str__", [](const Explanation& e) { return e.text; });

  auto scene = py::reinterpret_borrow<py::class_<SceneState, SharedState>>(m.attr("Scene"));
  scene
      .def("render", &render_with,
           "Draws the current scene. Options are those of \"scenefile render\".", py::kw_only(),
           py::arg("progress") = py::none())
      .def("explain", &explain,
           "Explains how the color of the pixel (x, y) is computed; row 0 is the top row.",
           py::arg("x"), py::arg("y"), py::kw_only(), py::arg("sample") = py::none())
      .def("_repr_png_", &preview);

  m.def(
      "read_picture",
      [](const FilePath& path, const std::string& layer) {
        return array_of(picture_of(py::cast(path), layer).texture);
      },
      "The picture in a file: height x width x 3 bytes.", py::arg("path"), py::kw_only(),
      py::arg("layer") = "");
}

}  // namespace scenefile::python
