#pragma once
// Conversions between values of the library and of Python.

#include <glm/glm.hpp>
#include <pybind11/pybind11.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace scenefile::python {

namespace py = pybind11;

/// The module scenefile._base; it lives as long as the process.
py::module_ base_module();

/// The double with the shortest digits of a float: 0.1 for 0.1f, not 0.10000000149011612. Converts
/// back to the same float.
double shown(float value);

/// A file name from any path-like Python object.
struct FilePath {
  std::string text;
};

/// The index of `word` in `words`. Raises a ValueError that lists them if there is none.
std::size_t index_of_word(const char* what, std::string_view word, const std::string_view* words,
                          std::size_t count);

template <typename Enum, std::size_t count>
Enum from_word(const char* what, std::string_view word,
               const std::array<std::string_view, count>& words) {
  return static_cast<Enum>(index_of_word(what, word, words.data(), count));
}

}  // namespace scenefile::python

namespace pybind11::detail {

template <>
struct type_caster<scenefile::python::FilePath> {
  PYBIND11_TYPE_CASTER(scenefile::python::FilePath, const_name("os.PathLike | str"));

  bool load(handle source, bool /*convert*/) {
    PyObject* bytes = nullptr;
    if (PyUnicode_FSConverter(source.ptr(), &bytes) == 0) {
      PyErr_Clear();
      return false;
    }
    value.text = reinterpret_steal<pybind11::bytes>(bytes);
    return true;
  }

  static handle cast(const scenefile::python::FilePath& path, return_value_policy /*policy*/,
                     handle /*parent*/) {
    return PyUnicode_DecodeFSDefaultAndSize(path.text.data(),
                                            static_cast<Py_ssize_t>(path.text.size()));
  }
};

/// Accepts any three numbers; returns scenefile.Vec3.
template <>
struct type_caster<glm::vec3> {
  PYBIND11_TYPE_CASTER(glm::vec3, const_name("Vec3"));

  bool load(handle source, bool /*convert*/) {
    if (PyUnicode_Check(source.ptr()) || PyBytes_Check(source.ptr())) {
      return false;
    }
    const object numbers = reinterpret_steal<object>(PySequence_Fast(source.ptr(), ""));
    if (!numbers || PySequence_Fast_GET_SIZE(numbers.ptr()) != 3) {
      PyErr_Clear();
      return false;
    }
    for (int i = 0; i < 3; ++i) {
      const double number = PyFloat_AsDouble(PySequence_Fast_GET_ITEM(numbers.ptr(), i));
      if (PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        return false;
      }
      value[i] = static_cast<float>(number);
    }
    return true;
  }

  static handle cast(const glm::vec3& v, return_value_policy /*policy*/, handle /*parent*/) {
    using scenefile::python::shown;
    return scenefile::python::base_module()
        .attr("Vec3")(shown(v.x), shown(v.y), shown(v.z))
        .release();
  }
};

}  // namespace pybind11::detail
