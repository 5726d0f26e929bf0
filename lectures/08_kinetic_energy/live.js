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
    const own = yours.euler_angle_accelerations, seconds = 12, moments = steps(0, seconds, 300);
    const samples = own
      ? history(runge_kutta(([q, v]) => [v, own(I, q, v)], seconds / 2400), [angles, rates_of(angles, omega0, A0)], 2400)
        .filter((_, k) => k % 8 === 0).map(([q, v]) => state_of(I, q, v))
      : motion(I, omega0, A0, seconds, 300).map(({ omega, A }) => state_of(I, angles_of(A), rates_of(angles_of(A), omega, A)));
    return { samples, tips: samples.map(({ tip }) => tip), curves: over_time(moments, (_, k) => samples[k].momenta) };
  },
  handle: ({ theta }) => [Math.sin(theta * degree), 0, Math.cos(theta * degree)],  // e₃ at the start
  draw: [(scene, m, time) => {
    const k = Math.round(25 * time), { A } = m.samples[k];
    scene.floor(-1.15, 1.3);
    scene.ellipsoid(origin, identity, "sky", 0.25);
    for (const latitude of [0, 30, 60]) scene.line(parallel(latitude * degree), "grey", 1.2);
    scene.trail(m.tips, k + 1, "e3", 3);
    scene.box(origin, A.map((axis, i) => times([0.34, 0.22, 0.1][i], axis)), axis_colors);
    scene.arrow(origin, A[2], "e3", "e₃");
    scene.arrow(origin, [0, 0, 1.25], "L", "L");
  }, ({ curves, samples: [{ momenta }] }, time, { expected }) =>
    ({ curves, expected: [[0, 1, 2], [0, 2]][expected]?.map(i => momenta[i]) })],
  numbers(m, time) {
    const { energy, momenta } = m.samples[Math.round(25 * time)];
    return [energy, ...momenta];
  },
});
