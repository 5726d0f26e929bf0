// A bicycle wheel on a rope, and a free body by rules of integration.

live("wheel", {
  // A wheel that hardly spins does not stay level.
  legal(values) { if (Math.abs(values.spin) < 8) values.spin = values.spin < 0 ? -8 : 8; },
  prepare({ spin, arm, wheel_mass }) {
    const moment = wheel_mass * 0.3 ** 2, torque = wheel_mass * 9.81 * arm, L = moment * spin;  // all mass in a rim of 0.3 m
    return { arm, spin, L, torque, rate: torque / L };
  },
  handle: ({ arm }) => [arm, 0, 0.1],  // the hub at the start
  draw: [(scene, m, time) => {
    const turn = m.rate * time, axle = [Math.cos(turn), Math.sin(turn), 0], side = [-axle[1], axle[0], 0];
    const top = [0, 0, 0.1], on = part => sum(top, times(part, axle)), hub = on(m.arm), roll = 0.3 * m.spin * time;
    const radial = angle => sum(times(Math.cos(angle), side), times(Math.sin(angle), z_axis));
    scene.floor(-0.42, 0.62);
    scene.line([[0, 0, 1], top], "orange", 3);
    scene.round("rod", on(-0.03), on(m.arm + 0.1), 0.012, "ink");
    scene.solid("ring", hub, [side, z_axis, axle].map(axis => times(0.3, axis)), "grey", { whiteness: 0 });
    for (const k of steps(0, 11, 11))
      scene.line([hub, sum(hub, times(0.29, radial(k * 30 * degree + roll)))], k ? "grey" : "vermilion", k ? 1.5 : 4);
    const way = m.spin < 0 ? -1 : 1, tip = sum(hub, times(0.3 * way, axle));
    scene.arrow(hub, sum(hub, [0, 0, -0.22]), "ink", "Mg", { width: 2.2 });
    if (scene.released) {
      scene.arrow(hub, tip, "L", "L");
      scene.arrow(tip, sum(tip, times(0.18, side)), "green", "dL", { width: 2.2 });
      scene.trail(arc(top, times(m.arm + 0.1, x_axis), times(m.arm + 0.1, y_axis), 0, turn), 73, "grey", 1.5, { dash: [4, 4] });
    }
    const expected = [-1, undefined, 1][scene.expected], long = m.arm + 0.1;
    if (expected) scene.expect(arc(top, times(long, x_axis), times(expected * long, z_axis), 0, 1.3));
  }],
  numbers: m => [Math.abs(m.L), m.torque, m.rate, 2 * Math.PI / Math.abs(m.rate)],
});

const rules = [
  (rate, h) => state => sum(state, times(h, rate(state))),
  (rate, h) => state => sum(state, times(h, rate(sum(state, times(h / 2, rate(state)))))),
  runge_kutta,
  (rate, h, I) => omega => yours.splitting_step(I, omega, h)];
const constants = (I, omega) => yours.rotation_invariants?.(I, omega)
  ?? [dot(omega, scaled(I, omega)) / 2, dot(scaled(I, omega), scaled(I, omega))];

live("integrators", {
  prepare({ rule, h, w1, w2, w3 }) {
    const I = [1, 2, 3], start = [w1, w2, w3], seconds = 60, count = Math.floor(seconds / h);
    const step = rules[rule](omega => yours.euler_equations?.(I, omega, origin) ?? free_rate(I)(omega), h, I);
    // What has left far behind what is drawn stays there, before its numbers overflow.
    const computed = history(omega => norm(omega) > 100 ? omega : step(omega), start, count);
    const exact = motion(I, start, undefined, seconds, 400, yours.free_rotation), [T, L2] = constants(I, start);
    const drift = omega => constants(I, omega).map((now, i) => Math.log10(Math.max(Math.abs(now / [T, L2][i] - 1), 1e-17)));
    const moments = steps(0, h * count, count);
    const size = 1 / Math.sqrt(2 * T), drawn = omega => times(size, omega);
    return { I, h, computed, exact, size, path: computed.map(drawn), true_path: exact.map(({ omega }) => drawn(omega)),
      axes: I.map(moment => 1 / Math.sqrt(moment)), seconds,
      drifts: over_time(moments, (_, k) => drift(computed[k])),
      curves: [...over_time(exact, ({ omega }) => omega), ...over_time(moments, (_, k) => computed[k])] };
  },
  handle: ({ w1, w2, w3 }) => on_ellipsoid([1, 2, 3], [w1, w2, w3]),  // the start of ω
  draw: [(scene, m, time) => {
    const k = Math.floor(time / m.h);
    scene.ellipsoid(origin, diagonal(...m.axes), "sky");
    if (scene.released) scene.line(m.true_path, "ink", 1.5);
    scene.trail(m.path, k + 1, "vermilion", 2.2);
    scene.arrow(origin, times(m.size, m.computed[k]), "omega", "ω");
    scene.arrows(axis_arrows(identity, m.axes));
  }, m => ({ curves: m.drifts }), m => ({ curves: m.curves })],
  numbers: (m, time) => [...constants(m.I, m.computed[Math.floor(time / m.h)]),
    moved_on(m.I, m.exact, time, yours.free_rotation).omega[1]],
});
if (!yours.splitting_step) definitions.integrators.controls[0].options.pop();
