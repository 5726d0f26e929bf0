// The heavy symmetric top.

const I1 = 3.28e-4, I3 = 6.6e-5, mgl = 0.0456;  // kg m², kg m², J: the toy top of the lecture

/** The axes of the top, as columns, at equal steps of time: torque and ω act on L, on an axis across, and on its own. */
function spun(angles, rates, seconds, count) {
  const own = yours.heavy_top_accelerations, A = attitude(angles);
  if (own)
    return history(state => runge_kutta(([a, b, c, ...v]) => [...v, ...own([I1, I1, I3], mgl, [a, b, c], v)], state,
      seconds / count), [...angles, ...rates], count).map(([a, b, c]) => attitude([a, b, c]));
  const part = (state, i) => state.slice(3 * i, 3 * i + 3);
  const rate = state => {
    const [L, across, axis] = [0, 1, 2].map(i => part(state, i)), along = dot(L, axis);
    const omega = sum(times(1 / I1, L), times(along / I3 - along / I1, axis));
    return [...times(mgl, cross(z_axis, axis)), ...cross(omega, across), ...cross(omega, axis)];
  };
  const omega = sum(times(rates[0], z_axis), times(rates[2], A[2]));
  const along = dot(omega, A[2]), L = sum(times(I1, omega), times((I3 - I1) * along, A[2]));
  return history(state => runge_kutta(rate, state, seconds / count), [...L, ...A[0], ...A[2]], count)
    .map(state => [part(state, 1), cross(part(state, 2), part(state, 1)), part(state, 2)]);
}

/** What the path of the axis shows, from one turning point on: the inclinations at which it turns round, the time until
 *  it comes back, and how far it has gone round the vertical. */
function measured_nutation(axes, h) {
  const lean = axes.map(axis => Math.acos(axis[2])), down = lean[1] > lean[0];
  const end = lean.findIndex((theta, k) => k > 0 && k + 1 < lean.length && (lean[k + 1] < theta) === down);
  if (end < 0) return [NaN, NaN, NaN, NaN];
  // The parabola through three inclinations has its end at `part` of a step from the middle one.
  const [a, b, c] = lean.slice(end - 1, end + 2), part = (a - c) / (a - 2 * b + c) / 2, last = b - (a - c) * part / 4;
  const turns = axes.slice(1, end + 2).map(([x, y], k) => {
    const [a, b] = axes[k];
    return Math.atan2(a * y - b * x, a * x + b * y);
  });
  const round = turns.slice(0, end).reduce((total, turn) => total + turn) + part * turns[part < 0 ? end - 1 : end];
  return [Math.min(lean[0], last), Math.max(lean[0], last), 2 * h * (end + part), 2 * round];
}

live("heavy_top", {
  about: "A top spins on its tip; the other end of its axis draws a path. Beside it, its effective potential.",
  question: "The axis of the spinning top is held at 30° and then released. What does the axis do?",
  choices: {
    "it sinks until the top lies": "No: so falls a top without spin; to keep p_φ this one must go round, and that " +
      "takes the energy which sinking sets free.",
    "it goes round, always at 30°": "No: to stay at 30° it must go round from the start, and this axis starts at rest.",
    "it sinks a little, goes round, and comes up again": "Yes: to keep p_φ it goes round as it sinks, until that " +
      "takes all the energy which sinking sets free.",
  },
  answer: "It sinks and rises between two inclinations while it goes round, and at the top of each arc it is at rest: a cusp. A small " +
    "push forwards makes waves, a push backwards loops. Upright the top sleeps, down to the spin at which its well becomes flat.",
  controls: [slider("theta", "θ", 4, 85, 1, 30, "°"), slider("push", "push dφ/dt", -8, 8, 0.2, 0, "rad/s"),
    slider("spin", "spin ω̃₃", 40, 300, 5, 150, "rad/s")],
  starts: {
    "released at rest": { theta: 30, push: 0, spin: 150 },
    "pushed forwards": { theta: 40, push: 2.6, spin: 200 },
    "pushed backwards": { theta: 40, push: -5, spin: 200 },
    "nearly upright and fast": { theta: 4, push: 0, spin: 250 },
    "nearly upright and slow": { theta: 4, push: 0, spin: 90 },
  },
  prepare({ theta, push, spin }) {
    const tilt = theta * degree, rates = [push, 0, spin - push * Math.cos(tilt)], start = [0, tilt, 0];
    const attitudes = spun(start, rates, 2, 4000), samples = attitudes.filter((_, k) => k % 8 === 0);
    // About its own axis, and about the vertical.
    const along = I3 * spin, [p_phi, , p_psi] = yours.canonical_momenta?.([I1, I1, I3], start, rates)
      ?? [I1 * push * Math.sin(tilt) ** 2 + along * Math.cos(tilt), 0, along];
    const potential = angle => yours.effective_potential?.(I1, I3, mgl, p_phi, p_psi, angle)
      ?? (p_phi - p_psi * Math.cos(angle)) ** 2 / (2 * I1 * Math.sin(angle) ** 2) + p_psi ** 2 / (2 * I3) + mgl * Math.cos(angle);
    const well = steps(1, 120, 240).map(angle => [angle, 1000 * potential(angle * degree)]);
    // Steady precession has no nutation to measure.
    const least = 2 * Math.sqrt(I1 * mgl * Math.cos(tilt)) / I3, root = I3 * Math.sqrt(spin ** 2 - least ** 2);
    const precession = spin < 1.01 * least ? [] : yours.steady_precession?.(I1, I3, mgl, spin, tilt)
      ?? [2 * mgl / (along + root), (along + root) / (2 * I1 * Math.cos(tilt))];
    const is_steady = precession.some(steady => Math.abs(push - steady) < 0.05 * steady);
    const seen = measured_nutation(is_steady ? [] : attitudes.map(([, , axis]) => axis), 2 / 4000);
    const top = [I1, I3, mgl, tilt, rates];
    const nutation = isNaN(seen[0]) ? seen : [...yours.nutation_limits?.(...top) ?? seen.slice(0, 2),
      yours.nutation_period?.(...top) ?? seen[2], yours.precession_per_nutation?.(...top) ?? seen[3]];
    return { samples, well, energy: 1000 * potential(tilt), nutation, slow: precession[0] ?? NaN };
  },
  duration: () => 2,
  pace: 0.2,
  views: {
    "The top and the path of its axis": {
      half: 1.2, towards: [0.4, -1, 0.55],
      draw(scene, m, time) {
        const k = Math.round(250 * time), [x, y, axis] = m.samples[k];
        const foot = [0, 0, -0.5], on_axis = part => sum(foot, times(part, axis));
        scene.line([foot, [0, 0, 1.1]], "grey", 1.5, { dash: [6, 5] });
        scene.line(arc(foot, times(0.25, x_axis), times(0.25, y_axis)), "pale", 2);
        const rim = arc(on_axis(0.75), times(0.42, x), times(0.42, y));
        rim.slice(1).forEach((point, i) => scene.face([foot, rim[i], point], "blue", 0.1));
        scene.face(rim, "blue", 0.35, 1.5);
        scene.line([on_axis(0.75), sum(on_axis(0.75), times(0.42, x))], "ink", 2);
        const [, , [c, s, up]] = m.samples[0], level = Math.hypot(c, s), end = angle =>
          sum(foot, times(1.35, [c / level * Math.sin(angle), s / level * Math.sin(angle), Math.cos(angle)]));
        scene.expect([steps(Math.acos(up), Math.PI / 2, 24).map(end),
          arc(sum(foot, [0, 0, 1.35 * up]), times(1.35 * level, x_axis), times(1.35 * level, y_axis))][scene.expected]);
        scene.line(m.samples.slice(0, k + 1).map(sample => sum(foot, times(1.35, sample[2]))), "vermilion", 2.2);
        scene.arrow(on_axis(0.75), on_axis(1.35), "purple", "e₃");
      },
    },
    "Effective potential": {
      draw(scene, m, time) {
        const theta = Math.acos(m.samples[Math.round(250 * time)][2][2]) / degree;
        const lowest = Math.min(...m.well.map(([, U]) => U)), depth = Math.max(m.energy - lowest, 2);
        scene.plot({ x: [0, 120], y: [lowest - 0.4 * depth, m.energy + 0.8 * depth], x_name: "θ (°)", y_name: "mJ",
          mark: [theta, m.energy], curves: [{ points: scene.released ? m.well : [], color: "blue", name: "potential" },
            { points: [[0, m.energy], [120, m.energy]], color: "vermilion", name: "energy", dash: [6, 4] }] });
      },
    },
  },
  numbers: m => [["least θ", m.nutation[0], "°", degree], ["largest θ", m.nutation[1], "°", degree],
    ["nutation period", m.nutation[2], "s"], ["φ per nutation", m.nutation[3], "°", degree],
    ["steady dφ/dt", m.slow, "rad/s"], ["sleeps above", yours.sleeping_spin?.(I1, I3, mgl) ?? 2 * Math.sqrt(I1 * mgl) / I3, "rad/s"]],
});
