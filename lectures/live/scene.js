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
const origin = [0, 0, 0];
const degree = Math.PI / 180;
const axis_names = ["e₁", "e₂", "e₃"], axis_colors = ["e1", "e2", "e3"];
/** count + 1 numbers, equally spaced. */
const steps = (from, to, count) => Array.from({ length: count + 1 }, (_, i) => from + (to - from) * i / (count || 1));
/** Points of an ellipse with two half axes, or of a part of it. */
const arc = (center, a, b, from = 0, to = 2 * Math.PI) =>
  steps(from, to, 72).map(angle => sum(center, times(Math.cos(angle), a), times(Math.sin(angle), b)));

/** A circle of latitude on the unit sphere. */
const parallel = latitude => arc([0, 0, Math.sin(latitude)], times(Math.cos(latitude), x_axis), times(Math.cos(latitude), y_axis));
/** Arrows along the axes of a body, the columns of A, that begin at these distances. */
const axis_arrows = (A, begin, length = 0.3) => A.map((axis, i) =>
  [times(begin[i], axis), times(begin[i] + length, axis), axis_colors[i], axis_names[i], { width: 2.2 }]);

/** From point to point, the angle by which it goes on round the vertical. */
const turns_of = points => points.slice(1).map(([x, y], k) => {
  const [a, b] = points[k];
  return Math.atan2(a * y - b * x, a * x + b * y);
});
const inclination = ([x, y, z]) => Math.atan2(Math.hypot(x, y), z);
/** For a plot: the curve of each component that samples have, which are times or have one. */
function over_time(samples, components_of) {
  const rows = samples.map(components_of);
  return rows[0].map((_, i) => rows.map((row, k) => [samples[k].time ?? samples[k], row[i]]));
}

/** The step of the classical rule for a state, which is a vector or a list of vectors. */
const runge_kutta = (rate, h) => state => {
  const a = rate(state), b = rate(moved(state, h / 2, a)), c = rate(moved(state, h / 2, b)), d = rate(moved(state, h, c));
  return mixed(h / 6, state, a, b, c, d);
};
const moved = (state, time, rates) => state.map ? state.map((part, i) => moved(part, time, rates[i])) : state + time * rates;
const mixed = (time, state, a, b, c, d) => state.map ? state.map((part, i) => mixed(time, part, a[i], b[i], c[i], d[i])) : state + time * (a + 2 * (b + c) + d);

/** The state at the beginning and after each of so many steps. */
const history = (step, state, count) => Array.from({ length: count + 1 }, (_, k) => state = k ? step(state) : state);

/** From a start of three numbers, those with the least squares of deviations, by Gauss and Newton with Marquardt's damping. Numbers
 *  that change nothing stay. */
function fitted(deviations, start) {
  let left = deviations(start), damping = 1e-3;
  for (let round = 0; round < 25 && damping < 1e6; ++round) {
    const h = 1e-5, slopes = identity.map(axis => times(1 / h, minus(deviations(sum(start, times(h, axis))), left)));
    const least = 1e-9 * slopes.reduce((total, slope) => total + dot(slope, slope), 0);
    const [u, v, w] = slopes.map((a, i) => slopes.map((b, j) => i === j ? (1 + damping) * dot(a, a) + least : dot(a, b)));
    const right = slopes.map(slope => dot(slope, left)), determinant = dot(u, cross(v, w));
    const change = times(-1 / determinant, sum(times(right[0], cross(v, w)), times(right[1], cross(w, u)), times(right[2], cross(u, v))));
    const then = deviations(sum(start, change));
    if (dot(then, then) < dot(left, left)) {
      start = sum(start, change);
      left = then;
      damping /= 10;
      if (norm(change) < 1e-4) break;
    } else damping *= 10;
  }
  return { start, left };
}

/** A basis that has rotated about ω for a time, by the reader's own function if there is one. */
const rotated = (own, E, omega, time) => own?.(E, omega, time) ?? product(rotation(times(time, omega)), E);

/** The rotation about a vector by its length. */
function rotation(vector) {
  const angle = norm(vector), n = angle ? times(1 / angle, vector) : z_axis;
  return identity.map(axis => sum(times(Math.cos(angle), axis), times(Math.sin(angle), cross(n, axis)),
    times((1 - Math.cos(angle)) * dot(n, axis), n)));
}

// ---- Bodies. I is the list of the principal moments; ω is on the axes of the body, the columns of A are these axes.

const scaled = (factors, vector) => vector.map((component, i) => factors[i] * component);
/** ω on the ellipsoid of its energy, whose longest half axis is drawn as 1. */
const on_ellipsoid = (I, omega) => times(Math.sqrt(Math.min(...I) / dot(scaled(I, omega), omega)), omega);
/** The rate of ω where no torque acts. */
const free_rate = I => omega => cross(scaled(I, omega), omega).map((torque, i) => torque / I[i]);
const largest_turn = 0.1;  // rad in a step of integration: leaves errors of 1e-5, less than figures show

/** A free body at count + 1 times: time, ω and, with an A0, A. The last two parameters are the reader's own functions, if any. */
function motion(I, omega0, A0, seconds, count, own_omegas, own_turn) {
  const h = seconds / count, parts = Math.max(1, Math.ceil(norm(omega0) * h / largest_turn)), times = steps(0, seconds, count);
  // As the body sees them, the axes of space turn backwards.
  const step = runge_kutta(([omega, ...axes]) => [free_rate(I)(omega), ...axes.map(axis => cross(axis, omega))], h / parts);
  const states = history(state => history(step, state, parts).at(-1), [omega0, ...A0 ? transposed(A0) : []], count);
  const omegas = own_omegas?.(I, omega0, times) ?? states.map(([omega]) => omega), attitudes = [A0];
  for (let k = 1; k <= count && A0; ++k)
    attitudes.push(own_turn ? product(attitudes[k - 1], own_turn(I, omegas[k - 1], h)) : transposed(states[k].slice(1)));
  return omegas.map((omega, k) => ({ time: times[k], omega, A: attitudes[k] }));
}

/** Such a motion at a time between its samples. */
function moved_on(I, samples, time, own_omegas, own_turn) {
  const { time: before, omega, A } = samples.findLast(sample => sample.time <= time);
  return motion(I, omega, A, time - before, 1, own_omegas, own_turn)[1];
}

/** Twice the time between zeros of the middle component of ω; infinite where it takes longer than some twenty turns. */
function time_of_return(I, omega0) {
  const middle = [0, 1, 2].sort((i, j) => I[i] - I[j])[1], h = largest_turn / norm(omega0), zeros = [];
  const step = runge_kutta(free_rate(I), h);
  for (let k = 0, omega = omega0; k < 3000 && zeros.length < 2; ++k) {
    const next = step(omega), [a, b] = [omega[middle], next[middle]];
    if (a < 0 !== b < 0) zeros.push(h * (k + a / (a - b)));
    omega = next;
  }
  return zeros.length === 2 ? 2 * (zeros[1] - zeros[0]) : Infinity;
}

/** The axes of a body with the angles of lecture 07, as columns; the angles; and their rates for ω on the axes of space. */
const attitude = ([phi, theta, psi]) => product(rotation([0, 0, phi]), product(rotation([0, theta, 0]), rotation([0, 0, psi])));
const angles_of = A =>
  [Math.atan2(A[2][1], A[2][0]), Math.acos(Math.max(-1, Math.min(1, A[2][2]))), Math.atan2(A[1][2], -A[0][2])];
function angle_rates([phi, theta], [x, y, z]) {
  const across = (x * Math.cos(phi) + y * Math.sin(phi)) / Math.sin(theta);
  return [z - across * Math.cos(theta), y * Math.cos(phi) - x * Math.sin(phi), across];
}

/** A basis whose last vector has the direction of this one; its transpose turns the vector upright. */
function basis_along(vector) {
  const n = unit(vector), level = unit(cross(Math.abs(n[0]) < 0.9 ? x_axis : y_axis, n));
  return [level, cross(n, level), n];
}
const upright = vector => transposed(basis_along(vector));

// ---- Light and depth: WebGL2 on one canvas, which takes each picture of a page in its turn, with scene.vert and scene.frag.

/** Triangles of a surface round z: through points [radius, height], with a normal in each. */
function lathe(profile, count = 48) {
  const at = ([r, z], angle) => [r * Math.cos(angle), r * Math.sin(angle), z], angles = steps(0, 2 * Math.PI, count);
  const rows = profile.map(([point, normal]) => angles.map(angle => [...at(point, angle), ...at(normal, angle), 0, 0]));
  const corners = rows.slice(1).flatMap((row, i) => row.slice(1).flatMap((corner, k) =>
    [rows[i][k], rows[i][k + 1], corner, rows[i][k], corner, row[k]]));
  const vertices = new Float32Array(8 * corners.length);
  corners.forEach((corner, i) => vertices.set(corner, 8 * i));
  return vertices;
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
};

/** The unit ball, strong in colour where a function has large values, for painted_ball(). */
function on_ball(value_of) {
  const ball = meshes.ball.slice(), last = ball.length / 8 - 1;
  const values = steps(0, last, last).map(k => value_of(Array.from(ball.subarray(8 * k, 8 * k + 3))));
  const [least, most] = [Math.min(...values), Math.max(...values)];
  values.forEach((value, k) => ball[8 * k + 6] = (value - least) / (most - least || 1));
  return ball;
}

const circles = identity.map((axis, i) => arc(origin, axis, identity[(i + 1) % 3]));

/** Vertices of both sides of a line, made once for each list of points; a null among them is a gap, where it has no area. */
function strip(points) {
  if (strips.has(points)) return strips.get(points);
  const vertices = new Float32Array(16 * points.length);
  let along = 0;
  points.forEach((point, i) => {
    if (!point) return;
    const before = points[i - 1] ?? point, way = minus(points[i + 1] ?? point, before);
    along += norm(minus(point, before));
    for (const [k, side] of [1, -1].entries()) vertices.set([...point, ...way, side, along], 16 * i + 8 * k);
  });
  points.forEach((point, i) => point ?? vertices.set([...vertices.slice(16 * i - 8, 16 * i), ...vertices.slice(16 * i + 16, 16 * i + 24)], 16 * i));
  strips.set(points, vertices);
  return vertices;
}
const strips = new WeakMap();

const lights = {
  /** Makes the canvas, once; false where there is no WebGL2. */
  begin() {
    if (this.gl !== undefined) return this.gl;
    this.canvas = document.createElement("canvas");
    const gl = this.gl = this.canvas.getContext("webgl2", { stencil: true, antialias: false });
    if (!gl) return false;
    // Edges are smooth because pixels are small; without a graphics card only those of pictures that rest.
    const facts = gl.getExtension("WEBGL_debug_renderer_info"), renderer = facts ? gl.getParameter(facts.UNMASKED_RENDERER_WEBGL) : "";
    this.finest = Math.max(1, 2 / devicePixelRatio);
    this.moving = /SwiftShader|llvmpipe|Software|Basic Render/i.test(renderer) ? 1 : this.finest;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, shaders.vert], [gl.FRAGMENT_SHADER, shaders.frag]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    this.at = Object.fromEntries(["view", "axes", "normals", "center", "scale", "tint", "strong", "width", "gloss", "fade", "dash", "light",
      "mirror"].map(name => [name, gl.getUniformLocation(program, name)]));
    // Vertices for the shader, eight numbers each.
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    for (const [place, size, from] of [[0, 3, 0], [1, 3, 12], [2, 2, 24]]) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 32, from);
    }
    gl.clearStencil(255);
    for (const kind of [gl.BLEND, gl.DEPTH_TEST, gl.STENCIL_TEST]) gl.enable(kind);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    // Without a graphics card programs for each kind of pass are made when it first draws: here, while the figure is prepared.
    const dot = { vertices: meshes.head, center: origin, tint: [0, 0, 0, 1] }, layers = ["solid", "mark", "clear"];
    this.render(layers.map(layer => ({ ...dot, layer })), dot, identity, z_axis, [1, 1], [1, 1, 1]);
    return gl;
  },
  /** One thing; `change` maps it, as onto its shadow. */
  draw({ layer, vertices, count, axes = identity, center = origin, tint, strong = tint, width = 0, fade = 0, dash = [0, 0], gloss = 1 }, change, shadow) {
    const { gl, at } = this;
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STREAM_DRAW);
    gl.uniform4fv(at.tint, shadow ?? tint);
    gl.uniform4fv(at.strong, shadow ?? strong);
    const [a, b, c] = axes;
    (layer === "clear" && !shadow ? gl.enable : gl.disable).call(gl, gl.CULL_FACE);
    gl.uniformMatrix3fv(at.normals, false, [cross(b, c), cross(c, a), cross(a, b)].flat());
    gl.uniformMatrix3fv(at.axes, false, (change ? axes.map(change.axis) : axes).flat());
    gl.uniform3fv(at.center, change ? change.point(center) : center);
    gl.uniform1f(at.width, width);
    gl.uniform1f(at.gloss, shadow ? 0 : gloss);
    gl.uniform1f(at.fade, fade);
    gl.uniform2fv(at.dash, dash);
    gl.drawArrays(width ? gl.TRIANGLE_STRIP : gl.TRIANGLES, 0, count ?? vertices.length / 8);
  },
  /** All things of a picture. A view is what is to the right, up, and towards the reader; so is the light. */
  render(things, ground, view, light, [width, height], scale) {
    const { gl, canvas } = this;
    for (const [side, length] of [["width", width], ["height", height]]) if (canvas[side] < length) canvas[side] = length;
    gl.viewport(0, canvas.height - height, width, height);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.uniformMatrix3fv(this.at.view, false, transposed(view).flat());
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
    const [solids, marks, clear, front] = ["solid", "mark", "clear", "front"].map(name => things.filter(({ layer }) => layer === name));
    if (ground) {
      pass([ground], gl.LEQUAL, true, [gl.ALWAYS, 1]);
      // Along the light onto the ground, once wherever that is.
      const way = turned(view, light), axis = v => minus(v, times(v[2] / way[2], way));
      const change = { axis, point: p => sum(ground.center, axis(minus(p, ground.center)), [0, 0, 0.004]) };
      const opaque = way[2] > 0.1 ? [...solids, ...marks, ...clear].filter(({ tint }) => tint[3] > 0.3) : [];
      pass(opaque, gl.ALWAYS, false, [gl.GREATER, 2], () => [change, [0, 0, 0, 0.2]]);
    }
    pass(solids, gl.LEQUAL, true, [gl.ALWAYS, 0]);
    if (solids.length) pass(marks, gl.GREATER, false, [gl.NOTEQUAL, 9], ({ tint }) => [undefined, [...tint.slice(0, 3), 0.3 * tint[3]]]);
    pass(marks, gl.LEQUAL, true, [gl.ALWAYS, 0]);
    for (const thing of clear.sort((a, b) => a.far - b.far)) for (const side of [gl.FRONT, gl.BACK]) {
      gl.cullFace(side);
      pass([thing], gl.LEQUAL, false, [gl.ALWAYS, 0]);
    }
    pass(front, gl.ALWAYS, false, [gl.ALWAYS, 0]);
    gl.flush();
    return canvas;
  },
};

// ---- Names in the letters of the formulas: single letters, with a tilde, an index, between bars; also the rate of one.

const italic = (letter, accent = "") => element("i", { className: `symbol ${accent}` }, letter);
const bold = (letter, accent = "") => element("b", { className: `symbol ${accent}` }, letter);
/** Words with their symbols as they stand in a page. In sentences "a" and "A" are words, and "s" is a unit. */
const typeset = (words, is_sentence) => words.split(/([\s,.:;?()]+)/).flatMap((token, i, all) => {
  const rate = token.match(/^d(.)\/dt$/), [, bar, letter, tilde, index = "", power, end] =
    token.match(/^(\|?)([A-Za-zα-ωΓΔΘΨΩ])(\u0303?)([₀-₉]+|_[a-zφθψ]+)?(²?)(\|?)$/u) ?? [];
  if (rate) return ["d", italic(rate[1]), "/d", italic("t")];
  if (token === "dL") return ["d", bold("L")];
  if (token === "Mg") return [italic("M"), bold("g")];
  if (!letter || is_sentence && (/^[aAI]$/.test(token) || token === "s" && /\d$/.test(all[i - 2])) || token === "a" && i + 1 < all.length) return [token];
  const is_vector = /^(V|L|ω|Ω|e[₁₂₃])$/.test(letter + index) && !tilde && !power;
  const digits = index.replace("_", "").replace(/[₀-₉]/g, digit => "₀₁₂₃₄₅₆₇₈₉".indexOf(digit));
  return [bar, is_vector ? bold(letter, index && "hat") : italic(letter, tilde && "tilde"),
    ...digits ? [element("sub", {}, digits)] : [], power + end];
});
const text = (tag, words, is_sentence = true) => element(tag, {}, ...typeset(words, is_sentence));

// ---- A picture: orthographic. Plots are drawn in their order, what is in space by its depth; names lie above.

let colors = {};  // of the page, until it turns light or dark
class Scene {
  /** A view has `half`, the half width of what it shows in its own units, and `towards`, from where one looks at first; without
   *  it one looks from above, and cannot turn it. */
  constructor(canvas, { half, towards }) {
    // What is to be predicted must not be seen before it is released; `expected` is the number of the choice that was made.
    Object.assign(this, { canvas, half, flat: !towards, context: canvas.getContext("2d"), released: false, expected: undefined, names: [], lit: "" });
    const [x, y, z] = towards ?? [0, -1e-9, 1];  // x to the right, y up
    this.azimuth = Math.atan2(y, x);
    this.height = Math.PI / 2 - inclination([x, y, z]);
  }

  /** Clears the picture; where bodies are drawn, of the screen's pixels they may have a part. */
  begin(part) {
    this.ratio = devicePixelRatio * part;
    // What is copied is the whole canvas of the lights: no larger than need be.
    if (part !== lights.part) Object.assign(lights, { part }).canvas.width = lights.canvas.height = 1;
    const { canvas, context: c } = this, { clientWidth: width, clientHeight: high } = canvas;
    const [w, h] = [width, high].map(length => Math.max(1, Math.round(length * devicePixelRatio)));
    if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
    c.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    c.clearRect(0, 0, width, high);
    Object.assign(c, { lineJoin: "bevel", lineCap: "round" });
    Object.assign(this, { width, high, things: [], labels: [], ground: undefined, scale: Math.min(width, high) / 2 / this.half });
    const level = [Math.cos(this.azimuth), Math.sin(this.azimuth), 0];
    this.towards = sum(times(Math.cos(this.height), level), [0, 0, Math.sin(this.height)]);
    this.right = [-level[1], level[0], 0];
    this.up = cross(this.towards, this.right);
  }

  color(name) { return colors[name] ??= getComputedStyle(this.canvas).getPropertyValue("--figure-" + name) || name; }

  /** Pixels of a point. */
  at(point) {
    return [this.width / 2 + this.scale * dot(point, this.right), this.high / 2 - this.scale * dot(point, this.up)];
  }

  /** A line on the paper, through pixels. */
  stroke(pixels, color, width, dash = []) {
    const c = this.context;
    Object.assign(c, { strokeStyle: this.color(color), lineWidth: width });
    c.setLineDash(dash);
    c.beginPath();
    for (const at of pixels) c.lineTo(...at);
    c.stroke();
  }

  /** Where one may take hold. */
  grip(point) {
    const [x, y] = this.at(point);
    this.labels.unshift({ name: this.ring ??= element("span", { className: "grip" }), x, y, align: "center" });
  }

  /** What the words are made of may be something else than letters of formulas. A name that stays is not made anew. */
  words(words, [x, y], color = "ink", align = "center", parts = typeset) {
    const i = this.labels.length, key = `${words} ${color}`;
    if (this.names[i]?.key !== key)
      this.names[i] = { key, name: element("span", { style: `color: var(--figure-${color})` }, ...parts(words)) };
    this.labels.push({ ...this.names[i], x, y, color, align });
  }

  /** After everything is drawn: names where they are to stand or, where another stands already, near by with a line to there. */
  finish() {
    const taken = [], names = this.labels.map(({ name }) => name), layer = this.canvas.nextElementSibling;
    if (layer.childElementCount !== names.length || names.some((name, i) => name !== layer.children[i])) layer.replaceChildren(...names);
    const widths = names.map(name => name.offsetWidth);
    this.labels.forEach((label, i) => {
      const width = widths[i], left = { left: 0, center: width / 2, right: width }[label.align];
      const box_at = ([dx, dy]) => {
        const x = Math.max(2, Math.min(this.width - width - 2, label.x - left + dx));
        const y = Math.max(9, Math.min(this.high - 9, label.y + dy));
        return { x, y, free: !taken.some(box => Math.abs(y - box.y) < 16 && x < box.x + box.width + 3 && box.x < x + width + 3) };
      };
      const ways = [[0, 0], ...[18, 30, 44].flatMap(far =>
        [[0, -1], [1, -0.6], [-1, -0.6], [0, 1], [1, 0.6], [-1, 0.6]].map(way => times(far, way)))];
      const { x, y } = this instanceof Space && ways.map(box_at).find(({ free }) => free) || box_at([0, 0]);
      taken.push({ x, y, width });
      label.name.style.transform = `translate(${x}px, ${y}px) translateY(-50%)`;
      if (Math.hypot(x + left - label.x, y - label.y) < 24) return;
      this.stroke([[label.x, label.y], [Math.max(x, Math.min(x + width, label.x)), y]], label.color, 1);
    });
  }

  /** Curves over x in ranges `x` and `y`; each has a line [name, color, style]. A line stands at the time `now`, or a dot at `mark`;
   *  `expected` are values that the reader expects. */
  plot({ lines, curves, x, y, over = "time (s)", unit, now, mark, expected = [] }) {
    if (!this.released) [lines, curves] = [lines, curves].map(list => list.filter((_, i) => lines[i][2] !== "secret"));
    const values = curves.flat().map(([, value]) => value);
    y ??= [1.1 * Math.min(0, ...values), 1.1 * Math.max(0, ...values) || 1];
    const [left, right, top, bottom] = [46, this.width - 16, 22, this.high - 38], c = this.context;
    const place = ([u, v]) => [left + (right - left) * (u - x[0]) / (x[1] - x[0]),
      bottom - (bottom - top) * (v - y[0]) / (y[1] - y[0])];
    const line = (points, ...style) => this.stroke(points.map(place), ...style);
    const dot = (point, color, radius) => line([point, point], color, 2 * radius);  // a dot is a line without length
    const labels = ([from, to], most) => {
      const rough = (to - from) / most, power = 10 ** Math.floor(Math.log10(rough));
      const step = [1, 2, 5, 10].map(k => k * power).find(k => k >= rough);
      const first = Math.ceil(from / step - 1e-9), last = Math.floor(to / step + 1e-9);
      return steps(first, last, last - first).map(k => [k * step, String(+(k * step).toPrecision(6)).replace("-", "−")]);
    };
    for (const [u, label] of labels(x, (right - left) / 90)) {
      line([[u, y[0]], [u, y[1]]], u ? "pale" : "grey", 1);
      this.words(label, sum(place([u, y[0]]), [0, 13]));
    }
    for (const [v, label] of labels(y, (bottom - top) / 27)) {
      line([[x[0], v], [x[1], v]], v ? "pale" : "grey", 1);
      this.words(label, sum(place([x[0], v]), [-6, 0]), "ink", "right");
    }
    c.save();
    c.beginPath();
    c.rect(left, top - 2, right - left, bottom - top + 4);
    c.clip();
    for (const value of expected) line([[x[0], value], [x[1], value]], "grey", 2, [7, 6]);
    if (expected.length) this.words("expected", sum(place([x[1], expected[0]]), [-4, 9]), "grey", "right");
    // Before the reader has predicted, only what has happened.
    lines.forEach(([name, color, style], i) => {
      const seen = this.released || mark ? curves[i] : curves[i].filter(([u]) => u <= now);
      if (style === "dots") for (const point of seen) dot(point, color, 2.5);
      else line(seen, color, name && this.lit === name ? 4.5 : 2.2, style === "dashed" ? [6, 4] : []);
    });
    if (mark) dot(mark, "ink", 5); else line([[now, y[0]], [now, y[1]]], "ink", 1.4);
    c.restore();
    this.words(over, [(left + right) / 2, this.high - 9], "ink", "center", over => [over]);
    if (!mark) this.times = [left, right, ...x];
    this.words(lines.reduce((all, [name, color]) => name ? `${all};${name};${color}` : all, unit), [left + 4, 9], "ink", "left", () =>
      [unit, ...lines.filter(([name]) => name).map(([name, color]) =>
        element("span", { className: "line", style: `color: var(--figure-${color})` }, ...typeset(name)))]);
  }
}

/** A picture in space, or of a plane from above: bodies with light and shadows, lines and arrows faint where a body hides them. */
class Space extends Scene {
  turn(right, up) {
    this.azimuth -= right;
    this.height = Math.max(-1.5, Math.min(1.5, this.height + up));
  }

  rgb(name, opacity = 1, whiteness = 0) {
    const parts = name => this.color(name).match(/\w\w/g).map(hex => parseInt(hex, 16) / 255);
    return [...sum(times(1 - whiteness, parts(name)), times(whiteness, parts("paper"))), opacity];
  }

  finish() {
    // The light comes from above, from the left, and from behind the reader.
    const view = [this.right, this.up, this.towards], light = unit([-0.35, 0.2, 0.55].map((part, i) => part + 0.9 * view[i][2]));
    const [width, height] = [this.width, this.high].map(length => Math.max(1, Math.round(length * this.ratio)));
    const scale = [2 * this.scale / this.width, 2 * this.scale / this.high, -0.2 / this.half];
    const picture = lights.render(this.things, this.ground, view, light, [width, height], scale);
    super.finish();  // while it is rendered
    this.context.globalCompositeOperation = "destination-over";
    this.context.drawImage(picture, 0, 0, width, height, 0, 0, this.width, this.high);
    this.context.globalCompositeOperation = "source-over";
  }

  /** A body: one of the meshes with three half axes; those that one sees through have an opacity. */
  solid(mesh, center, axes, color, { opacity = 1, whiteness = 0.35, layer = opacity < 1 ? "clear" : "solid", ...more } = {}) {
    this.things.push({ layer, vertices: meshes[mesh], center, axes, tint: this.rgb(color, opacity, whiteness),
      far: dot(center, this.towards), ...more });
  }
  ellipsoid(center, axes, color, opacity = 1) { this.solid("ball", center, axes, color, { opacity, whiteness: 0.5 }); }
  /** With circles that show how it turns. */
  rolling_ellipsoid(center, axes) {
    this.ellipsoid(center, axes, "sky");
    for (const circle of circles) this.line(circle, "grey", 1.2, { axes, center });
  }

  painted_ball(vertices, color) {
    this.solid("ball", origin, identity, color, { vertices, whiteness: 0.92, strong: this.rgb(color) });
  }

  /** A mesh of revolution from one point to another. */
  round(mesh, from, to, radius, color, properties) {
    const way = minus(to, from), [u, v] = basis_along(way), has_tip = /cone|head/.test(mesh);
    this.solid(mesh, has_tip ? to : sum(from, times(0.5, way)), [times(radius, u), times(radius, v), times(has_tip ? 1 : 0.5, way)], color, properties);
  }

  /** The ground below, where shadows fall: a disc at a height. */
  floor(height, radius, color = "shade") {
    this.ground = { vertices: meshes.disc, center: [0, 0, height], axes: diagonal(radius, radius, 1), tint: this.rgb(color), gloss: 0 };
  }

  /** Through points, or the first of them, which `axes` and `center` may move. */
  line(points, color, width = 2, { count = points.length, dash = [0, 0], opacity = 1, layer = "mark", fades = false, ...place } = {}) {
    if (count < 2) return;
    const vertices = strip(points);
    this.things.push({ layer, vertices, count: 2 * count, width: (width + 0.6) / 2 / this.scale, fade: fades ? vertices[16 * count - 1] : 0,
      dash: dash.map(length => length / this.scale), tint: this.rgb(color, opacity), gloss: 0.5, far: dot(points[0], this.towards), ...place });
  }
  /** Where something has been, fainter the longer ago. */
  trail(points, count, color, width, properties) { this.line(points, color, width, { ...properties, count, fades: true }); }

  /** Triangles with the first corner in common, as a flat face or a cone. */
  fan(apex, curve, color, opacity = 0.2, whiteness = 0) {
    const vertices = curve.slice(1).flatMap((point, i) => {
      const normal = cross(minus(curve[i], apex), minus(point, apex));
      return [apex, curve[i], point].flatMap(corner => [...corner, ...normal, 0, 0]);
    });
    this.things.push({ layer: opacity < 1 ? "clear" : "solid", vertices: new Float32Array(vertices), tint: this.rgb(color, opacity, whiteness),
      far: dot(sum(...curve), this.towards) / curve.length });
  }

  face(corners, color, opacity = 0.2, edge = 0, whiteness = 0) {
    this.fan(corners[0], corners.slice(1), color, opacity, whiteness);
    if (edge) this.line([...corners, corners[0]], "ink", edge, { layer: opacity < 1 ? "mark" : "solid" });
  }

  /** `axes` are the half edges, `colors` those of the faces along each; that at the other end is paler. */
  box(center, axes, colors, opacity = 1) {
    axes.forEach((axis, i) => [1, -1].forEach(side => {
      const corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([p, q]) =>
        sum(center, times(side, axis), times(p, axes[(i + 1) % 3]), times(q, axes[(i + 2) % 3])));
      this.face(corners, colors[i], opacity, 1.2, side > 0 ? 0.3 : 0.65);
    }));
  }

  /** With a head, and a name beyond its tip or beside it. */
  arrow(from, to, color, name = "", { width = 3, beside = false } = {}) {
    if (name && this.lit.includes(name)) width *= 1.8;
    const b = this.at(to), seen = minus(b, this.at(from)), length = norm(seen), along = times(1 / (length || 1), seen);
    const way = minus(to, from), size = norm(way), head = Math.min(4 * width / this.scale, size);
    if (size < 1e-6) return;
    const foot = sum(from, times(1 - head / size, way)), properties = { layer: "mark", whiteness: 0 };
    this.round("shaft", from, foot, width / 2 / this.scale, color, properties);
    this.round("head", foot, to, 0.42 * head, color, properties);
    // A short arrow points at the reader: its name stands beside it.
    const [dx, dy] = length <= 12 ? [0.7, -0.7] : beside ? [-along[1], along[0]] : along;
    if (name) this.words(name, [b[0] + 9 * dx, b[1] + 13 * dy], color, dx > 0.4 ? "left" : dx < -0.4 ? "right" : "center");
  }

  arrows(list) { for (const arrow of list) this.arrow(...arrow); }

  /** What the reader expects; nothing if there are no points. */
  expect(points = [], name = "expected") {
    if (!points.length) return;
    this.line(points, "grey", 2.5, { dash: [7, 6] });
    this.dot(points.at(-1), "grey", 4);
    this.words(name, sum(this.at(points.at(-1)), [0, -14]), "grey");
  }

  dot(point, color, radius = 4) {
    this.solid("bead", point, identity.map(axis => times(radius / this.scale, axis)), color, { layer: "mark", whiteness: 0 });
  }
}

/** A still figure that a reader has taken hold of: what its picture describes, in this light, and its texts where they belong. */
class Still extends Space {
  constructor(picture) {
    const { half, towards, calls, texts } = JSON.parse(picture.querySelector("metadata").textContent);
    const { width, height } = picture.viewBox.baseVal, room = 40, size = [width, height].map(length => length + 2 * room);
    const labels = [...picture.querySelectorAll("text")].filter(label => label.textContent);
    picture.insertAdjacentHTML("afterbegin", `<foreignObject x="${-room}" y="${-room}" width="${size[0]}" height="${size[1]}"><canvas></canvas><i></i></foreignObject>`);
    super(picture.querySelector("canvas"), { half: half * Math.min(...size) / Math.min(width, height), towards });
    for (const part of calls.flat()) if (part.profile) part.vertices = lathe(part.profile);
    this.begin(1);
    Object.assign(this, { calls, texts: texts.map((point, i) => ({ point, label: labels[i], first: this.at(point) })) });
    picture.classList.add("turned");
    new MutationObserver(() => (colors = {}, this.draw())).observe(document.documentElement, { attributeFilter: ["class"] });
  }

  draw(part = lights.finest) {
    this.begin(part);
    for (const [kind, ...values] of this.calls) this[kind](...values);
    this.finish();
    for (const { point, label, first } of this.texts)
      label.style.transform = `translate(${minus(this.at(point), first).map(length => length + "px")})`;
  }
}
