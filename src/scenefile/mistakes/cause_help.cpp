#include "scenefile/mistakes/cause_help.h"

#include <fmt/format.h>

#include <array>

namespace scenefile {

namespace {

constexpr std::array<CauseHelp, cause_count> pages{{
    {Cause::vertical_flip, "The picture is upside down",
     "Top and bottom are exchanged; nothing else differs.",
     "Row 0 of a picture is its top row, and y of the film grows upward.",
     "Where the row of a pixel is converted to a height on the film plane."},
    {Cause::horizontal_flip, "The picture is mirrored",
     "Left and right are exchanged, as in a mirror.",
     "The camera's right axis has the wrong sign: the factors of a cross product are swapped, or "
     "left-handed and right-handed are mixed up.",
     "Where the camera's axes are computed, and where the column of a pixel is converted to a "
     "position on the film plane."},
    {Cause::gamma, "Gamma",
     "Everything is paler (or darker) than it should be; black and full brightness are right.",
     "The format has no gamma correction: values are stored unchanged.",
     "Where colors become bytes, and where a library writes the file: some convert to sRGB "
     "automatically."},
    {Cause::rounding, "Rounding",
     "Values are off by one, all in the same direction. The difference is invisible.",
     "The references truncate; others round. This is not a mistake by itself.",
     "Nothing to fix, unless the bytes must be equal."},
    {Cause::swapped_channels, "Channels in the wrong order",
     "Red objects are blue, or another permutation of the channels; gray stays gray.",
     "Some libraries expect blue, green, red, or four values per pixel.",
     "Where a color becomes bytes, and how a pixel of a texture is read."},
    {Cause::half_pixel_shift, "Rays that miss the centers of pixels",
     "Edges are half a pixel off; areas are right.",
     "A pixel covers an area, and its ray goes through the center of that area.",
     "Where the row and column of a pixel become a position on the film plane; add 0.5 to both."},
    {Cause::ambient, "The ambient term",
     "Areas in shadow are black, or everything is too bright by the same amount.",
     "The ambient term is added once for each hit, with the global coefficient, independent of the "
     "lights.",
     "The lighting equation: what is before the loop over the lights, and what is inside it."},
    {Cause::diffuse, "The diffuse term",
     "Matte colors are missing, too bright, or on the wrong side of objects.",
     "The term is kd times the color times max(0, N.L); N and L are unit vectors.",
     "The lighting equation: coefficients, the dot product, and what happens below 0."},
    {Cause::specular, "The specular term",
     "Highlights are missing, in the wrong place, too large, too small, or too bright.",
     "The term is ks times the specular color times (R.V)^n: R is L reflected about N, and V "
     "points to the origin of the ray.",
     "The lighting equation: the signs of R and V, the exponent, the coefficient."},
    {Cause::blinn, "Blinn's highlights instead of Phong's",
     "Highlights are wider than they should be, and long at grazing angles.",
     "The equation has Phong's (R.V)^n. The half vector belongs to another model, Blinn-Phong.",
     "Which vectors the specular term multiplies."},
    {Cause::attenuation, "Attenuation of lights",
     "Distant surfaces are too bright or too dark; near ones may be too bright.",
     "Point lights and spotlights are multiplied by min(1, 1 / (c + l d + q d^2)), with the "
     "coefficients "
     "of the file; directional lights have no attenuation.",
     "Which coefficient belongs to which power of the distance, how the distance is measured, and "
     "the clamp to 1."},
    {Cause::normals, "Normals",
     "Shading is wrong on objects that are scaled or turned, and right on others; or all objects "
     "are lit from the wrong side.",
     "Normals are transformed to world space by the inverse transpose of the upper-left 3x3 "
     "matrix, and then normalized.",
     "Where normals are transformed to world space, and the normals of each shape."},
    {Cause::shadows, "Shadows", "Shadows are missing, too many, too dark, or where none should be.",
     "A light contributes unless the shadow ray hits something between the surface and the light. "
     "Each light is tested separately; the ambient term is never in shadow.",
     "The direction, the start and the end of the shadow ray, what is compared with the distance "
     "of "
     "the light, and what the loop over the lights does after a shadow."},
    {Cause::acne, "Shadow acne",
     "Dark specks or rings on surfaces that should be lit; flat faces may be dark all over.",
     "Rays that start on a surface hit the same surface again because of rounding errors.",
     "The start of shadow rays and reflected rays: offset it a little from the surface."},
    {Cause::texture, "Textures",
     "The image is upside down, mirrored, not repeated, missing, or too dark or too bright.",
     "u and v are computed in the object's space; v grows upward, rows of images grow downward; "
     "the "
     "texture is blended with the diffuse color, and is not multiplied by kd.",
     "The u and v of each shape and face, how they become a pixel of the image, and how its color "
     "goes into the diffuse term."},
    {Cause::recursion_depth, "Recursion depth of reflections",
     "Mirrors reflect nothing, turn black where they show other mirrors, or show too many "
     "reflections.",
     "The references follow four reflections in a row.",
     "Where the recursion starts and ends, and whether the count starts at 0 or 1."},
    {Cause::spot_falloff, "Spotlights",
     "The cone of light is too wide or too narrow, or its edge is too hard or too soft.",
     "angle is measured from the axis to the edge of the cone; the penumbra is inside of it; "
     "within the penumbra, the light falls off by the smoothstep of the angle.",
     "Which angles are inner and outer, half or full, degrees or radians; and the polynomial."},
    {Cause::camera, "The camera",
     "Everything is too large, too small, stretched, or seen from elsewhere.",
     "The height angle is the full vertical field of view; the width follows from the aspect "
     "ratio, which multiplies the tangent, not the angle. The camera looks along -w; up is made "
     "perpendicular to it.",
     "Half angles and their tangents, degrees and radians, the aspect ratio, and the three axes."},
    {Cause::transforms, "Transforms",
     "Objects are in the wrong place, turned the wrong way, or of the wrong size.",
     "The transforms of a transblock are multiplied in the order of the file, with those of outer "
     "transblocks on the left; angles are in degrees, matrices are listed row by row.",
     "The order of each product, degrees and radians, rows and columns (glm is column-major), and "
     "what is passed down to children."},
    {Cause::shapes, "Shapes",
     "Objects have holes, are missing, have the wrong size, or are shaded like other shapes.",
     "All shapes fit into a cube of side 1 around the origin; cylinders have two caps, cones one.",
     "The intersection of each shape: its size, its limits in y, its caps, its normal."},
    {Cause::nearest_hit, "The nearest hit", "Objects in the back are drawn over objects in front.",
     "The nearest of all hits in front of the camera counts; t is measured along the world-space "
     "ray.",
     "What is compared between objects, and in which space it is measured."},
    {Cause::lights, "Lights",
     "Light comes from the wrong side, is missing, too bright or too dark, or has the wrong color.",
     "Directional lights have a direction of travel; point lights and spotlights a position. "
     "Vectors in the lighting equation point to the light and have unit length.",
     "How each type of light is read, the sign and length of its vector, and the loop over all."},
    {Cause::reflection, "Combining reflections",
     "Mirrors are too bright, too dark, have the wrong color, or show the wrong objects.",
     "A reflection adds ks times the reflective color times the color of the reflected ray. "
     "Weights multiply from bounce to bounce; the eye of a reflection is where its ray starts.",
     "What the color of the reflected ray is multiplied by, what it is added to, and what the "
     "recursion passes on."},
    {Cause::refraction, "Refraction",
     "Glass shows nothing, or shows the background in the wrong place.",
     "Snell's law: on the way in, the ratio is 1 / ior, on the way out, ior; if the argument of "
     "the square root is negative, all light is reflected (total internal reflection).",
     "The ratio, the side of the normal, and the start of the ray inside."},
    {Cause::overflow, "Values over 1",
     "Bright areas have dark or colored rings, or the whole picture is too dark.",
     "A byte holds 0 to 255; larger values must be clamped before the conversion.",
     "Where colors become bytes."},
    {Cause::background, "The background", "Pixels where the ray hits nothing are not black.",
     "The references are black there, with full opacity.", "What a ray that hits nothing returns."},
    {Cause::brightness, "The whole picture is too dark, too bright, or gray",
     "Every value is off by the same factor or amount, or the picture is gray, tinted or a "
     "negative.",
     "Something changes all colors: samples that are counted but not taken, 256 instead of 255, a "
     "factor on the lights.",
     "Where colors are averaged and become bytes."},
    {Cause::black, "Nothing is drawn, or only a part of the picture",
     "The picture, or some of its rows or columns or a rectangle in it, is black or has a single "
     "color.",
     "No ray hits anything, all values are NaN, or the picture is never filled: a loop ends early "
     "or skips rows.",
     "Compute the direction of the ray through the center by hand; then the first intersection; "
     "then what is stored. 'scenefile explain' shows all of it for a pixel."},
    {Cause::features, "Different features than the reference",
     "Lights, shadows, reflections or textures are drawn that the reference does not show, or the "
     "reverse; or normals are drawn as colors.",
     "Each project has its own references: those of Intersect have only directional lights, and no "
     "shadows, reflections or textures. The ray tracer may be right.",
     "The settings of your program, and which folder of references belongs to them."},
    {Cause::samples, "Combining the samples of a pixel",
     "A black line around objects, everything too bright, the whole picture blurred, or, in Path, "
     "noise that repeats from pixel to pixel.",
     "A pixel is the mean of its samples; a sample that hits nothing is black, and counts like the "
     "others. Random numbers differ from pixel to pixel.",
     "Where the samples of a pixel are added, what is done when a ray hits nothing, and where the "
     "random numbers are seeded."},
    {Cause::scene_edited, "Another scene file",
     "An object, a light or the camera is elsewhere, or has another color, size or angle; all else "
     "follows from that: shadows, highlights, reflections.",
     "The picture was drawn from a copy of the scene file in which a value was changed, or the "
     "program reads that value wrongly.",
     "The named line of the scene file, and the same line in the file that the picture was drawn "
     "from. If they are equal: where the program reads that value, and what it does with it "
     "before the first ray."},
    {Cause::tessellation, "Tessellation (Realtime)",
     "Outlines have other corners than in the reference, shading bends at other edges, or parts of "
     "shapes are missing.",
     "Parameter 1 counts rings, stacks and tiles, parameter 2 the wedges about the y axis. The "
     "first wedge begins at the x axis; shapes have a radius of 0.5.",
     "Where the sliders are read, whether shapes are rebuilt when they move, and the loops that "
     "make vertices. docs/realtime.md gives the rule for each shape."},
    {Cause::facets, "Flat facets instead of smooth shading (Realtime)",
     "Each triangle of a sphere, cone or cylinder has one color, or highlights are blurred and "
     "bend at edges.",
     "Vertices have the normal of the exact shape; it is interpolated over the triangle, "
     "normalized, and used for lighting in each pixel.",
     "Where vertex normals are made, the qualifier flat in the shaders, and whether lighting is "
     "in the vertex or the fragment shader."},
    {Cause::culling, "Culling and winding (Realtime)",
     "The inside of shapes is visible where they are cut, or sides and caps are missing.",
     "Back faces are culled: triangles are counterclockwise, seen from outside.",
     "glEnable(GL_CULL_FACE), and the order of the corners where triangles are made."},
    {Cause::clipping, "Near and far planes (Realtime)",
     "Shapes are cut at another depth than in the reference, or not at all.",
     "The planes of the settings are depths along the view axis; what is nearer or farther is "
     "clipped.",
     "The projection matrix, and whether it is updated when the sliders move."},
    {Cause::filter, "Filters (Realtime)",
     "The picture is not filtered, too bright, shifted, or blurred too little or too much.",
     "The weights of a kernel add up to 1, samples are one texel of the frame apart and centered "
     "at the pixel. What they read beyond the border depends on the wrap mode of the texture.",
     "The fragment shader of the second pass: the size of the kernel, its divisor, the distance of "
     "samples, and the order of rows and columns."},
    {Cause::viewport, "Viewport and frame",
     "The scene is smaller, larger, stretched or shifted, only a quarter of it is shown, or its "
     "pixels are in another order: transposed, turned or skewed. Its content is right.",
     "What is drawn must fill the picture, pixel for pixel. In Realtime, the viewport must be as "
     "large as the framebuffer; its references were drawn in a window of 1092 x 818 pixels, which "
     "determines their aspect ratio, so other windows give other pictures.",
     "In a ray tracer, the width and height of picture and buffer, and the index of a pixel; in "
     "Realtime, glViewport before each pass, the sizes of framebuffer and textures, and the aspect "
     "ratio of the projection; in both, the device pixel ratio."},
    {Cause::light_samples, "Light samples (Path)",
     "All reflected light has a wrong factor, walls near the lamp are too bright or too dark, or "
     "there are no shadows; the lamp itself is right.",
     "A point on a lamp contributes Le times the BSDF, the cosines at both ends and the "
     "visibility, "
     "divided by the square of the distance and by the density of the point: the probability of "
     "its triangle divided by the area.",
     "Where points on lamps are chosen, what their light is multiplied with and divided by, the "
     "ends of the shadow ray, and the mean over several samples. A lamp that is hit by chance must "
     "not count again."},
    {Cause::scattering, "Scattered directions (Path)",
     "Indirect light is too bright or too dark, by a factor for each bounce, or at grazing angles, "
     "or has the wrong color.",
     "The weight of a path is a color. It is multiplied by the BSDF and the cosine, and divided by "
     "the density of the direction. Diffuse surfaces have Kd / pi; with directions distributed by "
     "the cosine, what remains is Kd.",
     "The function that chooses a direction, the density that belongs to it, 1 / pi, and whether "
     "the weight has three channels."},
    {Cause::path_length, "Ends of paths (Path)",
     "Light after some bounce is missing, each bounce is darker by the same factor, lamps are "
     "black "
     "in mirrors, or there are no caustics.",
     "A path that goes on with probability p is divided by p. Lamps that are hit count after the "
     "camera, mirrors and glass, where light samples cannot find them.",
     "The recursion: where it ends, what it is divided by, and when emission is added."},
    {Cause::specular_paths, "Mirrors and glass (Path)",
     "Mirrors or glass are too dark or too bright, glass shows the room upside down or not at all, "
     "and its caustics are wrong; the rest is right.",
     "Mirrors and glass have one direction: no cosine, no density. Glass chooses reflection or "
     "refraction with a probability, which cancels the same factor of Fresnel's equations.",
     "Which side the ray comes from, the ratio of the indices, total internal reflection, and what "
     "the choice is divided by."},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (pages[i].cause != static_cast<Cause>(i)) {
      return false;
    }
  }
  return true;
}
static_assert(in_order());

}  // namespace

const CauseHelp& help_of(Cause cause) {
  return pages[static_cast<std::size_t>(cause)];
}

std::optional<Cause> find_cause(std::string_view name) {
  for (const CauseHelp& page : pages) {
    if (name_of(page.cause) == name) {
      return page.cause;
    }
  }
  return std::nullopt;
}

std::string causes_markdown() {
  std::string text =
      "# Mistakes that scenefile knows\n"
      "\n"
      "`scenefile diff REFERENCE MINE --scene SCENE` names one of these if simulating it "
      "reproduces the picture.\n"
      "`scenefile help NAME` prints one of these pages. This file is generated by `scenefile help "
      "causes --markdown`.\n";
  for (const CauseHelp& page : pages) {
    text += fmt::format(
        "\n## {0}\n\n`{1}`\n\n{2}- What it looks like: {3}\n- Why: {4}\n- Where to look: {5}\n",
        page.title, name_of(page.cause),
        page.cause == Cause::rounding || page.cause >= Cause::light_samples
            ? std::string()  // nobody would see it, at this size
            : fmt::format("![Right, and with the mistake](images/mistakes/{}.png)\n\n",
                          name_of(page.cause)),
        page.looks, page.why, page.where);
  }
  return text;
}

}  // namespace scenefile
