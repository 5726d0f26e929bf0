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
  return motion(I, omega, identity, Math.min(period_of(I, omega), 60), count, yours.free_rotation).map(now => now.omega);
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
  return { I, omega0, edges: times(0.85 / norm(edges), edges), T, L2, L, period, at, seconds, omegas, moments_of_time,
    herpolhode, axes, others, momentum, once, polhode: polhode_of(I, omega0), size: 1 / Math.max(...axes),
    circles: [0, 1, 2].map(i => [1, 2].map(k => times(axes[(i + k) % 3], identity[(i + k) % 3])))
      .map(([u, v]) => arc(origin, u, v)) };
}

function draw_in_body(scene, m, time, { surface }) {
  const { omega } = m.at(time);
  // On the ellipsoid of energy stands ω, on the sphere L; both normals are along I ω.
  const place = surface === 0 ? w => times(m.size, w) : w => unit(m.momentum(w));
  const normal = p => surface === 0 ? m.momentum(p) : p;
  const arrows = axis_arrows(identity, surface === 0 ? times(m.size, m.axes) : [1, 1, 1]);
  arrows.push([origin, times(surface === 0 ? 1.25 : 1, unit(m.momentum(omega))), "blue", "L"]);
  if (surface === 0) arrows.push([origin, place(omega), "vermilion", "ω", { beside: true }]);
  scene.body_with_arrows(() => {
    scene.ellipsoid(origin, surface === 0 ? diagonal(...times(m.size, m.axes)) : identity, "blue");
    for (const curve of m.others) scene.on_surface(curve.map(place), normal, "grey", 1);
    if (scene.released) scene.on_surface(m.polhode.map(place), normal, "vermilion", 3);
  }, arrows);
}

/** A cone over a curve, with some of its lines, which show how it turns. */
function draw_cone(scene, apex, curve, color) {
  curve.slice(1).forEach((point, k) => scene.face([apex, curve[k], point], color, 0.1));
  curve.filter((_, k) => k % 16 === 0).forEach(point => scene.line([apex, point], color, 1));
  scene.line(curve, color, 2);
}

function draw_in_space(scene, m, time, { picture }) {
  const now = m.at(time), { A } = now, omega = turned(A, now.omega);
  // Cones stand on their tip.
  const [center, size] = picture === 1 ? [[0, 0, -0.7], 1.5 * m.size] : [origin, m.size];
  const drawn = vector => sum(center, times(size, vector)), in_body = vector => drawn(turned(A, vector));
  const bodies = [
    () => scene.box(origin, A.map((axis, i) => times(m.edges[i], axis)), axis_colors),
    () => {
      draw_cone(scene, center, m.herpolhode.slice(0, m.once).map(drawn), "grey");
      draw_cone(scene, center, m.polhode.map(in_body), "blue");
    },
    () => {
      const normal = p => turned(A, m.momentum(turned(transposed(A), p)));
      scene.ellipsoid(origin, A.map((axis, i) => times(size * m.axes[i], axis)), "blue");
      for (const circle of m.circles) scene.on_surface(circle.map(in_body), normal, "grey", 1);
      scene.on_surface(m.polhode.map(in_body), normal, "blue", 2);
      scene.face(arc([0, 0, size * 2 * m.T / m.L], times(1.15, x_axis), times(1.15, y_axis)), "grey", 0.2, 1);
      scene.line(m.herpolhode.slice(0, 1 + Math.floor(480 * time / m.seconds)).map(drawn), "vermilion", 2.2);
      scene.dot(drawn(omega), "ink");
    }];
  const arrows = [[center, sum(center, [0, 0, picture === 1 ? 1.7 : 1.25]), "blue", "L"],
    [center, drawn(omega), "vermilion", "ω", { beside: true }]];
  if (picture === 0) arrows.push(...axis_arrows(A, m.edges));
  if (picture === 1) arrows.push([center, sum(center, times(1.6, A[2])), "purple", "e₃"]);
  scene.body_with_arrows(bodies[picture], arrows);
  // e₂ along L, which is upright; e₃ round L the other way, or at rest.
  if (picture === 0 && scene.expected === 0) scene.expect([origin, z_axis], "e₂ expected");
  const start = m.at(0).A[2], across = unit(cross(z_axis, start));
  const expected = [minus(A[2], times(2 * dot(A[2], across), across)), start][scene.expected - 1];
  if (picture === 1 && expected) scene.expect([center, sum(center, times(1.6, expected))], "e₃ expected");
}

const free_body = {
  about: "A body that rotates without torque: its angular velocity ω moves along a curve on the ellipsoid of energy.",
  question: "The body is thrown about its intermediate axis e₂, nearly exactly. What will e₂ do in space?",
  choices: {
    "it stays near L": "No: so do the axes of the largest and the smallest moment; near the intermediate one an " +
      "error grows.",
    "it swings about L a little": "No: near e₂ the equations have one solution that grows and one that decays, none " +
      "that oscillates.",
    "it turns over, again and again": "Yes: the small error grows, and the curve on which ω then moves leads on to " +
      "−e₂ and back.",
  },
  answer: "It rests near L for a while, then turns over within a few 1/σ, rests upside down, and turns back. L stays where " +
    "it is. Make the start more exact: the rests grow longer, but no care prevents the next flip.",
  controls: [
    choice("surface", "In the body", ["ellipsoid of energy, with ω", "sphere of L"]),
    choice("picture", "In space", ["the body", "body cone and space cone", "Poinsot: ellipsoid on a plane"]),
    slider("I1", "I₁", 0.5, 4, 0.05, 1, "kg m²"), slider("I2", "I₂", 0.5, 4, 0.05, 2, "kg m²"),
    slider("I3", "I₃", 0.5, 4, 0.05, 3, "kg m²"),
    slider("w1", "ω̃₁", 0, 4, 0.01, 0, "rad/s"), slider("w2", "ω̃₂", 0, 4, 0.01, 0, "rad/s"),
    slider("w3", "ω̃₃", 0.01, 4, 0.01, 0, "rad/s")],
  starts: {
    "about the intermediate axis": { I1: 1, I2: 2, I3: 3, w1: 0, w2: 3, w3: 0.02, picture: 0 },
    "near the axis of the largest moment": { I1: 1, I2: 2, I3: 3, w1: 0.6, w2: 0.6, w3: 2, picture: 2 },
    "near the axis of the smallest moment": { I1: 1, I2: 2, I3: 3, w1: 2.6, w2: 0.6, w3: 0.4, picture: 2 },
    "a long top": { I1: 2, I2: 2, I3: 1, w1: 1, w2: 0, w3: 2, picture: 1 },
    "a flattened top": { I1: 1, I2: 1, I3: 1.8, w1: 1, w2: 0, w3: 2, picture: 1 },
  },
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
    "In the body": { half: 1.42, towards: [0.95, 1.15, 0.62], draw: draw_in_body },
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
  question: "A long top wobbles. Seen from above, L points at you: which way does e₃ go round L, compared with the spin ω̃₃?",
  choices: {
    "in the same sense": "Yes: it goes round L at the rate L/I₁, positive for every shape, and e₃ and L are less " +
      "than 90° apart.",
    "in the opposite sense": "No: this is what ω does in the body of a long top; in space e₃ goes round with the spin.",
    "it stays where it is": "No: only L stays; ω has a part across e₃, and that moves e₃.",
  },
  answer: "In the same sense, at L/I₁, for every top. Only seen from the body does ω go round the other way if the top is long. " +
    "Try the flattened top: there the wide body cone rolls around the narrow space cone inside it.",
  starts: Object.fromEntries(["a long top", "a flattened top"].map(title => [title, free_body.starts[title]])),
});
