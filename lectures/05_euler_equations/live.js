// A bicycle wheel on a rope, and a free body by rules of integration.

live("wheel", {
  // A wheel that hardly spins does not stay level.
  legal(values) { if (Math.abs(values.spin) < 8) values.spin = values.spin < 0 ? -8 : 8; },
  prepare({ spin, arm, wheel_mass }) {
    // All mass in a rim of 0.3 m.
    const moment = wheel_mass * 0.3 ** 2, torque = wheel_mass * 9.81 * arm, L = moment * spin;
    return { arm, spin, L, torque, rate: torque / L };
  },
  duration: () => 8,
  pace: 0.7,
  views: {
    "The wheel on its rope": {
      half: 0.62, towards: [0.5, -1, 0.5], aspect: 1.5,
      // The hub.
      handle: (m, time) => sum([0, 0, 0.1], times(m.arm, [Math.cos(m.rate * time), Math.sin(m.rate * time), 0])),
      drag: (pixels, scene) => ({ arm: norm(scene.point_at(pixels).slice(0, 2)) }),
      draw(scene, m, time) {
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
          scene.line(arc(top, times(m.arm + 0.1, x_axis), times(m.arm + 0.1, y_axis), 0, turn), "grey", 1.5, { dash: [4, 4] });
        }
        const expected = [-1, undefined, 1][scene.expected], long = m.arm + 0.1;
        if (expected) scene.expect(arc(top, times(long, x_axis), times(expected * long, z_axis), 0, 1.3));
      },
    },
  },
  numbers: m => [["|L|", Math.abs(m.L), "kg m²/s"], ["torque", m.torque, "N m"], ["round the rope", m.rate, "rad/s"],
    ["once round in", 2 * Math.PI / Math.abs(m.rate), "s"]],
});

const rules = [
  (rate, state, h) => sum(state, times(h, rate(state))),
  (rate, state, h) => sum(state, times(h, rate(sum(state, times(h / 2, rate(state)))))),
  runge_kutta,
  (_, omega, h, I) => yours.splitting_step(I, omega, h)];
const constants = (I, omega) => yours.rotation_invariants?.(I, omega)
  ?? [dot(omega, scaled(I, omega)) / 2, dot(scaled(I, omega), scaled(I, omega))];

live("integrators", {
  prepare({ rule, h, w1, w2, w3 }) {
    const I = [1, 2, 3], start = [w1, w2, w3], seconds = 60, count = Math.floor(seconds / h);
    const rate = omega => yours.euler_equations?.(I, omega, origin) ?? free_rate(I)(omega);
    // What has left far behind what is drawn stays there, before its numbers overflow.
    const computed = history(omega => norm(omega) > 100 ? omega : rules[rule](rate, omega, h, I), start, count);
    const moments = steps(0, seconds, 400), exact = motion(I, start, undefined, seconds, 400, yours.free_rotation).map(({ omega }) => omega);
    const [T, L2] = constants(I, start), size = 1 / Math.sqrt(2 * T);
    const drift = computed.map((omega, k) => {
      const now = constants(I, omega);
      return [h * k, ...[now[0] / T, now[1] / L2].map(ratio => Math.log10(Math.max(Math.abs(ratio - 1), 1e-17)))];
    });
    return { I, h, computed, moments, exact, drift, size, axes: I.map(moment => 1 / Math.sqrt(moment)), seconds };
  },
  duration: m => m.seconds,
  pace: 4,
  views: {
    "ω and the ellipsoid of energy": {
      half: 1.4, towards: [0.95, 1.15, 0.62],
      draw(scene, m, time) {
        const k = Math.floor(time / m.h);
        scene.ellipsoid(origin, diagonal(...m.axes), "sky");
        if (scene.released) scene.line(m.exact.map(omega => times(m.size, omega)), "ink", 1.5);
        scene.line(m.computed.slice(Math.max(0, k - 400), k + 1).map(omega => times(m.size, omega)), "vermilion", 2.2);
        scene.arrow(origin, times(m.size, m.computed[k]), "omega", "ω");
        scene.arrows(axis_arrows(identity, m.axes));
      },
    },
    "Drift of the constants": {
      draw(scene, m, time) {
        scene.plot({ x: [0, m.seconds], y: [-17, 2], x_name: "time (s)", y_name: "log₁₀ |relative change|", now: time,
          curves: [["T", "blue", 1], ["L²", "purple", 2]].map(([name, color, i]) =>
            ({ name, color, points: m.drift.map(row => [row[0], row[i]]) })) });
      },
    },
    "Components of ω in the body: exact, and by the rule": {
      aspect: 3.6,
      draw(scene, m, time) {
        const exact = i => ({ color: "grey", points: m.exact.map((omega, k) => [m.moments[k], omega[i]]) });
        scene.plot({ x: [0, m.seconds], y: [-2.2, 2.2], x_name: "time (s)", y_name: "rad/s", now: time,
          curves: [0, 1, 2].map(exact).concat(axis_colors.map((color, i) => ({ color, name: omega_names[i], dash: [6, 4],
            points: m.computed.map((omega, k) => [m.h * k, omega[i]]) }))) });
      },
    },
  },
  numbers(m, time) {
    const omega = m.computed[Math.floor(time / m.h)], [T, L2] = constants(m.I, omega);
    const k = Math.floor(400 * time / m.seconds), rest = time - m.moments[k];
    const exact = motion(m.I, m.exact[k], identity, rest, 1, yours.free_rotation)[1];
    return [["T", T, "J"], ["L²", L2, "kg² m⁴/s²"], ["ω̃₂ exact", exact.omega[1], "rad/s"]];
  },
});
if (!yours.splitting_step) definitions.integrators.controls[0].options.pop();
