// The free body.

const moments = v => [v.I1, v.I2, v.I3];
const spin = v => [v.w1, v.w2, v.w3];

/** The period of ω in the body. */
function period_of(I, omega) {
  const period = time_of_return(I, omega), order = [0, 1, 2].sort((i, j) => I[i] - I[j]);
  return Number.isFinite(period) && yours.tumbling_period?.(order.map(i => I[i]), order.map(i => omega[i])) || period;
}

/** ω over one period, or as long as a minute. */
function polhode_of(I, omega, count = 160) {
  return motion(I, omega, undefined, Math.min(period_of(I, omega), 60), count, yours.free_rotation).map(now => now.omega);
}

function prepare_free_body(values) {
  const I = moments(values), omega0 = spin(values);
  const momentum = omega => scaled(I, omega), L_body = momentum(omega0);
  const [T, L2] = yours.rotation_invariants?.(I, omega0) ?? [dot(omega0, L_body) / 2, dot(L_body, L_body)];
  const L = Math.sqrt(L2), period = period_of(I, omega0), seconds = Math.max(12, Math.min(2.5 * period, 40));
  // In space L is upright.
  const move = (omega, A, time, count) => motion(I, omega, A, time, count, yours.free_rotation, yours.free_attitude);
  const moments_of_time = steps(0, seconds, 480), samples = move(omega0, upright(L_body), seconds, 480);
  const at = time => {
    const k = Math.floor(480 * time / seconds);
    return move(samples[k].omega, samples[k].A, time - moments_of_time[k], 1)[1];
  };
  const omegas = samples.map(({ omega }) => omega), herpolhode = samples.map(({ omega, A }) => turned(A, omega));
  // The samples until ω has gone once round L.
  let round = 0, once = 1;
  for (; once < herpolhode.length && round < 2 * Math.PI; ++once) {
    const [[a, b], [c, d]] = [herpolhode[once - 1], herpolhode[once]];
    round += Math.abs(Math.atan2(a * d - b * c, a * c + b * d));
  }
  // Other motions with this energy, from the plane of each pair of neighbouring axes.
  const axes = I.map(moment => Math.sqrt(2 * T / moment));
  const others = [];
  for (const [i, j] of [[0, 1], [1, 2], [2, 0]]) {
    for (const angle of [0.35, 0.8, 1.2]) {
      const from = [0, 0, 0];
      from[i] = axes[i] * Math.cos(angle);
      from[j] = axes[j] * Math.sin(angle);
      const curve = polhode_of(I, from, 80);
      others.push(curve, curve.map(omega => times(-1, omega)));
    }
  }
  // Half edges of a uniform box with these moments.
  const [a, b, c] = I, edges = [b + c - a, c + a - b, a + b - c].map(square => Math.sqrt(Math.max(square, 0.003)));
  return { I, omega0, samples, edges: times(0.85 / norm(edges), edges), T, L2, L, period, at, seconds, omegas, moments_of_time,
    herpolhode, axes, others, momentum, once, polhode: polhode_of(I, omega0), size: 1 / Math.max(...axes),
    circles: [0, 1, 2].map(i => [1, 2].map(k => times(axes[(i + k) % 3], identity[(i + k) % 3])))
      .map(([u, v]) => arc(origin, u, v)) };
}

function draw_in_body(scene, m, time, { surface }) {
  const { omega } = m.at(time);
  // On the ellipsoid of energy stands ω, on the sphere L.
  const place = surface === 0 ? w => times(m.size, w) : w => unit(m.momentum(w));
  scene.ellipsoid(origin, surface === 0 ? diagonal(...times(m.size, m.axes)) : identity, "sky");
  for (const curve of m.others) scene.line(curve.map(place), "grey", 1.2);
  if (scene.released) scene.line(m.polhode.map(place), surface === 0 ? "omega" : "L", 3.5);
  scene.arrows(axis_arrows(identity, surface === 0 ? times(m.size, m.axes) : [1, 1, 1]));
  scene.arrow(origin, times(surface === 0 ? 1.25 : 1.02, unit(m.momentum(omega))), "L", "L");
  if (surface === 0) scene.arrow(origin, place(omega), "omega", "ω", { beside: true });
}

/** A cone over a curve, with some of its lines, which show how it turns. */
function draw_cone(scene, apex, curve, color) {
  scene.fan(apex, curve, color, 0.6);
  curve.filter((_, k) => k % 16 === 0).forEach(point => scene.line([apex, point], color, 1));
  scene.line(curve, color, 2);
}

function draw_in_space(scene, m, time, { picture }) {
  const now = m.at(time), { A } = now, omega = turned(A, now.omega);
  // Cones stand on their tip.
  const [center, size] = picture === 1 ? [[0, 0, -0.7], 1.5 * m.size] : [origin, m.size];
  const drawn = vector => sum(center, times(size, vector)), in_body = vector => drawn(turned(A, vector));
  if (picture === 0 || picture === 3) {
    scene.floor(-1.15, 1.25);
    if (picture === 0) scene.box(origin, A.map((axis, i) => times(m.edges[i], axis)), axis_colors);
    else draw_handle(scene, A);
    scene.arrows(axis_arrows(A, m.edges));
    // Where the tip of e₂ has been, as far as two seconds ago.
    const tips = m.samples.slice(Math.max(0, Math.floor(480 * (time - 2) / m.seconds)), 1 + Math.floor(480 * time / m.seconds));
    scene.line(tips.map(({ A }) => times(m.edges[1] + 0.3, A[1])), "e2", 2.5);
  } else if (picture === 1) {
    draw_cone(scene, center, m.herpolhode.slice(0, m.once).map(drawn), "grey");
    draw_cone(scene, center, m.polhode.map(in_body), "blue");
    scene.arrow(center, sum(center, times(1.6, A[2])), "e3", "e₃");
  } else {
    scene.ellipsoid(origin, A.map((axis, i) => times(size * m.axes[i], axis)), "sky");
    for (const circle of m.circles) scene.line(circle.map(in_body), "grey", 1.2);
    scene.line(m.polhode.map(in_body), "blue", 2.5);
    scene.face(arc([0, 0, size * 2 * m.T / m.L], times(1.15, x_axis), times(1.15, y_axis)), "grey", 0.15, 1);
    scene.line(m.herpolhode.slice(0, 1 + Math.floor(480 * time / m.seconds)).map(drawn), "omega", 2.5);
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
  duration: m => m.seconds,
  views: {
    "In the body": {
      half: 1.42, towards: [0.95, 1.15, 0.62], draw: draw_in_body,
      // The start of ω, on its ellipsoid or as the direction of L; T stays.
      handle: (m, time, { surface }) => surface === 0 ? times(m.size, m.omega0) : unit(m.momentum(m.omega0)),
      drag(pixels, scene, { surface }, m) {
        const point = scene.point_at(pixels, 1), n = surface === 0 ? point : point.map((part, i) => part / m.I[i]);
        const omega = times(Math.sqrt(2 * m.T / dot(n, m.momentum(n))), n.map(Math.abs));
        return { w1: omega[0], w2: omega[1], w3: omega[2] };
      },
    },
    "In space": { half: 1.42, towards: [0.3, -1, 0.45], draw: draw_in_space },
    "Components of ω in the body": {
      aspect: 3.6,
      draw(scene, m, time) {
        const most = 1.1 * Math.max(...m.omegas.flat().map(Math.abs));
        scene.plot({ x: [0, m.seconds], y: [-most, most], x_name: "time (s)", y_name: "rad/s", now: time,
          curves: axis_colors.map((color, i) => ({ color, name: omega_names[i],
            points: m.omegas.map((omega, k) => [m.moments_of_time[k], omega[i]]) })) });
      },
    },
  },
  numbers(m, time) {
    return [...m.at(time).omega.map((rate, i) => [omega_names[i], rate, "rad/s"]), ["T", m.T, "J"], ["L²", m.L2, "kg² m⁴/s²"],
      ["period in the body", m.period, "s"]];
  },
};
live("free_body", free_body);

live("rolling_cones", {
  ...free_body,
});

// ---- The T-handle: a bar along e₁, with a stem along e₂ at its middle.

function draw_handle(scene, A) {
  scene.round("rod", times(-0.62, A[0]), times(0.62, A[0]), 0.1, "e1");
  scene.round("rod", times(0.05, A[1]), times(0.5, A[1]), 0.09, "e2");
}

live("t_handle", {
  ...free_body,
  legal: undefined,
  prepare: ({ spin, error }) => prepare_free_body({ I1: 1, I2: 2.2, I3: 2.9, w1: 0, w2: spin * Math.cos(error * degree),
    w3: spin * Math.sin(error * degree) }),
  views: {
    "The handle in space": { half: 1.42, towards: [0.3, -1, 0.45], draw: (scene, m, time) => draw_in_space(scene, m, time, { picture: 3 }) },
    "In the body": { half: 1.42, towards: [0.95, 1.15, 0.62], draw: (scene, m, time) => draw_in_body(scene, m, time, { surface: 0 }) },
    "Components of ω in the body": free_body.views["Components of ω in the body"],
  },
  numbers: (m, time) => [...m.at(time).omega.map((rate, i) => [omega_names[i], rate, "rad/s"]),
    ["from flip to flip", m.period / 2, "s"], ["turns meanwhile", m.period / 2 * m.L / m.I[1] / 2 / Math.PI, ""]],
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
  duration: m => m.seconds,
  pace: 0.4,
  views: {
    "The plate in flight": {
      half: 1.3, towards: [0.2, -1, 0.4],
      handle: (m, time) => times(0.95, m.at(time)[2]),
      drag(pixels, scene) {
        const [x, y, z] = scene.point_at(pixels, 0.95);
        return { tilt: Math.atan2(Math.hypot(x, y), z) / degree };
      },
      draw(scene, m, time) {
        const A = m.at(time), [c, s] = [Math.cos(m.theta), Math.sin(m.theta)];
        scene.floor(-0.9, 1.2);
        const thick = 0.05 + 0.6 * (2 - m.ratio);
        scene.round("rod", times(-thick, A[2]), times(thick, A[2]), 0.9, "sky");
        const [from, to] = [0.2, 0.85].map(part => sum(times(thick + 0.01, A[2]), times(part, A[0])));
        scene.line([from, to], "vermilion", 7);
        if (scene.released) scene.line(arc([0, 0, 0.95 * c], times(0.95 * s, x_axis), times(0.95 * s, y_axis)), "e3", 1.5, { dash: [4, 4] });
        scene.arrow(origin, [0, 0, 1.15], "L", "L");
        scene.arrow(origin, times(0.95, A[2]), "e3", "e₃");
        const turn = m.round * time * [0.5, 1][scene.expected];
        if (turn >= 0) scene.expect([origin, times(0.95, [s * Math.cos(turn), s * Math.sin(turn), c])], "e₃ expected");
      },
    },
    "How far they have gone round": {
      draw(scene, m, time) {
        const turns = rate => [0, m.seconds].map(t => [t, rate * t / 2 / Math.PI]);
        scene.plot({ x: [0, m.seconds], y: [0, 1.05 * m.wobble * m.seconds / 2 / Math.PI], x_name: "time (s)", y_name: "turns", now: time,
          curves: [{ name: "emblem", color: "vermilion", points: turns(m.round) },
            ...scene.released ? [{ name: "wobble", color: "e3", points: turns(m.wobble) }] : []] });
      },
    },
  },
  numbers: m => [["wobble", m.wobble, "rad/s"], ["emblem", m.round, "rad/s"], ["wobbles to a turn", m.wobble / m.round, ""]],
});

// ---- A satellite with antennas that bend.

live("friction", {
  prepare({ I1, kappa, angle }) {
    const I = [I1, 2, 2.4], L0 = times(3, [Math.cos(angle * degree), 0.6 * Math.sin(angle * degree), 0.8 * Math.sin(angle * degree)]);
    const seconds = 60, count = 1200, omega_of = L => L.map((part, i) => part / I[i]);
    // L on the axes of the body, and with it the axes of space, which turn backwards there.
    const rate = state => {
      const L = state.slice(0, 3), omega = omega_of(L), across = cross(L, omega);
      return [...sum(across, times(kappa / norm(L), cross(L, across))), ...[3, 6].flatMap(i => cross(state.slice(i, i + 3), omega))];
    };
    const [x, y] = transposed(upright(L0));
    const samples = history(state => runge_kutta(rate, runge_kutta(rate, state, 0.025), 0.025), [...L0, ...x, ...y], count);
    const momenta = samples.map(state => state.slice(0, 3)), energies = momenta.map(L => dot(L, omega_of(L)) / 2);
    return { I, seconds, momenta, omega_of, energies, landscape: on_ball(n => dot(n, omega_of(n))),
      at: k => transposed([unit(cross(samples[k].slice(6), momenta[k])), samples[k].slice(6), unit(momenta[k])]) };
  },
  duration: m => m.seconds,
  pace: 3,
  views: {
    "L in the body, on its sphere: strong where the energy is high": {
      half: 1.4, towards: [1.1, 0.9, 0.6],
      draw(scene, m, time) {
        const k = Math.round(20 * time);
        scene.painted_ball(m.landscape, "sky");
        scene.arrows(axis_arrows(identity, [1, 1, 1]));
        scene.line(m.momenta.slice(0, k + 1).map(unit), "L", 2.5);
        scene.arrow(origin, times(1.05, unit(m.momenta[k])), "L", "L");
        const expected = [undefined, x_axis][scene.expected];
        if (expected) scene.expect([origin, times(1.3, expected)]);
      },
    },
    "In space": {
      half: 1.4, towards: [0.3, -1, 0.45],
      draw(scene, m, time) {
        const k = Math.round(20 * time), A = m.at(k);
        scene.floor(-1.2, 1.2);
        scene.round("rod", times(-0.75, A[0]), times(0.45, A[0]), 0.16, "e1");
        scene.round("cone", times(0.45, A[0]), times(0.85, A[0]), 0.16, "e1", { whiteness: 0.1 });
        for (const axis of [A[1], A[2]]) scene.line([times(-0.6, axis), times(0.6, axis)], "ink", 2);
        scene.arrow(origin, [0, 0, 1.2], "L", "L");
        scene.arrow(times(0.85, A[0]), times(1.1, A[0]), "e1", "e₁");
      },
    },
    "Energy": {
      aspect: 3.6,
      draw(scene, m, time) {
        const most = 1.1 * m.energies[0];
        scene.plot({ x: [0, m.seconds], y: [0, most], x_name: "time (s)", y_name: "J", now: time,
          curves: [{ name: "T", color: "ink", points: m.energies.map((T, k) => [k / 20, T]) }] });
      },
    },
  },
  numbers(m, time) {
    const k = Math.round(20 * time), L = m.momenta[k];
    return [["|L|", norm(L), "kg m²/s"], ["T", m.energies[k], "J"], ["heat", m.energies[0] - m.energies[k], "J"],
      ["L from e₁", Math.acos(Math.min(1, Math.abs(L[0]) / norm(L))), "°", degree]];
  },
});
