#pragma once
// Where items are, and where new ones may stand. Internal to edit.

#include "scenefile/edit/edits.h"

#include <glm/glm.hpp>

#include <optional>

namespace scenefile {

/// The item whose transforms place an item: in JSON, primitives, lights and instances have the
/// place of their group.
ItemId placed_item(const Document& document, ItemId item);

/// The transform from the space of an item to that of the scene, or of the template that contains
/// it; nullopt if it is too large for numbers.
std::optional<glm::dmat4> tree_from_item(const Document& document, ItemId item);

/// The same as handle_of(), also of a part of a template: then in the template's space.
std::optional<Handle> handle_in_tree(const Document& document, ItemId item);

/// The translation of a new object or light in a group, or outside of all, so that it stands near
/// what the author looks at and overlaps nothing.
glm::dvec3 free_place(const Document& document, std::optional<ItemId> group, const NewItem& what,
                      const std::optional<Viewpoint>& view);
/// How far a copy has to move, in the space of its original, to stand beside it, as the author sees
/// it; 0 for what has no place.
glm::dvec3 way_beside(const Document& document, ItemId item, const std::optional<Viewpoint>& view);

}  // namespace scenefile
