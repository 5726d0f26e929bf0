// Three turns in three conventions, and a passage near the vertical.

const angles_at = A => yours.euler_angles?.(transposed(A)) ?? angles_of(A);

const conventions = [[2, 1, 2], [2, 0, 2], [2, 1, 0]];  // the axes of the body about which each turns it, in order
const turn_names = [["φ", "θ", "ψ"], ["φ", "θ", "ψ"], ["yaw", "pitch", "roll"]];
const turn_colors = ["phi", "theta", "psi"];

/** Before, between and after the turns. */
const attitudes_of = ({ convention, phi, theta, psi }) => conventions[convention].reduce((before, axis, k) =>
  [...before, rotated(yours.rotated_basis, before[k], times([phi, theta, psi][k] * degree, before[k][axis]), 1)], [identity]);

live("three_turns", {
  prepare({ convention, phi, theta, psi }) {
    const angles = times(degree, [phi, theta, psi]), axes = conventions[convention];
    const attitudes = attitudes_of({ convention, phi, theta, psi });
    return { angles, axes, attitudes, names: turn_names[convention], ours: angles_at(attitudes[3]) };
  },
  handle: values => times(1.1, attitudes_of(values)[3][2]),  // e₃ in the end
  draw: [(scene, m, time) => {
    const turn = Math.min(2, Math.floor(time)), part = time - turn;
    const E = rotated(yours.rotated_basis, m.attitudes[turn], times(m.angles[turn], m.attitudes[turn][m.axes[turn]]), part);
    scene.arrows(axis_arrows(identity, origin, 0.6).map(([from, to, color]) => [from, to, color]));
    for (let k = 0; k <= turn; ++k) {
      const kept = m.axes[k], [u, v] = [1, 2].map(i => m.attitudes[k][(kept + i) % 3]);
      scene.face(arc(origin, u, v), turn_colors[k], 0.12, 1);
      const angle = m.angles[k] * (k === turn ? part : 1), swept = arc(origin, times(0.75, u), times(0.75, v), 0, angle);
      scene.fan(origin, swept, turn_colors[k], 0.35);
      scene.line(swept, turn_colors[k], 4);
      if (Math.abs(angle) > 0.2) scene.words(m.names[k], scene.at(times(1.25, swept[36])), turn_colors[k]);
    }
    scene.box(origin, E.map((axis, i) => times([0.34, 0.22, 0.08][i], axis)), axis_colors);
    scene.arrows(axis_arrows(E, origin, 1.1));
  }],
  numbers: m => [...m.ours, ...m.attitudes[3][2]],
});

live("gimbal_passage", {
  prepare({ distance, spin }) {
    // e₃ moves in the plane of x and the direction of the passage; half way it stands at `distance` from the vertical.
    const omega = [0, Math.cos(distance * degree), Math.sin(distance * degree)];
    const start = rotation([distance * degree, 0, 0]);
    const at = time => {
      const carried = rotated(yours.rotated_basis, start, omega, time - Math.PI / 2), A = rotated(yours.rotated_basis, carried, times(spin, carried[2]), time);
      const omega_now = sum(omega, times(spin, A[2])), angles = angles_at(A);
      const own = yours.euler_angle_rates?.(angles, turned(transposed(A), omega_now));
      return { A, angles, rates: own ?? angle_rates(angles, omega_now) };
    };
    const moments = steps(0, Math.PI, 240), curves = over_time(moments, time => at(time).rates);
    return { at, curves, seconds: Math.PI, most: 1.1 * Math.max(...curves.flat().map(([, rate]) => Math.abs(rate))) };
  },
  // Where the axis passes the vertical.
  handle: ({ distance }) => times(1.1, [0, -Math.sin(distance * degree), Math.cos(distance * degree)]),
  draw: [(scene, m, time) => {
    const { A, angles: [phi] } = m.at(time), nodes = [-Math.sin(phi), Math.cos(phi), 0];
    const across = [Math.cos(phi), Math.sin(phi), 0];
    const ring = (radius, u, v, color) =>
      scene.solid("ring", origin, [times(radius, u), times(radius, v), times(radius, cross(u, v))], color, { whiteness: 0.1 });
    scene.floor(-1.4, 1.1);
    ring(1.1, z_axis, nodes, "phi");
    ring(0.9, A[2], nodes, "theta");
    scene.round("rod", times(-0.06, A[2]), times(0.06, A[2]), 0.62, "psi");
    scene.line([times(0.065, A[2]), sum(times(0.065, A[2]), times(0.6, A[0]))], "ink", 3);
    for (const [axis, long, color, name] of [[z_axis, 1.35, "phi", "φ"], [nodes, 1.2, "theta", "θ"], [A[2], 1.1, "psi", "ψ"]])
      scene.arrow(times(-long, axis), times(long, axis), color, name);
    scene.line([times(-1, across), across], "grey", 1.5, { dash: [3, 5] });
  }, ({ curves, most }, time, { released, expected }) =>
    ({ y: released ? [-most, most] : [-2.2, 2.2], curves, expected: [[1, -1], [-6, 6]][expected] })],
  numbers(m, time) {
    const { angles, rates } = m.at(time);
    return [...angles, ...rates];
  },
});
