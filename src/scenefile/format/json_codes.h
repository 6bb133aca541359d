#pragma once
// Findings of the JSON reader.

#include "scenefile/base/diagnostics.h"

namespace scenefile {

inline constexpr Code json_syntax{
    "json.syntax", Severity::error, "the file is not valid JSON",
    "The text breaks the rules of JSON at this place: a comma, colon, quote or bracket is missing "
    "or extra. Nothing after it was read. Keys and strings are in double quotes; members and "
    "elements are separated by single commas."};
inline constexpr Code json_truncated{
    "json.truncated", Severity::error, "the file ends too early",
    "The file ends inside an object, an array or a string: it was truncated when it was copied or "
    "saved, or a closing bracket is missing further up."};
inline constexpr Code json_trailing_comma{
    "json.trailing-comma", Severity::error, "a comma after the last element",
    "JSON allows commas only between members and elements. Remove the comma before the closing "
    "bracket, or add the missing element."};
inline constexpr Code json_comment{"json.comment", Severity::error, "a comment",
                                   "JSON has no comments. Remove it, or say it in a \"name\"."};
inline constexpr Code json_number{
    "json.number",
    Severity::error,
    "a number that JSON does not allow",
    "JSON numbers have digits on both sides of the point and no leading zero or plus: 0.6 instead "
    "of .6, 1.0 instead of 1., 7 instead of 07 or +7. There is no NaN, Infinity or hexadecimal. "
    "With --compat course, a missing digit next to the point counts as 0, with a warning.",
    CodeKind::plain,
    Severity::warning};
inline constexpr Code json_number_range{"json.number-range", Severity::error,
                                        "a number that is too large",
                                        "Values are kept in single precision, up to about 3.4e38."};
inline constexpr Code json_number_underflow{
    "json.number-underflow", Severity::warning, "a number that is too small to be represented",
    "It is closer to 0 than the smallest single-precision number, about 1.4e-45, and counts as 0."};
inline constexpr Code json_conflict_marker{
    "json.conflict-marker", Severity::error, "an unresolved git conflict",
    "git left both versions of a part in the file, between lines of <<<<<<<, ======= and >>>>>>>. "
    "Keep one version and remove these lines."};
inline constexpr Code json_string{
    "json.string", Severity::error, "a string that JSON cannot say",
    "Inside a string, line breaks, tabs and other control characters must be written \\n, \\t or "
    "\\u0000, a backslash \\\\ and a quote \\\". A \\u escape has four digits, and characters "
    "beyond "
    "\\uffff need both halves of a surrogate pair."};
inline constexpr Code json_after_end{
    "json.after-end", Severity::error, "something after the end",
    "The first value is complete and more follows: two files in one, or an extra bracket."};
inline constexpr Code json_limit{
    "json.limit", Severity::error, "a limit is reached",
    "Limits keep a faulty or hostile file from taking all memory and time. They leave ample room "
    "for every scene of the course, and can be raised.",
    CodeKind::limit};

inline constexpr Code json_wrong_type{
    "json.wrong-type", Severity::error, "a value of the wrong type",
    "Each key has one type of value: numbers and strings are not converted to each other, vectors "
    "are arrays of numbers, groups and lights are arrays of objects."};
inline constexpr Code json_wrong_length{
    "json.wrong-length", Severity::error, "an array of the wrong length",
    "Vectors and colors have 3 numbers, rotate has 4 (x, y, z and degrees), matrix has 4 rows of 4 "
    "numbers."};
inline constexpr Code json_four_dimensional{
    "json.four-dimensional", Severity::error, "a vector of a 4-D scene",
    "A variant of the format describes scenes in four dimensions: vectors have 4 numbers there and "
    "rotate has 7. Such scenes cannot be read."};
inline constexpr Code json_missing_key{
    "json.missing-key", Severity::error, "a required key is missing",
    "The format requires this key, and other readers reject the file without it."};
inline constexpr Code json_unknown_key{
    "json.unknown-key", Severity::warning, "an unknown key",
    "The key is not part of the format but an extension of another reader. It is ignored with "
    "everything in it. The course's reader rejects the file."};
inline constexpr Code json_misspelled_key{
    "json.misspelled-key", Severity::error, "a key that is probably misspelled",
    "The key is close to another one, which the object lacks. Ignoring it would give a picture "
    "that its author did not intend. The course's reader rejects the file."};
inline constexpr Code json_duplicate_key{"json.duplicate-key", Severity::warning,
                                         "a key that occurs twice",
                                         "Each key may occur once in an object. The last one "
                                         "counts, as in most programs; earlier ones are ignored."};
inline constexpr Code json_unused_key{
    "json.unused-key", Severity::note, "a key without effect",
    "The key belongs to the format, but not to this kind of light or primitive, or not without "
    "another key."};
inline constexpr Code json_look_and_focus{
    "json.look-and-focus", Severity::error, "a camera with look and focus",
    "look is the direction of view, focus a point to look at. A camera has one of them."};
inline constexpr Code json_unknown_light_type{"json.unknown-light-type", Severity::error,
                                              "a light of unknown type",
                                              "Lights are point, directional, spot or area."};
inline constexpr Code json_light_default{
    "json.light-default", Severity::warning, "a light lacks a key",
    "The format requires the key for this type of light, and the course's reader rejects the file. "
    "The default given in the message is used."};
inline constexpr Code json_no_light{
    "json.no-light", Severity::warning, "something else among the lights",
    "The list \"lights\" holds lights, each with \"type\" and \"color\". Groups belong into "
    "\"groups\"; a light stands at the origin of the group that holds its list."};
inline constexpr Code json_unknown_primitive_type{
    "json.unknown-primitive-type",
    Severity::warning,
    "a primitive of unknown type",
    "Primitives are cube, cone, cylinder, sphere or mesh. Other types are extensions of other "
    "readers. The primitive is ignored. The course's reader rejects the file. An error if the type "
    "cannot be the name of a shape.",
    CodeKind::plain,
    Severity::error};
inline constexpr Code json_area_light{
    "json.area-light", Severity::note, "an area light",
    "Area lights belong to the format, but the course's JSON reader does not support them and "
    "rejects the file. width and height are read here."};
inline constexpr Code json_matrix_with_others{
    "json.matrix-with-others", Severity::warning, "a matrix beside other transforms",
    "The order is translate, rotate, scale, matrix, whatever the order of the keys: the matrix "
    "acts first. Some programs reject a matrix beside others; nested groups make the order "
    "visible."};
inline constexpr Code json_no_groups{"json.no-groups", Severity::warning, "a scene without groups",
                                     "Everything visible, and all lights, are in groups."};
inline constexpr Code json_instance_keys{
    "json.instance-keys", Severity::warning, "an instance with keys that are ignored",
    "A group whose name is that of a template group declared before stands for that template, and "
    "its other keys are ignored. To place an instance, put it into a group with the transforms: "
    "{\"translate\": [1, 0, 0], \"groups\": [{\"name\": \"chair\"}]}. If no instance is meant, "
    "give "
    "the group another name."};
inline constexpr Code json_template_order{
    "json.template-order", Severity::warning, "a group with the name of a later template",
    "A template can use only templates declared before it; here the name is declared later, and "
    "other readers see an ordinary group. Declare the template first, or rename the group."};
inline constexpr Code json_unknown_template{
    "json.unknown-template", Severity::warning, "a group with a name and nothing else",
    "This is how an instance of a template group is written, but no template group has the name, "
    "so "
    "that nothing is drawn. Names are compared exactly, upper and lower case included."};

}  // namespace scenefile
