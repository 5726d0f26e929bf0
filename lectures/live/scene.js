// What live figures draw with: vectors, bodies in motion, pictures in the plane and in space. It computes what it draws, and
// measures what it draws: this file lies in every student's copy and holds no function that the course asks for.

// ---- Vectors are arrays, matrices arrays of their columns.

const sum = (...vectors) => vectors[0].map((_, i) => vectors.reduce((total, vector) => total + vector[i], 0));
const times = (factor, vector) => vector.map(component => factor * component);
const minus = (a, b) => a.map((component, i) => component - b[i]);
const dot = (a, b) => a.reduce((total, component, i) => total + component * b[i], 0);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const norm = vector => Math.hypot(...vector);
const unit = vector => times(1 / norm(vector), vector);
const turned = (A, vector) => sum(...A.map((column, i) => times(vector[i], column)));
const product = (A, B) => B.map(column => turned(A, column));
const transposed = A => A[0].map((_, row) => A.map(column => column[row]));
const diagonal = (a, b, c) => [[a, 0, 0], [0, b, 0], [0, 0, c]];
const identity = diagonal(1, 1, 1);
const [x_axis, y_axis, z_axis] = identity;
const from_above = [0, -1e-9, 1];  // x to the right, y up
const origin = [0, 0, 0];
const degree = Math.PI / 180;
const axis_names = ["e₁", "e₂", "e₃"], axis_colors = ["e1", "e2", "e3"];
const omega_names = ["ω̃₁", "ω̃₂", "ω̃₃"], moment_names = ["I₁", "I₂", "I₃"];
/** count + 1 numbers, equally spaced. */
const steps = (from, to, count) => Array.from({ length: count + 1 }, (_, i) => from + (to - from) * i / count);
/** Points of an ellipse with two half axes, or of a part of it. */
const arc = (center, a, b, from = 0, to = 2 * Math.PI) =>
  steps(from, to, 72).map(angle => sum(center, times(Math.cos(angle), a), times(Math.sin(angle), b)));

/** A circle of latitude on the unit sphere. */
const parallel = latitude =>
  arc([0, 0, Math.sin(latitude)], times(Math.cos(latitude), x_axis), times(Math.cos(latitude), y_axis));
/** Arrows along the axes of a body, the columns of A, that begin at these distances. */
const axis_arrows = (A, begin, length = 0.3) => A.map((axis, i) =>
  [times(begin[i], axis), times(begin[i] + length, axis), axis_colors[i], axis_names[i], { width: 2.2 }]);

/** A step of the classical rule for a state, which is a list of numbers. */
function runge_kutta(rate, state, h) {
  const along = (time, rates) => state.map((number, i) => number + time * rates[i]);
  const a = rate(state), b = rate(along(h / 2, a)), c = rate(along(h / 2, b)), d = rate(along(h, c));
  return along(h / 6, a.map((number, i) => number + 2 * b[i] + 2 * c[i] + d[i]));
}

/** The state at the beginning and after each of so many steps. */
function history(step, state, count) {
  const states = [state];
  while (states.length <= count) states.push(step(states.at(-1)));
  return states;
}

/** The rotation about a vector by its length. */
function rotation(vector) {
  const angle = norm(vector), n = angle ? times(1 / angle, vector) : z_axis;
  return identity.map(axis => sum(times(Math.cos(angle), axis), times(Math.sin(angle), cross(n, axis)),
    times((1 - Math.cos(angle)) * dot(n, axis), n)));
}

// ---- Bodies. I is the list of the principal moments; ω is on the axes of the body, the columns of A are these axes.

const scaled = (factors, vector) => vector.map((component, i) => factors[i] * component);
/** The rate of ω where no torque acts. */
const free_rate = I => omega => cross(scaled(I, omega), omega).map((torque, i) => torque / I[i]);
const largest_turn = 0.05;  // rad in a step of integration: enough for the digits that figures show

/** A free body at count + 1 equally spaced times: ω and A, without an A0 only ω. The last two are the reader's own functions,
 *  if any. */
function motion(I, omega0, A0, seconds, count, own_omegas, own_turn) {
  const h = seconds / count, parts = Math.max(1, Math.ceil(norm(omega0) * h / largest_turn)), rate = free_rate(I);
  // As the body sees them, the axes of space turn backwards.
  const rates = state => {
    const omega = state.slice(0, 3);
    return rate(omega).concat(...A0 ? [3, 6, 9].map(i => cross(state.slice(i, i + 3), omega)) : []);
  };
  const step = state => history(now => runge_kutta(rates, now, h / parts), state, parts).at(-1);
  const states = history(step, [...omega0, ...A0 ? transposed(A0).flat() : []], count);
  const omegas = own_omegas?.(I, omega0, steps(0, seconds, count)) ?? states.map(state => state.slice(0, 3));
  const attitudes = [A0];
  for (let k = 1; k <= count && A0; ++k)
    attitudes.push(own_turn ? product(attitudes[k - 1], own_turn(I, omegas[k - 1], h))
      : transposed([3, 6, 9].map(i => states[k].slice(i, i + 3))));
  return omegas.map((omega, k) => ({ omega, A: attitudes[k] }));
}

/** The time after which ω comes back, twice that between zeros of its part along the axis of the intermediate moment;
 *  infinite where it takes longer than some twenty turns of the body. */
function time_of_return(I, omega0) {
  const middle = [0, 1, 2].sort((i, j) => I[i] - I[j])[1], h = largest_turn / norm(omega0), zeros = [];
  for (let k = 0, omega = omega0; k < 3000 && zeros.length < 2; ++k) {
    const next = runge_kutta(free_rate(I), omega, h), [a, b] = [omega[middle], next[middle]];
    if (a < 0 !== b < 0) zeros.push(h * (k + a / (a - b)));
    omega = next;
  }
  return zeros.length === 2 ? 2 * (zeros[1] - zeros[0]) : Infinity;
}

/** The axes of a body with the angles of lecture 07, as columns; the angles; and their rates for ω on the axes of space. */
const attitude = ([phi, theta, psi]) =>
  product(rotation([0, 0, phi]), product(rotation([0, theta, 0]), rotation([0, 0, psi])));
const angles_of = A =>
  [Math.atan2(A[2][1], A[2][0]), Math.acos(Math.max(-1, Math.min(1, A[2][2]))), Math.atan2(A[1][2], -A[0][2])];
function angle_rates([phi, theta], [x, y, z]) {
  const across = (x * Math.cos(phi) + y * Math.sin(phi)) / Math.sin(theta);
  return [z - across * Math.cos(theta), y * Math.cos(phi) - x * Math.sin(phi), across];
}

/** A rotation that turns a vector upright. */
function upright(vector) {
  const n = unit(vector), level = unit(cross(Math.abs(n[0]) < 0.9 ? x_axis : y_axis, n));
  return transposed([level, cross(n, level), n]);
}

// ---- Light and depth: WebGL2 on one canvas for all pictures of a page, which takes each picture in its turn.

const vertex_shader = `#version 300 es
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
}`;
const fragment_shader = `#version 300 es
precision highp float;
in vec3 n;
in float along;
in vec4 color;
uniform float width, gloss;
uniform vec2 dash;
uniform vec3 light, mirror;
out vec4 seen;
void main() {
  seen = vec4(color.rgb, 1) * color.a;
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
}`;

/** Triangles of a surface round z: through points [radius, height], with a normal in each. */
function lathe(profile, count = 48) {
  const at = ([r, z], angle) => [r * Math.cos(angle), r * Math.sin(angle), z], vertices = [];
  const angles = steps(0, 2 * Math.PI, count);
  profile.slice(1).forEach(([point, normal], i) => angles.slice(1).forEach((angle, k) => {
    const [before, normal_before] = profile[i];
    const corners = [[before, normal_before, angles[k]], [before, normal_before, angle], [point, normal, angle], [point, normal, angles[k]]];
    for (const c of [0, 1, 2, 0, 2, 3]) vertices.push(...at(corners[c][0], corners[c][2]), ...at(corners[c][1], corners[c][2]));
  }));
  return new Float32Array(vertices);
}
/** Edges stay sharp: each piece of the profile has its own normal. */
const edged = points => points.slice(1).flatMap((point, i) => {
  const [dr, dz] = minus(point, points[i]), normal = [dz, -dr];
  return [[points[i], normal], [point, normal]];
});
const around = (radius, thickness, from, to, count) => steps(from, to, count).map(angle => [Math.cos(angle), Math.sin(angle)])
  .map(normal => [[radius + thickness * normal[0], thickness * normal[1]], normal]);
const meshes = {
  ball: lathe(around(0, 1, -Math.PI / 2, Math.PI / 2, 20), 44),
  bead: lathe(around(0, 1, -Math.PI / 2, Math.PI / 2, 6), 12),
  shaft: lathe(edged([[1, -1], [1, 1]]), 8),
  head: lathe(edged([[0, -1], [1, -1], [0, 0]]), 12),
  rod: lathe(edged([[0, -1], [1, -1], [1, 1], [0, 1]])),
  cone: lathe(edged([[0, -1], [1, -1], [0, 0]])),  // its tip at the origin
  ring: lathe(around(1, 0.035, 0, 2 * Math.PI, 12), 72),
  disc: lathe(edged([[1, 0], [0, 0]])),
  square: new Float32Array([[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]].flatMap(corner => [...corner, 0, 0, 0, 1])),
};

/** What a function has on the unit ball, as parts of its range, for painted_ball(). */
function on_ball(value_of) {
  const values = steps(0, meshes.ball.length / 6 - 1, meshes.ball.length / 6 - 1).map(k => value_of(Array.from(meshes.ball.subarray(6 * k, 6 * k + 3))));
  const [least, most] = [Math.min(...values), Math.max(...values)];
  return values.map(value => (value - least) / (most - least || 1));
}

const lights = {
  /** Makes the canvas, once; false where there is no WebGL2. */
  begin() {
    if (this.gl !== undefined) return this.gl;
    // Without a graphics card smooth edges would take three times as long; there pictures that rest have smaller pixels.
    const context = properties => {
      this.canvas = document.createElement("canvas");
      return this.canvas.getContext("webgl2", { stencil: true, ...properties });
    };
    const first = context({ antialias: false }), facts = first?.getExtension("WEBGL_debug_renderer_info");
    const is_slow = /SwiftShader|llvmpipe|Software|Basic Render/i.test(facts ? first.getParameter(facts.UNMASKED_RENDERER_WEBGL) : "");
    const gl = this.gl = is_slow || !first ? first : context({ antialias: true });
    if (!gl) return false;
    this.finest = is_slow ? 2 : 1;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex_shader], [gl.FRAGMENT_SHADER, fragment_shader]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    this.at = Object.fromEntries(["axes", "normals", "center", "scale", "width", "gloss", "dash", "light", "mirror"]
      .map(name => [name, gl.getUniformLocation(program, name)]));
    this.arrays = Object.fromEntries(Object.entries(meshes).map(([name, vertices]) => [name, this.array(vertices)]));
    this.loose = this.array(new Float32Array(6));
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    return gl;
  },
  /** Vertices for the shader: place and normal, and where there are paints, in their own colours. */
  array(vertices) {
    const { gl } = this, array = { object: gl.createVertexArray(), buffer: gl.createBuffer(), paints: gl.createBuffer() };
    gl.bindVertexArray(array.object);
    gl.bindBuffer(gl.ARRAY_BUFFER, array.paints);
    gl.vertexAttribPointer(2, 4, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, array.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
    for (const place of [0, 1]) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, 12 * place);
    }
    return array;
  },
  /** One thing; `change` maps it, as onto its shadow. */
  draw({ mesh, vertices, axes = identity, center = origin, color, paints, width = 0, dash = [0, 0], gloss = 1 }, change, shadow) {
    const { gl, at } = this, array = this.arrays[mesh] ?? this.loose;
    gl.bindVertexArray(array.object);
    if (vertices) {
      gl.bindBuffer(gl.ARRAY_BUFFER, array.buffer);
      gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STREAM_DRAW);
    }
    if (paints && !shadow) {
      gl.bindBuffer(gl.ARRAY_BUFFER, array.paints);
      gl.bufferData(gl.ARRAY_BUFFER, paints, gl.STREAM_DRAW);
      gl.enableVertexAttribArray(2);
    } else gl.disableVertexAttribArray(2);
    gl.vertexAttrib4fv(2, shadow ?? color);
    const [a, b, c] = axes;
    gl.uniformMatrix3fv(at.normals, false, [cross(b, c), cross(c, a), cross(a, b)].flat());
    gl.uniformMatrix3fv(at.axes, false, (change ? axes.map(change.axis) : axes).flat());
    gl.uniform3fv(at.center, change ? change.point(center) : center);
    gl.uniform1f(at.width, width);
    gl.uniform1f(at.gloss, shadow ? 0 : gloss);
    gl.uniform2fv(at.dash, dash);
    gl.drawArrays(width ? gl.TRIANGLE_STRIP : gl.TRIANGLES, 0, (vertices ?? meshes[mesh]).length / 6);
  },
  /** All things of a picture, in coordinates to the right, up, and towards the reader. */
  render(things, ground, light, [width, height], scale) {
    const { gl, canvas } = this;
    for (const [side, length] of [["width", width], ["height", height]]) if (canvas[side] < length) canvas[side] = length;
    gl.viewport(0, canvas.height - height, width, height);
    gl.scissor(0, canvas.height - height, width, height);
    gl.enable(gl.SCISSOR_TEST);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.STENCIL_TEST);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.uniform3fv(this.at.scale, scale);
    gl.uniform3fv(this.at.light, light);
    gl.uniform3fv(this.at.mirror, unit(sum(light, z_axis)));
    const pass = (layer, depth, writes, [test, value], extra) => {
      gl.depthFunc(depth);
      gl.depthMask(writes);
      gl.stencilFunc(test, value, 255);
      gl.stencilOp(gl.KEEP, gl.KEEP, test === gl.ALWAYS && !value ? gl.KEEP : gl.REPLACE);
      layer.forEach(thing => this.draw(thing, ...extra?.(thing) ?? []));
    };
    const [solids, marks, clear] = ["solid", "mark", "clear"].map(name => things.filter(({ layer }) => layer === name));
    if (ground) {
      pass([ground], gl.LEQUAL, true, [gl.ALWAYS, 1]);
      // Along the light onto the ground, once wherever that is.
      const n = ground.axes[2], slope = dot(n, light), axis = v => minus(v, times(dot(n, v) / slope, light));
      const change = { axis, point: p => sum(ground.center, axis(minus(p, ground.center)), times(0.004, n)) };
      gl.stencilMask(255);
      gl.depthFunc(gl.ALWAYS);
      gl.depthMask(false);
      gl.stencilFunc(gl.EQUAL, 1, 255);
      gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
      if (slope > 0.1) for (const thing of [...solids, ...marks, ...clear])
        if (thing.color[3] > 0.3) this.draw(thing, change, [0, 0, 0, 0.2]);
    }
    pass(solids, gl.LEQUAL, true, [gl.ALWAYS, 0]);
    if (solids.length) pass(marks, gl.GREATER, false, [gl.NOTEQUAL, 9], ({ color }) => [undefined, [...color.slice(0, 3), 0.3 * color[3]]]);
    pass(marks, gl.LEQUAL, true, [gl.ALWAYS, 0]);
    gl.enable(gl.CULL_FACE);
    const far_to_near = clear.sort((a, b) => a.far - b.far);
    for (const thing of far_to_near) for (const side of thing.mesh === "ball" ? [gl.FRONT, gl.BACK] : [0]) {
      side ? gl.cullFace(side) : gl.disable(gl.CULL_FACE);
      pass([thing], gl.LEQUAL, false, [gl.ALWAYS, 0]);
      gl.enable(gl.CULL_FACE);
    }
    gl.disable(gl.CULL_FACE);
    return canvas;
  },
};

// ---- Names in the letters of the formulas: single letters, with a tilde, an index, between bars; also the rate of one.

const vectors = /^(V|L|ω|Ω|e[₁₂₃])$/;
/** What names and sentences consist of: [words, style], the style "", "i" of a symbol, "b" of a vector, "sub" of an index;
 *  the accent of a letter follows it. In sentences "a" and "A" are words. */
const pieces_of = (words, is_sentence) => words.split(/([\s,.:;?()]+)/).flatMap((token, i, all) => {
  const rate = token.match(/^d(.)\/dt$/), [, bar, letter, accent, index, power, end] =
    token.match(/^(\|?)([A-Za-zα-ωΓΔΘΨΩ])(\u0303?)([₀-₉]+|_[a-zφθψ]+)?(²?)(\|?)$/u) ?? [];
  if (rate) return [["d", ""], [rate[1], "i"], ["/d", ""], ["t", "i"]];
  if (/^(dL|Mg)$/.test(token)) return [[token[0], token === "Mg" ? "i" : ""], [token[1], "b"]];
  if (!letter || is_sentence && /^[aAI]$/.test(token) || token === "a" && i + 1 < all.length) return [[token, ""]];
  const digits = (index ?? "").replace("_", "").replace(/[₀-₉]/g, digit => "₀₁₂₃₄₅₆₇₈₉".indexOf(digit));
  const is_vector = vectors.test(letter + (index ?? "")) && !accent && !power;
  return [[bar, ""], [letter + (is_vector && index ? "\u0302" : accent), is_vector ? "b" : "i"], [digits, "sub"], [power + end, ""]];
}).filter(([part]) => part);

// ---- A picture: orthographic. Plots are drawn in their order, what is in space by its depth; names lie above.

class Scene {
  /** A view has `half`, the half width of what it shows in its own units, and `towards`, from where one looks at first,
   *  if it is not a plot; `fixed` pictures cannot be turned. */
  constructor(canvas, view) {
    Object.assign(this, { canvas, half: view.half ?? 1, flat: view.fixed || !view.towards, context: canvas.getContext("2d") });
    const [x, y, z] = view.towards ?? z_axis;
    this.azimuth = Math.atan2(y, x);
    this.height = Math.atan2(z, Math.hypot(x, y));
    this.released = false;  // what is to be predicted must not be seen before
    this.expected = undefined;  // the number of the choice that the reader has made
  }

  /** Clears the picture; where bodies are drawn, of the screen's pixels they may have a part. */
  begin(part) {
    this.ratio = devicePixelRatio * part;
    const { canvas, context: c } = this, { clientWidth: width, clientHeight: high } = canvas;
    const [w, h] = [width, high].map(length => Math.max(1, Math.round(length * devicePixelRatio)));
    if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
    c.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    c.clearRect(0, 0, width, high);
    Object.assign(c, { lineJoin: "round", lineCap: "round", textBaseline: "middle" });
    Object.assign(this, { width, high, things: [], labels: [], ground: undefined, scale: Math.min(width, high) / 2 / this.half });
    const level = [Math.cos(this.azimuth), Math.sin(this.azimuth), 0];
    this.towards = sum(times(Math.cos(this.height), level), [0, 0, Math.sin(this.height)]);
    this.right = [-level[1], level[0], 0];
    this.up = cross(this.towards, this.right);
    const style = getComputedStyle(canvas), known = {};
    this.color = name => known[name] ??= style.getPropertyValue("--figure-" + name) || name;
  }

  /** After everything is drawn. */
  finish() { this.place_labels(); }

  /** A vector to the right, up, and towards the reader. */
  seen([x, y, z]) { return [this.right, this.up, this.towards].map(axis => x * axis[0] + y * axis[1] + z * axis[2]); }

  /** Pixels of a point. */
  at(point) {
    return [this.width / 2 + this.scale * dot(point, this.right), this.high / 2 - this.scale * dot(point, this.up)];
  }

  /** The point at some pixels, on the ball about the origin that has this radius and in front; 0 for a flat view. */
  point_at([x, y], radius = 0) {
    const [r, u] = [(x - this.width / 2) / this.scale, (this.high / 2 - y) / this.scale];
    const far = Math.max(1, Math.hypot(r, u) / (radius || Infinity));
    const depth = Math.sqrt(Math.max(0, radius ** 2 - (r * r + u * u) / far ** 2));
    return sum(times(r / far, this.right), times(u / far, this.up), times(depth, this.towards));
  }

  path(points, close = false) {
    const c = this.context;
    c.beginPath();
    points.forEach((point, i) => i ? c.lineTo(...this.at(point)) : c.moveTo(...this.at(point)));
    if (close) c.closePath();
  }

  line(points, color, width = 2, { dash = [], opacity = 1 } = {}) {
    const c = this.context;
    Object.assign(c, { strokeStyle: this.color(color), lineWidth: width, globalAlpha: opacity });
    c.setLineDash(dash);
    this.path(points);
    c.stroke();
    c.globalAlpha = 1;
    c.setLineDash([]);
  }

  dot(point, color, radius = 4) {
    const c = this.context;
    c.fillStyle = this.color(color);
    c.beginPath();
    c.arc(...this.at(point), radius, 0, 2 * Math.PI);
    c.fill();
  }

  /** Where one may take hold. */
  grip(point) {
    const c = this.context;
    for (const [color, width] of [["paper", 5], ["ink", 2]]) {
      Object.assign(c, { strokeStyle: this.color(color), lineWidth: width });
      c.beginPath();
      c.arc(...this.at(point), 10, 0, 2 * Math.PI);
      c.stroke();
    }
  }

  text(point, words, color = "ink", align = "center") { this.words(words, this.at(point), color, align); }
  /** Plain words are units or places, no symbols. */
  words(words, [x, y], color = "ink", align = "center", plain = false) {
    this.labels.push({ words: plain ? [[words, ""]] : pieces_of(words), x, y, color, align });
  }

  /** Names where they are to stand or, where another stands already, near by with a line to their place. */
  place_labels() {
    const taken = [], c = this.context;
    for (const label of this.labels) {
      const width = this.write(label.words, 0, 0) + 4, left = { left: 0, center: width / 2, right: width }[label.align];
      const box_at = ([dx, dy]) => {
        const x = Math.max(2, Math.min(this.width - width - 2, label.x - left + dx));
        const y = Math.max(9, Math.min(this.high - 9, label.y + dy));
        return { x, y, free: !taken.some(box => Math.abs(y - box.y) < 16 && x < box.x + box.width && box.x < x + width) };
      };
      const ways = [[0, 0], ...[18, 30, 44].flatMap(far =>
        [[0, -1], [1, -0.6], [-1, -0.6], [0, 1], [1, 0.6], [-1, 0.6]].map(way => times(far, way)))];
      const found = this.flat ? box_at([0, 0]) : ways.map(box_at).find(({ free }) => free) ?? box_at([0, 0]);
      taken.push({ ...found, width });
      if (Math.hypot(found.x + left - label.x, found.y - label.y) > 24) {
        Object.assign(c, { strokeStyle: this.color(label.color), lineWidth: 1 });
        c.beginPath();
        c.moveTo(label.x, label.y);
        c.lineTo(Math.max(found.x, Math.min(found.x + width, label.x)), found.y);
        c.stroke();
      }
      this.write(label.words, found.x, found.y, this.color(label.color));
    }
  }

  /** Writes from the left, if it has a color; the width. */
  write(words, x, y, color) {
    const c = this.context, fonts = { "": "15px system-ui, Helvetica, Arial, sans-serif", i: "italic 18px KaTeX_Math, serif",
      b: "italic bold 18px KaTeX_Math, serif", sub: "13px KaTeX_Main, serif" };
    let at = x;
    for (const [part, style] of words) {
      const letters = part.normalize("NFD").replace(/[\u0302\u0303]/, ""), accent = { "\u0302": "ˆ", "\u0303": "˜" }[part.normalize("NFD")[1]];
      c.font = fonts[style];
      const width = c.measureText(letters).width;
      if (color) {
        Object.assign(c, { textAlign: "left", strokeStyle: this.color("paper"), fillStyle: color, lineWidth: 4 });
        const down = style === "sub" ? 5 : 0, all = [[letters, at, y + down]];
        if (accent) all.push([accent, at + width / 2 - 2, y - (/[A-Z]/.test(letters) ? 5 : 1)]);
        for (const act of ["strokeText", "fillText"]) for (const [glyphs, u, v] of all) {
          if (glyphs === accent) c.font = "bold 18px KaTeX_Main, serif";
          c[act](glyphs, u, v);
          c.font = fonts[style];
        }
      }
      at += width + (style === "i" || style === "b" ? 1 : 0);
    }
    return at - x;
  }

  /** Curves over x in a flat view: `x` and `y` are the ranges, a curve is {points, color, name, dash},
   *  or its points alone with `dots`; a line stands at
   *  the time `now`, or a dot at `mark`; `expected` are values that the reader expects. */
  plot({ x, y, x_name, y_name, curves, now, mark, expected = [] }) {
    const [left, right, top, bottom] = [46, this.width - 16, 22, this.high - 38];
    const place = ([u, v]) => [left + (right - left) * (u - x[0]) / (x[1] - x[0]),
      bottom - (bottom - top) * (v - y[0]) / (y[1] - y[0])];
    const c = this.context;
    this.at = place;
    const labels = ([from, to], most) => {
      const rough = (to - from) / most, power = 10 ** Math.floor(Math.log10(rough));
      const step = [1, 2, 5, 10].map(k => k * power).find(k => k >= rough);
      const first = Math.ceil(from / step - 1e-9), last = Math.floor(to / step + 1e-9);
      return steps(first, last, last - first).map(k => [k * step, String(+(k * step).toPrecision(6)).replace("-", "−")]);
    };
    for (const [u, label] of labels(x, (right - left) / 90)) {
      this.line([[u, y[0]], [u, y[1]]], u ? "pale" : "grey", 1);
      this.words(label, sum(place([u, y[0]]), [0, 13]));
    }
    for (const [v, label] of labels(y, (bottom - top) / 36)) {
      this.line([[x[0], v], [x[1], v]], v ? "pale" : "grey", 1);
      this.words(label, sum(place([x[0], v]), [-6, 0]), "ink", "right");
    }
    c.save();
    c.beginPath();
    c.rect(left, top - 2, right - left, bottom - top + 4);
    c.clip();
    for (const value of expected) this.line([[x[0], value], [x[1], value]], "grey", 2, { dash: [7, 6] });
    if (expected.length) this.words("expected", sum(place([x[1], expected[0]]), [-4, 9]), "grey", "right");
    // Before the reader has predicted, only what has happened.
    for (const { points, color, dash, dots } of curves) {
      const seen = this.released || mark ? points : points.filter(([u]) => u <= now);
      if (dots) for (const point of seen) this.dot(point, color, 2.5);
      else this.line(seen, color, 2.2, { dash });
    }
    if (mark) this.dot(mark, "ink", 5); else this.line([[now, y[0]], [now, y[1]]], "ink", 1.4);
    c.restore();
    this.words(x_name, [(left + right) / 2, this.high - 9], "ink", "center", true);
    if (!mark) this.times = [left, right, ...x];
    let at = left + 4;
    for (const { name, color, plain } of [{ name: y_name, color: "ink", plain: true }, ...curves.filter(curve => curve.name)]) {
      this.words(name, [at, 9], color, "left", plain);
      at += this.write(plain ? [[name, ""]] : pieces_of(name), 0, 0) + 14;
    }
    delete this.at;
  }
}

/** A picture in space, or of a plane from above: bodies with light and shadows, lines and arrows faint where a body hides them. */
class Space extends Scene {
  turn(right, up) {
    if (this.flat) return;
    this.azimuth -= right;
    this.height = Math.max(-1.5, Math.min(1.5, this.height + up));
  }

  rgb(name, opacity = 1, whiteness = 0) {
    const parts = color => {
      Object.assign(this.context, { fillStyle: color });
      const hex = this.context.fillStyle;
      return [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16) / 255);
    };
    return [...sum(times(1 - whiteness, parts(this.color(name))), times(whiteness, parts(this.color("paper")))), opacity];
  }

  finish() {
    // The light comes from above, from the left, and from behind the reader.
    const light = unit([-0.35, 0.2, 0.55].map((part, i) => part + 0.9 * this.seen(z_axis)[i]));
    const [width, height] = [this.width, this.high].map(length => Math.max(1, Math.round(length * this.ratio)));
    const scale = [2 * this.scale / this.width, 2 * this.scale / this.high, -0.2 / this.half];
    const picture = lights.render(this.things, this.ground, light, [width, height], scale);
    this.context.globalCompositeOperation = "destination-over";
    this.context.drawImage(picture, 0, 0, width, height, 0, 0, this.width, this.high);
    this.context.globalCompositeOperation = "source-over";
    super.finish();
  }

  /** A body: one of the meshes with three half axes; those that one sees through have an opacity. */
  solid(mesh, center, axes, color, { opacity = 1, whiteness = 0.35, paints, layer = opacity < 1 ? "clear" : "solid" } = {}) {
    this.things.push({ layer, mesh, center: this.seen(center), axes: axes.map(axis => this.seen(axis)),
      color: this.rgb(color, opacity, whiteness), paints, far: dot(center, this.towards) });
  }
  ellipsoid(center, axes, color, opacity = 1) { this.solid("ball", center, axes, color, { opacity, whiteness: 0.5 }); }

  /** The unit ball, strong in colour where the values are large. */
  painted_ball(values, color) {
    const [strong, weak] = [this.rgb(color), this.rgb(color, 1, 0.92)];
    const paints = new Float32Array(values.flatMap(value => strong.map((part, i) => value * part + (1 - value) * weak[i])));
    this.solid("ball", origin, identity, color, { paints });
  }

  /** A mesh of revolution from one point to another. */
  round(mesh, from, to, radius, color, properties) {
    const half = times(0.5, minus(to, from)), level = unit(cross(Math.abs(half[0]) < 0.9 * norm(half) ? x_axis : y_axis, half));
    const center = /cone|head/.test(mesh) ? to : sum(from, half), along = /cone|head/.test(mesh) ? times(2, half) : half;
    this.solid(mesh, center, [times(radius, level), times(radius, cross(unit(half), level)), along], color, properties);
  }

  /** The ground below, where shadows fall: a disc at a height. */
  floor(height, radius, color = "shade") {
    const axes = [times(radius, x_axis), times(radius, y_axis), z_axis].map(axis => this.seen(axis));
    this.ground = { mesh: "disc", center: this.seen([0, 0, height]), axes, color: this.rgb(color), gloss: 0 };
  }

  line(points, color, width = 2, { dash = [0, 0], opacity = 1, layer = "mark" } = {}) {
    if (points.length < 2) return;
    const seen = points.map(point => this.seen(point)), vertices = new Float32Array(12 * points.length);
    let along = 0, across = [0, 1];
    seen.forEach((point, i) => {
      const before = seen[Math.max(i - 1, 0)], after = seen[Math.min(i + 1, seen.length - 1)];
      const [x, y] = minus(after, before), length = Math.hypot(x, y);
      if (length > 1e-9) across = [-y / length, x / length];
      along += this.scale * Math.hypot(point[0] - before[0], point[1] - before[1]);
      for (const [k, side] of [1, -1].entries()) vertices.set([...point, ...times(side, across), along], 12 * i + 6 * k);
    });
    this.things.push({ layer, vertices, width: (width + 0.6) / 2 / this.scale, dash, color: this.rgb(color, opacity), gloss: 0.5, far: seen[0][2] });
  }

  /** Triangles with the first corner in common, as a flat face or a cone. */
  fan(apex, curve, color, opacity = 0.2) {
    const [a, ...points] = [apex, ...curve].map(point => this.seen(point)), vertices = [];
    points.slice(1).forEach((point, i) => {
      const normal = cross(minus(points[i], a), minus(point, a));
      for (const corner of [a, points[i], point]) vertices.push(...corner, ...normal);
    });
    const center = times(1 / points.length, sum(...points));
    this.things.push({ layer: opacity < 1 ? "clear" : "solid", vertices: new Float32Array(vertices), color: this.rgb(color, opacity),
      far: center[2] });
  }

  face(corners, color, opacity = 0.2, edge = 0) {
    this.fan(corners[0], corners.slice(1), color, opacity);
    if (edge) this.line([...corners, corners[0]], "ink", edge, { layer: opacity < 1 ? "mark" : "solid" });
  }

  /** `axes` are the half edges, `colors` those of the faces along each; that at the other end is paler. */
  box(center, axes, colors, opacity = 1) {
    const [at, corner] = [axes.map(axis => this.seen(axis)), signs => sum(center, ...axes.map((axis, i) => times(signs[i], axis)))];
    axes.forEach((axis, i) => {
      const [u, v] = [axes[(i + 1) % 3], axes[(i + 2) % 3]];
      for (const side of [1, -1]) this.solid("square", sum(center, times(side, axis)), [u, v, times(side, axis)], colors[i],
        { opacity, whiteness: side > 0 ? 0.3 : 0.65 });
      for (const [p, q] of [[1, 1], [1, -1], [-1, -1], [-1, 1]]) {
        const signs = [0, 0, 0].map((_, k) => k === i ? 1 : k === (i + 1) % 3 ? p : q);
        this.line([corner(signs), corner(signs.map((sign, k) => k === i ? -1 : sign))], "ink", 1.2, { layer: opacity < 1 ? "mark" : "solid" });
      }
    });
  }

  /** With a head, and a name beyond its tip or beside it. */
  arrow(from, to, color, name = "", { width = 3, beside = false } = {}) {
    const [a, b] = [this.at(from), this.at(to)];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const along = length > 0 ? [(b[0] - a[0]) / length, (b[1] - a[1]) / length] : [0, 0];
    const way = minus(to, from), size = norm(way), head = Math.min(4 * width / this.scale, size);
    if (size < 1e-6) return;
    const foot = sum(from, times(1 - head / size, way)), properties = { layer: "mark", whiteness: 0 };
    this.round("shaft", from, foot, width / 2 / this.scale, color, properties);
    this.round("head", foot, to, 0.42 * head, color, properties);
    // A short arrow points at the reader: its name stands beside it.
    const [dx, dy] = length <= 12 ? [0.7, -0.7] : beside ? [-along[1], along[0]] : along;
    if (name) this.words(name, [b[0] + (10 + 3 * name.length) * dx, b[1] + 14 * dy], color);
  }

  arrows(list) { for (const arrow of list) this.arrow(...arrow); }

  /** What the reader expects, as far as it is in the picture; nothing if there are no points. */
  expect(points = [], name = "expected") {
    const outside = points.findIndex(point => Math.max(...[this.right, this.up].map(axis => Math.abs(dot(point, axis)))) > this.half);
    const seen = outside < 0 ? points : points.slice(0, Math.max(outside, 1));
    if (!seen.length) return;
    this.line(seen, "grey", 2.5, { dash: [7, 6] });
    this.dot(seen.at(-1), "grey", 4);
    const [from, to] = seen.slice(-2).map(point => this.at(point)), [x, y] = to ? minus(to, from) : [1, 0];
    if (Math.abs(y) > Math.abs(x)) this.words(name, sum(to, [-9, 0]), "grey", "right");
    else this.words(name, sum(to ?? from, [0, to ? -13 : 14]), "grey");
  }

  dot(point, color, radius = 4) {
    this.solid("bead", point, identity.map(axis => times(radius / this.scale, axis)), color, { layer: "mark", whiteness: 0 });
  }
}
