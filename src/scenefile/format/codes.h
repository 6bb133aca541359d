#pragma once
// The codes of the findings of the readers, the writers, and of course configurations.

#include "scenefile/base/code.h"

namespace scenefile {

inline constexpr Code format_codes[] = {
    // The file as a whole.

    {"format.empty", Severity::error, "the file has no content",
     "A scene file contains one XML element <scenefile> or one JSON object."},
    {"format.unknown", Severity::error, "the file is neither XML nor JSON",
     "The first character that is not white space decides: < is XML, { or [ is JSON. The name of "
     "the file does not matter. Web pages, archives, meshes and pictures are recognized and "
     "named."},
    {"format.encoding", Severity::error, "the text encoding of the file cannot be read",
     "Save the file as UTF-8. UTF-16 is read if it has a byte order mark, ISO-8859-1 and "
     "windows-1252 if the XML declaration names them."},
    {"format.encoding-assumed", Severity::warning, "the declared encoding is not known",
     "The file contains only ASCII characters, which nearly all encodings share, so it was read as "
     "ASCII. Declare UTF-8, or leave the declaration out."},

    // XML syntax.

    {"xml.syntax", Severity::error, "the file is not well-formed XML",
     "Tags must be closed in the order they were opened, values must be in quotes, & and < are "
     "written &amp; and &lt;. After a value without quotes or an end tag in the wrong case, the "
     "rest of the file was read; after any other of these mistakes, nothing was."},
    {"xml.comment", Severity::error, "a comment that XML does not allow",
     "A comment starts with <!-- and ends with the first -->; between them, XML does not allow --, "
     "nor a - right before the end. Write a single dash, or =. The parsers of the course's "
     "programs accept such comments, and so does --compat course, with a warning.",
     CodeKind::plain, Severity::warning},
    {"xml.conflict-marker", Severity::error, "the file contains an unresolved git conflict",
     "Choose one of the two versions and delete the lines that start with <<<<<<<, ======= and "
     ">>>>>>>."},
    {"xml.external-dtd", Severity::warning, "the DOCTYPE names another file",
     "Nothing outside the scene file is ever opened. Delete the DOCTYPE: scene files need none."},
    {"xml.entity", Severity::error, "the file declares or uses an entity",
     "Entities and attribute defaults of a DOCTYPE can hide or multiply the content of a file, so "
     "they are rejected. Write the content itself."},
    {"xml.nesting-limit", Severity::error, "elements are nested too deeply",
     "No known scene has more than 50 levels. Declare parts as templates (masters) and use them by "
     "name.",
     CodeKind::limit},
    {"xml.attribute-limit", Severity::error, "an element has too many attributes",
     "No element of the format has more than five.", CodeKind::limit},
    {"xml.length-limit", Severity::error, "a name, a value or a comment is too long",
     "The limits leave ample room for every known scene; text of this length is damage or an "
     "attack.",
     CodeKind::limit},
    {"xml.light-limit", Severity::error, "the file has too many lights",
     "The format allows 8 lights. More are read, up to this limit.", CodeKind::limit},

    // Names of elements.

    {"xml.root-element", Severity::error, "the file is XML but not a scene",
     "A scene is one element <scenefile> that contains everything else."},
    {"xml.name-case", Severity::warning, "a name has the wrong case",
     "Names of the format are lower case, and most programs insist on it.", CodeKind::dialect},
    {"xml.unknown-element", Severity::warning, "an element is not part of the format",
     "It was ignored, with everything in it. Extensions of other programs are not supported."},
    {"xml.misspelled-element", Severity::error, "an element is probably misspelled",
     "Its name is one or two letters away from a name of the format. Ignoring it would give a "
     "picture that its author did not intend."},
    {"xml.misspelled-transblock", Severity::warning, "a transblock is misspelled",
     "A tree may contain only transblocks, so it was read as one. Other programs may reject or "
     "ignore it.",
     CodeKind::dialect},
    {"xml.misplaced-element", Severity::warning, "an element is in a place where it has no meaning",
     "The format has this element, but not here. It was ignored, with everything in it."},
    {"xml.ignored-element", Severity::warning, "an element that some programs read has no effect",
     "Some programs read it, but the format does not define it, and nothing here depends on it. A "
     "note where nothing could depend on it.",
     CodeKind::plain, Severity::note},
    {"xml.alias-element", Severity::warning, "an element has its alternative name",
     "The format uses two names for the same thing; the suggested one is the one that all programs "
     "read.",
     CodeKind::dialect},
    {"xml.duplicate-element", Severity::warning, "something is given twice",
     "The later one counts."},
    {"xml.second-camera", Severity::warning, "the scene has more than one camera",
     "The format allows one. The last one counts."},
    {"xml.text", Severity::warning, "there is text between the elements",
     "Values of the format are attributes, and comments are written <!-- like this -->. Only the "
     "first such text of a file is reported."},

    // Attributes.

    {"xml.unknown-attribute", Severity::warning, "an attribute is not part of the format",
     "It was ignored."},
    {"xml.misspelled-attribute", Severity::error, "an attribute is probably misspelled",
     "An attribute that the element needs is missing, and this one has nearly the same name."},
    {"xml.missing-attribute", Severity::error, "an attribute is missing",
     "The element has no meaning without it."},
    {"xml.alias-attribute", Severity::warning, "an attribute has another name",
     "Some programs use the order of attributes, not their names, so files with other names exist. "
     "Programs that use the names reject them.",
     CodeKind::dialect},
    {"xml.positional-attributes", Severity::warning, "attributes were read by their order",
     "None of the names that the format gives these attributes is present. Some programs use only "
     "the order; those that use the names reject the file.",
     CodeKind::dialect},
    {"xml.attribute-order", Severity::warning, "attributes are in an unusual order",
     "They were read by their names. Programs that use the order read wrong values and draw a "
     "different picture. `scenefile convert old.xml new.xml` writes the usual order.",
     CodeKind::dialect},
    {"xml.color-alpha", Severity::note, "a color has a fourth value",
     "Colors have three values; `transparent` says how much light passes through."},
    {"xml.number", Severity::error, "a value is not a number",
     "Numbers are decimal with a point, such as -0.5, 3 or 1e-3. With --compat course the longest "
     "numeric prefix is used, with a warning, as in older programs.",
     CodeKind::plain, Severity::warning},
    {"xml.number-range", Severity::error, "a number is too large",
     "It does not fit in a single-precision number; the largest is about 3.4e38."},
    {"xml.number-underflow", Severity::warning, "a number is too small to be represented",
     "It is closer to 0 than the smallest single-precision number, about 1.4e-45, and counts as "
     "0."},
    {"xml.empty-number", Severity::warning, "a number is empty", "It counts as 0."},

    // Camera and lights.

    {"xml.camera-default", Severity::warning, "the camera is missing a value",
     "A camera has pos, look or focus, up and heightangle. The default given in the message is "
     "used."},
    {"xml.look-and-focus", Severity::error, "the camera has both look and focus",
     "`look` is a direction, `focus` the point to look at. Delete one of them."},
    {"xml.focus-at-position", Severity::error, "the camera looks at itself",
     "`focus` is the point to look at; it must differ from `pos`."},
    {"xml.light-type", Severity::error, "a light has an unknown type",
     "The types are point, directional, spot and area."},
    {"xml.light-id", Severity::warning,
     "a light without an id, or with an id that is not an integer",
     "The id has no effect here; programs that store lights by id expect a different number from 0 "
     "to 7 for each light."},
    {"xml.light-default", Severity::warning, "a light is missing a value",
     "The format requires it. The default given in the message is used."},
    {"xml.light-unused", Severity::warning, "a value has no effect on this type of light",
     "Only directional lights, spotlights and area lights have a direction, directional lights "
     "have no position, angle and penumbra are for spotlights, width and height for area lights."},

    // Objects.

    {"xml.object-type", Severity::error, "an object has a misspelled type",
     "The types are tree, master and primitive."},
    {"xml.unknown-object-type", Severity::warning, "an object has an unknown type",
     "The types are tree, master and primitive. The object was ignored, with everything in it."},
    {"xml.misspelled-shape", Severity::error, "a shape is probably misspelled",
     "The shapes are cube, cone, cylinder, sphere and mesh."},
    {"xml.unknown-shape", Severity::warning, "a shape is not part of the format",
     "The shapes are cube, cone, cylinder, sphere and mesh. The object is not drawn; many programs "
     "draw a cube instead."},
    {"xml.mesh-files", Severity::warning, "a mesh names two files",
     "`filename`, the name in the format, is used."},
    {"xml.master-name", Severity::error, "an object has no name",
     "A tree outside the root needs a name by which it is used, and an instance needs the name of "
     "its template."},
    {"xml.duplicate-name", Severity::error, "a name is declared twice",
     "Names of trees must be unique; otherwise it is unclear which one an instance means."},
    {"xml.reserved-root", Severity::error, "the name root is used for something else",
     "It is the name of the main tree of the scene, which cannot be part of itself. A warning if a "
     "tree inside another one has the name.",
     CodeKind::plain, Severity::warning},
    {"xml.no-root", Severity::warning, "the scene has no tree named root",
     "What is drawn is <object type=\"tree\" name=\"root\">; all other trees are templates "
     "(masters), drawn only where they are used."},
    {"xml.master-after-root", Severity::warning, "a template (master) is declared after the root",
     "All templates should be declared before the root. Programs that read in one pass reject the "
     "file.",
     CodeKind::dialect},
    {"xml.nested-master", Severity::warning, "an instance names a tree inside another tree",
     "The format allows any name to be used again, but most programs only find trees at the top "
     "level of the file. Declare it there.",
     CodeKind::dialect},
    {"xml.instance-children", Severity::warning, "an instance has contents",
     "It is a copy of a template (master) as declared; its other contents were ignored."},
    {"xml.empty-tree", Severity::warning, "a tree is empty", "Nothing is drawn for it."},
    {"xml.object-without-transblock", Severity::warning, "an object is not in a transblock",
     "Each object must be directly inside a transblock. It was read as if it were in one without "
     "transforms.",
     CodeKind::dialect},
    {"xml.transblock-without-object", Severity::warning, "a transblock has no object",
     "Nothing is drawn for it."},
    {"xml.after-object", Severity::warning, "something follows the object of a transblock",
     "According to the format, everything after the first object of a transblock is ignored. The "
     "course's programs used all of it; so does --compat course."},
    {"xml.after-object-used", Severity::warning, "something that follows the object was used",
     "According to the format, everything after the first object of a transblock is ignored; it "
     "was used because of --compat course. Give each object its own transblock."},

    // Transformations and materials.

    {"xml.rotate-angle", Severity::warning, "a rotation has no angle",
     "It was read as a rotation by 0 degrees."},
    {"xml.rotate-axis", Severity::warning, "a rotation has no axis", "Nothing is rotated."},
    {"xml.matrix-rows", Severity::error, "a matrix does not have four rows",
     "A matrix has four elements, one for each row, with four numbers each."},
    {"xml.matrix-not-affine", Severity::warning, "the last row of a matrix is not 0 0 0 1",
     "Transforms are affine. A last row of 0 0 0 w divides the matrix by w; anything else in it "
     "has no effect. A translation belongs in the last column: a matrix with a translation in the "
     "last row was written column by column. An error if dividing is impossible.",
     CodeKind::plain, Severity::error},
    {"xml.texture-blend", Severity::warning, "a texture has its own blend",
     "An early description of the format puts a number on the texture; all programs read it from "
     "an element <blend>.",
     CodeKind::dialect},

    // JSON.

    {"json.syntax", Severity::error, "the file is not valid JSON",
     "The text breaks the rules of JSON at this place: a comma, colon, quote or bracket is missing "
     "or extra. Nothing after it was read. Keys and strings are in double quotes; members and "
     "elements are separated by single commas."},
    {"json.truncated", Severity::error, "the file ends too early",
     "The file ends inside an object, an array or a string: it was truncated when it was copied or "
     "saved, or a closing bracket is missing further up."},
    {"json.trailing-comma", Severity::error, "a comma after the last element",
     "JSON allows commas only between members and elements. Remove the comma before the closing "
     "bracket, or add the missing element."},
    {"json.comment", Severity::error, "a comment",
     "JSON has no comments. Remove it, or put it into a \"name\"."},
    {"json.number", Severity::error, "a number that JSON does not allow",
     "JSON numbers have digits on both sides of the point and no leading zero or plus: 0.6 instead "
     "of .6, 1.0 instead of 1., 7 instead of 07 or +7. There is no NaN, Infinity or hexadecimal. "
     "With --compat course, a missing digit next to the point counts as 0, with a warning.",
     CodeKind::plain, Severity::warning},
    {"json.number-range", Severity::error, "a number that is too large",
     "Values are kept in single precision, up to about 3.4e38."},
    {"json.number-underflow", Severity::warning, "a number that is too small to be represented",
     "It is closer to 0 than the smallest single-precision number, about 1.4e-45, and counts as "
     "0."},
    {"json.conflict-marker", Severity::error, "an unresolved git conflict",
     "git left both versions of a part in the file, between lines of <<<<<<<, ======= and >>>>>>>. "
     "Keep one version and remove these lines."},
    {"json.string", Severity::error, "a string that is not valid JSON",
     "Inside a string, line breaks, tabs and other control characters must be written \\n, \\t or "
     "\\u0000, a backslash \\\\ and a quote \\\". A \\u escape has four digits, and characters "
     "beyond \\uffff need both halves of a surrogate pair."},
    {"json.after-end", Severity::error, "something after the end",
     "The first value is complete and more follows: two files in one, or an extra bracket."},
    {"json.limit", Severity::error, "a limit is reached",
     "Limits keep a faulty or malicious file from taking all memory and time. They leave ample "
     "room for every scene of the course, and can be raised.",
     CodeKind::limit},

    {"json.wrong-type", Severity::error, "a value of the wrong type",
     "Each key has one type of value: numbers and strings are not converted to each other, vectors "
     "are arrays of numbers, groups and lights are arrays of objects."},
    {"json.wrong-length", Severity::error, "an array of the wrong length",
     "Vectors and colors have 3 numbers, rotate has 4 (x, y, z and degrees), matrix has 4 rows of "
     "4 numbers."},
    {"json.four-dimensional", Severity::error, "a vector of a 4-D scene",
     "A variant of the format describes scenes in four dimensions: vectors have 4 numbers there "
     "and rotate has 7. Such scenes cannot be read."},
    {"json.missing-key", Severity::error, "a required key is missing",
     "The format requires this key, and other readers reject the file without it."},
    {"json.unknown-key", Severity::warning, "an unknown key",
     "The key is not part of the format but an extension of another reader. It is ignored with "
     "everything in it. The course's reader rejects the file."},
    {"json.misspelled-key", Severity::error, "a key that is probably misspelled",
     "The key is close to another one, which is missing here. Ignoring it would give a picture "
     "that its author did not intend. The course's reader rejects the file."},
    {"json.duplicate-key", Severity::warning, "a key that occurs twice",
     "Each key may occur once in an object. The last one counts, as in most programs; earlier ones "
     "are ignored."},
    {"json.unused-key", Severity::note, "a key without effect",
     "The key belongs to the format, but not to this kind of light or primitive, or not without "
     "another key."},
    {"json.look-and-focus", Severity::error, "a camera with look and focus",
     "look is the direction of view, focus a point to look at. A camera has one of them."},
    {"json.unknown-light-type", Severity::error, "a light of unknown type",
     "Lights are point, directional, spot or area."},
    {"json.light-default", Severity::warning, "a light is missing a key",
     "The format requires the key for this type of light, and the course's reader rejects the "
     "file. The default given in the message is used."},
    {"json.no-light", Severity::warning, "an item of \"lights\" that is not a light",
     "The list \"lights\" contains lights, each with \"type\" and \"color\". Groups belong in "
     "\"groups\"; a light is at the origin of the group that contains it."},
    {"json.unknown-primitive-type", Severity::warning, "a primitive of unknown type",
     "Primitives are cube, cone, cylinder, sphere or mesh. Other types are extensions of other "
     "readers. The primitive is ignored. The course's reader rejects the file. An error if the "
     "type cannot be the name of a shape.",
     CodeKind::plain, Severity::error},
    {"json.area-light", Severity::note, "an area light",
     "Area lights belong to the format, but the course's JSON reader does not support them and "
     "rejects the file. width and height are read here."},
    {"json.matrix-with-others", Severity::warning, "a matrix next to other transforms",
     "The order is translate, rotate, scale, matrix, whatever the order of the keys: the matrix "
     "acts first. Some programs reject this; nested groups make the order explicit."},
    {"json.no-groups", Severity::warning, "a scene without groups",
     "Everything visible, and all lights, are in groups."},
    {"json.instance-keys", Severity::warning, "an instance with keys that are ignored",
     "A group whose name is that of a template group declared before is an instance of that "
     "template, and its other keys are ignored. To place an instance, put it into a group with the "
     "transforms: {\"translate\": [1, 0, 0], \"groups\": [{\"name\": \"chair\"}]}. If it should "
     "not be an instance, give the group another name."},
    {"json.template-order", Severity::warning, "a group with the name of a later template",
     "A template can use only templates declared before it; here the name is declared later, and "
     "other readers see an ordinary group. Declare the template first, or rename the group."},
    {"json.unknown-template", Severity::warning, "a group with a name and nothing else",
     "This is how an instance of a template group is written, but no template group has the name, "
     "so that nothing is drawn. Names are compared exactly, upper and lower case included."},

    // Writing.

    {"write.light-moved", Severity::note, "a light is moved to the top level of the file",
     "In XML, lights are at the top level and in world space. The transforms of the group that "
     "held the light are applied to it; a light in a template is written once for each instance."},
    {"write.light-limit", Severity::error, "too many lights",
     "In XML, lights in a template are written once for each instance. The limit bounds how many; "
     "it can be raised.",
     CodeKind::limit},
    {"write.light-turned", Severity::warning, "an area light that XML cannot express",
     "In XML, an area light has a direction, a width and a height; it cannot be rotated about its "
     "direction, or sheared. It is written with the same center, direction and size, but without "
     "that rotation."},
    {"write.light-dark", Severity::warning, "a light that lights nothing",
     "It has no direction, or no finite position, and is dropped."},
    {"write.light-id", Severity::note, "light ids are dropped or added",
     "JSON lights have no ids. XML requires one for each light: those without get the next free "
     "number. Ids have no effect on the picture."},
    {"write.light-name", Severity::note, "a light's name is dropped",
     "XML lights have an id but no name."},
    {"write.scene-name", Severity::note, "the scene's name is dropped",
     "In XML, a scene has no name."},
    {"write.area-light", Severity::note, "an area light in JSON",
     "The course's JSON reader does not support area lights and rejects the file."},
    {"write.default-camera", Severity::note, "the default camera is written",
     "JSON requires a camera; the scene has none, so the default camera is written."},
    {"write.transforms-nested", Severity::note, "transforms become nested groups",
     "A JSON group has one translate, rotate, scale and matrix each, applied in a fixed order. "
     "Other orders become nested groups."},
    {"write.renamed", Severity::note, "a group is renamed",
     "In JSON, a group with a template's name is an instance of that template. In XML, trees at "
     "the top of the file have different names, and root is that of the scene."},
    {"write.empty-group", Severity::note, "an empty group is dropped",
     "In XML, a transblock contains an object, and a tree is not empty."},
    {"write.matrix-row", Severity::note, "the last row of a matrix is written as 0 0 0 1",
     "Transforms are affine; their last row is 0 0 0 1. Other values have no effect."},
    {"write.character", Severity::warning, "a character that cannot be written",
     "XML cannot contain control characters, and neither format can contain bytes that are not "
     "UTF-8. They are replaced; a file with such a character in its name will not be found."},
    {"write.nesting-limit", Severity::error, "the file would be nested too deeply",
     "Readers limit how deeply a file may be nested. What the other format writes flat may need "
     "several levels here.",
     CodeKind::limit},

    // Configuration files of the course's programs.

    {"config.syntax", Severity::error, "a line of the configuration cannot be read",
     "A line is a [section], a key = value, or a comment that starts with a semicolon. Values may "
     "be in double quotes, which must end on the same line."},
    {"config.backslash", Severity::error, "a backslash that is not an escape",
     "The course's reader (QSettings) treats a backslash as the start of an escape and drops what "
     "follows. Write / between folders, \\\\ for a backslash, \\\" for a quote, \\x with the "
     "number in hexadecimal for any other character."},
    {"config.unknown-key", Severity::warning, "an unknown key of the configuration",
     "The keys are scene and output in [IO]. For the ray tracer: width and height in [Canvas], "
     "maximum-recursive-depth and only-render-normals in [Settings], and in [Feature] shadows, "
     "reflect, refract, texture, texture-filter, super-sample, depthoffield; parallel and "
     "acceleration are accepted, but do not affect the picture. For the path tracer, in "
     "[Settings]: imageWidth, imageHeight, samplesPerPixel, pathContinuationProb, "
     "directLightingOnly, numDirectLightingSamples. Other keys have no effect."},
    {"config.key-case", Severity::warning, "a key of the configuration in the wrong case",
     "Names of sections and keys were matched ignoring case. The course's program does so only on "
     "Windows; elsewhere it does not find the key."},
    {"config.duplicate-key", Severity::warning, "a key of the configuration is given twice",
     "The last one counts. Delete the others."},
    {"config.missing-key", Severity::error, "the configuration is missing a key",
     "A configuration needs at least scene and output in [IO], width and height in [Canvas]; one "
     "of the path tracer imageWidth and imageHeight in [Settings]. If other keys of the path "
     "tracer are missing, numbers of samples count as 1 and all other values as 0, with a warning.",
     CodeKind::plain, Severity::warning},
    {"config.picture-format", Severity::warning, "the picture is written as PNG",
     "The extension of output decides: .png, .exr or .pfm. Any other extension gives a PNG."},
    {"config.zero", Severity::warning, "a count of 0",
     "A picture needs at least one sample per pixel, and one point on the lamps for each surface "
     "point. With 0 most programs divide by zero. 1 is used."},
    {"config.value", Severity::error, "a value of the configuration cannot be used",
     "Features are true or false (1 or 0); sizes and counts are whole numbers; a probability is "
     "between 0 and 1. The course's program reads every other word as true and every other number "
     "as 0."},
};

template <CodeName name>
constexpr const Code& operator""_code() requires(code_index(format_codes, name) <
                                                 std::size(format_codes)) {
  constexpr std::size_t index = code_index(format_codes, name);
  return format_codes[index];
}

}  // namespace scenefile
