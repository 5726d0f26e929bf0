// A free body in Euler angles.

/** The axes of the body, and what it has by ω, on the axes of space. */
function state_of(I, q, v) {
  const own = yours.rotation_matrix?.(q), A = own ? transposed(own) : attitude(q);
  const nodes = [-Math.sin(q[0]), Math.cos(q[0]), 0];
  const omega = sum(times(v[0], z_axis), times(v[1], nodes), times(v[2], A[2]));
  const L = turned(A, scaled(I, turned(transposed(A), omega)));
  return { A, tip: yours.inertial_components?.(z_axis, q) ?? A[2],
    energy: yours.kinetic_energy_euler?.(I, q, v) ?? dot(L, omega) / 2,
    momenta: yours.canonical_momenta?.(I, q, v) ?? [z_axis, nodes, A[2]].map(axis => dot(L, axis)) };
}

live("angles_and_momenta", {
  prepare(values) {
    const I = [values.I1, values.I2, values.I3], angles = times(degree, [0, values.theta, values.psi]);
    // L is upright; its components on the body axes are those of the vertical.
    const A0 = attitude(angles), omega0 = turned(transposed(A0), [0, 0, values.L]).map((component, i) => component / I[i]);
    const rates_of = (q, omega, A) => yours.euler_angle_rates?.(q, omega) ?? angle_rates(q, turned(A, omega));
    const own = yours.euler_angle_accelerations, seconds = 12;
    const own_step = state => runge_kutta(([a, b, c, ...v]) => [...v, ...own(I, [a, b, c], v)], state, seconds / 2400);
    const samples = own
      ? history(own_step, [...angles, ...rates_of(angles, omega0, A0)], 2400).filter((_, k) => k % 8 === 0)
        .map(([a, b, c, ...v]) => state_of(I, [a, b, c], v))
      : motion(I, omega0, A0, seconds, 300).map(({ omega, A }) => state_of(I, angles_of(A), rates_of(angles_of(A), omega, A)));
    return { seconds, samples, L: values.L };
  },
  duration: m => m.seconds,
  views: {
    "e₃ in space": {
      half: 1.4, towards: [0.3, -1, 0.9],
      draw(scene, m, time) {
        const k = Math.round(300 * time / m.seconds), { A } = m.samples[k];
        scene.floor(-1.15, 1.3);
        scene.ellipsoid(origin, identity, "sky", 0.25);
        for (const latitude of [0, 30, 60]) scene.line(parallel(latitude * degree), "grey", 1.2);
        scene.line(m.samples.slice(0, k + 1).map(({ tip }) => tip), "e3", 3);
        scene.box(origin, A.map((axis, i) => times([0.34, 0.22, 0.1][i], axis)), axis_colors);
        scene.arrow(origin, A[2], "e3", "e₃");
        scene.arrow(origin, [0, 0, 1.25], "L", "L");
      },
    },
    "Canonical momenta": {
      draw(scene, m, time) {
        scene.plot({ x: [0, m.seconds], y: [-1.15 * m.L, 1.15 * m.L], x_name: "time (s)", y_name: "kg m²/s", now: time,
          curves: ["p_φ", "p_θ", "p_ψ"].map((name, i) => ({ name, color: ["phi", "theta", "psi"][i],
            points: m.samples.map(({ momenta }, k) => [m.seconds * k / 300, momenta[i]]) })),
          expected: [[0, 1, 2], [0, 2]][scene.expected]?.map(i => m.samples[0].momenta[i]) });
      },
    },
  },
  numbers(m, time) {
    const { energy, momenta } = m.samples[Math.round(300 * time / m.seconds)];
    return [["T", energy, "J"], ...momenta.map((p, i) => [["p_φ", "p_θ", "p_ψ"][i], p, "kg m²/s"])];
  },
});
