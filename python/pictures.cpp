// Rendering, and explaining pixels.

#include "pictures.h"

#include "interruptible.h"
#include "render_options.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/trace/layers.h"
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
  write(path.text, encoded(result.image, *format, rounding));
  for (std::size_t i = 1; i < files.size(); ++i) {
    const Image image =
        layer_picture(picture.options.layers[i - 1], result.layers[i - 1], result.image.width,
                      result.image.height, picture.options.max_depth);
    write(files[i].path, encoded(image, *format, Rounding::nearest));
  }
}

std::unique_ptr<Picture> draw(SceneState& state, const RenderOptions& options,
                              const py::object& progress) {
  const std::shared_ptr<const LoadedScene> loaded = usable(state);
  if (const std::string missing = missing_light(options.layers, loaded->ready.scene.lights.size());
      !missing.empty()) {
    throw py::value_error("layers: " + missing);
  }
  auto picture = std::make_unique<Picture>();
  picture->options = options;
  picture->inputs = used_files(*loaded, state.access, state.settings.limits);
  run_interruptible(
      [&](const Progress& go_on) {
        picture->result = render(loaded->ready.scene, loaded->assets, options, {.progress = go_on});
      },
      progress);
  if (const std::optional<Error> error = render_error(picture->result.status)) {
    raise_error(*error);
  }
  return picture;
}

std::unique_ptr<Picture> render_with(SceneState& state, const py::object& progress,
                                     const py::kwargs& given) {
  return draw(state, render_options(given), progress);
}

// For notebooks: small, with few samples.
py::object preview(SceneState& state) {
  if (!look_at(state)->usable()) {
    return py::none();
  }
  RenderOptions options = default_options(Profile::fine);
  options.width = 400;
  options.height = 300;
  options.samples = 4;
  const std::unique_ptr<Picture> picture = draw(state, options, py::none());
  return png_of(quantize(picture->result.image, Rounding::nearest));
}

struct Explanation {
  std::string text;
  std::string json;
};

Explanation explain(SceneState& state, int x, int y, std::optional<std::uint32_t> sample,
                    const py::kwargs& given) {
  const RenderOptions options = render_options(given);
  if (x < 0 || y < 0 || x >= options.width || y >= options.height) {
    throw py::value_error(fmt::format("({}, {}) is not in the picture: (0, 0) to ({}, {})", x, y,
                                      options.width - 1, options.height - 1));
  }
  const std::shared_ptr<const LoadedScene> loaded = usable(state);
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
    return {.texture = quantize(p.result.image, rounding_of(p.options.profile))};
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
      .def_property_readonly(
          "pixels", &pixels_of,
          "height x width x 3 floats, where 1 is full intensity; shares the picture's memory")
      .def_property_readonly("layers", &layers_of, "the requested layers, by name")
      .def_property_readonly(
          "quantized",
          [](const Picture& p) {
            return array_of(quantize(p.result.image, rounding_of(p.options.profile)));
          },
          "height x width x 3 bytes, as stored in a .png")
      .def_property_readonly("rays",
                             [](const Picture& p) {
                               const RenderStats& s = p.result.stats;
                               return s.primary_rays + s.shadow_rays + s.secondary_rays;
                             })
      .def("save", &save,
           "Writes a .png, .exr or .pfm atomically. Never replaces the scene or its files.",
           py::arg("path"))
      .def("_repr_png_",
           [](const Picture& p) {
             return png_of(quantize(p.result.image, rounding_of(p.options.profile)));
           })
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
