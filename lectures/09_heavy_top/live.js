// The heavy symmetric top.

const I1 = 3.28e-4, I3 = 6.6e-5, mgl = 0.0456;  // kg m², kg m², J: the toy top of the lecture

/** The axes of the top, as columns, and L where it changes by friction, which takes this part of the spin in a second;
 *  at equal steps of time. Torque and ω act on L, on an axis across, and on its own. */
function spun(angles, rates, loss, seconds, count) {
  const own = !loss && yours.heavy_top_accelerations, A = attitude(angles), moved = (rate, state) => history(runge_kutta(rate, seconds / count), state, count);
  if (own) return moved(([q, v]) => [v, own([I1, I1, I3], mgl, q, v)], [angles, rates]).map(([q]) => attitude(q));
  const omega = sum(times(rates[0], z_axis), times(rates[2], A[2]));
  const L = sum(times(I1, omega), times((I3 - I1) * dot(omega, A[2]), A[2]));
  return moved(([L, across, axis]) => {
    const spin = dot(L, axis), omega = sum(times(1 / I1, L), times((1 / I3 - 1 / I1) * spin, axis));
    return [sum(times(mgl, cross(z_axis, axis)), times(-loss * spin, axis)), cross(omega, across), cross(omega, axis)];
  }, [L, A[0], A[2]]).map(([L, across, axis]) => [across, cross(axis, across), axis, L]);
}

/** What the path of the axis shows, from one turning point on: the inclinations at which it turns round, the time until
 *  it comes back, and how far it has gone round the vertical. */
function measured_nutation(axes, h) {
  const lean = axes.map(axis => Math.acos(axis[2])), down = lean[1] > lean[0];
  const end = lean.findIndex((theta, k) => k > 0 && k + 1 < lean.length && (lean[k + 1] < theta) === down);
  if (end < 0) return [NaN, NaN, NaN, NaN];
  // The parabola through three inclinations has its end at `part` of a step from the middle one.
  const [a, b, c] = lean.slice(end - 1, end + 2), part = (a - c) / (a - 2 * b + c) / 2, last = b - (a - c) * part / 4;
  const turns = turns_of(axes.slice(0, end + 2));
  const round = turns.slice(0, end).reduce((total, turn) => total + turn) + part * turns[part < 0 ? end - 1 : end];
  return [Math.min(lean[0], last), Math.max(lean[0], last), 2 * h * (end + part), 2 * round];
}

const foot = [0, 0, -0.5], on_sphere = direction => sum(foot, times(1.35, direction));

live("heavy_top", {
  prepare({ theta, push, spin, loss }) {
    const tilt = theta * degree, rates = [push, 0, spin - push * Math.cos(tilt)], start = [0, tilt, 0];
    const attitudes = spun(start, rates, loss, 2, 4000), samples = attitudes.filter((_, k) => k % 8 === 0);
    // About the vertical and about its own axis.
    const along = I3 * spin, momenta = yours.canonical_momenta?.([I1, I1, I3], start, rates)
      ?? [I1 * push * Math.sin(tilt) ** 2 + along * Math.cos(tilt), 0, along];
    const state = time => {
      const [, , axis, L] = samples[Math.round(250 * time)], [p_phi, , p_psi] = loss ? [L[2], 0, dot(L, axis)] : momenta;
      const potential = angle => yours.effective_potential?.(I1, I3, mgl, p_phi, p_psi, angle)
        ?? (p_phi - p_psi * Math.cos(angle)) ** 2 / (2 * I1 * Math.sin(angle) ** 2) + p_psi ** 2 / (2 * I3) + mgl * Math.cos(angle);
      const energy = loss ? (dot(L, L) - p_psi ** 2) / (2 * I1) + p_psi ** 2 / (2 * I3) + mgl * axis[2] : potential(tilt);
      return { spin: p_psi / I3, energy: 1000 * energy, potential };
    };
    // Steady precession has no nutation to measure.
    const least = 2 * Math.sqrt(I1 * mgl * Math.cos(tilt)) / I3, root = I3 * Math.sqrt(spin ** 2 - least ** 2);
    const precession = spin < 1.01 * least ? [] : yours.steady_precession?.(I1, I3, mgl, spin, tilt)
      ?? [2 * mgl / (along + root), (along + root) / (2 * I1 * Math.cos(tilt))];
    const is_steady = precession.some(steady => Math.abs(push - steady) < 0.05 * steady);
    const seen = measured_nutation(is_steady || loss ? [] : attitudes.map(([, , axis]) => axis), 2 / 4000);
    const top = [I1, I3, mgl, tilt, rates];
    const nutation = isNaN(seen[0]) ? seen : [...yours.nutation_limits?.(...top) ?? seen.slice(0, 2),
      yours.nutation_period?.(...top) ?? seen[2], yours.precession_per_nutation?.(...top) ?? seen[3]];
    return { samples, tips: samples.map(([, , axis]) => on_sphere(axis)), state, nutation, slow: precession[0] ?? NaN };
  },
  handle: ({ theta }) => on_sphere([Math.sin(theta * degree), 0, Math.cos(theta * degree)]),  // the axis at the start
  draw: [(scene, m, time) => {
    const k = Math.round(250 * time), [x, , axis] = m.samples[k], on_axis = part => sum(foot, times(part, axis));
    scene.floor(-0.5, 1.2);
    scene.line([foot, [0, 0, 1.1]], "grey", 1.5, { dash: [6, 5] });
    scene.round("cone", on_axis(0.5), foot, 0.16, "orange");
    scene.round("rod", on_axis(0.5), on_axis(0.64), 0.46, "sky");
    scene.round("rod", on_axis(0.64), on_axis(1.05), 0.05, "orange");
    // A stripe shows the spin.
    for (const side of [-1, 1]) scene.line([on_axis(0.65), sum(on_axis(0.65), times(0.45 * side, x))], side > 0 ? "ink" : "grey", 4);
    const [c, s, up] = m.samples[0][2], level = Math.hypot(c, s);
    const fallen = angle => on_sphere([c / level * Math.sin(angle), s / level * Math.sin(angle), Math.cos(angle)]);
    scene.expect([steps(Math.acos(up), Math.PI / 2, 24).map(fallen),
      arc(on_sphere([0, 0, up]), times(1.35 * level, x_axis), times(1.35 * level, y_axis))][scene.expected]);
    scene.ellipsoid(foot, identity.map(axis => times(1.34, axis)), "grey", 0.07);
    scene.trail(m.tips, k + 1, "e3", 3);
    scene.arrow(on_axis(0.9), on_axis(1.35), "e3", "e₃");
  }, (m, time) => {
    const theta = inclination(m.samples[Math.round(250 * time)][2]) / degree, { energy, potential } = m.state(time);
    const well = steps(1, 120, 240).map(angle => [angle, 1000 * potential(angle * degree)]);
    const lowest = Math.min(...well.map(([, U]) => U)), depth = Math.max(energy - lowest, 2);
    return { y: [lowest - 0.4 * depth, energy + 0.8 * depth], mark: [theta, energy], curves: [well, [[0, energy], [120, energy]]] };
  }],
  numbers: (m, time) => [...m.nutation, m.slow, m.state(time).spin, yours.sleeping_spin?.(I1, I3, mgl) ?? 2 * Math.sqrt(I1 * mgl) / I3],
});
