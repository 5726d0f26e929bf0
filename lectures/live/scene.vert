#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;  // of a line: across it, and how far along it
layout(location = 2) in vec4 paint;
uniform mat3 axes, normals;
uniform vec3 center, scale;
uniform float width;
out vec3 n;
out float along;
out vec4 color;
void main() {
  vec3 p = axes * position + center;
  if (width > 0.0) p += vec3(width * normal.xy, width);
  gl_Position = vec4(p * scale, 1);
  n = width > 0.0 ? vec3(normal.xy, 0) : normals * normal;
  along = normal.z;
  color = paint;
}
