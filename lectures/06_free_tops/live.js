// The free body.

/** The period of ω in the body. */
function period_of(I, omega) {
  const period = time_of_return(I, omega), order = [0, 1, 2].sort((i, j) => I[i] - I[j]);
  return Number.isFinite(period) && yours.tumbling_period?.(order.map(i => I[i]), order.map(i => omega[i])) || period;
}

/** ω over one period, or as long as a minute. */
const polhode_of = (I, omega, count = 160) =>
  motion(I, omega, undefined, Math.min(period_of(I, omega), 60), count, yours.free_rotation).map(now => now.omega);

function prepare_free_body(values) {
  const I = [values.I1, values.I2, values.I3], omega0 = [values.w1, values.w2, values.w3];
  const momentum = omega => scaled(I, omega), L_body = momentum(omega0);
  const [T, L2] = yours.rotation_invariants?.(I, omega0) ?? [dot(omega0, L_body) / 2, dot(L_body, L_body)];
  const L = Math.sqrt(L2), period = period_of(I, omega0), seconds = Math.max(12, Math.min(2.5 * period, 40));
  const samples = motion(I, omega0, upright(L_body), seconds, 480, yours.free_rotation, yours.free_attitude);  // in space L is upright
  const herpolhode = samples.map(({ omega, A }) => turned(A, omega));
  let round = 0;  // until ω has gone once round L
  const full = turns_of(herpolhode).findIndex(turn => (round += Math.abs(turn)) >= 2 * Math.PI);
  // Other motions with this energy, from the plane of each pair of neighbouring axes.
  const axes = I.map(moment => Math.sqrt(2 * T / moment));
  const others = [[0, 1], [1, 2], [2, 0]].flatMap(([i, j]) => [0.35, 0.8, 1.2].flatMap(angle => {
    const from = sum(times(axes[i] * Math.cos(angle), identity[i]), times(axes[j] * Math.sin(angle), identity[j]));
    const curve = polhode_of(I, from, 80);
    return [curve, curve.map(omega => times(-1, omega))];
  }));
  // On the ellipsoid of energy stands ω, on the sphere L.
  const size = 1 / Math.max(...axes), place = values.surface ? omega => unit(momentum(omega)) : omega => times(size, omega);
  const polhode = polhode_of(I, omega0);
  // Half edges of a uniform box with these moments.
  const [a, b, c] = I, edges = [b + c - a, c + a - b, a + b - c].map(square => Math.sqrt(Math.max(square, 0.003)));
  return { I, omega0, samples, edges: times(0.85 / norm(edges), edges), T, L2, L, period, seconds, herpolhode, axes, momentum, place, size,
    polhode, on_surface: polhode.map(place), others: others.flatMap(curve => [...curve.map(place), null]),
    space_cone: herpolhode.slice(0, full < 0 ? undefined : full + 2), curves: over_time(samples, ({ omega }) => omega),
    at: time => moved_on(I, samples, time, yours.free_rotation, yours.free_attitude) };
}

function draw_in_body(scene, m, time, { surface = 0 }) {
  const { omega } = m.at(time);
  scene.ellipsoid(origin, surface === 0 ? diagonal(...times(m.size, m.axes)) : identity, "sky");
  scene.line(m.others, "grey", 1.2);
  if (scene.released) scene.line(m.on_surface, surface === 0 ? "omega" : "L", 3.5);
  scene.arrows(axis_arrows(identity, surface === 0 ? times(m.size, m.axes) : [1, 1, 1]));
  scene.arrow(origin, times(surface === 0 ? 1.25 : 1.02, unit(m.momentum(omega))), "L", "L");
  if (surface === 0) scene.arrow(origin, m.place(omega), "omega", "ω", { beside: true });
}

function draw_in_space(scene, m, time, { picture }) {
  const now = m.at(time), { A } = now, omega = turned(A, now.omega);
  const [center, size] = picture === 1 ? [[0, 0, -0.7], 1.5 * m.size] : [origin, m.size];  // cones stand on their tip
  const drawn = vector => sum(center, times(size, vector)), in_body = vector => drawn(turned(A, vector));
  if (picture === 0 || picture === 3) {
    scene.floor(-1.15, 1.25);
    if (picture === 0) scene.box(origin, A.map((axis, i) => times(m.edges[i], axis)), axis_colors);
    else for (const [i, from, to, radius] of [[0, -0.62, 0.62, 0.1], [1, 0.05, 0.5, 0.09]])
      scene.round("rod", times(from, A[i]), times(to, A[i]), radius, axis_colors[i]);
    scene.arrows(axis_arrows(A, m.edges));
    // Where the tip of e₂ has been, as far as two seconds ago.
    const tips = m.samples.filter(sample => sample.time > time - 2 && sample.time <= time).map(({ A }) => times(m.edges[1] + 0.3, A[1]));
    scene.trail(tips, tips.length, "e2", 2.5);
  } else if (picture === 1) {
    // Some of the lines of each cone show how it turns.
    for (const [curve, color] of [[m.space_cone.map(drawn), "grey"], [m.polhode.map(in_body), "blue"]]) {
      scene.fan(center, curve, color, 0.6);
      scene.line(curve.flatMap((point, k) => k % 16 ? [] : [center, point, null]), color, 1);
      scene.line(curve, color, 2);
    }
    scene.arrow(center, sum(center, times(1.6, A[2])), "e3", "e₃");
  } else {
    scene.rolling_ellipsoid(origin, A.map((axis, i) => times(size * m.axes[i], axis)));
    scene.line(m.polhode, "blue", 2.5, { axes: A.map(axis => times(size, axis)) });
    scene.face(arc([0, 0, size * 2 * m.T / m.L], times(1.15, x_axis), times(1.15, y_axis)), "grey", 0.15, 1);
    scene.trail(m.herpolhode, 1 + Math.floor(480 * time / m.seconds), "omega", 2.5, { axes: diagonal(size, size, size) });
    scene.dot(drawn(omega), "ink");
  }
  scene.arrow(center, sum(center, [0, 0, picture === 1 ? 1.7 : 1.25]), "L", "L");
  scene.arrow(center, drawn(omega), "omega", "ω", { beside: true });
  // e₂ along L, which is upright; e₃ round L the other way, or at rest.
  if (picture === 0 && scene.expected === 0) scene.expect([origin, z_axis], "e₂ expected");
  const start = m.at(0).A[2], across = unit(cross(z_axis, start));
  const expected = [minus(A[2], times(2 * dot(A[2], across), across)), start][scene.expected - 1];
  if (picture === 1 && expected) scene.expect([center, sum(center, times(1.6, expected))], "e₃ expected");
}

const free_body = {
  // No moment is larger than the sum of the others.
  legal(values, changed) {
    const names = ["I1", "I2", "I3"];
    if (!names.includes(changed)) return;
    const [a, b] = names.filter(name => name !== changed).map(name => values[name]);
    values[changed] = Math.min(Math.max(values[changed], Math.abs(a - b)), a + b);
  },
  prepare: prepare_free_body,
  // The start of ω, on its ellipsoid or as the direction of L.
  handle: ({ surface, I1, I2, I3, w1, w2, w3 }) =>
    surface === 0 ? on_ellipsoid([I1, I2, I3], [w1, w2, w3]) : unit([I1 * w1, I2 * w2, I3 * w3]),
  draw: [draw_in_body, draw_in_space, ({ curves }) => ({ curves })],
  numbers: (m, time) => [...m.at(time).omega, m.T, m.L2, m.period],
};
live("free_body", free_body);
live("rolling_cones", free_body);

// ---- The T-handle: a bar along e₁, with a stem along e₂ at its middle.

const handle_values = ({ spin, error }) =>
  ({ surface: 0, I1: 1, I2: 2.2, I3: 2.9, w1: 0, w2: spin * Math.cos(error * degree), w3: spin * Math.sin(error * degree) });
live("t_handle", {
  prepare: values => prepare_free_body(handle_values(values)),
  handle: values => free_body.handle(handle_values(values)),
  draw: [(scene, m, time) => draw_in_space(scene, m, time, { picture: 3 }), draw_in_body, ({ curves }) => ({ curves })],
  numbers: (m, time) => [...m.at(time).omega, m.period / 2, m.period / 2 * m.L / m.I[1] / 2 / Math.PI],
});

// ---- A thrown plate.

live("plate", {
  prepare({ tilt, ratio, spin }) {
    const theta = tilt * degree, omega = [ratio * spin * Math.tan(theta), 0, spin];
    const wobble = yours.space_precession_rate?.(1, ratio, omega) ?? norm(scaled([1, 1, ratio], omega));
    const round = wobble + spin - wobble * Math.cos(theta);  // of the emblem: wobble and rotation about the axis
    return { theta, ratio, wobble, round, spin, seconds: 4 * 2 * Math.PI / round,
      at: time => attitude([wobble * time, theta, (round - wobble) * time]) };
  },
  handle: ({ tilt }) => times(0.95, [Math.sin(tilt * degree), 0, Math.cos(tilt * degree)]),  // the axis at the start
  draw: [(scene, m, time) => {
    const A = m.at(time), [c, s] = [Math.cos(m.theta), Math.sin(m.theta)], thick = 0.05 + 0.6 * (2 - m.ratio);
    scene.floor(-0.9, 1.2);
    scene.round("rod", times(-thick, A[2]), times(thick, A[2]), 0.9, "sky");
    const [from, to] = [0.2, 0.85].map(part => sum(times(thick + 0.01, A[2]), times(part, A[0])));
    scene.line([from, to], "vermilion", 7);
    if (scene.released) scene.line(arc([0, 0, 0.95 * c], times(0.95 * s, x_axis), times(0.95 * s, y_axis)), "e3", 1.5, { dash: [4, 4] });
    scene.arrow(origin, [0, 0, 1.15], "L", "L");
    scene.arrow(origin, times(0.95, A[2]), "e3", "e₃");
    const turn = m.round * time * [0.5, 1][scene.expected];
    if (turn >= 0) scene.expect([origin, times(0.95, [s * Math.cos(turn), s * Math.sin(turn), c])], "e₃ expected");
  }, m => ({ curves: over_time([0, m.seconds], time => times(time / 2 / Math.PI, [m.round, m.wobble])) })],
  numbers: m => [m.wobble, m.round, m.wobble / m.round],
});

// ---- A satellite with antennas that bend.

const start_of_L = ({ angle }) => [Math.cos(angle * degree), 0.6 * Math.sin(angle * degree), 0.8 * Math.sin(angle * degree)];
live("friction", {
  prepare({ I1, kappa, angle }) {
    const I = [I1, 2, 2.4], L0 = times(3, start_of_L({ angle }));
    const omega_of = L => L.map((part, i) => part / I[i]), energy = L => dot(L, omega_of(L)) / 2;
    // L on the axes of the body, and with it two axes of space, which turn backwards there.
    const step = runge_kutta(([L, ...axes]) => {
      const omega = omega_of(L), across = cross(L, omega);
      return [sum(across, times(kappa / norm(L), cross(L, across))), ...axes.map(axis => cross(axis, omega))];
    }, 0.025);
    const samples = history(state => step(step(state)), [L0, ...transposed(upright(L0)).slice(0, 2)], 1200);
    return { samples, momenta: samples.map(([L]) => unit(L)), energies: samples.map(([L]) => energy(L)), landscape: on_ball(energy) };
  },
  handle: values => start_of_L(values),
  draw: [(scene, m, time) => {
    const k = Math.round(20 * time);
    scene.painted_ball(m.landscape, "sky");
    scene.arrows(axis_arrows(identity, [1, 1, 1]));
    scene.trail(m.momenta, k + 1, "L", 2.5);
    scene.arrow(origin, times(1.05, m.momenta[k]), "L", "L");
    if (scene.expected === 1) scene.expect([origin, times(1.3, x_axis)]);
  }, (scene, m, time) => {
    const [L, , y] = m.samples[Math.round(20 * time)], A = transposed([unit(cross(y, L)), y, unit(L)]);
    scene.floor(-1.2, 1.2);
    scene.round("rod", times(-0.75, A[0]), times(0.45, A[0]), 0.16, "e1");
    scene.round("cone", times(0.45, A[0]), times(0.85, A[0]), 0.16, "e1", { whiteness: 0.1 });
    for (const axis of [A[1], A[2]]) scene.line([times(-0.6, axis), times(0.6, axis)], "ink", 2);
    scene.arrow(origin, [0, 0, 1.2], "L", "L");
    scene.arrow(times(0.85, A[0]), times(1.1, A[0]), "e1", "e₁");
  }, m => ({ curves: [m.energies.map((T, k) => [k / 20, T])] })],
  numbers(m, time) {
    const k = Math.round(20 * time), [L] = m.samples[k];
    return [norm(L), m.energies[k], m.energies[0] - m.energies[k], Math.acos(Math.min(1, Math.abs(L[0]) / norm(L)))];
  },
});
