// A throw replayed.

/** Throws of racket_throws.csv: seconds from sample to sample, and ω at the samples. */
const racket_throws = [6, 3].map(number => {
  const rows = table.split("\n").map(row => row.split(",").map(Number)).filter(row => row[0] === number);
  return { step: (rows.at(-1)[1] - rows[0][1]) / (rows.length - 1), samples: rows.map(row => row.slice(2)) };
});

live("replayed_throw", {
  prepare({ which, Iy, Iz, gamma }) {
    const { step, samples } = racket_throws[which], I = [1, Iy, Iz];
    const moved = runge_kutta(now => minus(free_rate(I)(now), times(gamma, now)), step / 2);
    const motion_from = from => history(now => moved(moved(now)), from, samples.length - 1);
    const { start, left } = fitted(from => motion_from(from).flatMap((omega, k) => minus(omega, samples[k])), samples[0]);
    const computed = motion_from(start).map((now, k) => yours.damped_rotation?.(I, start, gamma, k * step) ?? now);
    const momenta = samples.map(now => scaled(I, now)), over_L = now => times(1 / norm(scaled(I, now)), now);
    const size_of = now => dot(now, scaled(I, now)) / norm(scaled(I, now)) ** 2;
    const mean = samples.reduce((total, now) => total + size_of(now), 0) / samples.length;
    const axes = I.map(moment => Math.sqrt(mean / moment)), attitudes = [upright(momenta[0])];
    for (let k = 1; k < samples.length; ++k) {
      const turn = yours.attitude_from_rates?.([0, step], [samples[k - 1], samples[k]])
        ?? rotation(times(step / 2, sum(samples[k - 1], samples[k])));
      attitudes.push(product(attitudes[k - 1], turn));
    }
    const curves = [samples, computed].flatMap(rows => over_time(steps(0, step * (samples.length - 1), samples.length - 1), (_, k) => rows[k]));
    return { step, samples, curves, momenta, attitudes, axes, size: 1 / Math.max(...axes), seconds: step * (samples.length - 1),
      measured_points: samples.map(over_L), curve: computed.map(over_L), left_over: norm(left) / Math.sqrt(left.length) };
  },
  handle: ({ Iy }) => [Math.sqrt(Iy), 0, 0],  // the tip of the x axis of the ellipsoid
  draw: [(scene, m, time) => {
    const k = Math.floor(time / m.step + 1e-6), place = p => times(m.size, p);
    scene.ellipsoid(origin, diagonal(...times(m.size, m.axes)), "sky");
    if (scene.released) scene.line(m.curve.map(place), "grey", 2);
    for (const point of m.measured_points.slice(0, k + 1)) scene.dot(place(point), "vermilion", 3);
    m.axes.forEach((length, i) => scene.arrow(times(m.size * length, identity[i]), times(m.size * length + 0.25, identity[i]),
      axis_colors[i], "xyz"[i], { width: 2.2 }));
  }, (scene, m, time) => {
    const A = m.attitudes[Math.floor(time / m.step + 1e-6)], at = (x, y, z = 0) => turned(A, [x, y, z]);
    const phone = [[-0.1, 0.2], [0.1, 0.2], [0.1, 0.6], [-0.1, 0.6]].map(([x, y]) => at(x, y, 0.04));
    scene.floor(-1.2, 1.2);
    scene.face(arc(at(0, 0.42), times(0.36, A[0]), times(0.45, A[1])), dot(A[2], scene.towards) >= 0 ? "green" : "orange", 0.5, 5);
    scene.round("rod", at(0, -0.03), at(0, -0.75), 0.045, "ink");
    scene.face(phone, "ink", 1, 1.2);
    scene.arrow(origin, [0, 0, 1.15], "L", "L");
    scene.arrow(origin, times(0.9, A[2]), "e3", "z");
  }, m => ({ curves: m.curves })],
  numbers(m, time) {
    const k = Math.floor(time / m.step + 1e-6), L = turned(m.attitudes[k], m.momenta[k]);
    return [m.left_over, ...m.samples[k], norm(L) / norm(m.momenta[0]), inclination(L)];
  },
});
