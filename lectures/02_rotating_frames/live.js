// The puck on a turntable, and Foucault's pendulum.

const fictitious = (r, v, w) =>
  yours.fictitious_force?.(1, r, v, w, origin) ?? sum(times(2, cross(v, w)), cross(cross(w, r), w));
/** The law of motion of the rider, for a puck of 1 kg, by the forces that are counted. */
const laws = [
  fictitious,
  (r, v, w) => fictitious(origin, v, w),
  (r, v, w) => fictitious(r, origin, w),
  (r, v, w) => fictitious(r, times(0.5, v), w)];

/** Positions and velocities by a law of motion, at equal steps of time. */
const ridden = (law, r, v, seconds, count) => history(runge_kutta(([r, v]) => [v, law(r, v)], seconds / count), [r, v], count);

function draw_table(scene, angle) {
  const one = [Math.cos(angle), Math.sin(angle), 0], other = [-one[1], one[0], 0];
  scene.floor(-0.02, 1.15);
  scene.line([times(-1.15, other), times(1.15, other)], "pale", 2);
  scene.line([times(-1.15, one), origin], "vermilion", 2);
  scene.line([origin, times(1.15, one)], "pale", 2);
}

live("puck", {
  prepare({ law, speed, heading, start, omega }) {
    const w = [0, 0, omega], r = [start, 0, 0], v = times(speed, [Math.cos(heading * degree), Math.sin(heading * degree), 0]);
    // On the table it starts with the velocity that the rider sees.
    const seen = minus(v, cross(w, r)), path = ridden((p, u) => laws[law](p, u, w), r, seen, 4, 160);
    const straight = steps(0, 4, 160).map(time => sum(r, times(time, v)));
    const back = straight.map((p, i) => turned(rotated(yours.rotated_basis, identity, w, -i / 40), p));
    // Straight on, and the mirror image of what the rider sees, from the velocity that the rider sees at first.
    const along = norm(seen) ? unit(seen) : x_axis;
    const expected = [steps(0, 4, 160).map(time => sum(r, times(time, seen))),
      back.map(p => sum(r, minus(times(2 * dot(minus(p, r), along), along), minus(p, r))))];
    return { w, v, path, ridden_path: path.map(([p]) => p), straight, back, law, expected };
  },
  // The tip of the velocity at the start.
  handle: ({ speed, heading, start }) => [start + speed * Math.cos(heading * degree), speed * Math.sin(heading * degree), 0],
  draw: [(scene, m, time) => {
    const k = Math.floor(40 * time);
    draw_table(scene, m.w[2] * time);
    scene.arrow(m.straight[0], sum(m.straight[0], m.v), "green", "v", { width: 2.2, beside: true });
    scene.trail(m.straight, k + 1, "blue", 3);
    scene.dot(m.straight[k], "ink", 6);
  }, (scene, m, time) => {
    const k = Math.floor(40 * time), [r, v] = m.path[k];
    draw_table(scene, 0);
    if (scene.released) scene.line(m.back, "ink", 1.5, { dash: [1, 6] });
    scene.expect(m.expected[scene.expected]?.slice(0, k + 1));
    scene.trail(m.ridden_path, k + 1, "blue", 3);
    const force = (law, factor, color, name) => scene.arrow(r, sum(r, times(factor, laws[law](r, v, m.w))), color, name);
    if (scene.released && m.law !== 1) force(2, 0.4, "green", "centrifugal");
    if (scene.released && m.law !== 2) force(1, m.law === 3 ? 0.2 : 0.4, "purple", "Coriolis");
    scene.dot(r, "ink", 6);
  }],
  numbers(m, time) {
    const [r, v] = m.path[Math.floor(40 * time)], a = laws[m.law](r, v, m.w);
    const outside = yours.inertial_acceleration?.(a, v, r, m.w, origin) ?? minus(a, laws[0](r, v, m.w));
    return [norm(laws[1](r, v, m.w)), norm(laws[2](r, v, m.w)), norm(outside)];
  },
});

// Ten swings to a revolution of the planet, so that one sees the plane of swing rotate.
const planet_rate = 0.1, sidereal_day = 86164.0989;

const coriolis = (v, latitude) => yours.coriolis_acceleration?.(v, latitude, planet_rate)
  ?? times(2 * planet_rate, cross(v, [0, Math.cos(latitude), Math.sin(latitude)]));

live("foucault", {
  prepare({ latitude, release }) {
    const lambda = latitude * degree, seconds = 20 * Math.PI;
    // The law on the floor for g/ℓ = 1/s²; the rotation of the frame in which the swing is plane decides the second start.
    const law = (r, v) => sum(times(-1, r), [...coriolis(v, lambda).slice(0, 2), 0]);
    const sideways = [release ? planet_rate * Math.sin(lambda) : 0, 0, 0];
    const path = ridden(law, [0, 1, 0], sideways, seconds, 1000);
    return { lambda, seconds, path, passed: path.map(([r]) => r),
      // In the south in the same time, the other way round.
      period: lambda ? yours.foucault_period?.(Math.abs(lambda), sidereal_day) ?? sidereal_day / Math.sin(Math.abs(lambda)) : NaN,
      turning: lambda ? `${lambda > 0 ? "" : "anti"}clockwise in` : "no turn" };
  },
  handle: ({ latitude }) => [Math.cos(latitude * degree), 0, Math.sin(latitude * degree)],  // the place of the pendulum
  draw: [(scene, m, time) => {
    const k = Math.round(1000 * time / m.seconds), bob = m.path[k][0];
    scene.floor(0, 1.12);
    ["N", "E", "S", "W"].forEach((name, i) =>
      scene.words(name, scene.at(times(1.25, [Math.sin(i * 90 * degree), Math.cos(i * 90 * degree), 0])), "ink", "center", name => [name]));
    scene.trail(m.passed, k + 1, "blue", 2);
    const hung = sum(bob, [0, 0, 0.12 + 0.2 * (bob[0] ** 2 + bob[1] ** 2)]);
    scene.line([[0, 0, 3.4], hung], "ink", 1.5);
    scene.solid("ball", hung, diagonal(0.09, 0.09, 0.09), "orange");
    if (!scene.released) return;
    const day = times(1.12, [Math.sin(planet_rate * time), Math.cos(planet_rate * time), 0]);
    scene.line([times(-1, day), day], "grey", 1.5, { dash: [4, 5] });
    scene.words("once a day", scene.at(times(1.08, day)), "grey", "center", name => [name]);
    const turn = planet_rate * time * [NaN, 1, NaN, -Math.sin(m.lambda)][scene.expected];
    if (!isNaN(turn)) scene.expect([origin, [Math.sin(turn), Math.cos(turn), 0]]);
  }, (scene, { lambda }, time) => {
    const up = [Math.cos(lambda), 0, Math.sin(lambda)], north = [-up[2], 0, up[0]];
    scene.ellipsoid(origin, identity, "blue");
    for (const latitude of [0, lambda]) scene.line(parallel(latitude), latitude ? "green" : "grey", 2);
    for (const length of steps(0, 150, 5)) scene.line(circles[2], "pale", 1, { axes: rotation([0, 0, length * degree]) });
    // The line of swing where the place has been, hour by hour.
    for (let hour = 0; scene.released && hour * 15 * degree <= planet_rate * time; ++hour) {
      const A = rotation([0, 0, hour * 15 * degree]), bearing = hour * 15 * degree * Math.sin(lambda), at = turned(A, up);
      const way = turned(A, sum(times(0.13 * Math.cos(bearing), north), [0, 0.13 * Math.sin(bearing), 0]));
      scene.line([minus(at, way), sum(at, way)], "ink", 2.5);
    }
    scene.line([times(-1.4, z_axis), times(1.4, z_axis)], "grey", 2, { dash: [6, 5] });
    scene.arrow(up, sum(up, [0, 0, 0.6]), "omega", "Ω");
    if (scene.released) scene.arrow(up, sum(up, times(0.6 * up[2], up)), "purple", "Ω sin λ", { beside: true });
  }],
  numbers(m, time) {
    const [r, v] = m.path[Math.round(1000 * time / m.seconds)], [east, north] = coriolis(v, m.lambda);
    return [m.period, east, north];
  },
});
