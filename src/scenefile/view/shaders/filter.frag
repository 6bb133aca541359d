// A filter of the assignment Realtime: docs/realtime.md.

#define NONE 0
#define INVERT 1
#define GRAYSCALE 2
#define BLUR 3
#define SHARPEN 4

layout(location = 0) out vec4 color;

uniform sampler2D picture;
uniform int kind;
uniform vec3 target_size;  // pixels; the last is unused

// The texel at this offset from the pixel.
vec3 at(vec2 step) {
  vec2 place = gl_FragCoord.xy / target_size.xy + step / vec2(textureSize(picture, 0));
  return textureLod(picture, place, 0.0).rgb;
}

void main() {
  vec3 result = at(vec2(0.0));
  if (kind == INVERT) {
    result = 1.0 - result;
  } else if (kind == GRAYSCALE) {
    result = vec3(dot(result, vec3(0.299, 0.587, 0.114)));
  } else if (kind == BLUR) {
    vec3 sum = vec3(0.0);
    for (int y = -2; y <= 2; ++y) {
      for (int x = -2; x <= 2; ++x) {
        sum += at(vec2(x, y));
      }
    }
    result = sum / 25.0;
  } else if (kind == SHARPEN) {
    vec3 sum = 18.0 * result;
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        sum -= at(vec2(x, y));
      }
    }
    result = sum / 9.0;
  }
  color = vec4(result, 1.0);
}
