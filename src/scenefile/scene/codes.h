#pragma once
// The findings of check().

#include "scenefile/base/code.h"

namespace scenefile {

inline constexpr Code scene_codes[] = {
    {"scene.bad-index", Severity::error, "a node that does not exist",
     "Scene::root, Scene::templates and Node::children hold indices into Scene::nodes. Files "
     "cannot cause this; a program that edits scenes can, by erasing nodes. Leave unused nodes in "
     "place, or renumber."},
    {"scene.shared-node", Severity::error, "a node with two parents",
     "Every node is the root, a template, or the child of exactly one node. To draw a part twice, "
     "make it a template and add a node with instance_of for each copy."},
    {"scene.not-finite", Severity::error, "a value that is not a finite number",
     "Infinity and NaN spread to every pixel they touch. Files cannot cause this; a computation in "
     "a program can."},
    {"scene.empty", Severity::warning, "nothing to draw",
     "The root contains no primitive, neither directly nor through templates. The picture will be "
     "black.",
     CodeKind::absence},
    {"scene.no-light", Severity::warning, "no light shines",
     "Without a light only the ambient term is left: no highlights, no shading, no shadows. Lights "
     "with a black color do not count. Add a light, or raise the ambient colors if this is "
     "intended.",
     CodeKind::absence},

    {"global.negative", Severity::warning, "a negative coefficient",
     "The coefficients scale the terms of the lighting equation and are usually between 0 and 1. A "
     "negative one subtracts light. It is used as written."},
    {"global.huge", Severity::warning, "a coefficient that is far too large",
     "The coefficients scale the terms of the lighting equation and are usually between 0 and 1. "
     "With this one, every lit pixel is white or saturated. It is used as written."},
    {"global.transparent-default", Severity::warning,
     "a transparent material, but no transparentcoeff",
     "Programs disagree about a missing transparentcoeff: it is 0 with --profile course (then "
     "nothing is transparent) and 0.5 with --profile fine. Write it in the global data (JSON: "
     "transparentCoeff) to be safe."},

    {"camera.look-zero", Severity::error, "a camera without a view direction",
     "look is the direction of view, focus a point to look at. The direction is zero if look is 0 "
     "0 0, or if focus is the same point as pos."},
    {"camera.up-zero", Severity::error, "a camera without an up direction",
     "up says which direction is up in the picture and must not be 0 0 0. 0 1 0 is the usual "
     "choice."},
    {"camera.up-parallel-to-look", Severity::error, "the camera looks along its up direction",
     "If look is parallel to up, the camera could be rotated any way about that axis. Choose an up "
     "that points elsewhere; to look straight down, use 0 0 -1, for example."},
    {"camera.up-nearly-parallel", Severity::warning,
     "the camera looks almost along its up direction",
     "Rounding then decides how the picture is rotated. Choose an up that points elsewhere."},
    {"camera.height-angle", Severity::error, "an impossible height angle",
     "heightangle (JSON: heightAngle) is the full vertical angle of view in degrees, above 0 and "
     "below 180. 30 to 60 are common."},
    {"camera.far-away", Severity::warning, "a camera very far from the origin",
     "Single precision has 7 digits: at this distance it cannot distinguish points of the scene, "
     "and the picture breaks up or shows nothing."},
    {"camera.lens-negative", Severity::warning, "a negative lens value",
     "aperture and focallength (JSON: focalLength) are lengths. A negative value counts as 0, a "
     "pinhole: everything is sharp."},
    {"camera.lens-incomplete", Severity::warning, "an aperture without a focal length",
     "Depth of field needs both: aperture, the size of the lens, and focallength (JSON: "
     "focalLength), the distance of the plane in focus. With only one of them everything is "
     "sharp."},

    {"light.many", Severity::warning, "more than 8 lights",
     "The format allows up to 8 lights, and many programs use only 8. All are used here. A light "
     "in a template counts once for each instance."},
    {"light.count-limit", Severity::error, "too many lights",
     "Every lit point considers every light. The limit keeps a faulty or malicious file from "
     "taking hours; it can be raised. A light in a template counts once for each instance.",
     CodeKind::limit},
    {"light.duplicate-id", Severity::warning, "two lights with the same id",
     "Programs that store lights by id keep only one of them. All are used here."},
    {"light.id-range", Severity::warning, "a light id outside 0 to 7",
     "The format numbers lights from 0 to 7, and some programs use the id as an index. It has no "
     "effect here."},
    {"light.direction-zero", Severity::error, "a light without a direction",
     "Directional, spot and area lights need a direction other than 0 0 0: the direction in which "
     "their light travels."},
    {"light.function-zero", Severity::warning, "an attenuation function of zeros",
     "The light is divided by v1 + v2 d + v3 d^2, where v1, v2 and v3 are the values of function "
     "(JSON: attenuationCoeff) and d is the distance. All zeros would divide by zero; they count "
     "as 1 0 0, no attenuation."},
    {"light.function-negative", Severity::warning, "a negative attenuation coefficient",
     "The light is divided by v1 + v2 d + v3 d^2, where v1, v2 and v3 are the values of function "
     "(JSON: attenuationCoeff) and d is the distance. A negative coefficient counts as 0."},
    {"light.color-negative", Severity::warning, "a light of negative color",
     "Such a light subtracts light. It is used as written."},
    {"light.color-huge", Severity::warning, "a light that is far too bright",
     "Full intensity is 1. Values above 1 are fine for a light that is attenuated, but this one "
     "saturates everything it reaches. Values up to 255 come from other formats: divide them by "
     "255."},
    {"light.spot-without-angle", Severity::warning, "a spotlight without an angle",
     "angle is the half-angle of the cone in degrees; inside it, the light falls off over the last "
     "penumbra degrees. Without angle, penumbra counts as the half-angle, and the light falls off "
     "from the axis."},
    {"light.angle-range", Severity::warning, "an impossible spotlight angle",
     "angle is the half-angle of the cone in degrees, above 0 and up to 180 (90 lights half of "
     "space). A smaller angle lights nothing, a larger one counts as 180."},
    {"light.penumbra-negative", Severity::warning, "a negative penumbra",
     "penumbra is how many degrees inside the cone the light takes to fall off. A negative value "
     "counts as 0: a hard edge."},
    {"light.penumbra-over-angle", Severity::warning, "a penumbra wider than the cone",
     "penumbra must not exceed angle. A larger value counts as angle: the light falls off from the "
     "axis."},
    {"light.area-without-size", Severity::warning, "an area light without an area",
     "width and height of an area light must be above 0. Without both it lights like a point or a "
     "line, with hard shadows."},

    {"transform.axis-zero", Severity::warning, "a rotation without an axis",
     "rotate needs an axis other than 0 0 0. Without one, nothing is rotated."},
    {"transform.flat", Severity::warning, "a transform that flattens",
     "A scale by 0, or a matrix without an inverse, leaves no volume and no normals to shade with. "
     "Objects inside are not drawn. For a thin plate, scale by a small number such as 0.001."},
    {"transform.degenerate", Severity::warning, "transforms that are degenerate when combined",
     "Each transform is fine by itself, but their product is too large, too small or too skewed "
     "for single precision; or a single one scales by 1e30 or 1e-30. Objects inside are not "
     "drawn."},
    {"transform.matrix-projective", Severity::warning, "a matrix with an unusual last row",
     "Files list a matrix row by row, with the translation in the last column; the last row is 0 0 "
     "0 1. Any other last row is ignored. If the translation is in the last row, the matrix is "
     "transposed (written column by column)."},

    {"material.color-negative", Severity::warning, "a negative color",
     "Colors go from 0 to 1. A negative value subtracts light. It is used as written."},
    {"material.color-255", Severity::warning, "a color that looks like 0 to 255",
     "Colors go from 0 to 1, not to 255. Divide by 255. It is used as written."},
    {"material.color-huge", Severity::warning, "a color that is far too large",
     "Colors go from 0 to 1. With this one, every lit pixel is saturated. It is used as written."},
    {"material.shininess-negative", Severity::warning, "a negative shininess",
     "shininess is the exponent of the highlight: larger values give smaller, sharper highlights. "
     "A negative value counts as 0: no highlight."},
    {"material.shininess-huge", Severity::warning, "a highlight too small to see",
     "shininess is the exponent of the highlight: larger values give smaller, sharper highlights. "
     "1 to 200 are common; above several thousand the highlight is smaller than a pixel."},
    {"material.specular-without-shininess", Severity::warning, "a specular color without effect",
     "shininess is the exponent of the highlight, and 0 means no highlight. Programs that compute "
     "x^0 = 1 instead paint the whole surface with the specular color. Set shininess, or remove "
     "specular."},
    {"material.ior-negative", Severity::warning, "a negative index of refraction",
     "ior is 1 for air, 1.33 for water, 1.5 for glass, 2.4 for diamond. A negative value counts as "
     "1: light passes straight through."},
    {"material.ior-unusual", Severity::warning, "an unusual index of refraction",
     "ior is 1 for air, 1.33 for water, 1.5 for glass, 2.4 for diamond, and may go down to one "
     "half for a bubble of air in a denser medium. It is used as written."},
    {"material.blend-range", Severity::warning, "a blend outside 0 to 1",
     "blend is the share of the texture in the diffuse color: 0 none, 1 only the texture. Values "
     "outside are clamped."},
    {"material.texture-without-blend", Severity::warning, "a texture that is not visible",
     "blend is the share of the texture in the diffuse color, and 0 by default. Set it to 1 to see "
     "only the texture."},
    {"material.blend-without-texture", Severity::note, "a blend without a texture",
     "blend mixes a texture with the diffuse color. Without a texture it has no effect."},
    {"material.texture-without-file", Severity::warning, "a texture without a file",
     "texture and bumpmap need the name of an image (XML: file, JSON: textureFile, bumpMapFile). "
     "Without one there is no texture."},
    {"material.repeat", Severity::warning, "a texture that repeats oddly",
     "u and v (JSON: textureU, textureV) say how often the image repeats across the surface; 1 is "
     "once. With 0, or close to it, the surface takes the color of one edge of the image; a "
     "negative value mirrors it; a huge one looks like noise, and counts as 10000."},
    {"material.reflective-and-transparent", Severity::warning,
     "reflective and transparent together above 1",
     "Reflected light (reflective times specularcoeff) and transmitted light (transparent times "
     "transparentcoeff) are added. If they exceed 1, the surface returns more light than it "
     "receives, and looks washed out."},

    {"tree.mesh-without-file", Severity::error, "a mesh without a file",
     "A primitive of type mesh needs the name of an OBJ file: filename or meshfile (JSON: "
     "meshFile)."},
    {"tree.template-without-name", Severity::error, "a template without a name",
     "Templates (XML: masters, JSON: template groups) are used by name, so each needs one."},
    {"tree.duplicate-template", Severity::error, "two templates with the same name",
     "Templates (XML: masters, JSON: template groups) are used by name. With two of the same name "
     "it is unclear which one is meant, and programs differ. Rename one."},
    {"tree.unknown-template", Severity::error, "an instance of an unknown template",
     "Only templates (XML: masters, JSON: template groups) that the file declares can be used. "
     "Names are compared exactly, including case."},
    {"tree.loop", Severity::error, "a template that contains itself",
     "A template that contains an instance of itself, directly or through others, would never "
     "end."},
    {"tree.used-before-declared", Severity::warning, "a template used before its declaration",
     "Declare a template before its first use: other programs read the file once from the top and "
     "reject it. It is used anyway."},
    {"tree.instance-with-contents", Severity::warning, "contents inside an instance",
     "An instance is a copy of its template and nothing else; its other contents are ignored. Put "
     "both into a group."},
    {"tree.unused-template", Severity::note, "a template that is never used",
     "Nothing in the scene instantiates it, so it is not drawn.", CodeKind::absence},
    {"tree.nesting-limit", Severity::error, "templates nested too deeply",
     "Templates can contain instances of other templates. The limit on nesting keeps rendering "
     "within its memory; it can be raised.",
     CodeKind::limit},
};

template <CodeName name>
constexpr const Code& operator""_code() requires(code_index(scene_codes, name) <
                                                 std::size(scene_codes)) {
  constexpr std::size_t index = code_index(scene_codes, name);
  return scene_codes[index];
}

}  // namespace scenefile
