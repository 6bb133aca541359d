// Transforms a vertex of an instanced object. World space here is relative to the eye.

layout(location = 0) in vec3 position;      // object space
layout(location = 1) in vec4 normal_round;  // object space; 1: on a round side
layout(location = 2) in vec2 texture_uv;
layout(location = 3) in vec4 row_x;  // world_from_object, row by row
layout(location = 4) in vec4 row_y;
layout(location = 5) in vec4 row_z;
layout(location = 6) in vec4 object;  // material, number of the object

uniform mat4 clip_from_world;

#ifndef DEPTH_ONLY
centroid out vec3 on_object;
#if defined(TEXTURED) || defined(BUMPED)
out vec3 even_object;  // the same at the center of the pixel, interpolated linearly
#endif
out vec3 from_eye;
out vec3 mesh_normal;
out vec2 mesh_uv;
flat out vec3 eye_object;           // the eye in object space
flat out mat3 world_from_normal;    // inverse transpose, not normalized
flat out vec3 identity;             // material, number of the object, round
#endif

void main() {
  vec4 p = vec4(position, 1.0);
  vec3 world = vec3(dot(row_x, p), dot(row_y, p), dot(row_z, p));
  gl_Position = clip_from_world * vec4(world, 1.0);
#ifndef DEPTH_ONLY
  mat3 linear = transpose(mat3(row_x.xyz, row_y.xyz, row_z.xyz));
  mat3 cofactors = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]),
                        cross(linear[0], linear[1]));
  float determinant = dot(linear[0], cofactors[0]);
  vec3 offset = vec3(row_x.w, row_y.w, row_z.w);
  on_object = position;
#if defined(TEXTURED) || defined(BUMPED)
  even_object = position;
#endif
  from_eye = world;
  mesh_normal = normal_round.xyz;
  mesh_uv = texture_uv;
  eye_object = -(offset * cofactors) / determinant;
  world_from_normal = determinant < 0.0 ? -cofactors : cofactors;
  identity = vec3(object.xy, normal_round.w);
#endif
}
