// A child on a merry-go-round, and a book that is rotated twice.

live("two_sources", {
  prepare({ omega, walk, start, lift }) {
    const w = [0, 0, omega];
    const at = time => {
      const E = rotated(yours.rotated_basis, identity, w, time);
      const V = turned(E, [start + walk * time, 0, lift]), rate_body = times(walk, E[0]);
      const changed = rate => yours.inertial_rate?.(rate, w, V) ?? sum(rate, cross(w, V));
      return { E, V, rate_body, carried: changed(origin), rate: changed(rate_body) };
    };
    return { w, at, path: steps(0, 5, 120).map(time => at(time).V) };
  },
  handle: ({ start, lift }) => [start, 0, lift],  // the place of the child at the start
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
    const tip = vector => sum(V, times(1.4, vector));  // the velocities, at a length that one can see
    scene.line([tip(rate_body), tip(rate), tip(carried)], "grey", 1, { dash: [4, 4] });
    scene.arrow(V, tip(rate_body), "blue", "walk");
    scene.arrow(V, tip(carried), "green", "ω × V");
    if (scene.released) scene.arrow(V, tip(rate), "purple", "sum");
    const expected = [V, cross(m.w, V)][scene.expected];
    if (expected && norm(expected)) scene.expect([V, tip(times(norm(rate), unit(expected)))]);
    scene.round("rod", V, sum(V, [0, 0, 0.16]), 0.04, "ink");  // the child
    scene.dot(sum(V, [0, 0, 0.2]), "ink", 0.055 * scene.scale);
  }],
  numbers(m, time) {
    const { E, carried, rate } = m.at(time);
    const E_rate = yours.cross_matrix ? product(yours.cross_matrix(m.w), E) : E.map(axis => cross(m.w, axis));
    return [norm(carried), norm(rate), rate[0], rate[1], (yours.angular_velocity_of_basis?.(E, E_rate) ?? m.w)[2]];
  },
});

const book_places = [[-0.72, -0.54, 0], [0.72, 0.54, 0]];

live("book", {
  prepare({ x, z }) {
    const turns = [[x * degree, 0, 0], [0, 0, z * degree]];
    const books = [turns, turns.toReversed()].map(order => time =>
      order.reduce((E, turn, k) => rotated(yours.rotated_basis, E, turn, Math.max(0, Math.min(1, time - k))), identity));
    // The columns of attitudes that a rotation by Θ joins differ by √8 sin Θ/2 in all.
    const apart = 2 * Math.asin(norm(minus(...books.map(at => at(2).flat()))) / Math.sqrt(8));
    return { books, apart, ratio: apart / Math.abs(x * z * degree ** 2) };
  },
  // The upper edge of the first book after its rotation about x.
  handle: ({ x }) => sum(book_places[0], [0, 0.55 * Math.cos(x * degree), 0.55 * Math.sin(x * degree)]),
  draw: [(scene, m, time) => {
    scene.floor(-0.62, 1.4);
    m.books.forEach((at, i) => {
      const E = at(time), place = book_places[i], on = (...part) => sum(place, turned(E, part));
      scene.box(place, [0.38, 0.55, 0.11].map((half, k) => times(half, E[k])), ["pale", "pale", "sky"]);
      for (const [y, right, width] of [[0.25, 0.22, 8], [-0.3, 0.05, 4]]) scene.line([on(-0.22, y, 0.12), on(right, y, 0.12)], "ink", width);
      scene.line([on(-0.39, -0.55, 0), on(-0.39, 0.55, 0)], "blue", 10);
      for (const [axis, name] of [[x_axis, "x"], [z_axis, "z"]]) scene.arrow(place, sum(place, times(0.85, axis)), "omega", name, { width: 2 });
      scene.words(["x, then z", "z, then x"][i], sum(scene.at(sum(place, [0, 0, -0.62])), [0, 32]));
    });
    if (scene.expected === 0) scene.expect([book_places[1], sum(book_places[1], times(0.75, m.books[0](time)[1]))]);
  }],
  numbers: m => [m.apart, m.ratio],
});
