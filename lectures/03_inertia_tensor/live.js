// A box in bearings.

const moment_about = (I, n) => yours.moment_about_axis?.(I, n) ?? dot(n, turned(I, n));
const momentum_of = (I, omega) => yours.angular_momentum?.(I, omega) ?? turned(I, omega);
const direction = ({ polar, azimuth }) => [Math.sin(polar * degree) * Math.cos(azimuth * degree),
  Math.sin(polar * degree) * Math.sin(azimuth * degree), Math.cos(polar * degree)];

live("held_spin", {
  prepare(values) {
    const edges = [values.a, values.b, values.c], [a2, b2, c2] = edges.map(edge => edge ** 2 / 12);
    const I = yours.cuboid_about_center?.(1, ...edges) ?? diagonal(b2 + c2, a2 + c2, a2 + b2);
    const n = direction(values), omega = times(values.rate, n);
    const moments = I.map((column, i) => column[i]);
    const L = momentum_of(I, omega), scale = 1.25 / Math.max(...moments) / values.rate;
    const around = steps(0, 2 * Math.PI / values.rate, 72).map(time =>
      times(scale, turned(rotated(yours.rotated_basis, identity, omega, time), L)));
    // The ellipsoid x I x = 1, drawn with the longest half axis of the box at 0.85.
    const size = 1.7 / Math.max(...edges);
    return { I, n, omega, scale, around, moments, size, edges, L,
      energies: on_ball(direction => moment_about(I, direction)), energy: yours.kinetic_energy?.(I, omega) ?? dot(omega, L) / 2,
      moment: moment_about(I, n), torque: yours.torque_to_hold_rotation?.(I, omega) ?? cross(omega, L) };
  },
  handle: values => times(1.3, direction(values)),  // the tip of ω
  draw: [(scene, m, time) => {
    const A = rotated(yours.rotated_basis, identity, m.omega, time);
    const I = yours.rotated_inertia?.(m.I, A) ?? product(A, product(m.I, transposed(A)));
    scene.round("rod", times(-1.15, m.n), times(1.15, m.n), 0.025, "grey");
    for (const side of [-1, 1]) scene.round("rod", times(0.98 * side, m.n), times(1.1 * side, m.n), 0.09, "grey");
    scene.box(origin, A.map((axis, i) => times(m.size * m.edges[i] / 2, axis)), axis_colors);
    scene.ellipsoid(origin, A.map((axis, i) => times(m.size / Math.sqrt(m.moments[i]), axis)), "sky", 0.35);
    scene.arrow(origin, times(1.3, m.n), "omega", "ω");
    if (scene.released) {
      scene.arrow(origin, times(m.scale, momentum_of(I, m.omega)), "L", "L");
      scene.fan(origin, m.around, "L", 0.12);
      scene.line(m.around, "L", 2);
    }
    const expected = [times(norm(m.around[0]), m.n), m.around[0]][scene.expected];
    if (expected) scene.expect([origin, expected]);
  }, (scene, m) => {
    scene.painted_ball(m.energies, "purple");
    scene.arrows(axis_arrows(identity, [1, 1, 1]));
    scene.arrow(origin, times(1.3, m.n), "omega", "ω");
  }],
  numbers: m => [m.moment, m.energy, norm(m.L), norm(m.torque), ...m.moments],
});
