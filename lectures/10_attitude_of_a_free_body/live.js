// The ellipsoid that rolls on its plane.

const crate = [1.2, 2, 2.7], once = 360;  // kg m²; samples in a period of ω

live("herpolhode", {
  prepare({ w1, w2, w3 }) {
    const omega0 = [w1, w2, w3], momentum = omega => scaled(crate, omega), L_body = momentum(omega0);
    const [T, L2] = yours.rotation_invariants?.(crate, omega0) ?? [dot(omega0, L_body) / 2, dot(L_body, L_body)];
    // Close to a motion that never returns, or to a pure spin, there is no period worth the name.
    const is_far = Math.abs(L2 - 2 * T * crate[1]) > 0.02 * L2 && omega0.every(rate => Math.abs(rate) > 0.06 * norm(omega0));
    const period = is_far ? yours.tumbling_period?.(crate, omega0) ?? time_of_return(crate, omega0) : NaN;
    const seconds = is_far ? 3 * period : 60, count = 3 * once;
    // L points down at the plane.
    const motions = motion(crate, omega0, upright(times(-1, L_body)), seconds, count, yours.free_rotation, yours.free_attitude);
    const omegas = motions.map(({ omega }) => omega), attitudes = motions.map(({ A }) => A);
    const contacts = motions.map(({ omega, A }) => turned(A, omega)), distances = contacts.map(([x, y]) => Math.hypot(x, y));
    // Where L encloses an axis of the body: triangles from its end, counted on the unit sphere.
    const axis = L2 > 2 * T * crate[1] ? 2 : 0, end = times(Math.sign(omega0[axis]), identity[axis]);
    const passed = omegas.slice(0, once + 1).map(omega => unit(momentum(omega)));
    const enclosed = passed.slice(1).reduce((area, b, k) => area + 2 * Math.atan2(dot(end, cross(passed[k], b)),
      1 + dot(end, passed[k]) + dot(passed[k], b) + dot(b, end)), 0);
    // L looks down, so that what goes round it to the right comes from x to −y.
    const gone = attitudes.slice(1, once + 1).reduce((angle, A, k) => {
      const [a, b] = attitudes[k][2], [c, d] = A[2];
      return angle + Math.atan2(b * c - a * d, a * c + b * d);
    }, 0);
    const axes = crate.map(moment => Math.sqrt(2 * T / moment));
    return { omega0, momentum, height: -contacts[0][2], period, seconds, count, omegas, attitudes, contacts, axes,
      size: 1 / Math.max(...axes),
      radii: is_far ? yours.herpolhode_radii?.(crate, omega0) ?? [Math.min(...distances), Math.max(...distances)] : [],
      turn: is_far ? yours.turn_per_period?.(crate, omega0) ?? gone : NaN,
      angle: is_far ? yours.geometric_phase?.(crate, omega0) ?? Math.abs(enclosed) : NaN,
      circles: [[0, 1], [1, 2], [2, 0]].map(([i, j]) => arc(origin, times(axes[i], identity[i]), times(axes[j], identity[j]))) };
  },
  duration: m => m.seconds,
  pace: 2,
  views: {
    "The ellipsoid rolls on the plane": {
      half: 1.3, towards: [0.3, -1, 0.5],
      draw(scene, m, time) {
        const k = Math.floor(m.count * time / m.seconds), A = m.attitudes[k], drawn = p => sum(times(m.size, p), [0, 0, 0.3]);
        const on_body = curve => curve.map(p => drawn(turned(A, p))), foot = drawn([0, 0, -m.height]);
        scene.floor(foot[2], 1.25);
        scene.line(m.contacts.slice(0, k + 1).map(drawn), "omega", 2.5);
        scene.ellipsoid(drawn(origin), A.map((axis, i) => times(m.size * m.axes[i], axis)), "sky");
        for (const circle of m.circles) scene.line(on_body(circle), "grey", 1.2);
        scene.line(on_body(m.omegas.slice(0, 1 + once)), "blue", 3);
        scene.arrow(drawn(origin), sum(foot, [0, 0, -0.25]), "L", "L");
        scene.arrow(drawn(origin), drawn(m.contacts[k]), "omega", "ω", { beside: true });
        scene.dot(drawn(m.contacts[k]), "ink");
      },
    },
    "The plane from above": {
      half: 1.15, towards: from_above, fixed: true,
      draw(scene, m, time) {
        const k = Math.floor(m.count * time / m.seconds), size = 1 / Math.max(...m.contacts.map(([x, y]) => Math.hypot(x, y)));
        const drawn = ([x, y]) => [size * x, size * y, 0];
        if (scene.expected === 0) scene.expect([drawn(m.contacts[0])], "P expected");
        for (const radius of scene.released ? m.radii : [])
          scene.line(arc(origin, times(size * radius, x_axis), times(size * radius, y_axis)), "grey", 1.2, { dash: [5, 5] });
        scene.line(m.contacts.slice(0, k + 1).map(drawn), "vermilion", 2.2);
        for (let turns = 0; once * turns <= k; ++turns) {
          scene.line([origin, drawn(m.contacts[once * turns])], "grey", 1.2);
          scene.dot(drawn(m.contacts[once * turns]), "blue", 5);
          scene.text(times(1.09, drawn(m.contacts[once * turns])), ["0", "P", "2P", "3P"][turns], "blue");
        }
        scene.dot(drawn(m.contacts[k]), "ink");
        scene.dot(origin, "ink", 3);
      },
    },
  },
  numbers(m, time) {
    const k = Math.floor(m.count * time / m.seconds), rest = time - k * m.seconds / m.count;
    const { omega, A } = motion(crate, m.omegas[k], m.attitudes[k], rest, 1, yours.free_rotation, yours.free_attitude)[1];
    const [x, y, z] = turned(A, omega), [height, distance] = yours.poinsot?.(crate, omega) ?? [-z, Math.hypot(x, y)];
    return [["height", height, "rad/s"], ["contact to foot", distance, "rad/s"], ["period P", m.period, "s"],
      ["e₃ round L in P", m.turn, "°", degree], ["solid angle of L", m.angle, "sr"]];
  },
});
