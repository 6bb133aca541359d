// The lighting equation of docs/rendering.md, evaluated at one pixel.
//
// The triangles of round shapes only mark where the surface is: the point is moved along the ray of
// the pixel to the exact surface, and normal and uv are computed there.
//
// For small round shapes, the ray must be one that hits the triangle. Everything else is evaluated
// at the center of the pixel, because llvmpipe uses 1/w from there even for centroid values.

#define SHADED 0
#define FLAT_COLOR 1
#define NORMALS 2
#define UV 3
#define DEPTH 4
#define OBJECT_COLOR 5
#define OBJECT_NUMBER 6
#define BOX 7

centroid in vec3 on_object;
#if defined(TEXTURED) || defined(BUMPED)
in vec3 even_object;
#endif
in vec3 from_eye;
in vec3 mesh_normal;
in vec2 mesh_uv;
flat in vec3 eye_object;
flat in mat3 world_from_normal;
flat in vec3 identity;

layout(location = 0) out vec4 color;

uniform sampler2D materials;  // MATERIAL_TEXELS for each
uniform sampler2D emitters;   // EMITTER_TEXELS for each
uniform int emitter_count;
uniform vec3 quadric;      // round side: x^2 + z^2 + a y^2 + b y + c = 0; 0 for meshes
uniform float transparent; // transparentcoeff
uniform int passing;       // 1: output the light transmitted by the object instead of its own
uniform float truncation;  // 1/510 to truncate, 0 to round
uniform vec4 depth_axis;   // dot product with a world point: 0 nearest, 1 farthest

const float pi = 3.14159265358979;

vec4 material(int texel) {
  int index = int(identity.x);
  return texelFetch(materials, ivec2(index % TABLE_WIDTH * MATERIAL_TEXELS + texel, index / TABLE_WIDTH), 0);
}

vec4 emitter(int index, int texel) {
  return texelFetch(emitters, ivec2(index % TABLE_WIDTH * EMITTER_TEXELS + texel, index / TABLE_WIDTH), 0);
}

struct Point {
  vec3 object;
  vec3 world;   // relative to the eye
  vec3 normal;  // object space, any length
};

// The nearer intersection of the pixel's ray with the quadric, relative to the triangle.
Point find_point() {
  Point point = Point(on_object, from_eye, mesh_normal);
  vec3 p = on_object;
  vec3 way = p - eye_object;
  vec3 slope = vec3(p.x, quadric.x * p.y + 0.5 * quadric.y, p.z);
  float a = dot(way, vec3(way.x, quadric.x * way.y, way.z));
  float b = dot(slope, way);
  float c = p.x * p.x + p.z * p.z + (quadric.x * p.y + quadric.y) * p.y + quadric.z;
  float root = b + (b < 0.0 ? -1.0 : 1.0) * sqrt(max(b * b - a * c, 0.0));
  float t = abs(root) > 1e-20 ? -c / root : 0.0;
  t *= identity.z;
  point.object = p + t * way;
  point.world += t * from_eye;
  if (identity.z > 0.5) {
    point.normal = vec3(point.object.x, quadric.x * point.object.y + 0.5 * quadric.y, point.object.z);
  }
  return point;
}

#if defined(TEXTURED) || defined(BUMPED) || MODE == UV
vec2 find_uv(Point point) {
  if (identity.z < 0.5) {
    return quadric.z < 0.0 ? clamp(mesh_uv, 0.0, 1.0) : mesh_uv;
  }
  vec3 p = point.object;
  float phi = atan(p.z, p.x);
  float v = quadric.x > 0.5 ? asin(clamp(2.0 * p.y, -1.0, 1.0)) / pi : p.y;
  return vec2((phi < 0.0 ? 0.0 : 1.0) - phi / (2.0 * pi), v + 0.5);
}
#endif

#if defined(TEXTURED) || defined(BUMPED)
// The change of uv for a step on the surface.
vec2 uv_step(Point point, vec3 step, vec2 mesh_step) {
  if (identity.z < 0.5) {
    return mesh_step;
  }
  vec3 p = point.object;
  float u = (step.x * p.z - step.z * p.x) / max(dot(p.xz, p.xz), 1e-12) / (2.0 * pi);
  float v = quadric.x > 0.5 ? 2.0 / pi * step.y / sqrt(max(1.0 - 4.0 * p.y * p.y, 1e-6)) : step.y;
  return vec2(u, v);
}

#endif

#ifdef TEXTURED
uniform sampler2D image;
uniform int lookup;  // 0 nearest, 1 the course's filter, 2 nearest averaged over the pixel, 3 filtered

// Moves a position between texel centers toward the nearer one, so that only a range of `width`
// texels around their border is interpolated.
vec2 sharpened(vec2 p, vec2 width) {
  vec2 low = floor(p - 0.5) + 0.5;
  return low + clamp((p - low - 0.5) / width + 0.5, 0.0, 1.0);
}

vec3 texture_color(Point point) {
  vec4 repeats = material(4);
  vec2 size = vec2(textureSize(image, 0));
  vec2 scale = repeats.xy * size;
  vec2 uv = find_uv(point);
  vec2 p = vec2(uv.x, 1.0 - uv.y) * scale;
  vec2 along_x = uv_step(point, dFdx(even_object), dFdx(mesh_uv)) * scale;
  vec2 along_y = uv_step(point, dFdy(even_object), dFdy(mesh_uv)) * scale;
  along_x.y = -along_x.y;
  along_y.y = -along_y.y;
  if (lookup < 2) {
    vec2 place = lookup == 1 ? p + 0.5 : floor(p) + 0.5;
    return textureLod(image, place / size, 0.0).rgb;
  }
  if (length(along_x) < length(along_y)) {
    vec2 swapped = along_x;
    along_x = along_y;
    along_y = swapped;
  }
  float longer = length(along_x);
  float shorter = length(along_y);
  // Filtered: samples along the longer axis, at the mip level of the shorter. Averaged: a grid over
  // the pixel.
  float width = max(max(shorter, longer / 16.0), 1.0);
  vec2 taps = lookup == 3 ? vec2(clamp(ceil(longer / width), 1.0, 16.0), 1.0)
                          : clamp(ceil(3.0 * vec2(longer, shorter)), 1.0, longer > 8.0 ? 3.0 : 5.0);
  along_x /= taps.x;
  along_y /= taps.y;
  if (lookup == 2) {
    width = max(max(length(along_x), length(along_y)), 1.0);
  }
  vec2 border = lookup == 3 || width > 1.0 ? vec2(1.0) : clamp(abs(along_x) + abs(along_y), 1e-4, 1.0);
  vec3 sum = vec3(0.0);
  for (float i = 0.0; i < taps.x * taps.y; i += 1.0) {
    float row = floor((i + 0.5) / taps.x);
    vec2 step = vec2(i - row * taps.x, row) - 0.5 * (taps - 1.0);
    vec2 place = p + step.x * along_x + (lookup == 3 ? 0.0 : step.y) * along_y;
    sum += textureLod(image, sharpened(place, border) / size, log2(width)).rgb;
  }
  return sum / (taps.x * taps.y);
}
#endif

#ifdef SHADOWED
uniform sampler2D shadow_table;  // SHADOW_TEXELS for each layer: place in the layer; size of a texel
uniform highp sampler2DArrayShadow shadows;

vec4 shadow_texel(int layer, int texel) {
  return texelFetch(shadow_table, ivec2(layer % TABLE_WIDTH * SHADOW_TEXELS + texel, layer / TABLE_WIDTH), 0);
}

// The share of the light that reaches the point. `code`: 2 * first layer, + 1 for a cube.
float visibility(float code, vec3 path, vec3 world, vec3 normal, float cosine) {
  int layer = int(code) / 2;
  if (int(code) % 2 == 1) {
    vec3 size = abs(path);
    float along = size.x >= size.y && size.x >= size.z ? path.x : size.y >= size.z ? path.y : path.z;
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    layer += 2 * axis + (along > 0.0 ? 1 : 0);  // path points to the light, the views away from it
  }
  mat4 place = mat4(shadow_texel(layer, 0), shadow_texel(layer, 1), shadow_texel(layer, 2),
                    shadow_texel(layer, 3));
  vec4 texel = shadow_texel(layer, 4);
  // An offset from the surface, by the extent of a texel on it.
  float reach = texel.x + texel.y * (place * vec4(world, 1.0)).w;
  float slant = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec4 p = place * vec4(world + (cosine < 0.0 ? -1.0 : 1.0) * (0.7 + 1.5 * slant) * reach * normal, 1.0);
  p.xyz /= p.w;
  vec2 step = 0.75 / vec2(textureSize(shadows, 0).xy);
  float sum = textureGrad(shadows, vec4(p.xy + step * vec2(-0.5, -1.0), layer, p.z), vec2(0.0), vec2(0.0)) +
              textureGrad(shadows, vec4(p.xy + step * vec2(1.0, -0.5), layer, p.z), vec2(0.0), vec2(0.0)) +
              textureGrad(shadows, vec4(p.xy + step * vec2(0.5, 1.0), layer, p.z), vec2(0.0), vec2(0.0)) +
              textureGrad(shadows, vec4(p.xy + step * vec2(-1.0, 0.5), layer, p.z), vec2(0.0), vec2(0.0));
  return 0.25 * sum;
}
#endif

#ifdef BUMPED
uniform sampler2D bumps;

const float bump_height = 1.0 / 16.0;

// The footprint of a pixel in uv: steps along the longer axis, at the mip level of the shorter.
struct Average {
  vec2 step;
  float taps;
  float level;
};

float height(vec2 uv, vec2 scale, Average over) {
  float sum = 0.0;
  for (float i = 0.5 - 0.5 * over.taps; i < 0.5 * over.taps; i += 1.0) {
    vec2 place = vec2(uv.x + i * over.step.x, 1.0 - uv.y - i * over.step.y) * scale;
    sum += dot(textureLod(bumps, place, over.level).rgb, vec3(1.0 / 3.0));
  }
  return bump_height * sum / over.taps;
}

// The normal in object space at an offset in pixels, tilted by the slope of the map over a quarter
// of the pixel. Two slopes along the surface give its gradient (Mikkelsen, "Bump Mapping
// Unparametrized Surfaces on the GPU", 2010).
vec3 bumped(Point point, vec2 shift) {
  vec2 repeats = material(4).zw;
  vec2 size = vec2(textureSize(bumps, 0));
  vec3 n = normalize(point.normal);
  vec3 across = dFdx(even_object);
  vec3 down = dFdy(even_object);
  across -= dot(across, n) * n;
  down -= dot(down, n) * n;
  vec2 along_x = uv_step(point, across, dFdx(mesh_uv));
  vec2 along_y = uv_step(point, down, dFdy(mesh_uv));
  // The axes of the ellipse in texels that a quarter of the pixel maps to.
  vec2 texels = repeats * size;
  mat2 map = 0.5 * mat2(along_x * texels, along_y * texels);
  mat2 square = map * transpose(map);
  float middle = 0.5 * (square[0][0] + square[1][1]);
  float aside = 0.5 * (square[0][0] - square[1][1]);
  float longer = sqrt(middle + length(vec2(aside, square[0][1])));
  float shorter = abs(determinant(map)) / max(longer, 1e-9);
  float turn = 0.5 * atan(square[0][1], aside);
  vec2 axis = vec2(cos(turn), sin(turn)) / max(abs(texels), vec2(1e-6)) * sign(texels);
  vec2 minor = vec2(-sin(turn), cos(turn)) / max(abs(texels), vec2(1e-6));
  float width = max(max(shorter, longer / 4.0), 1.0);
  float taps = clamp(ceil(longer / width), 1.0, 4.0);
  Average over = Average(longer / taps * axis, taps, log2(width));
  vec2 reach = max(1.0 / max(abs(texels), vec2(1e-6)),
                   min(max(longer * abs(axis), shorter * abs(minor)), vec2(0.25)));
  vec2 right = vec2(reach.x, 0.0);
  vec2 up = vec2(0.0, reach.y);
  vec2 uv = find_uv(point) + shift.x * along_x + shift.y * along_y;
  vec2 slope = vec2(height(uv + right, repeats, over) - height(uv - right, repeats, over),
                    height(uv + up, repeats, over) - height(uv - up, repeats, over)) /
               (2.0 * reach);
  float area = dot(across, cross(down, n));
  if (abs(area) < 1e-12 * length(across) * length(down) || repeats.x == 0.0 || repeats.y == 0.0) {
    return n;
  }
  vec3 gradient = (dot(slope, along_x) * cross(down, n) + dot(slope, along_y) * cross(n, across)) / area;
  return n - gradient;
}
#endif

#if MODE == SHADED
vec3 diffuse_color(Point point) {
  vec4 diffuse = material(1);
#ifdef TEXTURED
  diffuse.rgb = mix(diffuse.rgb, texture_color(point), diffuse.w);
#endif
  return diffuse.rgb;
}

vec3 lit(Point point, vec3 normal, vec3 diffuse) {
  vec4 ambient = material(0);
  vec3 specular = material(2).rgb;
  float shininess = ambient.w;
  vec3 to_eye = -normalize(point.world);
  vec3 sum = ambient.rgb;
  for (int i = 0; i < emitter_count; ++i) {
    vec4 place = emitter(i, 0);
    vec4 light = emitter(i, 1);
    vec4 fading = emitter(i, 2);
    vec4 axis = emitter(i, 3);
    vec3 path = place.xyz - place.w * point.world;
    float distance_to_light = length(path);
    vec3 to_light = path / distance_to_light;
    float fade = 1.0 / max(1.0, fading.x + distance_to_light * (fading.y + distance_to_light * fading.z));
    float angle = acos(clamp(-dot(to_light, axis.xyz), -1.0, 1.0));
    float t = clamp((angle - fading.w) / max(axis.w - fading.w, 1e-6), 0.0, 1.0);
    fade *= 1.0 - t * t * (3.0 - 2.0 * t);
    float cosine = dot(normal, to_light);
    float mirrored = dot(2.0 * cosine * normal - to_light, to_eye);
    vec3 share = diffuse * max(0.0, cosine);
    if (mirrored > 0.0 && shininess > 0.0) {
      share += specular * pow(mirrored, shininess);
    }
#ifdef SHADOWED
    if (light.w >= 0.0) {
      fade *= visibility(light.w, emitter(i, 4).xyz - point.world, point.world, normal, cosine);
    }
#endif
    sum += share * light.rgb * fade;
  }
  return sum;
}
#endif

// Distinct colors for integers.
vec3 number_color(float number) {
  vec3 turn = fract(number * vec3(0.618034, 0.754878, 0.569840) + vec3(0.1, 0.4, 0.7));
  return 0.25 + 0.75 * turn;
}

void main() {
  Point point = find_point();
  vec3 normal = normalize(world_from_normal * point.normal);
#if MODE == SHADED
  vec3 diffuse = diffuse_color(point);
#ifdef BUMPED
  // A bump map varies too much for one normal at the center of the pixel: uses one in each ninth of
  // it.
  vec3 result = vec3(0.0);
  for (int i = 0; i < 9; ++i) {
    vec3 tilted = bumped(point, vec2(i % 3 - 1, i / 3 - 1) / 3.0);
    result += 1.0 / 9.0 * lit(point, normalize(world_from_normal * tilted), diffuse);
  }
#else
  vec3 result = lit(point, normal, diffuse);
#endif
  if (passing == 1) {
    result = transparent * material(3).rgb;
  }
#elif MODE == FLAT_COLOR
  vec3 result = 0.25 + 0.75 * material(1).rgb;
#elif MODE == NORMALS
  vec3 result = 0.5 * (normal + 1.0);
#elif MODE == UV
  vec2 uv = find_uv(point);
  vec3 result = vec3(uv - floor(uv), 0.0);
#elif MODE == DEPTH
  vec3 result = vec3(1.0 - clamp(dot(depth_axis, vec4(point.world, 1.0)), 0.0, 1.0));
#elif MODE == OBJECT_COLOR
  vec3 result = number_color(identity.y);
#elif MODE == OBJECT_NUMBER
  int number = int(identity.y) + 1;
  vec3 result = vec3(number & 255, (number >> 8) & 255, number >> 16) / 255.0;
#elif MODE == BOX
  vec3 result = vec3(0.08, 0.05, 0.03);
#endif
#if MODE != OBJECT_NUMBER
#endif
  // GPUs round to 8 bits, but the course's pictures are truncated.
  color = vec4(result - truncation, 1.0);
}
