#pragma once
// Findings of the readers. Codes that only apply to JSON: json_codes.h.

#include "scenefile/base/diagnostics.h"

#include <span>

namespace scenefile {

/// All codes of the room, including those of JSON.
std::span<const Code* const> format_codes();

// The file as a whole.

inline constexpr Code format_empty{
    "format.empty", Severity::error, "the file has no content",
    "A scene file holds one XML element <scenefile> or one JSON object."};
inline constexpr Code format_unknown{
    "format.unknown", Severity::error, "the file is neither XML nor JSON",
    "The first character that is not white space decides: < is XML, { or [ is JSON. The name of "
    "the file does not matter. Web pages, archives, meshes and pictures are recognized and named."};
inline constexpr Code format_encoding{
    "format.encoding", Severity::error, "the text encoding of the file cannot be read",
    "Save the file as UTF-8. UTF-16 is read if it has a byte order mark, ISO-8859-1 and "
    "windows-1252 if the XML declaration names them."};
inline constexpr Code format_encoding_assumed{
    "format.encoding-assumed", Severity::warning, "the declared encoding is not known",
    "The file contains only ASCII characters, which nearly all encodings share, so it was read as "
    "ASCII. Declare UTF-8, or leave the declaration out."};

// XML syntax.

inline constexpr Code xml_syntax{
    "xml.syntax", Severity::error, "the file is not well-formed XML",
    "Tags must be closed in the order they were opened, values must be in quotes, & and < are "
    "written &amp; and &lt;. Nothing after this place could be read."};
inline constexpr Code xml_comment{
    "xml.comment",
    Severity::error,
    "a comment that XML does not allow",
    "A comment starts with <!-- and ends with the first -->; between them, XML does not allow --, "
    "nor a - right before the end. Write a single dash, or =. The parsers of the course's programs "
    "accept such comments, and so does --compat course, with a warning.",
    CodeKind::plain,
    Severity::warning};
inline constexpr Code xml_conflict_marker{"xml.conflict-marker", Severity::error,
                                          "the file contains an unresolved git conflict",
                                          "Choose one of the two versions and delete the lines "
                                          "that start with <<<<<<<, ======= and >>>>>>>."};
inline constexpr Code xml_external_dtd{
    "xml.external-dtd", Severity::warning, "the DOCTYPE names another file",
    "Nothing outside the scene file is ever opened. Delete the DOCTYPE: scene files need none."};
inline constexpr Code xml_entity{
    "xml.entity", Severity::error, "the file declares or uses an entity",
    "Entities and attribute defaults of a DOCTYPE can hide or multiply the content of a file, so "
    "they are rejected. Write the content itself."};
inline constexpr Code xml_nesting_limit{"xml.nesting-limit", Severity::error,
                                        "elements are nested too deeply",
                                        "No known scene has more than 50 levels. Declare parts as "
                                        "templates (masters) and use them by name.",
                                        CodeKind::limit};
inline constexpr Code xml_attribute_limit{
    "xml.attribute-limit", Severity::error, "an element has too many attributes",
    "No element of the format has more than five.", CodeKind::limit};
inline constexpr Code xml_length_limit{"xml.length-limit", Severity::error,
                                       "a name, a value or a comment is too long",
                                       "The limits leave ample room for every known scene; text of "
                                       "this length is damage or an attack.",
                                       CodeKind::limit};
inline constexpr Code xml_light_limit{
    "xml.light-limit", Severity::error, "the file has too many lights",
    "The format allows 8 lights. More are read, up to this limit.", CodeKind::limit};

// Names of elements.

inline constexpr Code xml_root_element{
    "xml.root-element", Severity::error, "the file is XML but not a scene",
    "A scene is one element <scenefile> that contains everything else."};
inline constexpr Code xml_name_case{
    "xml.name-case", Severity::warning, "a name has the wrong case",
    "Names of the format are lower case, and most programs insist on it.", CodeKind::dialect};
inline constexpr Code xml_unknown_element{
    "xml.unknown-element", Severity::warning, "an element is not part of the format",
    "It was ignored, with everything in it. Extensions of other programs are not supported."};
inline constexpr Code xml_misspelled_element{
    "xml.misspelled-element", Severity::error, "an element is probably misspelled",
    "Its name is one or two letters away from a name of the format. Ignoring it would give a "
    "picture that its author did not intend."};
inline constexpr Code xml_misspelled_transblock{
    "xml.misspelled-transblock", Severity::warning, "a transblock is misspelled",
    "A tree may contain only transblocks, so it was read as one. Other programs may reject or "
    "ignore it.",
    CodeKind::dialect};
inline constexpr Code xml_misplaced_element{
    "xml.misplaced-element", Severity::warning, "an element is in a place where it has no meaning",
    "The format has this element, but not here. It was ignored, with everything in it."};
inline constexpr Code xml_ignored_element{
    "xml.ignored-element",
    Severity::warning,
    "an element that some programs read has no effect",
    "Some programs read it, but the format does not define it, and nothing here depends on it. A "
    "note where nothing could depend on it.",
    CodeKind::plain,
    Severity::note};
inline constexpr Code xml_alias_element{"xml.alias-element", Severity::warning,
                                        "an element has its alternative name",
                                        "The format uses two names for the same thing; the "
                                        "suggested one is the one that all programs read.",
                                        CodeKind::dialect};
inline constexpr Code xml_duplicate_element{"xml.duplicate-element", Severity::warning,
                                            "something is given twice", "The later one counts."};
inline constexpr Code xml_second_camera{"xml.second-camera", Severity::warning,
                                        "the scene has more than one camera",
                                        "The format allows one. The last one counts."};
inline constexpr Code xml_text{"xml.text", Severity::warning, "there is text between the elements",
                               "Values of the format are attributes, and comments are written <!-- "
                               "like this -->. Only the first such text of a file is reported."};

// Attributes.

inline constexpr Code xml_unknown_attribute{"xml.unknown-attribute", Severity::warning,
                                            "an attribute is not part of the format",
                                            "It was ignored."};
inline constexpr Code xml_misspelled_attribute{
    "xml.misspelled-attribute", Severity::error, "an attribute is probably misspelled",
    "An attribute that the element needs is missing, and this one has nearly the same name."};
inline constexpr Code xml_missing_attribute{"xml.missing-attribute", Severity::error,
                                            "an attribute is missing",
                                            "The element has no meaning without it."};
inline constexpr Code xml_alias_attribute{
    "xml.alias-attribute", Severity::warning, "an attribute has another name",
    "Some programs go by the order of attributes, not by their names, so files with other names "
    "exist. Programs that go by names reject them.",
    CodeKind::dialect};
inline constexpr Code xml_positional_attributes{
    "xml.positional-attributes", Severity::warning, "attributes were read by their order",
    "None of the names that the format gives these attributes is present. Some programs go by the "
    "order alone; those that go by names reject the file.",
    CodeKind::dialect};
inline constexpr Code xml_attribute_order{
    "xml.attribute-order", Severity::warning, "attributes are in an unusual order",
    "They were read by their names. Programs that go by the order mix them up and draw another "
    "picture. `scenefile convert old.xml new.xml` writes the usual order.",
    CodeKind::dialect};
inline constexpr Code xml_color_alpha{
    "xml.color-alpha", Severity::note, "a color has a fourth value",
    "Colors have three values; `transparent` says how much light passes through."};
inline constexpr Code xml_number{
    "xml.number",
    Severity::error,
    "a value is not a number",
    "Numbers are decimal with a point, such as -0.5, 3 or 1e-3. With --compat course the longest "
    "numeric prefix is used, with a warning, as in older programs.",
    CodeKind::plain,
    Severity::warning};
inline constexpr Code xml_number_range{
    "xml.number-range", Severity::error, "a number is too large",
    "It does not fit in a single-precision number; the largest is about 3.4e38."};
inline constexpr Code xml_number_underflow{
    "xml.number-underflow", Severity::warning, "a number is too small to be represented",
    "It is closer to 0 than the smallest single-precision number, about 1.4e-45, and counts as 0."};
inline constexpr Code xml_empty_number{"xml.empty-number", Severity::warning, "a number is empty",
                                       "It counts as 0."};

// Camera and lights.

inline constexpr Code xml_camera_default{"xml.camera-default", Severity::warning,
                                         "the camera lacks a value",
                                         "A camera has pos, look or focus, up and heightangle. The "
                                         "default given in the message is used."};
inline constexpr Code xml_look_and_focus{
    "xml.look-and-focus", Severity::error, "the camera has both look and focus",
    "`look` is a direction, `focus` the point to look at. Delete one of them."};
inline constexpr Code xml_focus_at_position{
    "xml.focus-at-position", Severity::error, "the camera looks at itself",
    "`focus` is the point to look at; it must differ from `pos`."};
inline constexpr Code xml_light_type{"xml.light-type", Severity::error,
                                     "a light has an unknown type",
                                     "The types are point, directional, spot and area."};
inline constexpr Code xml_light_id{"xml.light-id", Severity::warning,
                                   "a light without an id, or with an id that is not an integer",
                                   "The id has no effect here; programs that store lights by id "
                                   "expect a different number from 0 to 7 for each light."};
inline constexpr Code xml_light_default{
    "xml.light-default", Severity::warning, "a light lacks a value",
    "The format requires it. The default given in the message is used."};
inline constexpr Code xml_light_unused{
    "xml.light-unused", Severity::warning, "a value has no effect on this type of light",
    "Only spots and directional and area lights have a direction, directional lights have no "
    "position, penumbra and angle are for spots, width and height for area lights."};

// Objects.

inline constexpr Code xml_object_type{"xml.object-type", Severity::error,
                                      "an object has a misspelled type",
                                      "The types are tree, master and primitive."};
inline constexpr Code xml_unknown_object_type{
    "xml.unknown-object-type", Severity::warning, "an object has an unknown type",
    "The types are tree, master and primitive. The object was ignored, with everything in it."};
inline constexpr Code xml_misspelled_shape{"xml.misspelled-shape", Severity::error,
                                           "a shape is probably misspelled",
                                           "The shapes are cube, cone, cylinder, sphere and mesh."};
inline constexpr Code xml_unknown_shape{"xml.unknown-shape", Severity::warning,
                                        "a shape is not part of the format",
                                        "The shapes are cube, cone, cylinder, sphere and mesh. The "
                                        "object is not drawn; many programs draw a cube instead."};
inline constexpr Code xml_mesh_files{"xml.mesh-files", Severity::warning, "a mesh names two files",
                                     "`filename`, the name in the format, is used."};
inline constexpr Code xml_master_name{"xml.master-name", Severity::error, "an object has no name",
                                      "A tree outside the root needs a name by which it is used, "
                                      "and an instance needs the name of its template."};
inline constexpr Code xml_duplicate_name{
    "xml.duplicate-name", Severity::error, "a name is declared twice",
    "Names of trees must be unique; otherwise it is unclear which one an instance means."};
inline constexpr Code xml_reserved_root{
    "xml.reserved-root",
    Severity::error,
    "the name root is used for something else",
    "It is the name of the main tree of the scene, which cannot be part of itself. A warning if a "
    "tree inside another one has the name.",
    CodeKind::plain,
    Severity::warning};
inline constexpr Code xml_no_root{
    "xml.no-root", Severity::warning, "the scene has no tree named root",
    "What is drawn is <object type=\"tree\" name=\"root\">; all other trees are templates "
    "(masters), drawn only where they are used."};
inline constexpr Code xml_master_after_root{"xml.master-after-root", Severity::warning,
                                            "a template (master) is declared after the root",
                                            "All templates should be declared before the root. "
                                            "Programs that read in one pass reject the file.",
                                            CodeKind::dialect};
inline constexpr Code xml_nested_master{
    "xml.nested-master", Severity::warning, "an instance names a tree inside another tree",
    "The format allows any name to be used again, but most programs know only the trees at the top "
    "level of the file. Declare it there.",
    CodeKind::dialect};
inline constexpr Code xml_instance_children{
    "xml.instance-children", Severity::warning, "an instance has contents",
    "It is a copy of a template (master) as declared; its other contents were ignored."};
inline constexpr Code xml_empty_tree{"xml.empty-tree", Severity::warning, "a tree is empty",
                                     "Nothing is drawn for it."};
inline constexpr Code xml_object_without_transblock{
    "xml.object-without-transblock", Severity::warning, "an object is not in a transblock",
    "Each object must be directly inside a transblock. It was read as if it were in one without "
    "transforms.",
    CodeKind::dialect};
inline constexpr Code xml_transblock_without_object{"xml.transblock-without-object",
                                                    Severity::warning, "a transblock has no object",
                                                    "Nothing is drawn for it."};
inline constexpr Code xml_after_object{
    "xml.after-object", Severity::warning, "something follows the object of a transblock",
    "According to the format, everything after the first object of a transblock is ignored. The "
    "course's programs used all of it; so does --compat course."};
inline constexpr Code xml_after_object_used{
    "xml.after-object-used", Severity::warning, "something that follows the object was used",
    "According to the format, everything after the first object of a transblock is ignored; it was "
    "used because of --compat course. Give each object its own transblock."};

// Transformations and materials.

inline constexpr Code xml_rotate_angle{"xml.rotate-angle", Severity::warning,
                                       "a rotation has no angle",
                                       "It was read as a rotation by 0 degrees."};
inline constexpr Code xml_rotate_axis{"xml.rotate-axis", Severity::warning,
                                      "a rotation has no axis", "Nothing is rotated."};
inline constexpr Code xml_matrix_rows{
    "xml.matrix-rows", Severity::error, "a matrix does not have four rows",
    "A matrix has four elements, one a row, with four numbers each."};
inline constexpr Code xml_matrix_not_affine{
    "xml.matrix-not-affine",
    Severity::warning,
    "the last row of a matrix is not 0 0 0 1",
    "Transforms are affine. A last row of 0 0 0 w divides the matrix by w; anything else in it has "
    "no effect. A translation belongs in the last column: a matrix with a translation in the last "
    "row was written column by column. An error if dividing is impossible.",
    CodeKind::plain,
    Severity::error};
inline constexpr Code xml_texture_blend{"xml.texture-blend", Severity::warning,
                                        "a texture has its own blend",
                                        "An early description of the format puts a number on the "
                                        "texture; all programs read it from an element <blend>.",
                                        CodeKind::dialect};

}  // namespace scenefile
