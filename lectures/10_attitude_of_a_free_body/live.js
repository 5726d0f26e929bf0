// The ellipsoid that rolls on its plane. Calls poinsot, herpolhode_radii, turn_per_period, geometric_phase,
// rotation_invariants, tumbling_period, free_rotation, free_attitude, shortest_rotation.

const crate = [1.2, 2, 2.7];

live("herpolhode", {
  about: "The ellipsoid of a free body rolls on a plane at rest; the point of contact draws the herpolhode in its ring.",
  question: "After one period of ω the ellipsoid touches the plane with the same point of its surface. Where on the plane?",
  choices: ["at the same place", "at another place of the ring", "outside the ring"],
  answer: "At another place, at the same distance from the foot: the body has turned about L by an angle that is in general no " +
    "fraction of a full turn. The herpolhode repeats itself, rotated by this angle, and never closes. The angle differs from " +
    "2TP/L by the solid angle that L encloses in the body, up to full turns.",
  controls: [slider("w1", "ω₁", 0.1, 1, 0.05, 0.4, "rad/s"), slider("w2", "ω₂", -1, -0.1, 0.05, -0.9, "rad/s"),
    slider("w3", "ω₃", 0.1, 1, 0.05, 0.6, "rad/s")],
  starts: { "round axis 3": { w1: 0.4, w2: -0.9, w3: 0.6 }, "round axis 1": { w1: 0.9, w2: -0.5, w3: 0.2 } },
  prepare({ w1, w2, w3 }) {
    const omega0 = [w1, w2, w3], momentum = omega => omega.map((rate, i) => crate[i] * rate);
    const [T, L2] = rigid.rotation_invariants(crate, omega0), [height] = rigid.poinsot(crate, omega0);
    // Close to the separatrix, or to a pure spin, there is no period worth the name.
    const is_far = Math.abs(L2 - 2 * T * crate[1]) > 0.02 * L2 && omega0.every(rate => Math.abs(rate) > 0.06 * norm(omega0));
    const period = is_far ? rigid.tumbling_period(crate, omega0) : NaN, seconds = is_far ? 3 * period : 60, count = 360;
    // L points down at the plane; the motion goes from sample to sample.
    const start = rigid.shortest_rotation(momentum(omega0), [0, 0, -1]), moments = steps(0, seconds, count);
    const omegas = rigid.free_rotation(crate, omega0, moments), attitudes = [start];
    for (let k = 1; k <= count; ++k)
      attitudes.push(product(attitudes[k - 1], rigid.free_attitude(crate, omegas[k - 1], seconds / count)));
    const contacts = omegas.map((omega, k) => turned(attitudes[k], omega));
    const axes = crate.map(moment => Math.sqrt(2 * T / moment));
    return { omega0, momentum, height, period, seconds, count, omegas, attitudes, contacts, axes, size: 1 / Math.max(...axes),
      radii: is_far ? rigid.herpolhode_radii(crate, omega0) : [],
      turn: is_far ? rigid.turn_per_period(crate, omega0) : NaN, angle: is_far ? rigid.geometric_phase(crate, omega0) : NaN,
      circles: [[0, 1], [1, 2], [2, 0]].map(([i, j]) => arc(origin, times(axes[i], identity[i]), times(axes[j], identity[j]))) };
  },
  duration: m => m.seconds,
  pace: 2,
  views: {
    "The ellipsoid rolls on the plane": {
      half: 1.3, towards: [0.3, -1, 0.5],
      draw(scene, m, time) {
        const k = Math.floor(m.count * time / m.seconds), A = m.attitudes[k], drawn = p => sum(times(m.size, p), [0, 0, 0.3]);
        const on_body = curve => curve.map(p => drawn(turned(A, p)));
        const normal = p => turned(A, m.momentum(turned(transposed(A), minus(p, [0, 0, 0.3]))));
        const foot = drawn([0, 0, -m.height]);
        scene.face(arc(foot, times(1.15, x_axis), times(1.15, y_axis)), "grey", 0.2, 1);
        scene.line(m.contacts.slice(0, k + 1).map(drawn), "vermilion", 2.2);
        scene.body_with_arrows(() => {
          scene.ellipsoid(drawn(origin), A.map((axis, i) => times(m.size * m.axes[i], axis)), "blue");
          for (const circle of m.circles) scene.on_surface(on_body(circle), normal, "grey", 1);
          scene.on_surface(on_body(m.omegas.slice(0, 1 + m.count / 3)), normal, "blue", 2);
        }, [[drawn(origin), sum(foot, [0, 0, -0.25]), "blue", "L"], [drawn(origin), drawn(m.contacts[k]), "vermilion", "ω"]]);
        scene.dot(drawn(m.contacts[k]), "ink");
      },
    },
    "The plane from above": {
      half: 1.15,
      draw(scene, m, time) {
        const k = Math.floor(m.count * time / m.seconds), size = 1 / Math.max(...m.contacts.map(([x, y]) => Math.hypot(x, y)));
        const drawn = ([x, y]) => [size * x, size * y, 0];
        for (const radius of m.radii)
          scene.line(arc(origin, times(size * radius, x_axis), times(size * radius, y_axis)), "grey", 1.2, { dash: [5, 5] });
        scene.line(m.contacts.slice(0, k + 1).map(drawn), "vermilion", 2.2);
        for (let turns = 0; 120 * turns <= k; ++turns) {
          scene.line([origin, drawn(m.contacts[120 * turns])], "grey", 1.2);
          scene.dot(drawn(m.contacts[120 * turns]), "blue", 5);
          scene.text(times(1.09, drawn(m.contacts[120 * turns])), ["0", "P", "2P", "3P"][turns], "blue");
        }
        scene.dot(drawn(m.contacts[k]), "ink");
        scene.dot(origin, "ink", 3);
      },
    },
  },
  numbers(m, time) {
    const [height, distance] = rigid.poinsot(crate, rigid.free_rotation(crate, m.omega0, [time]));
    return [["height", height, "rad/s"], ["contact to foot", distance, "rad/s"], ["period P", m.period, "s"],
      ["e₃ round L in P", m.turn, "°", degree], ["solid angle of L", m.angle, "sr"]];
  },
});
