// A child on a merry-go-round.

live("two_sources", {
  about: "A vector V from the axis of a merry-go-round to a child that walks outwards, with the two parts of its rate of change.",
  question: "The child walks straight outwards on the merry-go-round. Which way does it move for somebody on the ground?",
  choices: {
    "outwards, along V": "No: this is what one sees on the merry-go-round, which carries the child sideways meanwhile.",
    "at right angles to V": "No: this is how a child at rest on the merry-go-round would move; this one walks.",
    "outwards and along with the rotation": "Yes: for the ground, the walk and the motion of the place where it " +
      "walks add up.",
  },
  answer: "Both at once: what the child walks, along V, and what the rotating basis adds, ω × V at right angles to it. The further " +
    "out, the more the second wins. Lift the child: ω × V does not change, for only the distance from the axis counts.",
  controls: [slider("omega", "ω", -2, 2, 0.1, 0.6, "rad/s"), slider("walk", "walking", -0.3, 0.3, 0.05, 0.15, "m/s"),
    slider("start", "start", 0, 1, 0.05, 0.3, "m"), slider("lift", "lift", 0, 1, 0.1, 0, "m")],
  prepare({ omega, walk, start, lift }) {
    const w = [0, 0, omega], seconds = 5;
    const at = time => {
      const E = yours.rotated_basis?.(identity, w, time) ?? rotation(times(time, w));
      const V = turned(E, [start + walk * time, 0, lift]), rate_body = times(walk, E[0]);
      const changed = rate => yours.inertial_rate?.(rate, w, V) ?? sum(rate, cross(w, V));
      return { E, V, rate_body, carried: changed(origin), rate: changed(rate_body) };
    };
    return { w, at, seconds, path: steps(0, seconds, 120).map(time => at(time).V) };
  },
  duration: m => m.seconds,
  views: {
    "Seen from the ground": {
      half: 1.2, towards: [0.25, -1, 1.6], aspect: 1.5,
      draw(scene, m, time) {
        const { E, V, rate_body, carried, rate } = m.at(time);
        scene.face(arc(origin, x_axis, y_axis), "shade", 1, 1);
        for (const k of [0, 1]) scene.line([times(-1, E[k]), E[k]], "pale", 2);
        scene.line(m.path.slice(0, Math.floor(120 * time / m.seconds) + 1), "ink", 1.5, { dash: [1, 5] });
        for (const k of [0, 1]) scene.arrow(times(0.8, E[k]), times(1.12, E[k]), "grey", axis_names[k], { width: 2.2 });
        scene.arrow(origin, times(0.5, unit([0, 0, m.w[2] || 1])), "purple", "ω", { width: 2.2 });
        scene.arrow(origin, V, "ink", "", { width: 2 });
        scene.words("V", sum(scene.at(times(0.6, V)), [13, 4]));
        // The velocities, at a length that one can see.
        const tip = vector => sum(V, times(1.4, vector));
        scene.line([tip(rate_body), tip(rate), tip(carried)], "grey", 1, { dash: [4, 4] });
        scene.arrow(V, tip(rate_body), "blue", "walk");
        scene.arrow(V, tip(carried), "orange", "ω × V");
        if (scene.released) scene.arrow(V, tip(rate), "vermilion", "sum");
        const expected = [V, cross(m.w, V)][scene.expected];
        if (expected && norm(expected)) scene.expect([V, tip(times(norm(rate), unit(expected)))]);
        scene.dot(V, "ink", 5);
      },
    },
  },
  numbers(m, time) {
    const { E, carried, rate } = m.at(time);
    const [x, y] = rate, E_rate = yours.cross_matrix ? product(yours.cross_matrix(m.w), E) : E.map(axis => cross(m.w, axis));
    const omega = yours.angular_velocity_of_basis?.(E, E_rate) ?? m.w;
    return [["|ω × V|", norm(carried), "m/s"], ["ground speed", norm(rate), "m/s"], ["dV/dt, x", x, "m/s"],
      ["dV/dt, y", y, "m/s"], ["ω of the basis", omega[2], "rad/s"]];
  },
});
