// The ellipsoid that rolls on its plane.

const crate = [1.2, 2, 2.7], once = 360;  // kg m²; samples in a period of ω

live("herpolhode", {
  prepare({ w1, w2, w3 }) {
    const omega0 = [w1, w2, w3], momentum = omega => scaled(crate, omega), L_body = momentum(omega0);
    const [T, L2] = yours.rotation_invariants?.(crate, omega0) ?? [dot(omega0, L_body) / 2, dot(L_body, L_body)];
    // Close to a motion that never returns, or to a pure spin, there is no period worth the name.
    const is_far = Math.abs(L2 - 2 * T * crate[1]) > 0.02 * L2 && omega0.every(rate => Math.abs(rate) > 0.06 * norm(omega0));
    const period = is_far ? yours.tumbling_period?.(crate, omega0) ?? time_of_return(crate, omega0) : NaN;
    const seconds = is_far ? 3 * period : 60, count = 3 * once;
    // L points down at the plane.
    const samples = motion(crate, omega0, upright(times(-1, L_body)), seconds, count, yours.free_rotation, yours.free_attitude);
    const contacts = samples.map(({ omega, A }) => turned(A, omega)), distances = contacts.map(([x, y]) => Math.hypot(x, y));
    // Where L encloses an axis of the body: triangles from its end, counted on the unit sphere.
    const axis = L2 > 2 * T * crate[1] ? 2 : 0, end = times(Math.sign(omega0[axis]), identity[axis]);
    const in_period = samples.slice(0, once + 1), passed = in_period.map(({ omega }) => unit(momentum(omega)));
    const enclosed = passed.slice(1).reduce((area, b, k) => area + 2 * Math.atan2(dot(end, cross(passed[k], b)),
      1 + dot(end, passed[k]) + dot(passed[k], b) + dot(b, end)), 0);
    // L looks down: what goes round it to the right goes round the vertical to the left.
    const gone = -turns_of(in_period.map(({ A }) => A[2])).reduce((total, turn) => total + turn);
    const axes = crate.map(moment => Math.sqrt(2 * T / moment));
    return { height: -contacts[0][2], period, seconds, samples, contacts, polhode: in_period.map(({ omega }) => omega), axes,
      size: 1 / Math.max(...axes), widest: Math.max(...distances),
      radii: is_far ? yours.herpolhode_radii?.(crate, omega0) ?? [Math.min(...distances), Math.max(...distances)] : [],
      turn: is_far ? yours.turn_per_period?.(crate, omega0) ?? gone : NaN,
      angle: is_far ? yours.geometric_phase?.(crate, omega0) ?? Math.abs(enclosed) : NaN };
  },
  // The point of contact at the start.
  handle: ({ w1, w2, w3 }) => sum(turned(upright([-crate[0] * w1, -crate[1] * w2, -crate[2] * w3]), on_ellipsoid(crate, [w1, w2, w3])), [0, 0, 0.3]),
  draw: [(scene, m, time) => {
    const k = Math.floor(3 * once * time / m.seconds), { A } = m.samples[k], drawn = p => sum(times(m.size, p), [0, 0, 0.3]);
    const foot = drawn([0, 0, -m.height]);
    scene.floor(foot[2], 1.25);
    scene.trail(m.contacts, k + 1, "omega", 2.5, { axes: diagonal(m.size, m.size, m.size), center: drawn(origin) });
    scene.rolling_ellipsoid(drawn(origin), A.map((axis, i) => times(m.size * m.axes[i], axis)));
    scene.line(m.polhode, "blue", 3, { axes: A.map(axis => times(m.size, axis)), center: drawn(origin) });
    scene.arrow(drawn(origin), sum(foot, [0, 0, -0.25]), "L", "L");
    scene.arrow(drawn(origin), drawn(m.contacts[k]), "omega", "ω", { beside: true });
    scene.dot(drawn(m.contacts[k]), "ink");
  }, (scene, m, time) => {
    const k = Math.floor(3 * once * time / m.seconds), drawn = ([x, y]) => times(1 / m.widest, [x, y, 0]);
    if (scene.expected === 0) scene.expect([drawn(m.contacts[0])], "P expected");
    for (const radius of scene.released ? times(1 / m.widest, m.radii) : [])
      scene.line(arc(origin, times(radius, x_axis), times(radius, y_axis)), "grey", 1.2, { dash: [5, 5] });
    scene.trail(m.contacts, k + 1, "vermilion", 2.2, { axes: diagonal(1 / m.widest, 1 / m.widest, 0) });
    for (let turns = 0; once * turns <= k; ++turns) {
      const place = drawn(m.contacts[once * turns]);
      scene.line([origin, place], "grey", 1.2);
      scene.dot(place, "blue", 5);
      scene.words(["0", "P", "2P", "3P"][turns], scene.at(times(1.09, place)), "blue");
    }
    scene.dot(drawn(m.contacts[k]), "ink");
    scene.dot(origin, "ink", 3);
  }],
  numbers(m, time) {
    const { omega, A } = moved_on(crate, m.samples, time, yours.free_rotation, yours.free_attitude), [x, y, z] = turned(A, omega);
    return [...yours.poinsot?.(crate, omega) ?? [-z, Math.hypot(x, y)], m.period, m.turn, m.angle];
  },
});
