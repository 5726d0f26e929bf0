// The tensor of a block about a point that moves.

const mass = 6, edges = [1, 2, 3], center = times(0.5, edges);
const from_center = point => times(0.5, minus(point, center));
/** About the point at d from the centre. */
const block_about = d => identity.map((axis, i) =>
  minus(times(mass * (dot(edges, edges) - edges[i] ** 2) / 12 + mass * dot(d, d), axis), times(mass * d[i], d)));

/** Principal moments in ascending order, and axes: rotations that make the entries off the diagonal vanish. */
function principal(I) {
  let A = identity;
  const on_axes = () => product(transposed(A), product(I, A));
  for (let k = 0; k < 24; ++k) {
    const D = on_axes(), i = (k + 1) % 3, j = (k + 2) % 3, difference = D[i][i] - D[j][j];
    const angle = Math.atan2(2 * D[i][j] * (difference < 0 ? -1 : 1), Math.abs(difference)) / 2;
    A = product(A, rotation(times(angle, identity[k % 3])));
  }
  const D = on_axes(), order = [0, 1, 2].sort((i, j) => D[i][i] - D[j][j]);
  return { moments: yours.principal_moments?.(I) ?? order.map(i => D[i][i]),
    axes: yours.principal_axes?.(I) ?? order.map(i => A[i]) };
}

live("moving_point", {
  prepare({ x, y, z }) {
    const end = [x, y, z], I_corner = yours.cuboid_about_corner?.(mass, ...edges) ?? block_about(center);
    // R points from the new origin to the old one.
    const about = point => yours.inertia_about_shifted_origin?.(I_corner, mass, center, times(-1, point))
      ?? block_about(minus(point, center));
    const entries = I => [I[0][0], I[1][1], I[2][2], I[2][1]];
    return { end, about, curves: over_time(steps(0, 1, 60), part => entries(about(times(part, end)))) };
  },
  handle: ({ x, y, z }) => from_center([x, y, z]),
  draw: [(scene, m, time) => {
    const P = times(time / 6, m.end), at = from_center(P), { moments, axes } = principal(m.about(P));
    scene.box(origin, edges.map((edge, i) => times(edge / 4, identity[i])), ["grey", "grey", "grey"], 0.15);
    scene.line([from_center(origin), from_center(m.end)], "ink", 1.5, { dash: [4, 4] });
    scene.dot(origin, "ink", 3);
    if (scene.released) {
      scene.ellipsoid(at, axes.map((axis, i) => times(1 / Math.sqrt(moments[i]), axis)), "sky");
      axes.forEach((axis, i) => {
        const half = times(1.25 / Math.sqrt(moments[i]), axis);
        scene.line([minus(at, half), sum(at, half)], axis_colors[i], 2.5);
        scene.words(["I₁", "I₂", "I₃"][i], scene.at(sum(at, times(1.25, half))), axis_colors[i]);
      });
    }
    scene.dot(at, "vermilion", 5);
  }, (m, time) => ({ x: [0, 1], now: time / 6, curves: m.curves })],
  numbers(m, time) {
    const I = m.about(times(time / 6, m.end));
    return [I[0][0], I[2][1], I[1][0], ...principal(I).moments];
  },
});
