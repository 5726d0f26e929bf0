#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;  // of a line: along it
layout(location = 2) in vec2 extra;   // of a line: on which side, and how far along; else how strong in colour
uniform mat3 view, axes, normals;
uniform vec3 center, scale;
uniform vec4 tint, strong;
uniform float width;
out vec3 n;
out float along;
out vec4 color;
void main() {
  vec3 p = view * (axes * position + center);
  n = view * normals * normal;
  along = extra.y;
  color = mix(tint, strong, extra.x);
  if (width > 0.0) {
    vec2 way = (view * axes * normal).xy;
    n = vec3(extra.x * (length(way) > 1e-6 ? vec2(-way.y, way.x) / length(way) : vec2(0, 1)), 0);
    p += width * vec3(n.xy, 1);
    color = tint;
  }
  gl_Position = vec4(p * scale, 1);
}
