#pragma once
// The kinds of finding that reading a scene file reports. Codes about JSON alone: json_codes.h.

#include "scenefile/base/diagnostics.h"

#include <span>

namespace scenefile {

/// All codes of the room, those of JSON too.
std::span<const Code* const> format_codes();

// The file as a whole.

inline constexpr Code format_empty{
    "format.empty", Severity::error, "the file has no content",
    "A scene file holds one XML element <scenefile> or one JSON object."};
inline constexpr Code format_unknown{"format.unknown", Severity::error,
                                     "the file is neither XML nor JSON",
                                     "The first character that is not white space decides: < is "
                                     "XML, { or [ is JSON. The name of the "
                                     "file does not matter. Web pages, archives, meshes and "
                                     "pictures are told apart."};
inline constexpr Code format_encoding{
    "format.encoding", Severity::error, "the characters of the file cannot be read",
    "Save the file as UTF-8. UTF-16 is read when it has a byte order mark, ISO-8859-1 and "
    "windows-1252 when the XML declaration names them."};
inline constexpr Code format_encoding_assumed{
    "format.encoding-assumed", Severity::warning, "the declared encoding is not known",
    "The file holds nothing but ASCII, which nearly all encodings share, so it was read as that. "
    "Declare UTF-8 or leave the declaration out."};

// XML as such.

inline constexpr Code xml_syntax{"xml.syntax", Severity::error, "the file is not well-formed XML",
                                 "Tags must be closed in the order they were opened, values stand "
                                 "in quotes, & and < are written "
                                 "&amp; and &lt;. Nothing behind the place could be read."};
inline constexpr Code xml_comment{
    "xml.comment",
    Severity::error,
    "a comment that XML does not allow",
    "A comment starts with <!-- and ends with the first -->; between them XML allows no --, and no "
    "- right before the end. Write one dash, or =. The parsers of the course's programs read such "
    "comments all the same: with --compat course this is a warning, and so does the reader.",
    CodeKind::plain,
    Severity::warning};
inline constexpr Code xml_conflict_marker{
    "xml.conflict-marker", Severity::error, "the file holds an unresolved git conflict",
    "Decide for one of the two versions and delete the lines that start with <<<<<<<, ======= and "
    ">>>>>>>."};
inline constexpr Code xml_external_dtd{
    "xml.external-dtd", Severity::warning, "the DOCTYPE names another file",
    "Nothing outside the scene file is ever opened. Delete the DOCTYPE: scene files need none."};
inline constexpr Code xml_entity{
    "xml.entity", Severity::error, "the file declares or uses an entity",
    "Entities and attribute defaults of a DOCTYPE can hide or multiply the content of a file, so "
    "they are refused. Write the content itself."};
inline constexpr Code xml_nesting_limit{
    "xml.nesting-limit", Severity::error, "elements are nested too deeply",
    "The deepest scene known has fewer than 50 levels. Declare parts as masters and use them by "
    "name.",
    CodeKind::limit};
inline constexpr Code xml_attribute_limit{
    "xml.attribute-limit", Severity::error, "an element has too many attributes",
    "No element of the format has more than five.", CodeKind::limit};
inline constexpr Code xml_length_limit{
    "xml.length-limit", Severity::error, "a name, a value or a comment is too long",
    "The limits hold every scene known with room to spare; text of this length is damage or an "
    "attack.",
    CodeKind::limit};
inline constexpr Code xml_light_limit{
    "xml.light-limit", Severity::error, "the file has too many lights",
    "The format text allows 8 lights. More are read, up to this limit.", CodeKind::limit};

// Names of elements.

inline constexpr Code xml_root_element{
    "xml.root-element", Severity::error, "the file is XML but no scene",
    "A scene is one element <scenefile> that holds everything else."};
inline constexpr Code xml_name_case{
    "xml.name-case", Severity::warning, "a name is written in another case",
    "Names of the format are lower case, and most programs insist on it.", CodeKind::dialect};
inline constexpr Code xml_unknown_element{
    "xml.unknown-element", Severity::warning, "an element is not part of the format",
    "It was left out with everything in it. Extensions of other programs are not followed."};
inline constexpr Code xml_misspelt_element{"xml.misspelt-element", Severity::error,
                                           "an element is probably misspelt",
                                           "Its name is one or two letters away from one of the "
                                           "format. Leaving it out would give a picture "
                                           "that its author did not mean."};
inline constexpr Code xml_misspelt_transblock{
    "xml.misspelt-transblock", Severity::warning, "a transblock is misspelt",
    "Only transblocks may stand in a tree, so it was read as one. Other programs may refuse it or "
    "leave it out.",
    CodeKind::dialect};
inline constexpr Code xml_misplaced_element{
    "xml.misplaced-element", Severity::warning, "an element stands where it means nothing",
    "The format knows the element, but not in this place. It was left out with everything in it."};
inline constexpr Code xml_ignored_element{
    "xml.ignored-element",
    Severity::warning,
    "an element of some readers has no effect",
    "Some programs read it; the format text does not name it and nothing here depends on it. A "
    "note where nothing could depend on it at all and its value makes sense.",
    CodeKind::plain,
    Severity::note};
inline constexpr Code xml_alias_element{
    "xml.alias-element", Severity::warning, "an element has its other name",
    "The format text uses two names for the same thing; the one suggested is the one that all "
    "programs read.",
    CodeKind::dialect};
inline constexpr Code xml_duplicate_element{"xml.duplicate-element", Severity::warning,
                                            "something is given twice", "The later one counts."};
inline constexpr Code xml_second_camera{"xml.second-camera", Severity::warning,
                                        "the scene has more than one camera",
                                        "The format allows one. The last one counts."};
inline constexpr Code xml_text{
    "xml.text", Severity::warning, "there is text between the elements",
    "Values of the format are attributes, and comments are written <!-- like this -->. Only the "
    "first text of a file is reported."};

// Attributes.

inline constexpr Code xml_unknown_attribute{"xml.unknown-attribute", Severity::warning,
                                            "an attribute is not part of the format",
                                            "It was left out."};
inline constexpr Code xml_misspelt_attribute{
    "xml.misspelt-attribute", Severity::error, "an attribute is probably misspelt",
    "An attribute that the element needs is missing, and this one is nearly named like it."};
inline constexpr Code xml_missing_attribute{"xml.missing-attribute", Severity::error,
                                            "an attribute is missing",
                                            "The element means nothing without it."};
inline constexpr Code xml_alias_attribute{
    "xml.alias-attribute", Severity::warning, "an attribute has another name",
    "Some programs go by the order of attributes and not by their names, so files with other names "
    "exist. Programs that go by names refuse them.",
    CodeKind::dialect};
inline constexpr Code xml_positional_attributes{
    "xml.positional-attributes", Severity::warning, "attributes were read by their order",
    "None of the names that the format gives these attributes is there. Some programs go by the "
    "order alone; those that go by names refuse the file.",
    CodeKind::dialect};
inline constexpr Code xml_attribute_order{
    "xml.attribute-order", Severity::warning, "attributes stand in another order",
    "They were read by their names. Programs that go by the order alone take each for another one "
    "and draw another picture. `scenefile convert old.xml new.xml` writes the usual order.",
    CodeKind::dialect};
inline constexpr Code xml_color_alpha{
    "xml.color-alpha", Severity::note, "a color has a fourth part",
    "Colors have three parts; `transparent` says how much light passes through."};
inline constexpr Code xml_number{
    "xml.number",
    Severity::error,
    "a value is not a number",
    "Numbers are decimal with a point, such as -0.5, 3 or 1e-3. With --compat course the longest "
    "part at the front that is a number counts, with a warning, as in old programs.",
    CodeKind::plain,
    Severity::warning};
inline constexpr Code xml_number_range{
    "xml.number-range", Severity::error, "a number is too large",
    "It does not fit a single precision number, whose largest is about 3.4e38."};
inline constexpr Code xml_number_underflow{
    "xml.number-underflow", Severity::warning, "a number is too small to be kept",
    "It is nearer to 0 than the least single precision number, about 1.4e-45, and counts as 0."};
inline constexpr Code xml_empty_number{"xml.empty-number", Severity::warning, "a number is empty",
                                       "It counts as 0."};

// Camera and lights.

inline constexpr Code xml_camera_default{
    "xml.camera-default", Severity::warning, "the camera lacks a part",
    "A camera has pos, look or focus, up and heightangle. The default that the message names is "
    "used."};
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
                                   "a light without an id, or one that is no whole number",
                                   "The id has no effect here; programs that store lights by id "
                                   "expect numbers from 0 to 7, one of "
                                   "each light."};
inline constexpr Code xml_light_default{
    "xml.light-default", Severity::warning, "a light lacks a part",
    "The format text demands it. The default that the message names is used."};
inline constexpr Code xml_light_unused{
    "xml.light-unused", Severity::warning, "a value has no effect on this type of light",
    "Only spots and directional and area lights have a direction, directional lights have no "
    "position, penumbra and angle are for spots, width and height for area lights."};

// Objects.

inline constexpr Code xml_object_type{"xml.object-type", Severity::error,
                                      "an object has a misspelt type",
                                      "The types are tree, master and primitive."};
inline constexpr Code xml_unknown_object_type{
    "xml.unknown-object-type", Severity::warning, "an object has an unknown type",
    "The types are tree, master and primitive. The object was left out with everything in it."};
inline constexpr Code xml_misspelt_shape{"xml.misspelt-shape", Severity::error,
                                         "a shape is probably misspelt",
                                         "The shapes are cube, cone, cylinder, sphere and mesh."};
inline constexpr Code xml_unknown_shape{
    "xml.unknown-shape", Severity::warning, "a shape is not part of the format",
    "The shapes are cube, cone, cylinder, sphere and mesh. The object is not drawn; many programs "
    "draw a cube in its place."};
inline constexpr Code xml_mesh_files{
    "xml.mesh-files", Severity::warning, "a mesh names two files",
    "`filename` is the name that the format text gives; it counts."};
inline constexpr Code xml_master_name{
    "xml.master-name", Severity::error, "an object has no name",
    "A tree outside of the root needs a name to be used by, and an instance the name of what it "
    "stands for."};
inline constexpr Code xml_duplicate_name{
    "xml.duplicate-name", Severity::error, "a name is declared twice",
    "Names of trees must be unique, or it is open which one an instance means."};
inline constexpr Code xml_reserved_root{
    "xml.reserved-root",
    Severity::error,
    "the name root is used for something else",
    "It belongs to the main tree of the scene, which cannot be a part of itself. A warning where a "
    "tree inside another one has it.",
    CodeKind::plain,
    Severity::warning};
inline constexpr Code xml_no_root{"xml.no-root", Severity::warning,
                                  "the scene has no tree named root",
                                  "What is drawn is <object type=\"tree\" name=\"root\">; all "
                                  "other trees are masters, drawn only "
                                  "where they are used."};
inline constexpr Code xml_master_after_root{
    "xml.master-after-root", Severity::warning, "a master is declared after the root",
    "The root says that all masters have been declared. Programs that read in one pass refuse the "
    "file.",
    CodeKind::dialect};
inline constexpr Code xml_nested_master{"xml.nested-master", Severity::warning,
                                        "an instance names a tree inside another tree",
                                        "The format text lets every name be used again, but most "
                                        "programs know only the trees at the top "
                                        "of the file. Declare it there.",
                                        CodeKind::dialect};
inline constexpr Code xml_instance_children{
    "xml.instance-children", Severity::warning, "an instance has content of its own",
    "It stands for a master as that was declared; what it contains was left out."};
inline constexpr Code xml_empty_tree{"xml.empty-tree", Severity::warning, "a tree is empty",
                                     "Nothing is drawn for it."};
inline constexpr Code xml_object_without_transblock{
    "xml.object-without-transblock", Severity::warning, "an object stands in no transblock",
    "Each object must be immediately surrounded by a transblock. It was read as if it were in one "
    "without transformations.",
    CodeKind::dialect};
inline constexpr Code xml_transblock_without_object{"xml.transblock-without-object",
                                                    Severity::warning, "a transblock has no object",
                                                    "Nothing is drawn for it."};
inline constexpr Code xml_after_object{
    "xml.after-object", Severity::warning, "something follows the object of a transblock",
    "The format text says that nothing counts after the first object of a transblock. The course's "
    "programs used all of it: --compat course does the same."};
inline constexpr Code xml_after_object_used{
    "xml.after-object-used", Severity::warning, "something that follows the object was used",
    "The format text says that nothing counts after the first object of a transblock; it was used "
    "because of --compat course. Give each object a transblock of its own."};

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
    "Objects are moved by affine maps. A last row of 0 0 0 "
    "w divides the matrix by w; anything else "
    "in it has no effect. A translation belongs into the "
    "last column: a matrix with one in the last "
    "row was written column by column. An error where dividing is impossible.",
    CodeKind::plain,
    Severity::error};
inline constexpr Code xml_texture_blend{
    "xml.texture-blend", Severity::warning, "a texture carries its blend itself",
    "The sketch of the format text puts a number on the texture; all programs read it from an "
    "element <blend>.",
    CodeKind::dialect};

}  // namespace scenefile
