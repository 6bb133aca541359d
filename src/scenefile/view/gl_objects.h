#pragma once
// RAII wrappers for OpenGL objects. Internal to view.

#include "scenefile/view/gl_functions.h"

#include <utility>

namespace scenefile::gl {

/// Owns one object made by `generate`; move-only.
template <auto generate, auto remove>
class Object {
 public:
  Object() = default;
  explicit Object(const Functions& functions) : functions_(&functions) {
    (functions.*generate)(1, &name_);
  }
  Object(Object&& other) noexcept
      : functions_(other.functions_), name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(functions_, other.functions_);
    std::swap(name_, other.name_);
    return *this;
  }
  ~Object() {
    if (name_ != 0) {
      (functions_->*remove)(1, &name_);
    }
  }

  Name name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  const Functions* functions_ = nullptr;
  Name name_ = 0;
};

using Buffer = Object<&Functions::GenBuffers, &Functions::DeleteBuffers>;
using Texture = Object<&Functions::GenTextures, &Functions::DeleteTextures>;
using VertexArray = Object<&Functions::GenVertexArrays, &Functions::DeleteVertexArrays>;
using Framebuffer = Object<&Functions::GenFramebuffers, &Functions::DeleteFramebuffers>;
using Renderbuffer = Object<&Functions::GenRenderbuffers, &Functions::DeleteRenderbuffers>;

}  // namespace scenefile::gl
