#include "solutions/06_free_tops/shared.hpp"

/// Ωt
static double angle_of(double I1, double I3, const Vector3d& w, double t) {
  return body_precession_rate(I1, I3, w[2]) * t;
}

/// The rotation in space that carries ω and the symmetry axis round L.
static Matrix3d about_L(double I1, double I3, const Vector3d& w, double t) {
  return turn(L_of(I1, I3, w), space_precession_rate(I1, I3, w) * t);
}

/// ω turned about axis 3 at a rate of one's own.
template <class Rate>
static auto turning_at(const Rate& rate) {
  return [rate](auto I1, auto I3, auto& w, auto t) { return turn(z_axis, rate(I1, I3, w) * t) * w; };
}

static void add_routes_of_symmetric_top(auto& e) {
  e.route("amplitude and phase", [](auto I1, auto I3, auto& w, auto t) {
    const double amplitude = hypot(w[0], w[1]), angle = angle_of(I1, I3, w, t) + atan2(w[1], w[0]);
    return Vector3d(amplitude * cos(angle), amplitude * sin(angle), w[2]);
  });
  e.route("a complex number", [](auto I1, auto I3, auto& w, auto t) {
    const auto transverse = std::complex(w[0], w[1]) * polar(1.0, w[2] * (I3 / I1 - 1) * t);
    return Vector3d(transverse.real(), transverse.imag(), w[2]);
  });
  e.route("Euler's equations, step by step", [](auto I1, auto I3, auto& omega0, auto t) {
    return followed(omega0, t, 4000, [&](const Vector3d& w) { return free_rate(Vector3d(I1, I1, I3), w); });
  });
  e.route("the exact asymmetric top, with two equal moments",
          [](auto I1, auto I3, auto& w, auto t) { return ExactTop(Vector3d(I1, I1, I3), w).omega(t); });
  e.route("back from inertial components", [](auto I1, auto I3, auto& w, auto t) {
    // In space ω turns about L with L/I1; the body turns likewise and, besides, about its own axis with −Ω.
    const Matrix3d turned = about_L(I1, I3, w, t);
    return (turned * turn(z_axis, -angle_of(I1, I3, w, t))).transpose() * (turned * w);
  });
}

void judge_symmetric_top(Lecture& lecture) {
  auto& e = lecture.exercise(&symmetric_top,
                             {{"I1", positive(kg_m2)}, {"I3", positive(kg_m2)}, {"omega0", rad_per_s}, {"t", second}},
                             {"omega", rad_per_s});
  e.worked("the top of the lecture", 1, 1.8, lecture_omega, 0.7);
  e.worked("a long top, before time 0", 2, 0.5, {-0.7, 0.4, 1.5}, -0.9);
  e.special("time 0", 1, 1.8, lecture_omega, 0);
  e.special("a full period later", 1, 1.8, lecture_omega, 2 * pi / 1.6);
  e.special("half a period later", 1, 1.8, lecture_omega, pi / 1.6);
  e.special("a sphere", 2, 2, {0.3, -0.2, 0.5}, 3);
  e.special("no wobble", 1, 1.8, {0, 0, 2}, 0.7);
  e.special("no spin about the symmetry axis", 1, 1.8, {0.3, 0.4, 0}, 0.7);
  e.special("a wobble of 1e-8", 1, 1.8, {1e-8, 0, 2}, 0.7);
  e.random("a random top", 10, [](Random& random) {
    const auto [I1, I3] = symmetric_moments(random);
    const Vector3d omega = random.vector(3);
    const double angle = random.uniform(0.4, 1.2);  // how far ω turns: neither 0 nor near half a turn
    return tuple{I1, I3, omega, random.sign() * angle / abs(body_precession_rate(I1, I3, omega[2]))};
  });
  e.scale([](auto, auto, auto& w, auto) { return or_one(w.norm()); });
  e.sweep<3>({"The top of the lecture: I₁ = 1, I₃ = 1.8 kg m², A = 0.4, ω₃ = 2 rad/s", "time (s)",
              "body component of ω (rad/s)"},
             {"omega_1", "omega_2", "omega_3"}, {0, 6});

  e.term("cos Ωt · (ω₁, ω₂, 0) of time 0", 1,
         [](auto I1, auto I3, auto& w, auto t) { return cos(angle_of(I1, I3, w, t)) * Vector3d(w[0], w[1], 0); });
  e.term("sin Ωt · (−ω₂, ω₁, 0) of time 0", 1,
         [](auto I1, auto I3, auto& w, auto t) { return sin(angle_of(I1, I3, w, t)) * Vector3d(-w[1], w[0], 0); });
  e.term("(0, 0, ω₃)", 1, [](auto, auto, auto& w, auto) { return Vector3d(0, 0, w[2]); });
  e.wrong_input<3>("Your ω runs the wrong way round: it turns by +Ωt, Ω = ω₃ (I₃ − I₁)/I₁.", "wrong_sense", negated);
  e.wrong_input<2>("The initial phase is lost: at t = 0 your ω does not equal omega0.", "phase_lost",
                   [](auto& w) { w = Vector3d(hypot(w[0], w[1]), 0, w[2]); });
  e.wrong_input<2>("The initial phase has the wrong sign: your ω₂ starts with −ω₂.", "phase_negated", negate(1));
  e.wrong_input<2>("The phase lies in the wrong quadrant when ω₁ < 0: atan2(ω₂, ω₁) finds it, atan(ω₂/ω₁) does not.",
                   "phase_by_atan", [](auto& w) { w = Vector3d(abs(w[0]), copysign(1, w[0]) * w[1], w[2]); });
  e.wrong_output("Sine and cosine are exchanged: ω₁ takes the cosine.", "sine_and_cosine_exchanged", exchange(0, 1));
  e.wrong_input<2>("Your amplitude is ω₁² + ω₂²; A is the square root of it.", "amplitude_squared",
                   [](auto& w) { w = Vector3d(hypot(w[0], w[1]) * w[0], hypot(w[0], w[1]) * w[1], w[2]); });
  e.wrong("Your ω turns with ω₃ (I₃ − I₁)/I₃; the rate Ω is divided by I₁.", "divided_by_I3",
          turning_at([](auto I1, auto I3, auto& w) { return w[2] * (I3 - I1) / I3; }));
  e.wrong_inputs("I₁ and I₃ are exchanged in the rate of your ω; I₃ belongs to the symmetry axis.", "moments_exchanged",
                 first_two_exchanged);
  e.wrong({"Your ω turns with L/I₁, the rate in the inertial frame; seen from the body it turns with Ω.", space_notes},
          "space_rate", turning_at(space_precession_rate));
  e.wrong(
      {"Your ω turns with ω₃I₃/I₁, as in the inertial frame; in the body its rate is smaller by ω₃ (with its sign).",
       space_notes},
      "space_rate_of_a_small_wobble", turning_at([](auto I1, auto I3, auto& w) { return w[2] * I3 / I1; }));
  e.wrong("Your ω turns with ω₃ itself; the rate is Ω = ω₃ (I₃ − I₁)/I₁.", "spin_rate",
          turning_at([](auto, auto, auto& w) { return w[2]; }));
  e.wrong("The length of ω stands for ω₃ in your rate; only the spin about the symmetry axis counts there.",
          "length_for_spin", turning_at([](auto I1, auto I3, auto& w) { return w.norm() * (I3 - I1) / I1; }));
  e.wrong("Your ω always turns from axis 1 to axis 2; the sign of Ω decides the sense.", "magnitude_of_rate",
          turning_at([](auto I1, auto I3, auto& w) { return abs(body_precession_rate(I1, I3, w[2])); }));
  e.wrong_input<3>("This is ω of time 0; ω₁ and ω₂ change with time.", "no_motion", fixed(0.0));
  e.wrong("This is omega0 and one step t·dω/dt; over a finite time ω turns on a circle.", "one_step",
          [](auto I1, auto I3, auto& w, auto t) { return w + t * free_rate(Vector3d(I1, I1, I3), w); });
  e.wrong({"These are components on axes that do not turn, where ω circles L; asked for are the body's.", space_notes},
          "inertial_components", [](auto I1, auto I3, auto& w, auto t) { return about_L(I1, I3, w, t) * w; });
  e.wrong_terms("Your third component is zero; ω₃ keeps its value.", "spin_not_returned", {1, 1, 0});
  e.conserves({"The kinetic energy of a free top does not change: I₁ω₁² + I₁ω₂² + I₃ω₃² is the same at all times.",
               "free_tops_energy"},
              [](auto I1, auto I3, auto&...) { return Vector3d(I1, I1, I3); });
  add_routes_of_symmetric_top(e);
}
