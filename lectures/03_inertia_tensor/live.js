// A box in bearings.

const moment_about = (I, n) => yours.moment_about_axis?.(I, n) ?? dot(n, turned(I, n));
const momentum_of = (I, omega) => yours.angular_momentum?.(I, omega) ?? turned(I, omega);
const rotated_by = (omega, time) => yours.rotated_basis?.(identity, omega, time) ?? rotation(times(time, omega));
const direction = ({ polar, azimuth }) => [Math.sin(polar * degree) * Math.cos(azimuth * degree),
  Math.sin(polar * degree) * Math.sin(azimuth * degree), Math.cos(polar * degree)];

/** Small faces of the unit sphere with the moment about the direction of each. */
function faces_of_sphere(I) {
  const point = (polar, azimuth) => direction({ polar, azimuth });
  const faces = [];
  for (let polar = 0; polar < 180; polar += 12)
    for (let azimuth = 0; azimuth < 360; azimuth += 15) {
      const middle = point(polar + 6, azimuth + 7.5);
      faces.push({ middle, moment: moment_about(I, middle),
        corners: [[0, 0], [12, 0], [12, 15], [0, 15]].map(([p, a]) => point(polar + p, azimuth + a)) });
    }
  return faces;
}

/** The handle is the tip of ω, on a ball with the radius that is drawn. */
const draggable = radius => ({
  handle: m => times(radius, m.n),
  drag(pixels, scene) {
    const [x, y, z] = unit(scene.point_at(pixels, radius));
    return { polar: Math.round(Math.acos(z) / degree), azimuth: Math.round((Math.atan2(y, x) / degree + 360) % 360) };
  },
});

live("held_spin", {
  about: "A box rotates about an axis through its centre that bearings hold; its angular momentum is L.",
  question: "Bearings hold the axis, and the box rotates about it steadily: ω is constant. What does L do?",
  choices: {
    "it points along ω": "No: L is along ω only if ω is along a principal axis; this ω is along none.",
    "it leans away from ω and stays": "No: no torque would act then, but L is fixed in the box, and the box turns.",
    "it goes round ω with the box": "Yes: I and ω are constant on the axes of the box, and so is L = I·ω.",
  },
  answer: "L belongs to the box: it goes round with it, on a cone about ω. Its change is the torque ω × L of the bearings. " +
    "Drag ω along an edge of the box: there L points along ω and no torque is needed. The longer the ellipsoid in a " +
    "direction, the smaller the moment about it.",
  controls: [slider("polar", "ω from e₃", 0, 180, 1, 60, "°"), slider("azimuth", "ω round e₃", 0, 360, 1, 40, "°"),
    slider("rate", "|ω|", 0.5, 3, 0.1, 1.5, "rad/s"), slider("a", "edge a", 0.4, 3, 0.1, 3, "m"),
    slider("b", "edge b", 0.4, 3, 0.1, 1.6, "m"), slider("c", "edge c", 0.4, 3, 0.1, 0.6, "m")],
  prepare(values) {
    const edges = [values.a, values.b, values.c], [a2, b2, c2] = edges.map(edge => edge ** 2 / 12);
    const I = yours.cuboid_about_center?.(1, ...edges) ?? diagonal(b2 + c2, a2 + c2, a2 + b2);
    const n = direction(values), omega = times(values.rate, n);
    const moments = I.map((column, i) => column[i]), faces = faces_of_sphere(I);
    const L = momentum_of(I, omega), scale = 1.25 / Math.max(...moments) / values.rate;
    const around = steps(0, 2 * Math.PI / values.rate, 72).map(time =>
      times(scale, turned(rotated_by(omega, time), L)));
    // The ellipsoid x I x = 1, drawn with the longest half axis of the box at 0.85.
    const size = 1.7 / Math.max(...edges);
    return { I, n, omega, faces, scale, around, moments, size, edges, L,
      least: Math.min(...moments), most: Math.max(...moments), energy: yours.kinetic_energy?.(I, omega) ?? dot(omega, L) / 2,
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
        scene.line([times(-1.3, m.n), times(1.3, m.n)], "grey", 1.5, { dash: [6, 5] });
        scene.body_with_arrows(() => {
          scene.box(origin, A.map((axis, i) => times(m.size * m.edges[i] / 2, axis)), axis_colors);
          scene.ellipsoid(origin, A.map((axis, i) => times(m.size / Math.sqrt(m.moments[i]), axis)), "blue");
        }, [[origin, times(1.3, m.n), "vermilion", "ω"], ...scene.released ? [[origin, L, "blue", "L"]] : []]);
        if (scene.released) scene.line(m.around, "blue", 1.5, { dash: [3, 4] });
        const expected = [times(norm(m.around[0]), m.n), m.around[0]][scene.expected];
        if (expected) scene.expect([origin, expected]);
        scene.dot(times(1.3, m.n), "vermilion", 6);
      },
    },
    "Energy over directions of ω: strong where it is large": {
      half: 1.4, towards: [0.75, 1, 0.6], ...draggable(1),
      draw(scene, m) {
        for (const { corners, moment } of m.faces.filter(({ middle }) => dot(middle, scene.towards) > -0.05))
          scene.face(corners, "purple", 0.06 + 0.74 * (moment - m.least) / (m.most - m.least || 1));
        for (const arrow of axis_arrows(identity, [1, 1, 1])) scene.arrow(...arrow);
        scene.dot(m.n, "vermilion", 6);
        scene.words("ω", [scene.at(m.n)[0] + 14, scene.at(m.n)[1] - 8], "vermilion");
      },
    },
  },
  numbers: m => [["I about ω", m.moment, "kg m²"], ["T", m.energy, "J"],
    ["|L|", norm(m.L), "kg m²/s"], ["bearing torque", norm(m.torque), "N m"],
    ...m.moments.map((moment, i) => [moment_names[i], moment, "kg m²"])],
});
