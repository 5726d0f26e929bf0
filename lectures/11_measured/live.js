// A throw replayed.

/** Throws of racket_throws.csv: seconds from sample to sample, and ω in thousandths of a rad/s. */
const racket_throws = [
  { number: 6, step: 0.0100208, omega: [
    16190,-7632,-4712, 15651,-8464,-5794, 15054,-9362,-6953, 14307,-10480,-8176, 13281,-11694,-9469,
    11972,-12939,-10775, 10402,-14148,-12042, 8526,-15265,-13199, 6318,-16234,-14173, 3877,-16894,-14874,
    1294,-17194,-15230, -1336,-17118,-15198, -3890,-16670,-14795, -6239,-15891,-14072, -8310,-14872,-13101,
    -10085,-13709,-11963, -11565,-12496,-10745, -12730,-11282,-9510, -13647,-10130,-8304, -14362,-9074,-7155,
    -14900,-8145,-6085, -15288,-7342,-5089, -15569,-6666,-4170, -15778,-6131,-3314, -15918,-5724,-2513,
    -15998,-5437,-1751, -16041,-5265,-1018, -16050,-5206,-301, -16017,-5257,417, -15934,-5410,1142, -15818,-5677,1900,
    -15652,-6049,2696, -15418,-6535,3535, -15106,-7132,4431, -14704,-7845,5389, -14185,-8667,6423, -13517,-9583,7518,
    -12666,-10578,8658, -11610,-11626,9824, -10314,-12678,10973, -8763,-13684,12064, -6954,-14576,13027,
    -4932,-15275,13792, -2738,-15732,14302, -444,-15883,14511, 1839,-15717,14403, 4037,-15258,13988, 6062,-14545,13318,
    7862,-13641,12445, 9406,-12618,11444, 10692,-11548,10369, 11735,-10488,9272, 12567,-9487,8200, 13216,-8553,7174,
    13706,-7710,6212, 14073,-6970,5313, 14350,-6327,4481, 14547,-5781,3709, 14677,-5337,2997, 14765,-4980,2333,
    14810,-4720,1706, 14822,-4544,1102, 14811,-4455,522, 14777,-4446,-48, 14725,-4517,-621, 14645,-4674,-1197,
    14532,-4916,-1790, 14393,-5240,-2412, 14206,-5658,-3078, 13968,-6161,-3790, 13661,-6755,-4540, 13276,-7426,-5343,
    12782,-8177,-6209, 12164,-8986,-7113, 11405,-9840,-8035, 10483,-10718,-8970, 9381,-11595,-9882, 8087,-12434,-10742,
    6616,-13200,-11509, 4972,-13832,-12141, 3204,-14255,-12592, 1358,-14485,-12839, -508,-14488,-12856,
    -2350,-14249,-12646, -4094,-13800,-12228, -5695,-13188,-11636] },
  { number: 3, step: 0.0100208, omega: [
    9242,-13135,-10859, 7703,-14090,-11825, 5889,-14866,-12638, 3885,-15444,-13254, 1781,-15822,-13614,
    -401,-15880,-13676, -2568,-15638,-13439, -4612,-15165,-12957, -6476,-14433,-12166, -8165,-13575,-11265,
    -9577,-12583,-10364, -10761,-11588,-9330, -11721,-10606,-8249, -12464,-9660,-7188, -13054,-8820,-6171,
    -13505,-8054,-5206, -13834,-7401,-4293, -14082,-6855,-3436, -14255,-6399,-2626, -14361,-6076,-1853,
    -14413,-5844,-1114, -14427,-5716,-392, -14402,-5692,318, -14329,-5748,1032, -14227,-5916,1752, -14067,-6168,2491,
    -13857,-6526,3260, -13587,-6984,4061, -13238,-7517,4905, -12808,-8160,5788, -12258,-8870,6714, -11570,-9656,7672,
    -10736,-10498,8643, -9723,-11358,9607, -8518,-12217,10536, -7119,-13012,11381, -5539,-13705,12103,
    -3793,-14235,12658, -1930,-14566,13000, -13,-14671,13103, 1894,-14539,12968, 3724,-14190,12593, 5431,-13642,12013,
    6974,-12945,11270, 8317,-12147,10412, 9466,-11298,9481, 10423,-10443,8521, 11200,-9611,7564, 11831,-8827,6626,
    12325,-8110,5726, 12710,-7471,4877, 13003,-6911,4070, 13216,-6445,3307, 13361,-6042,2586, 13457,-5731,1910,
    13505,-5505,1258, 13521,-5352,626, 13494,-5291,9, 13438,-5297,-601, 13343,-5386,-1215, 13227,-5515,-1834,
    13063,-5762,-2462, 12852,-6061,-3108, 12603,-6412,-3783, 12284,-6878,-4489, 11911,-7373,-5239, 11450,-7957,-6042,
    10908,-8580,-6837, 10214,-9319,-7530, 9471,-9965,-8312, 8525,-10700,-9082, 7451,-11466,-9816, 6244,-12090,-10484,
    4884,-12670,-11057, 3417,-13121,-11501, 1860,-13381,-11778, 249,-13471,-11879, -1352,-13380,-11785,
    -2907,-13120,-11506, -4382,-12710,-11042, -5726,-12135,-10420, -6960,-11493,-9654, -8030,-10756,-9069,
    -8930,-10013,-8449, -9667,-9277,-7658, -10271,-8560,-6873, -10771,-7890,-6114, -11160,-7246,-5388,
    -11473,-6695,-4696, -11705,-6174,-4045, -11884,-5729,-3427, -12009,-5340,-2851, -12097,-5005,-2306] },
];

const last_of = made => (made.omega.length / 3 - 1) * made.step;
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
  about: "A throw of a racket with a phone on its strings: measured angular velocities, and the motion that fits them best.",
  question: "A free body without air is fitted to the measured ω, with the start that fits best. When does its ω_x vanish?",
  choices: {
    "at the same times as measured": "No: a free body turns over in equal times, and the racket takes longer each time.",
    "too late at first, too early at the end": "Yes: its period stays, that of the racket grows, and the best fit agrees halfway.",
    "too early at first, too late at the end": "No: that would be a racket that turns over in ever shorter times.",
  },
  answer: "Too late at first and too early at the end: the air takes from L, and the racket slows down. Raise γ until least is " +
    "left; the polhode hardly changes, because the torque of the air is opposite to L. Then try other moments.",
  controls: [choice("which", "Throw", racket_throws.map(({ number }) => `throw ${number}`)),
    slider("Iy", "I_y / I_x", 0.05, 0.12, 0.001, 0.08), slider("Iz", "I_z / I_x", 1.03, 1.12, 0.001, 1.075),
    slider("gamma", "γ", 0, 0.6, 0.01, 0, "1/s")],
  prepare({ which, Iy, Iz, gamma }) {
    const { step, omega } = racket_throws[which], I = [1, Iy, Iz];
    const samples = steps(0, omega.length / 3 - 1, omega.length / 3 - 1).map(k => times(0.001, omega.slice(3 * k, 3 * k + 3)));
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
    return { I, step, samples, computed, momenta, attitudes, axes, size: 1 / Math.max(...axes), seconds: last_of(racket_throws[which]),
      measured_points: samples.map(over_L), curve: computed.map(over_L), left_over: Math.sqrt(square(left) / (3 * left.length)) };
  },
  duration: m => m.seconds,
  pace: 0.15,
  views: {
    "ω over L on its ellipsoid": {
      half: 1.25, towards: [1, 0.5, 0.45],
      draw(scene, m, time) {
        const k = Math.floor(time / m.step + 1e-6), place = p => times(m.size, p), normal = p => scaled(m.I, p);
        scene.body_with_arrows(() => {
          scene.ellipsoid(origin, diagonal(...times(m.size, m.axes)), "blue");
          if (scene.released) scene.on_surface(m.curve.map(place), normal, "grey", 2);
          for (const point of m.measured_points.slice(0, k + 1))
            scene.dot(place(point), "vermilion", dot(normal(point), scene.towards) >= 0 ? 3 : 1.5);
        }, m.axes.map((length, i) => [origin, times(m.size * length + 0.25, identity[i]), axis_colors[i], axis_letters[i], { width: 2.2 }]));
      },
    },
    "The racket in space, as its phone felt it": {
      half: 1.3, towards: [0.3, -1, 0.45],
      draw(scene, m, time) {
        const A = m.attitudes[Math.floor(time / m.step + 1e-6)], at = (x, y, z = 0) => turned(A, [x, y, z]);
        const rim = steps(0, 2 * Math.PI, 48).map(angle => at(0.36 * Math.cos(angle), 0.42 + 0.45 * Math.sin(angle)));
        const phone = [[-0.1, 0.2], [0.1, 0.2], [0.1, 0.6], [-0.1, 0.6]].map(([x, y]) => at(x, y, 0.04));
        const front = dot(A[2], scene.towards) >= 0;
        const L = [origin, [0, 0, 1.15], "blue", "L"];
        scene.body_with_arrows(() => {
          if (!front) scene.face(phone, "ink", 0.6, 1.2);
          scene.face(rim, front ? "green" : "orange", 0.45, 2);
          scene.line([at(0, -0.03), at(0, -0.75)], "ink", 5);
          if (front) scene.face(phone, "ink", 0.6, 1.2);
        }, [L, [origin, times(0.9, A[2]), "purple", "z"]]);
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
