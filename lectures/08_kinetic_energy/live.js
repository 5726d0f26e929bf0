// A free body in Euler angles. Calls euler_angle_rates, euler_angle_accelerations, canonical_momenta, kinetic_energy_euler,
// inertial_components, rotation_matrix.

live("angles_and_momenta", {
  about: "The axis of a free body nods while it goes round L, which is upright; its canonical momenta over time.",
  question: "No torque acts, and L is upright. The three moments differ. Which canonical momenta stay constant?",
  choices: ["all three", "p_φ and p_ψ, not p_θ", "p_φ and p_θ, not p_ψ"],
  answer: "p_φ is L along the vertical, p_θ is L along the line of nodes, which is level: zero. p_ψ is L along e₃, and e₃ nods as " +
    "long as I₁ and I₂ differ. Make them equal: ψ becomes cyclic, p_ψ constant, and e₃ goes round on a circle.",
  controls: [slider("I1", "I₁", 0.8, 2.4, 0.1, 1, "kg m²"), slider("I2", "I₂", 0.8, 2.4, 0.1, 1.8, "kg m²"),
    slider("I3", "I₃", 0.8, 1.6, 0.1, 1.6, "kg m²"), slider("theta", "θ", 10, 80, 1, 40, "°"),
    slider("psi", "ψ", 0, 360, 5, 180, "°"), slider("L", "L", 1, 4, 0.1, 3, "kg m²/s")],
  prepare(values) {
    const I = [values.I1, values.I2, values.I3], angles = times(degree, [0, values.theta, values.psi]);
    // L is upright; its components on the body axes are those of the vertical.
    const upright = turned(rigid.rotation_matrix(angles), [0, 0, values.L]);
    const rates = rigid.euler_angle_rates(angles, upright.map((component, i) => component / I[i]));
    const rate = state => [...state.slice(3), ...rigid.euler_angle_accelerations(I, state.slice(0, 3), state.slice(3))];
    const seconds = 12, states = history(state => runge_kutta(rate, state, seconds / 2400), [...angles, ...rates], 2400);
    const samples = states.filter((_, k) => k % 8 === 0).map(state => {
      const [q, v] = [state.slice(0, 3), state.slice(3)];
      return { q, v, momenta: rigid.canonical_momenta(I, q, v), tip: rigid.inertial_components(z_axis, q) };
    });
    return { I, seconds, samples, L: values.L };
  },
  duration: m => m.seconds,
  views: {
    "e₃ in space": {
      half: 1.4, towards: [0.3, -1, 0.9],
      draw(scene, m, time) {
        const k = Math.round(300 * time / m.seconds), { q } = m.samples[k], A = transposed(rigid.rotation_matrix(q));
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
            points: m.samples.map(({ momenta }, k) => [m.seconds * k / 300, momenta[i]]) })) });
      },
    },
  },
  numbers(m, time) {
    const { q, v } = m.samples[Math.round(300 * time / m.seconds)], momenta = rigid.canonical_momenta(m.I, q, v);
    return [["T", rigid.kinetic_energy_euler(m.I, q, v), "J"], ...momenta.map((p, i) => [["p_φ", "p_θ", "p_ψ"][i], p, "kg m²/s"])];
  },
});
