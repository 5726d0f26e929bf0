// A child on a merry-go-round.

live("two_sources", {
  prepare({ omega, walk, start, lift }) {
    const w = [0, 0, omega];
    const at = time => {
      const E = rotated(identity, w, time);
      const V = turned(E, [start + walk * time, 0, lift]), rate_body = times(walk, E[0]);
      const changed = rate => yours.inertial_rate?.(rate, w, V) ?? sum(rate, cross(w, V));
      return { E, V, rate_body, carried: changed(origin), rate: changed(rate_body) };
    };
    return { w, at, path: steps(0, 5, 120).map(time => at(time).V) };
  },
  // The place of the child at the start.
  handle: ({ start, lift }) => [start, 0, lift],
  draw: [(scene, m, time) => {
    const { E, V, rate_body, carried, rate } = m.at(time);
    scene.floor(-0.2, 1.3);
    scene.round("rod", [0, 0, -0.12], origin, 1, "sky", { whiteness: 0.7 });
    scene.round("rod", [0, 0, -0.2], [0, 0, 0.25], 0.04, "grey");
    for (const k of [0, 1]) scene.line([times(-1, E[k]), E[k]], "grey", 1.5);
    scene.trail(m.path, 1 + Math.round(24 * time), "ink", 2, { dash: [3, 4] });
    scene.arrows(axis_arrows(E, [0.8, 0.8]).slice(0, 2));
    scene.arrow(origin, times(0.6, unit([0, 0, m.w[2] || 1])), "omega", "ω");
    scene.arrow(origin, V, "ink", "V", { width: 2 });
    // The velocities, at a length that one can see.
    const tip = vector => sum(V, times(1.4, vector));
    scene.line([tip(rate_body), tip(rate), tip(carried)], "grey", 1, { dash: [4, 4] });
    scene.arrow(V, tip(rate_body), "blue", "walk");
    scene.arrow(V, tip(carried), "green", "ω × V");
    if (scene.released) scene.arrow(V, tip(rate), "purple", "sum");
    const expected = [V, cross(m.w, V)][scene.expected];
    if (expected && norm(expected)) scene.expect([V, tip(times(norm(rate), unit(expected)))]);
    // The child.
    scene.round("rod", V, sum(V, [0, 0, 0.16]), 0.04, "ink");
    scene.dot(sum(V, [0, 0, 0.2]), "ink", 0.055 * scene.scale);
  }],
  numbers(m, time) {
    const { E, carried, rate } = m.at(time);
    const E_rate = yours.cross_matrix ? product(yours.cross_matrix(m.w), E) : E.map(axis => cross(m.w, axis));
    return [norm(carried), norm(rate), rate[0], rate[1], (yours.angular_velocity_of_basis?.(E, E_rate) ?? m.w)[2]];
  },
});
