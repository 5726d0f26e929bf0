// The heavy symmetric top. Calls heavy_top_accelerations, effective_potential, canonical_momenta, nutation_limits,
// nutation_period, precession_per_nutation, sleeping_spin, steady_precession, rotation_matrix.

const I1 = 3.28e-4, I3 = 6.6e-5, mgl = 0.0456;  // kg m², kg m², J: the toy top of the lecture

live("heavy_top", {
  about: "A top spins on its tip; the tip of its axis draws a path, and its inclination oscillates in a potential well.",
  question: "The axis of the spinning top is held at 30° and then released. What does the axis do?",
  choices: ["it sinks until the top lies", "it goes round, always at 30°", "it sinks a little, goes round, and comes up again"],
  answer: "It sinks and rises between two inclinations while it goes round, and at the top of each arc it is at rest: a cusp. A push " +
    "forwards makes waves, a push backwards loops. Upright the top sleeps, down to the spin at which its well becomes flat.",
  controls: [slider("theta", "θ", 4, 85, 1, 30, "°"), slider("push", "push dφ/dt", -8, 8, 0.2, 0, "rad/s"),
    slider("spin", "spin ω₃", 40, 300, 5, 150, "rad/s")],
  starts: {
    "released at rest: cusps": { theta: 30, push: 0, spin: 150 },
    "pushed forwards: waves": { theta: 40, push: 2.6, spin: 200 },
    "pushed backwards: loops": { theta: 40, push: -5, spin: 200 },
    "nearly upright and fast: asleep": { theta: 4, push: 0, spin: 250 },
    "nearly upright and slow: awake": { theta: 4, push: 0, spin: 90 },
  },
  prepare({ theta, push, spin }) {
    const tilt = theta * degree, rates = [push, 0, spin - push * Math.cos(tilt)], start = [0, tilt, 0];
    const rate = state => [...state.slice(3), ...rigid.heavy_top_accelerations([I1, I1, I3], mgl, state.slice(0, 3), state.slice(3))];
    const states = history(state => runge_kutta(rate, state, 2 / 4000), [...start, ...rates], 4000);
    const samples = states.filter((_, k) => k % 8 === 0).map(state => {
      const q = state.slice(0, 3);
      return { q, axis: transposed(rigid.rotation_matrix(q))[2] };
    });
    const [p_phi, , p_psi] = rigid.canonical_momenta([I1, I1, I3], start, rates);
    const potential = angle => rigid.effective_potential(I1, I3, mgl, p_phi, p_psi, angle);
    const well = steps(1, 120, 240).map(angle => [angle, 1000 * potential(angle * degree)]);
    // Steady precession has no nutation to measure.
    const precession = spin > 1.01 * 2 * Math.sqrt(I1 * mgl * Math.cos(tilt)) / I3 ? rigid.steady_precession(I1, I3, mgl, spin, tilt) : [];
    const is_steady = precession.some(steady => Math.abs(push - steady) < 0.05 * steady);
    const nutation = is_steady ? [NaN, NaN, NaN, NaN] : [...rigid.nutation_limits(I1, I3, mgl, tilt, rates),
      rigid.nutation_period(I1, I3, mgl, tilt, rates), rigid.precession_per_nutation(I1, I3, mgl, tilt, rates)];
    return { samples, well, energy: 1000 * potential(tilt), nutation, slow: precession[0] ?? NaN };
  },
  duration: () => 2,
  pace: 0.2,
  views: {
    "The top and the path of its axis": {
      half: 1.2, towards: [0.4, -1, 0.55],
      draw(scene, m, time) {
        const k = Math.round(250 * time), { q } = m.samples[k], [x, y, axis] = transposed(rigid.rotation_matrix(q));
        const foot = [0, 0, -0.5], on_axis = part => sum(foot, times(part, axis));
        scene.line([foot, [0, 0, 1.1]], "grey", 1.5, { dash: [6, 5] });
        scene.line(arc(foot, times(0.25, x_axis), times(0.25, y_axis)), "pale", 2);
        const rim = arc(on_axis(0.75), times(0.42, x), times(0.42, y));
        rim.slice(1).forEach((point, i) => scene.face([foot, rim[i], point], "blue", 0.1));
        scene.face(rim, "blue", 0.35, 1.5);
        scene.line([on_axis(0.75), sum(on_axis(0.75), times(0.42, x))], "ink", 2);
        scene.line(m.samples.slice(0, k + 1).map(sample => sum(foot, times(1.35, sample.axis))), "vermilion", 2.2);
        scene.arrow(on_axis(0.75), on_axis(1.35), "purple", "e₃");
      },
    },
    "Effective potential": {
      draw(scene, m, time) {
        const theta = m.samples[Math.round(250 * time)].q[1] / degree;
        const lowest = Math.min(...m.well.map(([, U]) => U)), depth = Math.max(m.energy - lowest, 2);
        scene.plot({ x: [0, 120], y: [lowest - 0.4 * depth, m.energy + 0.8 * depth], x_name: "θ (°)", y_name: "mJ",
          mark: [theta, m.energy], curves: [{ points: scene.released ? m.well : [], color: "blue", name: "potential" },
            { points: [[0, m.energy], [120, m.energy]], color: "vermilion", name: "energy", dash: [6, 4] }] });
      },
    },
  },
  numbers: m => [["least θ", m.nutation[0], "°", degree], ["largest θ", m.nutation[1], "°", degree],
    ["nutation period", m.nutation[2], "s"], ["φ per nutation", m.nutation[3], "°", degree],
    ["steady dφ/dt", m.slow, "rad/s"], ["sleeps above", rigid.sleeping_spin(I1, I3, mgl), "rad/s"]],
});
