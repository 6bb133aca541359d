#pragma once
// Edits of a scene file, as an author would make them by hand: everything that an edit does not
// concern stays, byte for byte. What is added is laid out like what is around it. Each returns the
// changes of the text, or an error that says why it cannot be made and what to do instead.

#include "scenefile/base/result.h"
#include "scenefile/edit/document.h"
#include "scenefile/edit/text_edit.h"

#include <glm/glm.hpp>

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

// Values. `field` is one of document.fields(item).

/// Sets one part of a field to what was typed, if parse_value() accepts it. A field that the file
/// does not have is added, with its other parts as FieldView::parts says, and with the fields
/// that it needs; `focus` replaces `look` and `look` `focus`. A light that changes its type gets
/// the fields that the type needs and loses those without effect; a primitive that becomes a mesh
/// gets a file; a template that is renamed keeps its instances. Refuses names that would make
/// templates or groups something else.
Result<Edit> set_value(const Document& document, ItemId item, const FieldView& field,
                       std::size_t part, std::string_view typed);
/// The same for several parts at once; nullopt leaves a part as it is. At least one is given. One
/// more than the field has is the file of a primitive that becomes a mesh.
Result<Edit> set_values(const Document& document, ItemId item, const FieldView& field,
                        std::span<const std::optional<std::string>> typed);
/// Sets the type of a light. It loses the fields that have no effect on the new type, and gets
/// those that this one needs, with the values of `known` where that has them.
Result<Edit> set_light_type(const Document& document, ItemId item, const FieldView& field,
                            std::string_view type, std::span<const FieldView> known = {});
/// Removes a field from the file. If the item needs it, reading then assumes its default.
Result<Edit> remove_value(const Document& document, ItemId item, const FieldView& field);
/// Adds a transform ("translate", "rotate", "scale", "matrix") with these values, or without effect
/// if there are none. In XML `before` others of the item; nullopt: after all, next to the object.
Result<Edit> add_transform(const Document& document, ItemId item, std::string_view word,
                           std::span<const double> values = {},
                           std::optional<std::size_t> before = std::nullopt);
/// XML: exchanges a transform with the one before (-1) or after it (1).
Result<Edit> move_transform(const Document& document, ItemId item, const FieldView& field,
                            int step);
/// Sets position, look, up and height angle. Numbers whose value does not change keep their
/// spelling. If the file's camera uses `focus`, it is set to position + look. Aperture and focal
/// length stay. `camera` must be acceptable to check(); the length of `look` may change. Refused
/// unless reading the result gives the same scene with that camera.
Result<Edit> set_camera(const Document& document, const Camera& camera);

// Items. In JSON, the group around a single object or light is only its place, and is copied,
// removed, reordered, moved and wrapped with it.

/// Something that add_item() can add.
struct NewItem {
  ItemKind kind = ItemKind::primitive;
  std::string name{};  ///< type of a light, shape of a primitive, template of an instance
  std::string file{};  ///< of a mesh, if it is known

  friend bool operator==(const NewItem&, const NewItem&) = default;
};

/// What the author sees, in world space.
struct Viewpoint {
  glm::dvec3 eye{0};
  glm::dvec3 at{0};
  /// By file name as written: the corners of the bounding boxes of meshes, if they are known;
  /// others count as cubes.
  std::map<std::string, std::array<glm::dvec3, 2>> meshes{};
};

/// What can be added beside an item, or without one: lights, primitives, a group, instances of
/// the templates, and the camera or global data if the file lacks them.
std::vector<NewItem> kinds_to_add(const Document& document, std::optional<ItemId> near);
/// Adds an item with sensible values to `near`, if that is a group, otherwise to the group of
/// `near`; without one, to the root. It stands near what the author looks at, otherwise near what
/// the scene's camera looks at, and overlaps nothing.
Result<Edit> add_item(const Document& document, std::optional<ItemId> near, const NewItem& what,
                      const std::optional<Viewpoint>& view = {});
/// Removes an item with all that it contains; comments around it stay.
Result<Edit> remove_item(const Document& document, ItemId item);
/// Inserts a copy after the item, which stands beside it as the author sees it, otherwise as the
/// scene's camera does. A light in XML gets a free id, a template a free name.
Result<Edit> duplicate_item(const Document& document, ItemId item,
                            const std::optional<Viewpoint>& view = {});
/// The item to exchange places with: before (-1) or after (1) it in its list.
std::optional<ItemId> neighbor_of(const Document& document, ItemId item, int step);
/// Exchanges an item, and the comments that belong to it, with its neighbor.
Result<Edit> reorder_item(const Document& document, ItemId item, int step);
/// The groups, templates and root that an item can be moved into; none in JSON if it shares its
/// place with others.
std::vector<ItemId> targets_for(const Document& document, ItemId item);
/// The nearest group in the same group as an item that the item can be moved into: the last one
/// before it, or else the first one after it.
std::optional<ItemId> group_to_enter(const Document& document, ItemId item);
/// The group around that of an item.
std::optional<ItemId> group_outside(const Document& document, ItemId item);
/// Moves an item to the end of another group. It stays where it is in the world, unless it enters
/// or leaves a template, or a group is scaled to nothing.
Result<Edit> move_into(const Document& document, ItemId item, ItemId group);
/// Puts an item into a new group at its place, without moving it in the world.
Result<Edit> wrap_in_group(const Document& document, ItemId item);

// Places in the world.

/// How an item can be moved. In JSON, a primitive or light is moved by the transforms of its group,
/// and in XML, a light by its position.
struct Handle {
  ItemId item = no_item;        ///< whose transforms or position change
  glm::dmat4 world_from_space;  ///< the space in which it is moved: that of its group
  glm::dmat4 world_from_item;
  bool is_light = false;  ///< has a position, but no axes to turn and scale
};

/// The handle of an item; nullopt if nothing can move it: it is part of a template, which may be
/// drawn several times, or has no place.
std::optional<Handle> handle_of(const Document& document, ItemId item);
/// Moves by `delta` in the space of the handle. Coordinates that change become multiples of `step`,
/// if that is not 0.
Result<Edit> move_item(const Document& document, const Handle& handle, const glm::dvec3& delta,
                       double step = 0);
/// Turns about an axis (0, 1, 2) of the handle's space, through the position given by the leading
/// translations.
Result<Edit> turn_item(const Document& document, const Handle& handle, int axis, double degrees);
/// Scales along an axis of the item's own space.
Result<Edit> scale_item(const Document& document, const Handle& handle, int axis, double factor);
/// Changes the item's transforms so that its world matrix is as given, to 1e-4 of its size: the
/// numbers of a translation, a rotation and a scale if the item has at most these, in this order,
/// otherwise one matrix. The last row of `world_from_item` must be 0 0 0 1.
Result<Edit> place_item(const Document& document, const Handle& handle,
                        const glm::dmat4& world_from_item);

}  // namespace scenefile
