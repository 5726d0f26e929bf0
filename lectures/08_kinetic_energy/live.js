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
  about: "The axis e₃ of a free body and its angular momentum L, which is upright; its canonical momenta over time.",
  question: "No torque acts, and L is upright. The three moments differ. Which canonical momenta stay constant?",
  choices: {
    "all three": "No: p_ψ is L along e₃, and the angle between e₃ and L changes as long as I₁ and I₂ differ.",
    "p_φ and p_ψ, not p_θ": "No: ψ is cyclic only if I₁ = I₂, and p_θ is zero because the line of nodes is at right " +
      "angles to L.",
    "p_φ and p_θ, not p_ψ": "Yes: the vertical and the line of nodes keep their angles with L, which is upright; e₃ " +
      "does not.",
  },
  answer: "p_φ is L along the vertical, p_θ is L along the line of nodes, which is level: zero. p_ψ is L along e₃, and e₃ nods as " +
    "long as I₁ and I₂ differ. Make them equal: ψ becomes cyclic, p_ψ constant, and e₃ goes round on a circle.",
  controls: [slider("I1", "I₁", 0.8, 2.4, 0.1, 1, "kg m²"), slider("I2", "I₂", 0.8, 2.4, 0.1, 1.8, "kg m²"),
    slider("I3", "I₃", 0.8, 1.6, 0.1, 1.6, "kg m²"), slider("theta", "θ", 10, 80, 1, 40, "°"),
    slider("psi", "ψ", 0, 360, 5, 180, "°"), slider("L", "L", 1, 4, 0.1, 3, "kg m²/s")],
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
        scene.ellipsoid(origin, identity, "blue", 0.6);
        for (const latitude of [0, 30, 60]) scene.on_surface(parallel(latitude * degree), p => p, "grey", 1);
        scene.on_surface(m.samples.slice(0, k + 1).map(({ tip }) => tip), p => p, "vermilion", 2.5);
        scene.body_with_arrows(() => scene.box(origin, A.map((axis, i) => times([0.34, 0.22, 0.1][i], axis)), axis_colors),
          [[origin, A[2], "purple", "e₃"], [origin, [0, 0, 1.25], "blue", "L"]]);
      },
    },
    "Canonical momenta": {
      draw(scene, m, time) {
        scene.plot({ x: [0, m.seconds], y: [-1.15 * m.L, 1.15 * m.L], x_name: "time (s)", y_name: "kg m²/s", now: time,
          curves: ["p_φ", "p_θ", "p_ψ"].map((name, i) => ({ name, color: ["blue", "vermilion", "green"][i],
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
