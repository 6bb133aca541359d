#pragma once
// The matrices of a written scene's nodes, as a program with mistakes computes them.

#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

#include <functional>

namespace scenefile {

/// Mistakes in how a program computes the matrices.
struct MatrixMistakes {
  bool nesting_reversed = false;      ///< the matrix of the inner node acts last
  bool listed_reversed = false;       ///< the first listed transform acts first
  bool not_restored = false;          ///< the matrix of a node also applies to its next siblings
  bool written_transposed = false;    ///< rows of the file's matrices are read as columns
  bool transposed = false;            ///< for shapes; not applied by visit_nodes()
  bool inverted = false;              ///< for shapes; not applied by visit_nodes()
  bool untranslated = false;          ///< for shapes; not applied by visit_nodes()
  bool inverse_by_transpose = false;  ///< for shapes; not applied by visit_nodes()
  bool lights_stay = false;           ///< lights ignore transforms; not applied by visit_nodes()
};

/// Calls `found` with each node and its matrix to world space, once per instance. Returns false if
/// there are too many nodes.
bool visit_nodes(const Scene& scene, const MatrixMistakes& mistakes,
                 const std::function<void(const Node&, const glm::dmat4&)>& found);

}  // namespace scenefile
