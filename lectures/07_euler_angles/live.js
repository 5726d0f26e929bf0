// Three turns in three conventions, and a passage near the vertical.

const rotated = (E, omega, time) => yours.rotated_basis?.(E, omega, time) ?? product(rotation(times(time, omega)), E);
const angles_at = A => yours.euler_angles?.(transposed(A)) ?? angles_of(A);

// The axes of the body about which each convention turns it, one after the other.
const conventions = [[2, 1, 2], [2, 0, 2], [2, 1, 0]];
const turn_names = [["φ", "θ", "ψ"], ["φ", "θ", "ψ"], ["yaw", "pitch", "roll"]];
const turn_colors = ["blue", "vermilion", "green"];

function draw_axes(scene, E, names = axis_names) {
  scene.body_with_arrows(() => {}, E.map((axis, i) => [origin, axis, axis_colors[i], names[i]]));
}

live("three_turns", {
  about: "A body is rotated three times, each time about one of its own axes; a disc marks the plane of each rotation.",
  question: "The body is rotated by φ about e₃, then by θ about its new e₂, then by ψ about its new e₃. Which of these moves e₃?",
  choices: {
    "all three": "No: a rotation about e₃ leaves e₃ where it is, and two of the three are about e₃.",
    "the first and the second": "No: the first is about e₃ itself; it only chooses the direction of the tilt.",
    "only the second": "Yes: it is about e₂; the two others are about e₃, which they do not move.",
  },
  answer: "Only the second: the first and the third are about e₃ itself. Yet φ decides in which direction θ tilts it. In another " +
    "convention the same three numbers mean another attitude.",
  controls: [choice("convention", "Convention", ["z–y–z, ours", "z–x–z, Goldstein", "yaw, pitch, roll (z–y–x)"]),
    slider("phi", "first", -180, 180, 5, 50, "°"), slider("theta", "second", -180, 180, 5, 50, "°"),
    slider("psi", "third", -180, 180, 5, 70, "°")],
  prepare({ convention, phi, theta, psi }) {
    const angles = times(degree, [phi, theta, psi]), axes = conventions[convention];
    // Before, between and after the turns.
    const attitudes = [identity];
    axes.forEach((axis, k) => attitudes.push(rotated(attitudes[k], times(angles[k], attitudes[k][axis]), 1)));
    return { angles, axes, attitudes, names: turn_names[convention], ours: angles_at(attitudes[3]) };
  },
  duration: () => 3,
  pace: 0.5,
  views: {
    "One turn after the other": {
      half: 1.25, towards: [0.9, -1, 0.65], aspect: 1.5,
      draw(scene, m, time) {
        const turn = Math.min(2, Math.floor(time)), part = time - turn;
        const E = rotated(m.attitudes[turn], times(m.angles[turn], m.attitudes[turn][m.axes[turn]]), part);
        draw_axes(scene, identity.map(axis => times(0.6, axis)), ["", "", ""]);
        for (let k = 0; k <= turn; ++k) {
          const kept = m.axes[k], [u, v] = [1, 2].map(i => m.attitudes[k][(kept + i) % 3]);
          scene.face(arc(origin, u, v), turn_colors[k], 0.13, 0.6);
          const angle = m.angles[k] * (k === turn ? part : 1), swept = arc(origin, times(0.75, u), times(0.75, v), 0, angle);
          scene.line(swept, turn_colors[k], 3);
          if (Math.abs(angle) > 0.2) scene.text(times(1.25, swept[36]), m.names[k], turn_colors[k]);
        }
        scene.box(origin, E.map((axis, i) => times([0.34, 0.22, 0.08][i], axis)), axis_colors);
        draw_axes(scene, E.map(axis => times(1.1, axis)));
      },
    },
  },
  numbers: m => [...m.ours.map((angle, i) => [`in the end, our ${["φ", "θ", "ψ"][i]}`, angle, "°", degree]),
    ...m.attitudes[3][2].map((component, i) => [`e₃ along ${"xyz"[i]}`, component])],
});

live("gimbal_passage", {
  about: "A rotor in its gimbals passes near the vertical while it rotates steadily; the rates of its Euler angles.",
  question: "The body rotates steadily at 1 rad/s, so that e₃ passes the vertical at 10°. How large does dφ/dt become?",
  choices: {
    "it stays below 1 rad/s": "No: the rates of φ and ψ nearly cancel each other, so each may be far larger than ω.",
    "about 6 rad/s": "Yes: e₃ passes the vertical at 1 rad/s on a circle of radius sin 10°, which takes φ at 1/sin " +
      "10° rad/s.",
    "infinite": "No: only a passage through the vertical itself needs an infinite rate.",
  },
  answer: "1/sin 10°, about 6 rad/s, and dψ/dt nearly as much in the other sense: the axes of φ and ψ have almost merged, and the " +
    "motion needs the direction across both rings. The body itself feels nothing. Let it pass nearer.",
  controls: [slider("distance", "distance", 1, 60, 1, 10, "°"), slider("spin", "spin about e₃", -1, 1, 0.1, 0, "rad/s")],
  prepare({ distance, spin }) {
    // e₃ moves in the plane of x and the direction of the passage; half way it stands at `distance` from the vertical.
    const omega = [0, Math.cos(distance * degree), Math.sin(distance * degree)];
    const start = rotation([distance * degree, 0, 0]);
    const at = time => {
      const carried = rotated(start, omega, time - Math.PI / 2), A = rotated(carried, times(spin, carried[2]), time);
      const omega_now = sum(omega, times(spin, A[2])), angles = angles_at(A);
      const own = yours.euler_angle_rates?.(angles, turned(transposed(A), omega_now));
      return { A, angles, rates: own ?? angle_rates(angles, omega_now) };
    };
    const moments = steps(0, Math.PI, 240);
    return { at, moments, samples: moments.map(at) };
  },
  duration: () => Math.PI,
  pace: 0.4,
  views: {
    "A rotor in its gimbals": {
      half: 1.45, towards: [0.5, -1, 0.45],
      draw(scene, m, time) {
        const { A, angles: [phi] } = m.at(time), nodes = [-Math.sin(phi), Math.cos(phi), 0];
        const across = [Math.cos(phi), Math.sin(phi), 0];
        scene.line(arc(origin, z_axis, nodes), "blue", 4);
        scene.line(arc(origin, times(0.9, A[2]), times(0.9, nodes)), "vermilion", 4);
        scene.face(arc(origin, times(0.6, A[0]), times(0.6, A[1])), "green", 0.35, 1);
        scene.line([origin, times(0.6, A[0])], "ink", 1.5);
        scene.body_with_arrows(() => {}, [[times(-1.3, z_axis), times(1.3, z_axis), "blue", "φ"],
          [times(-1.2, nodes), times(1.2, nodes), "vermilion", "θ"], [times(-1.2, A[2]), times(1.2, A[2]), "green", "ψ"]]);
        scene.line([times(-1, across), across], "grey", 1.5, { dash: [3, 5] });
      },
    },
    "Rates of the angles": {
      draw(scene, m, time) {
        const largest = Math.max(...m.samples.flatMap(({ rates }) => rates).map(Math.abs));
        const most = 1.1 * (scene.released ? largest : 2);
        scene.plot({ x: [0, Math.PI], y: [-most, most], x_name: "time (s)", y_name: "rad/s", now: time,
          curves: ["dφ/dt", "dθ/dt", "dψ/dt"].map((name, i) => ({ name, color: ["blue", "vermilion", "green"][i],
            points: m.samples.map(({ rates }, k) => [m.moments[k], rates[i]]) })),
          expected: [[1, -1], [-6, 6]][scene.expected] });
      },
    },
  },
  numbers(m, time) {
    const { angles, rates } = m.at(time);
    return [...["φ", "θ", "ψ"].map((name, i) => [name, angles[i], "°", degree]),
      ...["dφ/dt", "dθ/dt", "dψ/dt"].map((name, i) => [name, rates[i], "rad/s"])];
  },
});
