// A box in bearings.

const moment_about = (I, n) => yours.moment_about_axis?.(I, n) ?? dot(n, turned(I, n));
const momentum_of = (I, omega) => yours.angular_momentum?.(I, omega) ?? turned(I, omega);
const rotated_by = (omega, time) => yours.rotated_basis?.(identity, omega, time) ?? rotation(times(time, omega));
const direction = ({ polar, azimuth }) => [Math.sin(polar * degree) * Math.cos(azimuth * degree),
  Math.sin(polar * degree) * Math.sin(azimuth * degree), Math.cos(polar * degree)];

/** The handle is the tip of ω, on a ball with the radius that is drawn. */
const draggable = radius => ({
  handle: m => times(radius, m.n),
  drag(pixels, scene) {
    const [x, y, z] = unit(scene.point_at(pixels, radius));
    return { polar: Math.acos(z) / degree, azimuth: (Math.atan2(y, x) / degree + 360) % 360 };
  },
});

live("held_spin", {
  prepare(values) {
    const edges = [values.a, values.b, values.c], [a2, b2, c2] = edges.map(edge => edge ** 2 / 12);
    const I = yours.cuboid_about_center?.(1, ...edges) ?? diagonal(b2 + c2, a2 + c2, a2 + b2);
    const n = direction(values), omega = times(values.rate, n);
    const moments = I.map((column, i) => column[i]);
    const L = momentum_of(I, omega), scale = 1.25 / Math.max(...moments) / values.rate;
    const around = steps(0, 2 * Math.PI / values.rate, 72).map(time =>
      times(scale, turned(rotated_by(omega, time), L)));
    // The ellipsoid x I x = 1, drawn with the longest half axis of the box at 0.85.
    const size = 1.7 / Math.max(...edges);
    return { I, n, omega, scale, around, moments, size, edges, L,
      energies: on_ball(direction => moment_about(I, direction)), energy: yours.kinetic_energy?.(I, omega) ?? dot(omega, L) / 2,
      moment: moment_about(I, n), torque: yours.torque_to_hold_rotation?.(I, omega) ?? cross(omega, L) };
  },
  duration: () => 30,
  views: {
    "The box in its bearings, with its inertia ellipsoid": {
      half: 1.4, towards: [0.75, -1, 0.6], ...draggable(1.3),
      draw(scene, m, time) {
        const A = rotated_by(m.omega, time);
        const I = yours.rotated_inertia?.(m.I, A) ?? product(A, product(m.I, transposed(A)));
        const L = times(m.scale, momentum_of(I, m.omega));
        scene.round("rod", times(-1.15, m.n), times(1.15, m.n), 0.025, "grey");
        for (const side of [-1, 1]) scene.round("rod", times(0.98 * side, m.n), times(1.1 * side, m.n), 0.09, "grey");
        scene.box(origin, A.map((axis, i) => times(m.size * m.edges[i] / 2, axis)), axis_colors);
        scene.ellipsoid(origin, A.map((axis, i) => times(m.size / Math.sqrt(m.moments[i]), axis)), "sky", 0.35);
        scene.arrow(origin, times(1.3, m.n), "omega", "ω");
        if (scene.released) {
          scene.arrow(origin, L, "L", "L");
          scene.fan(origin, m.around, "L", 0.12);
          scene.line(m.around, "L", 2);
        }
        const expected = [times(norm(m.around[0]), m.n), m.around[0]][scene.expected];
        if (expected) scene.expect([origin, expected]);
      },
    },
    "Energy over directions of ω: strong where it is large": {
      half: 1.4, towards: [0.75, 1, 0.6], ...draggable(1),
      draw(scene, m) {
        scene.painted_ball(m.energies, "purple");
        scene.arrows(axis_arrows(identity, [1, 1, 1]));
        scene.dot(m.n, "omega", 6);
        scene.words("ω", [scene.at(m.n)[0] + 18, scene.at(m.n)[1] - 10], "omega");
      },
    },
  },
  numbers: m => [["I about ω", m.moment, "kg m²"], ["T", m.energy, "J"],
    ["|L|", norm(m.L), "kg m²/s"], ["bearing torque", norm(m.torque), "N m"],
    ...m.moments.map((moment, i) => [moment_names[i], moment, "kg m²"])],
});
