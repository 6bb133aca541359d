#include "scenefile/scene/vocabulary_words.h"

#include <algorithm>

namespace scenefile {

namespace {

constexpr std::string_view parts_of_scenefile[] = {"globaldata", "cameradata", "lightdata",
                                                   "object"};
constexpr std::string_view parts_of_globaldata[] = {"ambientcoeff", "diffusecoeff", "specularcoeff",
                                                    "transparentcoeff"};
constexpr AttributeWord ambientcoeff_attributes[] = {
    {"v", "The coefficient, usually from 0 to 1.", {}, true}};
constexpr std::string_view parts_of_cameradata[] = {
    "pos", "look", "focus", "up", "heightangle", "aspectratio", "aperture", "focallength"};
constexpr AttributeWord pos_attributes[] = {
    {"x", "The x part.", {}, true}, {"y", "The y part.", {}, true}, {"z", "The z part.", {}, true}};
constexpr AttributeWord heightangle_attributes[] = {
    {"v", "Degrees, above 0 and below 180; 30 to 60 are common.", {}, true}};
constexpr AttributeWord aspectratio_attributes[] = {
    {"v", "Has no effect; width divided by height, above 0.", {}, false}};
constexpr AttributeWord aperture_attributes[] = {{"v", "World units, 0 or more.", {}, true}};
constexpr std::string_view parts_of_lightdata[] = {"id",    "color",     "function", "position",
                                                   "type",  "direction", "angle",    "penumbra",
                                                   "width", "height"};
constexpr AttributeWord id_attributes[] = {
    {"v", "A whole number from 0 to 7, different for each light.", {}, true}};
constexpr AttributeWord color_attributes[] = {
    {"r", "Red: 0 none, 1 full; above 1 for a bright light with attenuation.", {}, true},
    {"g", "Green: 0 none, 1 full; above 1 for a bright light with attenuation.", {}, true},
    {"b", "Blue: 0 none, 1 full; above 1 for a bright light with attenuation.", {}, true},
    {"a", "Has no effect: colors have three parts.", {}, false}};
constexpr AttributeWord function_attributes[] = {
    {"v1", "The constant coefficient.", {}, true},  {"v2", "The linear coefficient.", {}, true},
    {"v3", "The quadratic coefficient.", {}, true}, {"x", "The constant coefficient.", {}, false},
    {"y", "The linear coefficient.", {}, false},    {"z", "The quadratic coefficient.", {}, false},
    {"a", "The constant coefficient.", {}, false},  {"b", "The linear coefficient.", {}, false},
    {"c", "The quadratic coefficient.", {}, false}};
constexpr std::string_view type_values[] = {"point", "directional", "spot", "area"};
constexpr AttributeWord type_attributes[] = {
    {"v", "point: from a position in all directions.", type_values, true}};
constexpr AttributeWord angle_attributes[] = {{"v", "Degrees, above 0 and up to 180.", {}, true}};
constexpr AttributeWord penumbra_attributes[] = {
    {"v", "Degrees, from 0 (a hard edge) to the angle of the spotlight.", {}, true}};
constexpr AttributeWord width_attributes[] = {{"v", "World units, above 0.", {}, true}};
constexpr std::string_view parts_of_object[] = {
    "transblock", "diffuse", "ambient", "specular", "reflective", "transparent",
    "shininess",  "ior",     "bumpmap", "blend",    "texture"};
constexpr std::string_view object_types[] = {"tree", "master", "primitive"};
constexpr std::string_view object_names[] = {"cube", "cone", "cylinder", "sphere", "mesh", "root"};
constexpr AttributeWord object_attributes[] = {
    {"type", "At the top of the file all objects are trees.", object_types, true},
    {"name",
     "The name that instances use; unique among masters. Declare the master before its first use.",
     object_names, true},
    {"filename", "The OBJ file, relative to the folder of the scene.", {}, false},
    {"meshfile",
     "The OBJ file, relative to the folder of the scene; another name of filename.",
     {},
     false}};
constexpr std::string_view parts_of_transblock[] = {"translate", "rotate", "scale", "matrix",
                                                    "object"};
constexpr AttributeWord translate_attributes[] = {{"x", "How far along x.", {}, true},
                                                  {"y", "How far along y.", {}, true},
                                                  {"z", "How far along z.", {}, true}};
constexpr AttributeWord rotate_attributes[] = {
    {"x", "x of the axis. Its length does not matter, but not all three are 0.", {}, true},
    {"y", "y of the axis. Its length does not matter, but not all three are 0.", {}, true},
    {"z", "z of the axis. Its length does not matter, but not all three are 0.", {}, true},
    {"angle", "Degrees.", {}, true}};
constexpr AttributeWord scale_attributes[] = {{"x", "The factor along x, not 0.", {}, true},
                                              {"y", "The factor along y, not 0.", {}, true},
                                              {"z", "The factor along z, not 0.", {}, true}};
constexpr std::string_view parts_of_matrix[] = {"row", "row0", "row1", "row2", "row3"};
constexpr AttributeWord row_attributes[] = {
    {"a", "Column 1.", {}, true},   {"b", "Column 2.", {}, true},
    {"c", "Column 3.", {}, true},   {"d", "Column 4: the translation.", {}, true},
    {"v1", "Column 1.", {}, false}, {"v2", "Column 2.", {}, false},
    {"v3", "Column 3.", {}, false}, {"v4", "Column 4: the translation.", {}, false}};
constexpr AttributeWord diffuse_attributes[] = {
    {"r", "Red, from 0 to 1.", {}, true},
    {"g", "Green, from 0 to 1.", {}, true},
    {"b", "Blue, from 0 to 1.", {}, true},
    {"a", "Has no effect: colors have three parts.", {}, false}};
constexpr AttributeWord shininess_attributes[] = {
    {"v", "0 to 10000; 1 to 200 are common.", {}, true}};
constexpr AttributeWord ior_attributes[] = {
    {"v", "1.33 for water, 1.5 for glass, 2.4 for diamond; 0 means not given.", {}, true}};
constexpr AttributeWord bumpmap_attributes[] = {
    {"file", "The image file, relative to the folder of the scene.", {}, true},
    {"u", "How often the image repeats around the shape. Default 1.", {}, false},
    {"v", "How often the image repeats from bottom to top. Default 1.", {}, false}};
constexpr AttributeWord blend_attributes[] = {
    {"v", "From 0, only the color, to 1, only the texture.", {}, true}};
constexpr std::string_view shape_values[] = {"cube", "cone", "cylinder", "sphere", "mesh"};

constexpr ElementWord elements[] = {
    {"scenefile",
     "A scene: data about the picture as a whole, one camera, any number of lights, and trees of "
     "objects, of which the one named root is drawn.",
     parts_of_scenefile,
     {}},
    {"globaldata",
     "Coefficients that scale the terms of the lighting equation in the whole scene. Optional, as "
     "is each coefficient.",
     parts_of_globaldata,
     {}},
    {"ambientcoeff",
     "Scales the ambient color of every object. Default 0.5.",
     {},
     ambientcoeff_attributes},
    {"diffusecoeff",
     "Scales the diffuse color of every object, but not its texture. Default 0.5.",
     {},
     ambientcoeff_attributes},
    {"specularcoeff",
     "Scales the specular and the reflected color of every object. Default 0.5.",
     {},
     ambientcoeff_attributes},
    {"transparentcoeff",
     "Scales the light that passes through transparent objects. Write it if anything is "
     "transparent: programs differ in the default, 0 or 0.5.",
     {},
     ambientcoeff_attributes},
    {"cameradata",
     "The camera, at most one. Without it a camera at 5 5 5 looks along -1 -1 -1.",
     parts_of_cameradata,
     {}},
    {"pos", "Where the camera is.", {}, pos_attributes},
    {"look",
     "The direction in which the camera looks, of any length. Give look or focus, not both.",
     {},
     pos_attributes},
    {"focus",
     "The point at which the camera looks. Give focus or look, not both.",
     {},
     pos_attributes},
    {"up",
     "The direction that is up in the picture, of any length; not parallel to the direction of "
     "view.",
     {},
     pos_attributes},
    {"heightangle", "The full vertical angle of view.", {}, heightangle_attributes},
    {"aspectratio",
     "Has no effect: the aspect ratio is that of the picture.",
     {},
     aspectratio_attributes},
    {"aperture",
     "The size of the lens, for depth of field. Default 0: everything is sharp.",
     {},
     aperture_attributes},
    {"focallength",
     "The distance of the plane in focus, for depth of field. Default 0: everything is sharp.",
     {},
     aperture_attributes},
    {"lightdata",
     "A light. Its type (default: point) determines what else it needs. point: position. "
     "directional: direction. spot: position, direction, angle and penumbra. area: position, "
     "direction, width and height.",
     parts_of_lightdata,
     {}},
    {"id",
     "The number of the light. It has no effect here; some programs use it as an index.",
     {},
     id_attributes},
    {"color", "The color of the light.", {}, color_attributes},
    {"function",
     "The attenuation of the light: it is divided by v1 + v2 d + v3 d^2, where d is the distance. "
     "Default 1 0 0, no attenuation. The numbers may also be named x y z or a b c.",
     {},
     function_attributes},
    {"position", "The position of the light; for an area light, its center.", {}, pos_attributes},
    {"type", "What kind of light this is. Default point.", {}, type_attributes},
    {"direction",
     "The direction in which the light travels, of any length but 0: from the light, not toward "
     "it.",
     {},
     pos_attributes},
    {"angle",
     "The half-angle of a spotlight's cone: from its axis to its edge.",
     {},
     angle_attributes},
    {"penumbra",
     "How far inside the edge of its cone a spotlight begins to fall off.",
     {},
     penumbra_attributes},
    {"width", "The width of an area light.", {}, width_attributes},
    {"height", "The height of an area light.", {}, width_attributes},
    {"object",
     "A tree at the top of the file. The one named root is what is drawn and comes last; the "
     "others are masters, drawn where an object of type master uses them by name.",
     parts_of_object, object_attributes},
    {"transblock",
     "One object and how it is placed: any number of transformations, then exactly one object, "
     "then nothing. The last transformation acts first.",
     parts_of_transblock,
     {}},
    {"translate", "Moves.", {}, translate_attributes},
    {"rotate",
     "Rotates about an axis through the origin, counterclockwise if the axis points at you.",
     {},
     rotate_attributes},
    {"scale", "Scales about the origin. Negative factors mirror.", {}, scale_attributes},
    {"matrix",
     "A 4x4 matrix, four rows from top to bottom. A translation is the last column; the last row "
     "is 0 0 0 1.",
     parts_of_matrix,
     {}},
    {"row",
     "A row of the matrix. Its numbers are named a b c d or v1 v2 v3 v4.",
     {},
     row_attributes},
    {"row0",
     "A row of the matrix. Its numbers are named a b c d or v1 v2 v3 v4.",
     {},
     row_attributes},
    {"row1",
     "A row of the matrix. Its numbers are named a b c d or v1 v2 v3 v4.",
     {},
     row_attributes},
    {"row2",
     "A row of the matrix. Its numbers are named a b c d or v1 v2 v3 v4.",
     {},
     row_attributes},
    {"row3",
     "A row of the matrix. Its numbers are named a b c d or v1 v2 v3 v4.",
     {},
     row_attributes},
    {"diffuse", "The color of the surface in direct light. Default 1 1 1.", {}, diffuse_attributes},
    {"ambient",
     "The color of the surface without any light. Default 0 0 0.",
     {},
     diffuse_attributes},
    {"specular",
     "The color of highlights; needs a shininess above 0. Default 0 0 0.",
     {},
     diffuse_attributes},
    {"reflective",
     "How much of each color the surface mirrors. Default 0 0 0.",
     {},
     diffuse_attributes},
    {"transparent",
     "How much of each color passes through. Default 0 0 0.",
     {},
     diffuse_attributes},
    {"shininess",
     "The exponent of highlights: the larger, the smaller and sharper. Default 0: no highlight.",
     {},
     shininess_attributes},
    {"ior",
     "The index of refraction of a transparent object. Default 1: light passes straight through.",
     {},
     ior_attributes},
    {"bumpmap", "An image whose brightness is the height of the surface.", {}, bumpmap_attributes},
    {"blend",
     "The share of the texture in the diffuse color. Default 0: the texture is not visible.",
     {},
     blend_attributes},
    {"texture",
     "An image on the surface. Needs a blend above 0 to be visible.",
     {},
     bumpmap_attributes}};

constexpr KeyWord keys_of_scene[] = {
    {"name", "The name of the scene. It has no effect.", {}, "", "\"my scene\""},
    {"globalData",
     "Coefficients that scale the terms of the lighting equation in the whole scene.",
     {},
     "globalData",
     "{}"},
    {"cameraData", "The position and direction of the camera.", {}, "cameraData", "{}"},
    {"templateGroups",
     "Groups that are drawn wherever a group has their name. A template can use the templates "
     "before it.",
     {},
     "templateGroup",
     "[]"},
    {"groups", "Everything that is drawn, and all lights.", {}, "group", "[]"}};
constexpr KeyWord keys_of_globalData[] = {
    {"ambientCoeff",
     "Scales the ambient color of every primitive. Usually from 0 to 1.",
     {},
     "",
     "0.5"},
    {"diffuseCoeff",
     "Scales the diffuse color of every primitive, but not its texture. Usually from 0 to 1.",
     {},
     "",
     "0.5"},
    {"specularCoeff",
     "Scales the specular and the reflected color of every primitive. Usually from 0 to 1.",
     {},
     "",
     "0.5"},
    {"transparentCoeff",
     "Scales the light that passes through transparent primitives. Write it if anything is "
     "transparent: programs differ in the default, 0 or 0.5.",
     {},
     "",
     "0.5"}};
constexpr KeyWord keys_of_cameraData[] = {
    {"position", "Where the camera is: x, y, z.", {}, "", "[5,5,5]"},
    {"look",
     "The direction in which the camera looks, of any length. Give look or focus, not both.",
     {},
     "",
     "[-1,-1,-1]"},
    {"focus",
     "The point at which the camera looks. Give focus or look, not both.",
     {},
     "",
     "[0,0,0]"},
    {"up",
     "The direction that is up in the picture, of any length; not parallel to the direction of "
     "view.",
     {},
     "",
     "[0,1,0]"},
    {"heightAngle",
     "The full vertical angle of view in degrees, above 0 and below 180. 30 to 60 are common.",
     {},
     "",
     "45"},
    {"aperture",
     "The size of the lens in world units, for depth of field. 0: everything is sharp.",
     {},
     "",
     "0"},
    {"focalLength",
     "The distance of the plane in focus in world units, for depth of field. 0: everything is "
     "sharp.",
     {},
     "",
     "0"}};
constexpr KeyWord keys_of_group[] = {
    {"name",
     "A name for readers of the file. If a template group has the same name, the group is an "
     "instance of it, and must contain nothing else: to place an instance, put it into a group "
     "with the transforms.",
     {},
     "",
     "\"chair\""},
    {"translate",
     "Moves the group by x, y, z. Acts after scale and rotate, whatever the order of the keys.",
     {},
     "",
     "[0,1,0]"},
    {"rotate",
     "Rotates the group: x, y, z of the axis, which is not 0 0 0, then degrees, counterclockwise "
     "if the axis points at you. Acts after scale and before translate.",
     {},
     "",
     "[0,1,0,90]"},
    {"scale",
     "Scales the group along x, y, z by factors other than 0; negative ones mirror. Acts before "
     "rotate and translate.",
     {},
     "",
     "[1,1,1]"},
    {"matrix",
     "A 4x4 matrix, row by row. A translation is the last column; the last row is 0 0 0 1. Acts "
     "before scale, rotate and translate; some programs do not accept it next to other transforms.",
     {},
     "",
     "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"},
    {"lights",
     "Lights at the origin of the group; its transforms move and rotate them.",
     {},
     "light",
     "[]"},
    {"primitives",
     "Shapes about the origin of the group; its transforms place them.",
     {},
     "primitive",
     "[]"},
    {"groups",
     "Groups in this group; their own transforms act first, then those of this group.",
     {},
     "group",
     "[]"}};
constexpr KeyWord keys_of_light[] = {
    {"type",
     "point: from the origin of the group in all directions. directional: parallel light from "
     "infinitely far away. spot: from the origin of the group into a cone. area: from a rectangle "
     "about the origin of the group; the course's reader rejects it.",
     type_values, "", ""},
    {"name", "A name for readers of the file.", {}, "", ""},
    {"color",
     "Red, green, blue: 0 none, 1 full; above 1 for a bright light with attenuation.",
     {},
     "",
     "[1,1,1]"},
    {"attenuationCoeff",
     "The attenuation of the light: it is divided by c + l d + q d^2, where d is the distance, for "
     "[c, l, q]. [1, 0, 0] means no attenuation. No effect on a directional light.",
     {},
     "",
     "[1,0,0]"},
    {"direction",
     "The direction in which the light travels, of any length but 0: from the light, not toward "
     "it. No effect on a point light.",
     {},
     "",
     "[0,-1,0]"},
    {"penumbra",
     "How many degrees inside the edge of its cone a spotlight begins to fall off: from 0 (a hard "
     "edge) to the angle.",
     {},
     "",
     "5"},
    {"angle",
     "The half-angle of a spotlight's cone in degrees, from its axis to its edge, above 0 and up "
     "to 180.",
     {},
     "",
     "30"},
    {"width", "The width of an area light in world units, above 0.", {}, "", "1"},
    {"height", "The height of an area light in world units, above 0.", {}, "", "1"}};
constexpr KeyWord keys_of_primitive[] = {
    {"type", "cube, cone (its tip at y = 0.5), cylinder, sphere, or mesh, which needs meshFile.",
     shape_values, "", ""},
    {"meshFile",
     "The OBJ file of a mesh, relative to the folder of the scene.",
     {},
     "",
     "\"meshes/teapot.obj\""},
    {"ambient",
     "The color of the surface without any light: red, green, blue from 0 to 1.",
     {},
     "",
     "[0,0,0]"},
    {"diffuse",
     "The color of the surface in direct light: red, green, blue from 0 to 1.",
     {},
     "",
     "[1,1,1]"},
    {"specular",
     "The color of highlights: red, green, blue from 0 to 1. Needs a shininess above 0.",
     {},
     "",
     "[0,0,0]"},
    {"reflective",
     "How much of each color the surface mirrors: red, green, blue from 0 to 1.",
     {},
     "",
     "[0,0,0]"},
    {"transparent",
     "How much of each color passes through: red, green, blue from 0 to 1.",
     {},
     "",
     "[0,0,0]"},
    {"shininess",
     "The exponent of highlights: the larger, the smaller and sharper. 0: no highlight; 1 to 200 "
     "are common.",
     {},
     "",
     "25"},
    {"ior",
     "The index of refraction of a transparent primitive: 1.33 for water, 1.5 for glass, 2.4 for "
     "diamond. Default 1: light passes straight through.",
     {},
     "",
     "1"},
    {"blend",
     "The share of the texture in the diffuse color, from 0, only the color, to 1, only the "
     "texture.",
     {},
     "",
     "0"},
    {"textureFile",
     "An image on the surface, relative to the folder of the scene. Needs a blend above 0 to be "
     "visible.",
     {},
     "",
     "\"textures/wood.png\""},
    {"textureU", "How often the texture repeats around the shape.", {}, "", "1"},
    {"textureV", "How often the texture repeats from bottom to top.", {}, "", "1"},
    {"bumpMapFile",
     "An image whose brightness is the height of the surface, relative to the folder of the scene.",
     {},
     "",
     "\"textures/bumps.png\""},
    {"bumpMapU", "How often the bump map repeats around the shape.", {}, "", "1"},
    {"bumpMapV", "How often the bump map repeats from bottom to top.", {}, "", "1"}};

constexpr ObjectWord objects[] = {{"", keys_of_scene},
                                  {"globalData", keys_of_globalData},
                                  {"cameraData", keys_of_cameraData},
                                  {"group", keys_of_group},
                                  {"templateGroup", keys_of_group},
                                  {"light", keys_of_light},
                                  {"primitive", keys_of_primitive}};

template <typename T>
const T* find_word(std::span<const T> words, std::string_view name) {
  const auto found =
      std::find_if(words.begin(), words.end(), [&](const T& word) { return word.name == name; });
  return found == words.end() ? nullptr : &*found;
}

}  // namespace

std::span<const ElementWord> element_words() {
  return elements;
}

std::span<const ObjectWord> object_words() {
  return objects;
}

const ElementWord* find_element(std::string_view name) {
  return find_word(element_words(), name);
}

const AttributeWord* find_attribute(const ElementWord& element, std::string_view name) {
  return find_word(element.attributes, name);
}

const ObjectWord* find_object(std::string_view name) {
  return find_word(object_words(), name);
}

const KeyWord* find_key(const ObjectWord& object, std::string_view name) {
  return find_word(object.keys, name);
}

}  // namespace scenefile
