#version 300 es
precision highp float;
in vec3 n;
in float along;
in vec4 color;
uniform float width, gloss, fade;
uniform vec2 dash;
uniform vec3 light, mirror;
out vec4 seen;
void main() {
  seen = vec4(color.rgb, 1) * color.a * (fade > 0.0 ? 0.2 + 0.8 * along / fade : 1.0);
  // Not discarded: that would make every hidden pixel be computed.
  if (dash.x > 0.0 && mod(along, dash.x + dash.y) > dash.x) seen *= 0.0;
  vec3 m = n;
  if (width > 0.0) {
    float edge = length(n.xy);
    seen *= min(1.0, (1.0 - edge) / fwidth(edge) + 0.3);
    m.z = sqrt(max(0.0, 1.0 - edge * edge));
  }
  if (gloss == 0.0) return;
  m *= inversesqrt(dot(m, m)) * (m.z < 0.0 ? -1.0 : 1.0);
  float shade = 0.5 + 0.5 * dot(m, light), glint = max(0.0, dot(m, mirror));
  glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint;
  seen.rgb = seen.rgb * (0.42 + 0.68 * shade * shade + 0.08 * m.z) + 0.25 * gloss * glint * seen.a;
}
