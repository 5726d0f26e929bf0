// The live figures: scenes that one turns in the hand, arrows, surfaces, plots, sliders, time. A figure is one call of
// live() in lectures/NN_topic/live.js. It computes what it draws, and measures what it draws: this file lies in every
// student's copy and holds no function that the course asks for.

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
const axis_names = ["e₁", "e₂", "e₃"], axis_colors = ["orange", "green", "purple"];
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

/** A free body at count + 1 equally spaced times: ω and A. The last two are the reader's own functions, if any. */
function motion(I, omega0, A0, seconds, count, own_omegas, own_turn) {
  const h = seconds / count, parts = Math.max(1, Math.ceil(norm(omega0) * h / largest_turn)), rate = free_rate(I);
  // As the body sees them, the axes of space turn backwards.
  const rates = state => {
    const omega = state.slice(0, 3);
    return rate(omega).concat(...[3, 6, 9].map(i => cross(state.slice(i, i + 3), omega)));
  };
  const step = state => history(now => runge_kutta(rates, now, h / parts), state, parts).at(-1);
  const states = history(step, [...omega0, ...transposed(A0).flat()], count);
  const omegas = own_omegas?.(I, omega0, steps(0, seconds, count)) ?? states.map(state => state.slice(0, 3));
  const attitudes = [A0];
  for (let k = 1; k <= count; ++k)
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

// ---- The reader's own functions by their names, those that pass: yours.free_rotation?.(I, omega0, times). There are
// none until `checker live` has compiled them; it finds the names that a figure can take by the word before the dot.

const yours = {};
let used = new Set();

async function load_yours() {
  const module = await rigid_module_of_the_student();
  const numbers_of = value => Array.isArray(value?.[0]) ? [value[0].length, value.length, ...value.flat()]
    : Array.isArray(value) ? [value.length, 1, ...value] : [1, 1, value];
  module.UTF8ToString(module._live_names()).split(" ").forEach((name, number) => yours[name] = (...values) => {
    used.add(name);
    const numbers = values.flatMap(numbers_of);
    module.HEAPF64.set(numbers, module._live_arguments(numbers.length) / 8);
    const at = module._live_call(number) / 8;
    const [rows, columns] = module.HEAPF64.subarray(at, at + 2);
    const column = k => Array.from(module.HEAPF64.subarray(at + 2 + k * rows, at + 2 + (k + 1) * rows));
    return columns > 1 ? steps(0, columns - 1, columns - 1).map(column) : rows > 1 ? column(0) : column(0)[0];
  });
}

// ---- A picture: orthographic, what is drawn first lies below.

class Scene {
  /** A view has `half`, the half width of what it shows in its own units, and `towards`, from where one looks at first;
   *  without that it is flat, x to the right and y up. */
  constructor(canvas, view) {
    this.canvas = canvas;
    this.half = view.half ?? 1;
    this.flat = !view.towards;
    const [x, y, z] = view.towards ?? z_axis;
    this.azimuth = this.flat ? -Math.PI / 2 : Math.atan2(y, x);
    this.height = this.flat ? Math.PI / 2 : Math.atan2(z, Math.hypot(x, y));
    this.released = false;  // what is to be predicted must not be seen before
    this.expected = undefined;  // the number of the choice that the reader has made
  }

  /** Clears the picture; of the screen's pixels it may have a part. */
  begin(part) {
    const ratio = devicePixelRatio * part, { clientWidth: width, clientHeight: height } = this.canvas;
    const [w, h] = [width, height].map(length => Math.max(1, Math.round(length * ratio)));
    if (this.canvas.width !== w || this.canvas.height !== h) Object.assign(this.canvas, { width: w, height: h });
    const c = this.context = this.canvas.getContext("2d");
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    Object.assign(c, { lineJoin: "round", lineCap: "round", textBaseline: "middle", textAlign: "center" });
    [this.width, this.high] = [width, height];
    this.scale = Math.min(width, height) / 2 / this.half;
    const level = [Math.cos(this.azimuth), Math.sin(this.azimuth), 0];
    this.towards = sum(times(Math.cos(this.height), level), [0, 0, Math.sin(this.height)]);
    this.right = [-level[1], level[0], 0];
    this.up = cross(this.towards, this.right);
    const style = getComputedStyle(this.canvas);
    this.color = name => style.getPropertyValue("--figure-" + name) || name;
  }

  turn(right, up) {
    if (this.flat) return;
    this.azimuth -= right;
    this.height = Math.max(-1.5, Math.min(1.5, this.height + up));
  }

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

  /** A line on a closed surface: what faces the reader, and faintly the rest. */
  on_surface(points, normal, color, width = 2) {
    const seen = points.map(point => dot(normal(point), this.towards) >= 0);
    for (const side of [false, true]) {
      for (let i = 0, start = 0; i < points.length; ++i) {
        if (i + 1 < points.length && seen[i + 1] === seen[i]) continue;
        if (seen[i] === side) this.line(points.slice(start, i + 2), color, width, side ? {} : { opacity: 0.3 });
        start = i + 1;
      }
    }
  }

  /** What the reader expects, as far as it is in the picture; nothing if there are no points. */
  expect(points = [], name = "expected") {
    const outside = points.findIndex(point => Math.max(...[this.right, this.up].map(axis => Math.abs(dot(point, axis)))) > this.half);
    const seen = outside < 0 ? points : points.slice(0, Math.max(outside, 1));
    if (!seen.length) return;
    this.line(seen, "grey", 2, { dash: [7, 6] });
    this.dot(seen.at(-1), "grey", 3.5);
    const [from, to] = seen.slice(-2).map(point => this.at(point)), [x, y] = to ? minus(to, from) : [1, 0];
    if (Math.abs(y) > Math.abs(x)) this.words(name, sum(to, [-9, 0]), "grey", "right");
    else this.words(name, sum(to ?? from, [0, to ? -13 : 14]), "grey");
  }

  face(corners, color, opacity = 0.2, edge = 0) {
    const c = this.context;
    Object.assign(c, { fillStyle: this.color(color), globalAlpha: opacity });
    this.path(corners, true);
    c.fill();
    c.globalAlpha = 1;
    if (edge) this.line([...corners, corners[0]], "ink", edge);
  }

  /** With a head, and a name beyond its tip or beside it. */
  arrow(from, to, color, name = "", { width = 3, beside = false } = {}) {
    const [a, b] = [this.at(from), this.at(to)];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]), c = this.context;
    const along = length > 0 ? [(b[0] - a[0]) / length, (b[1] - a[1]) / length] : [0, 0];
    const head = Math.min(3.6 * width, length);
    const foot = [b[0] - head * along[0], b[1] - head * along[1]];
    Object.assign(c, { strokeStyle: this.color(color), fillStyle: this.color(color), lineWidth: width });
    c.beginPath();
    c.moveTo(...a);
    c.lineTo(...foot);
    c.stroke();
    c.beginPath();
    c.moveTo(...b);
    for (const side of [0.45, -0.45]) c.lineTo(foot[0] - side * head * along[1], foot[1] + side * head * along[0]);
    c.fill();
    // A short arrow points at the reader: its name stands beside it.
    const [dx, dy] = length <= 12 ? [0.7, -0.7] : beside ? [-along[1], along[0]] : along;
    if (name) this.words(name, [b[0] + (10 + 4 * name.length) * dx, b[1] + 14 * dy], color);
  }

  /** A body and arrows from its inside: those that point away from the reader lie behind it. */
  body_with_arrows(draw, arrows) {
    const in_front = ([from, to]) => dot(minus(to, from), this.towards) >= 0;
    for (const arrow of arrows.filter(arrow => !in_front(arrow))) this.arrow(...arrow);
    draw();
    for (const arrow of arrows.filter(in_front)) this.arrow(...arrow);
  }

  dot(point, color, radius = 4) {
    const c = this.context;
    c.fillStyle = this.color(color);
    c.beginPath();
    c.arc(...this.at(point), radius, 0, 2 * Math.PI);
    c.fill();
  }

  text(point, words, color = "ink", align = "center") { this.words(words, this.at(point), color, align); }

  words(words, [x, y], color = "ink", align = "center") {
    const c = this.context;
    // Names of vectors are bold.
    c.font = `${/^([LVωΩ]|e[₁₂₃])$/.test(words) ? "bold " : ""}15px Helvetica, Arial, sans-serif`;
    Object.assign(c, { textAlign: align, strokeStyle: this.color("paper"), fillStyle: this.color(color), lineWidth: 4 });
    // Nothing is cut off at a side.
    const width = c.measureText(words).width + 4, before = { left: 0, center: width / 2, right: width }[align];
    const from = Math.max(before, Math.min(this.width - width + before, x));
    // A part after _ is a subscript.
    let at = from - (align === "left" ? 0 : align === "center" ? (width - 4) / 2 : width - 4);
    c.textAlign = "left";
    words.split("_").forEach((part, i) => {
      if (i) c.font = c.font.replace("15px", "11px");
      c.strokeText(part, at, y + 4 * i);
      c.fillText(part, at, y + 4 * i);
      at += c.measureText(part).width;
    });
  }

  /** The ellipsoid with three half axes: its outline and a shade. */
  ellipsoid(center, axes, color, opacity = 1) {
    // What one sees is the ellipse Q v, |v| ≤ 1, with two rows and three columns; L of Q Qᵀ = L Lᵀ makes it of a circle.
    const [q, p] = [this.right, this.up].map(direction => axes.map(axis => dot(axis, direction)));
    const a = norm(q), b = dot(q, p) / a, d = Math.sqrt(Math.max(0, dot(p, p) - b * b));
    const c = this.context, s = this.scale;
    c.save();
    c.transform(s * a, -s * b, 0, -s * d, ...this.at(center));
    const shade = c.createRadialGradient(-0.35, 0.4, 0, 0, 0, 1);
    for (const [place, alpha] of [[0, 0.05], [0.7, 0.22], [1, 0.5]]) {
      shade.addColorStop(place, `color-mix(in srgb, ${this.color(color)} ${100 * alpha * opacity}%, transparent)`);
    }
    c.fillStyle = shade;
    c.beginPath();
    c.arc(0, 0, 1, 0, 2 * Math.PI);
    c.fill();
    c.restore();
  }

  /** The faces of a box that one sees; `axes` are its half edges, `colors` those of the faces along each. */
  box(center, axes, colors, opacity = 1) {
    axes.forEach((axis, i) => {
      const facing = dot(axis, this.towards) / norm(axis);
      const middle = sum(center, times(facing < 0 ? -1 : 1, axis)), [u, v] = [axes[(i + 1) % 3], axes[(i + 2) % 3]];
      const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([p, q]) => sum(middle, times(p, u), times(q, v)));
      this.face(corners, "paper", opacity);
      // The face at the other end is paler, so that one tells them apart.
      this.face(corners, colors[i], (facing < 0 ? 0.22 : 0.5) + 0.25 * Math.abs(facing), 1.2);
    });
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
    this.words(x_name, [(left + right) / 2, this.high - 9]);
    let at = left + 4;
    for (const { name, color } of [{ name: y_name, color: "ink" }, ...curves.filter(curve => curve.name)]) {
      this.words(name, [at, 9], color, "left");
      at += c.measureText(name).width + 14;
    }
    delete this.at;
  }
}

// ---- What one sets: a slider, or one of several.

const slider = (name, label, from, to, step, value, unit = "") => ({ name, label, from, to, step, value, unit });
const choice = (name, label, options, value = 0) => ({ name, label, options, value });

/** Four digits, as one reads them. */
function shown(value) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const raised = power => power.replace("+", "").replace(/./g, sign => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]);
  const text = size < 1e-5 ? "0" : size >= 1e5 || size < 1e-3 ? value.toExponential(2) : value.toPrecision(4);
  return text.replace(/^-/, "−").replace(/e(.*)/, (_, power) => `·10${raised(power)}`);
}

/** A number of a figure with its unit, which may be so many of the SI unit. */
const measured = ([, value, measure = "", size = 1]) => `${shown(value / size)} ${measure}`;

// ---- A figure: its definition, then the figure on the page.

const definitions = {};

/** Adds a figure. A definition has
 *    question, choices, answer  what the reader predicts before it starts: choices by their words, each with one sentence
 *                               that begins with "Yes" or "No" and says why; and what happens. Until the reader has
 *                               chosen, neither numbers nor the caption are shown, and what is drawn must not tell
 *                               either; `scene.released` and `scene.expected` say whether and what
 *    about                      for those who do not see it
 *    controls                   sliders and choices; `values` holds what they are set to, by their names
 *    starts                     if need be: sets of values by their titles, the first at the beginning
 *    legal(values, changed)     may change values so that they fit the one that was changed
 *    prepare(values)            all that does not depend on time; `model` in the rest
 *    duration(model)            seconds of the motion;  pace: seconds of motion per second;  shows_end: a change of a
 *                               value shows the end of the motion instead of its beginning
 *    views                      pictures by their titles: {half, towards, aspect, draw(scene, model, time, values)} and,
 *                               for a point that one drags, handle(model, time, values) and drag(pixels, scene, values)
 *    numbers(model, time)       [name, value, unit] of what is shown as numbers; a fourth part says how much of the SI unit
 *                               the unit is
 */
function live(name, definition) { definitions[name] = definition; }

const element = (tag, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
};
/** I_xx with a subscript. */
const with_subscripts = words => words.split(/_([a-zφθψ]+)/).map((part, i) => i % 2 ? element("sub", { textContent: part }) : part);
const text = (tag, words) => element(tag, {}, ...with_subscripts(words));

class LiveFigure {
  constructor(place, definition) {
    Object.assign(this, { place, definition, time: 0, playing: false, in_sight: true, frames: 0, used: new Set() });
    this.values = Object.fromEntries(definition.controls.map(control => [control.name, control.value]));
    Object.assign(this.values, Object.values(definition.starts ?? {})[0]);
    place.replaceChildren(this.make_views(), this.make_question(), this.make_settings(), this.make_numbers());
    this.set({});
    this.turn_visible();
  }

  make_views() {
    this.scenes = Object.entries(this.definition.views).map(([title, view]) => {
      const canvas = element("canvas", { tabIndex: 0 });
      canvas.setAttribute("role", "img");
      const keys = view.towards ? " The arrow keys turn it." : "";
      canvas.setAttribute("aria-label", `${title}. ${this.definition.about}${keys}`);
      canvas.style.aspectRatio = view.aspect ?? 1.2;
      const scene = new Scene(canvas, view);
      this.offer_turning(scene, view);
      return { title, view, scene };
    });
    return element("div", { className: "views" }, ...this.scenes.map(({ title, view, scene }) =>
      element("div", { className: view.aspect > 1.5 ? "wide" : "" }, scene.canvas,
        text("span", scene.flat ? title : `${title} (drag to turn)`))));
  }

  /** With the pointer, and with the arrow keys. A finger that moves up or down scrolls the page. */
  offer_turning(scene, view) {
    const { canvas } = scene;
    let held = null, last;
    const pixels = event => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const grasped = event => {
      const at = view.handle && scene.at(view.handle(this.model, this.time, this.values)), [x, y] = pixels(event);
      return at && Math.hypot(at[0] - x, at[1] - y) < 28;
    };
    const hold = event => grasped(event.touches[0]) && event.preventDefault();
    canvas.addEventListener("touchstart", hold, { passive: false });
    canvas.onpointerdown = event => {
      held = grasped(event) ? "handle" : "view";
      last = pixels(event);
      canvas.setPointerCapture(event.pointerId);
    };
    canvas.onpointermove = event => {
      if (!held) return canvas.style.cursor = grasped(event) ? "pointer" : scene.flat ? "default" : "grab";
      const now = pixels(event);
      if (held === "handle") return this.set(view.drag(now, scene, this.values), "handle");
      scene.turn((now[0] - last[0]) / 120, (now[1] - last[1]) / 120);
      last = now;
      this.draw();
    };
    canvas.onpointerup = canvas.onpointercancel = () => held = null;
    canvas.onkeydown = event => {
      const way = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
      if (!way || scene.flat) return;
      event.preventDefault();
      scene.turn(...way);
      this.draw();
    };
  }

  /** What will happen? Only an answer lets the motion begin, and shows numbers and caption. */
  make_question() {
    const { question, choices, answer } = this.definition;
    const box = element("div", { className: "question" }, text("p", question));
    box.append(...Object.entries(choices).map(([expected, why], number) => element("button", {
      onclick: () => {
        this.explanation = element("details", {}, text("summary", "What happens"), text("p", why), text("p", answer));
        box.replaceChildren(text("p", `You expect: ${expected}.`), this.explanation);
        this.settings.disabled = this.numbers_box.hidden = false;
        this.place.closest("figure").classList.add("is-released");
        for (const { scene } of this.scenes) Object.assign(scene, { released: true, expected: number });
        this.play_button.focus();
        this.draw();
        this.speak();
        if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.play(true);
      },
    }, ...with_subscripts(expected))));
    return box;
  }

  make_settings() {
    this.play_button = element("button", { className: "play", onclick: () => this.play(!this.playing) });
    this.time_slider = element("input", { type: "range", min: 0, step: "any" });
    this.time_slider.oninput = () => {
      this.play(false);
      this.move_to(+this.time_slider.value);
    };
    this.time_slider.setAttribute("aria-label", "Time");
    this.clock = element("output");
    const rows = this.definition.controls.map(control => this.make_control(control)), { starts } = this.definition;
    if (starts) {
      this.start_box = element("select", { onchange: () => this.set(starts[this.start_box.value]) },
        ...Object.keys(starts).map(title => text("option", title)), text("option", "your own"));
      rows.unshift(element("label", {}, text("span", "Start"), this.start_box));
    }
    this.settings = element("fieldset", { disabled: true },
      element("div", { className: "time" }, this.play_button, this.time_slider, this.clock),
      element("div", { className: "settings" }, ...rows));
    this.play(false);
    return this.settings;
  }

  make_control(control) {
    const output = element("output");
    const input = control.options
      ? element("select", {}, ...control.options.map((title, i) => element("option", { textContent: title, value: i })))
      : element("input", { type: "range", min: control.from, max: control.to, step: control.step });
    input.oninput = () => {
      if (!control.options && this.start_box) this.start_box.value = "your own";
      this.set({ [control.name]: +input.value }, control.name);
    };
    control.show = value => {
      input.value = value;
      const digits = String(control.step).split(".")[1]?.length;
      if (!control.options) output.textContent = `${value.toFixed(digits).replace("-", "−")} ${control.unit}`;
    };
    return element("label", {}, text("span", control.label), input, ...control.options ? [] : [output]);
  }

  make_numbers() {
    this.list = element("dl");
    this.spoken = element("p", { className: "spoken" });
    this.spoken.setAttribute("role", "status");
    this.own = element("p");
    return this.numbers_box = element("div", { className: "numbers", hidden: true }, this.list, this.spoken, this.own);
  }

  /** Changes values: one by its name, that of the handle, or several. After another choice the time goes on, else the
   *  motion begins anew. */
  set(values, changed) {
    // The prediction was for other values.
    if (Object.keys(values).length) for (const { scene } of this.scenes) scene.expected = undefined;
    Object.assign(this.values, values);
    this.definition.legal?.(this.values, changed);
    for (const control of this.definition.controls) control.show(this.values[control.name]);
    used = this.used;
    this.model = this.definition.prepare(this.values);
    this.end = this.definition.duration(this.model);
    this.time_slider.max = this.end;
    const is_choice = this.definition.controls.some(({ name, options }) => options && name === changed);
    this.move_to(is_choice ? this.time : changed && this.definition.shows_end ? this.end : 0);
    this.speak();
  }

  move_to(time) {
    this.time = Math.min(time, this.end);
    this.draw();
  }

  play(playing) {
    if (playing && this.time >= this.end) this.time = 0;
    this.playing = playing;
    this.play_button.textContent = playing ? "Pause" : "Play";
    Object.assign(this, { last: undefined, interval: 16, pixels: 1 });
    if (playing) this.next_frame();
    else if (this.model) this.move_to(this.time), this.speak();
  }

  next_frame() {
    cancelAnimationFrame(this.frame);
    if (this.playing && this.in_sight) this.frame = requestAnimationFrame(now => {
      const passed = now - (this.last ?? now);
      this.last = now;
      this.adapt(passed);
      this.move_to(this.time + Math.min(passed, 100) / 1000 * (this.definition.pace ?? 1));
      if (this.time >= this.end) {
        this.play(false);
        this.explanation.open = true;
      }
      this.next_frame();
    });
  }

  /** Fewer pixels where there are less than fifty frames in a second, until it stands still. */
  adapt(passed) {
    this.interval += 0.05 * (Math.min(passed, 200) - this.interval);
    if (++this.frames % 60 || this.interval < 20) return;
    this.pixels = Math.max(0.7 * this.pixels, 0.5 / devicePixelRatio);
  }

  draw() {
    used = this.used;
    for (const { view, scene } of this.scenes) {
      scene.begin(this.pixels);
      view.draw(scene, this.model, this.time, this.values);
    }
    this.numbers = this.definition.numbers(this.model, this.time);
    if (used.size) this.own.textContent = `Computed with your own ${[...used].join(", ")}.`;
    this.time_slider.value = this.time;
    this.clock.textContent = `${this.time.toFixed(2)} s`;
    this.time_slider.setAttribute("aria-valuetext", this.clock.textContent);
    if (this.list.childElementCount !== this.numbers.length)
      this.list.replaceChildren(...this.numbers.map(() => element("div", {}, element("dt"), element("dd"))));
    this.numbers.forEach((number, i) => {
      const [term, text] = this.list.children[i].children;
      if (term.textContent !== number[0].replace("_", "")) term.replaceChildren(...with_subscripts(number[0]));
      text.textContent = measured(number);
    });
  }

  /** The numbers as a sentence, once they rest. */
  speak() {
    clearTimeout(this.pending);
    this.pending = setTimeout(() => {
      const numbers = this.numbers.map(number => `${number[0].replace("_", " ")} ${measured(number)}`).join(", ");
      this.spoken.textContent = `At ${this.time.toFixed(2)} seconds: ${numbers}.`;
    }, 300);
  }

  /** Shows the figure in the place of the still picture and its texts; it rests while it is out of sight. */
  turn_visible() {
    this.place.closest("figure").classList.add("is-live");
    new IntersectionObserver(entries => {
      this.in_sight = entries.at(-1).isIntersecting;
      this.last = undefined;
      this.next_frame();
    }).observe(this.place);
    new ResizeObserver(() => this.draw()).observe(this.place);
    new MutationObserver(() => this.draw()).observe(document.documentElement, { attributeFilter: ["class"] });
    this.draw();
  }
}

/** Called by site.js when all scripts are there. */
function start_live(place) {
  const begun = performance.now();
  place.live = new LiveFigure(place, definitions[place.dataset.figure]);
  place.live.started = performance.now() - begun;
}
