// A throw replayed.

/** Throws of racket_throws.csv: seconds from sample to sample, and ω at the samples. */
const racket_throws = [6, 3].map(number => {
  const rows = table.split("\n").map(row => row.split(",").map(Number)).filter(row => row[0] === number);
  return { step: (rows.at(-1)[1] - rows[0][1]) / (rows.length - 1), samples: rows.map(row => row.slice(2)) };
});

const axis_letters = ["x", "y", "z"], component_names = ["ω_x", "ω_y", "ω_z"];
const square = vectors => vectors.reduce((total, vector) => total + dot(vector, vector), 0);

/** Fits starts of a motion, which gives ω at all samples, by Gauss and Newton with Marquardt's damping. */
function fitted(motion_from, samples) {
  const deviations = from => motion_from(from).map((omega, k) => minus(omega, samples[k]));
  let start = samples[0], left = deviations(start), damping = 1e-3;
  for (let round = 0; round < 25 && damping < 1e6; ++round) {
    const h = 1e-5, slopes = identity.map(axis =>
      deviations(sum(start, times(h, axis))).map((moved, k) => times(1 / h, minus(moved, left[k]))));
    const together = (a, b) => a.reduce((total, vector, k) => total + dot(vector, b[k]), 0);
    const [u, v, w] = slopes.map((a, i) => slopes.map((b, j) => together(a, b) * (i === j ? 1 + damping : 1)));
    const right = slopes.map(slope => together(slope, left)), determinant = dot(u, cross(v, w));
    const change = times(-1 / determinant, sum(times(right[0], cross(v, w)), times(right[1], cross(w, u)), times(right[2], cross(u, v))));
    const then = deviations(sum(start, change));
    if (square(then) < square(left)) {
      start = sum(start, change);
      left = then;
      damping /= 10;
      if (norm(change) < 1e-4) break;
    } else damping *= 10;
  }
  return { start, left };
}

live("replayed_throw", {
  prepare({ which, Iy, Iz, gamma }) {
    const { step, samples } = racket_throws[which], I = [1, Iy, Iz];
    const free = free_rate(I), rate = now => minus(free(now), times(gamma, now));
    const motion_from = from =>
      history(now => runge_kutta(rate, runge_kutta(rate, now, step / 2), step / 2), from, samples.length - 1);
    const { start, left } = fitted(motion_from, samples);
    const computed = motion_from(start).map((now, k) => yours.damped_rotation?.(I, start, gamma, k * step) ?? now);
    const momenta = samples.map(now => scaled(I, now)), over_L = now => times(1 / norm(scaled(I, now)), now);
    const size_of = now => dot(now, scaled(I, now)) / square([scaled(I, now)]);
    const mean = samples.reduce((total, now) => total + size_of(now), 0) / samples.length;
    const axes = I.map(moment => Math.sqrt(mean / moment)), attitudes = [upright(momenta[0])];
    for (let k = 1; k < samples.length; ++k) {
      const turn = yours.attitude_from_rates?.([0, step], [samples[k - 1], samples[k]])
        ?? rotation(times(step / 2, sum(samples[k - 1], samples[k])));
      attitudes.push(product(attitudes[k - 1], turn));
    }
    return { I, step, samples, computed, momenta, attitudes, axes, size: 1 / Math.max(...axes), seconds: step * (samples.length - 1),
      measured_points: samples.map(over_L), curve: computed.map(over_L), left_over: Math.sqrt(square(left) / (3 * left.length)) };
  },
  duration: m => m.seconds,
  pace: 0.15,
  views: {
    "ω over L on its ellipsoid": {
      half: 1.25, towards: [1, 0.5, 0.45],
      draw(scene, m, time) {
        const k = Math.floor(time / m.step + 1e-6), place = p => times(m.size, p);
        scene.ellipsoid(origin, diagonal(...times(m.size, m.axes)), "sky");
        if (scene.released) scene.line(m.curve.map(place), "grey", 2);
        for (const point of m.measured_points.slice(0, k + 1)) scene.dot(place(point), "vermilion", 3);
        m.axes.forEach((length, i) => scene.arrow(times(m.size * length, identity[i]), times(m.size * length + 0.25, identity[i]),
          axis_colors[i], axis_letters[i], { width: 2.2 }));
      },
    },
    "The racket in space, as its phone felt it": {
      half: 1.42, towards: [0.3, -1, 0.45],
      draw(scene, m, time) {
        const A = m.attitudes[Math.floor(time / m.step + 1e-6)], at = (x, y, z = 0) => turned(A, [x, y, z]);
        const rim = steps(0, 2 * Math.PI, 48).map(angle => at(0.36 * Math.cos(angle), 0.42 + 0.45 * Math.sin(angle)));
        const phone = [[-0.1, 0.2], [0.1, 0.2], [0.1, 0.6], [-0.1, 0.6]].map(([x, y]) => at(x, y, 0.04));
        scene.floor(-1.2, 1.2);
        scene.face(rim, dot(A[2], scene.towards) >= 0 ? "green" : "orange", 0.5, 5);
        scene.round("rod", at(0, -0.03), at(0, -0.75), 0.045, "ink");
        scene.face(phone, "ink", 1, 1.2);
        scene.arrow(origin, [0, 0, 1.15], "L", "L");
        scene.arrow(origin, times(0.9, A[2]), "e3", "z");
      },
    },
    "Components of ω in the body: measured, and as fitted": {
      aspect: 3.0,
      draw(scene, m, time) {
        const points = rows => i => rows.map((omega, k) => [k * m.step, omega[i]]);
        const curve = points(m.computed), sample = points(m.samples);
        scene.plot({ x: [0, m.seconds], y: [-20, 20], x_name: "time (s)", y_name: "rad/s", now: time,
          curves: [0, 1, 2].flatMap(i => [
            { color: axis_colors[i], name: component_names[i], points: sample(i), dots: true },
            ...scene.released ? [{ color: axis_colors[i], points: curve(i) }] : []]) });
      },
    },
  },
  numbers(m, time) {
    const k = Math.floor(time / m.step + 1e-6), L = turned(m.attitudes[k], m.momenta[k]);
    return [["left over", m.left_over, "rad/s"], ...m.samples[k].map((rate, i) => [component_names[i], rate, "rad/s"]),
      ["L / L at the start", norm(m.momenta[k]) / norm(m.momenta[0]), ""],
      ["L off the vertical", Math.acos(Math.min(1, L[2] / norm(L))), "°", degree]];
  },
});
