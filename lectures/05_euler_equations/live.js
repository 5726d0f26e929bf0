// A free body by rules of integration.

const rules = [
  (rate, state, h) => sum(state, times(h, rate(state))),
  (rate, state, h) => sum(state, times(h, rate(sum(state, times(h / 2, rate(state)))))),
  runge_kutta,
  (_, omega, h, I) => yours.splitting_step(I, omega, h)];
const constants = (I, omega) => yours.rotation_invariants?.(I, omega)
  ?? [dot(omega, scaled(I, omega)) / 2, dot(scaled(I, omega), scaled(I, omega))];

live("integrators", {
  about: "The angular velocity of a free body, exact and as a rule of integration computes it with a chosen step.",
  question: "The explicit Euler rule integrates the free body with steps of 0.1 s. What becomes of the energy?",
  choices: {
    "it stays": "No: the motion keeps T, but a step along the tangent leaves the ellipsoid on which T is constant.",
    "it falls": "No: the tangents of an ellipsoid lie outside it, where T is larger.",
    "it swings about its value": "No: every step adds to T, and none takes from it.",
    "it grows": "Yes: every step goes along a tangent of the ellipsoid of energy, which lies outside it.",
  },
  answer: "It grows, in jumps, each time the body turns over: every step leaves along the tangent, outwards. Half the step halves " +
    "the drift; a rule of order p divides it by 2ᵖ. Splitting, a problem of this lecture, lets T swing a little and keeps " +
    "L² to rounding: solve it, and ./checker/run live 05 adds it to the rules.",
  controls: [choice("rule", "Rule", ["explicit Euler", "midpoint", "Runge–Kutta", ...yours.splitting_step ? ["your splitting"] : []]),
    slider("h", "step", 0.02, 0.5, 0.02, 0.1, "s"), slider("w1", "ω̃₁", -1, 1, 0.05, 0.1, "rad/s"),
    slider("w2", "ω̃₂", -1, 1, 0.05, 1, "rad/s"), slider("w3", "ω̃₃", 0.05, 1, 0.05, 0.1, "rad/s")],
  prepare({ rule, h, w1, w2, w3 }) {
    const I = [1, 2, 3], start = [w1, w2, w3], seconds = 60, count = Math.floor(seconds / h);
    const rate = omega => yours.euler_equations?.(I, omega, origin) ?? free_rate(I)(omega);
    // What has left far behind what is drawn stays there, before its numbers overflow.
    const computed = history(omega => norm(omega) > 100 ? omega : rules[rule](rate, omega, h, I), start, count);
    const moments = steps(0, seconds, 400), exact = motion(I, start, identity, seconds, 400, yours.free_rotation).map(({ omega }) => omega);
    const [T, L2] = constants(I, start), size = 1 / Math.sqrt(2 * T);
    const drift = computed.map((omega, k) => {
      const now = constants(I, omega);
      return [h * k, ...[now[0] / T, now[1] / L2].map(ratio => Math.log10(Math.max(Math.abs(ratio - 1), 1e-17)))];
    });
    return { I, h, computed, moments, exact, drift, size, axes: I.map(moment => 1 / Math.sqrt(moment)), seconds };
  },
  duration: m => m.seconds,
  pace: 4,
  views: {
    "ω and the ellipsoid of energy": {
      half: 1.4, towards: [0.95, 1.15, 0.62],
      draw(scene, m, time) {
        const k = Math.floor(time / m.h), normal = p => p.map((x, i) => m.I[i] * x);
        scene.ellipsoid(origin, diagonal(...m.axes), "blue");
        if (scene.released) scene.on_surface(m.exact.map(omega => times(m.size, omega)), normal, "grey", 1.5);
        scene.line(m.computed.slice(Math.max(0, k - 400), k + 1).map(omega => times(m.size, omega)), "vermilion", 2.2);
        scene.arrow(origin, times(m.size, m.computed[k]), "vermilion", "ω");
        for (const arrow of axis_arrows(identity, m.axes)) scene.arrow(...arrow);
      },
    },
    "Drift of the constants": {
      draw(scene, m, time) {
        scene.plot({ x: [0, m.seconds], y: [-17, 2], x_name: "time (s)", y_name: "log₁₀ |relative change|", now: time,
          curves: [["T", "blue", 1], ["L²", "purple", 2]].map(([name, color, i]) =>
            ({ name, color, points: m.drift.map(row => [row[0], row[i]]) })) });
      },
    },
    "Components of ω in the body: exact, and by the rule": {
      aspect: 3.6,
      draw(scene, m, time) {
        const exact = i => ({ color: "grey", points: m.exact.map((omega, k) => [m.moments[k], omega[i]]) });
        scene.plot({ x: [0, m.seconds], y: [-2.2, 2.2], x_name: "time (s)", y_name: "rad/s", now: time,
          curves: [0, 1, 2].map(exact).concat(axis_colors.map((color, i) => ({ color, name: omega_names[i], dash: [6, 4],
            points: m.computed.map((omega, k) => [m.h * k, omega[i]]) }))) });
      },
    },
  },
  numbers(m, time) {
    const omega = m.computed[Math.floor(time / m.h)], [T, L2] = constants(m.I, omega);
    const k = Math.floor(400 * time / m.seconds), rest = time - m.moments[k];
    const exact = motion(m.I, m.exact[k], identity, rest, 1, yours.free_rotation)[1];
    return [["T", T, "J"], ["L²", L2, "kg² m⁴/s²"], ["ω̃₂ exact", exact.omega[1], "rad/s"]];
  },
});
