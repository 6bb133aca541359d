#include "scenefile/mistakes/node_matrices.h"

#include "scenefile/scene/transforms.h"

#include <string>
#include <variant>

namespace scenefile {

namespace {

struct NodeVisit {
  const Scene& scene;
  const MatrixMistakes& mistakes;
  const std::function<void(const Node&, const glm::dmat4&)>& found;
  std::size_t left = 20000;  // maximum number of nodes to visit

  static glm::dmat4 matrix_of(const DAffine& a) {
    return {glm::dvec4(a.linear[0], 0), glm::dvec4(a.linear[1], 0), glm::dvec4(a.linear[2], 0),
            glm::dvec4(a.offset, 1)};
  }

  glm::dmat4 own(const Node& node) const {
    glm::dmat4 product(1);
    for (const Transform& t : node.transforms) {
      const auto* const written = std::get_if<Matrix>(&t.map);
      const glm::dmat4 m = written != nullptr && mistakes.written_transposed
                               ? glm::transpose(glm::dmat4(written->m()))
                               : matrix_of(composed(DAffine(), t));
      product = mistakes.listed_reversed ? m * product : product * m;
    }
    return product;
  }

  // NOLINTNEXTLINE(misc-no-recursion): limited depth
  bool visit(NodeId id, glm::dmat4& parent, int depth) {
    if (left-- == 0 || depth > 200) {
      left = 0;
      return false;
    }
    const Node& node = scene.nodes[id];
    glm::dmat4 matrix = mistakes.nesting_reversed ? own(node) * parent : parent * own(node);
    found(node, matrix);
    for (const NodeId child : node.children) {
      if (!visit(child, matrix, depth + 1)) {
        return false;
      }
    }
    const std::string wanted(node.instance_of);
    for (const NodeId id_of_template : scene.templates) {
      if (!wanted.empty() && std::string(scene.nodes[id_of_template].name) == wanted) {
        return visit(id_of_template, matrix, depth + 1);
      }
    }
    if (mistakes.not_restored) {
      parent = matrix;
    }
    return true;
  }
};

}  // namespace

bool visit_nodes(const Scene& scene, const MatrixMistakes& mistakes,
                 const std::function<void(const Node&, const glm::dmat4&)>& found) {
  glm::dmat4 start(1);
  NodeVisit visit{scene, mistakes, found};
  return visit.visit(scene.root, start, 0);
}

}  // namespace scenefile
