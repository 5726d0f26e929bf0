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
  shows_end: true,
  prepare({ x, y, z }) {
    const end = [x, y, z], I_corner = yours.cuboid_about_corner?.(mass, ...edges) ?? block_about(center);
    // R points from the new origin to the old one.
    const about = point => yours.inertia_about_shifted_origin?.(I_corner, mass, center, times(-1, point))
      ?? block_about(minus(point, center));
    return { end, about, curve: steps(0, 1, 60).map(part => [part, about(times(part, end))]) };
  },
  duration: () => 6,
  views: {
    "The block and its ellipsoid about the point": {
      half: 1.2, towards: [1, -1, 0.6],
      handle: m => from_center(m.end),
      drag(pixels, scene, { x, y, z }) {
        const depth = dot(from_center([x, y, z]), scene.towards);
        const point = sum(center, times(2, sum(scene.point_at(pixels), times(depth, scene.towards))));
        return { x: point[0], y: point[1], z: point[2] };
      },
      draw(scene, m, time) {
        const P = times(time / 6, m.end), I = m.about(P), at = from_center(P);
        const { moments, axes } = principal(I);
        scene.box(origin, edges.map((edge, i) => times(edge / 4, identity[i])), ["grey", "grey", "grey"], 0.15);
        scene.line([from_center(origin), from_center(m.end)], "ink", 1.5, { dash: [4, 4] });
        scene.dot(origin, "ink", 3);
        if (scene.released) {
          scene.ellipsoid(at, axes.map((axis, i) => times(1 / Math.sqrt(moments[i]), axis)), "sky");
          axes.forEach((axis, i) => {
            const half = times(1.25 / Math.sqrt(moments[i]), axis);
            scene.line([minus(at, half), sum(at, half)], axis_colors[i], 2.5);
            scene.text(sum(at, times(1.25, half)), moment_names[i], axis_colors[i]);
          });
        }
        scene.dot(at, "vermilion", 5);
      },
    },
    "Along the path": {
      draw(scene, m, time) {
        const entries = [["I_xx", "blue", 0, 0], ["I_yy", "green", 1, 1], ["I_zz", "purple", 2, 2], ["I_yz", "vermilion", 2, 1]];
        const curves = entries.map(([name, color, i, j]) =>
          ({ name, color, points: m.curve.map(([part, I]) => [part, I[i][j]]) }));
        const all = curves.flatMap(({ points }) => points.map(([, value]) => value));
        scene.plot({ x: [0, 1], y: [1.1 * Math.min(...all), 1.1 * Math.max(...all)], x_name: "part of the path",
          y_name: "kg m²", now: time / 6, curves });
      },
    },
  },
  numbers(m, time) {
    const I = m.about(times(time / 6, m.end));
    return [["I_xx", I[0][0], "kg m²"], ["I_yz", I[2][1], "kg m²"], ["I_xy", I[1][0], "kg m²"],
      ...principal(I).moments.map((moment, i) => [moment_names[i], moment, "kg m²"])];
  },
});
