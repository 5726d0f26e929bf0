#include "solutions/05_euler_equations/shared.hpp"

/// The right ω₃, and (ω₁, ω₂) turned through an angle of one's own.
template <class Angle>
static auto turned_by(const Angle& angle) {
  return [angle](auto I1, auto I3, auto& w, auto torque, auto t) -> Vector3d {
    return turn(z_axis, (I3 / I1 - 1) * angle(w[2], torque / I3, t)) * w + torque / I3 * t * z_axis;
  };
}

void judge_spin_up(Lecture& lecture) {
  auto& e = lecture.exercise(&spin_up,
                             {{"I1", positive(kg_m2)},
                              {"I3", positive(kg_m2)},
                              {"omega0", rad_per_s},
                              {"torque", newton_metre},
                              {"t", second}},
                             {"omega", rad_per_s});
  e.generated([](auto I1, auto I3, auto& w, auto torque, auto t) {
    return abs((I3 / I1 - 1) * t) * (abs(w[2]) + abs(torque / I3 * t)) < 30;
  });
  const Vector3d start(0.4, 0, 2);
  e.worked("the satellite of the lecture", 1, 1.8, start, 0.9, 8);
  e.worked("a long satellite is braked", 2, 0.5, {-0.7, 0.4, 1.5}, -0.1, 4);
  e.special("without a torque", 1, 1.8, {0.3, 0.1, 2}, 0, 3);
  e.special("a sphere", 2, 2, example_omega, 0.7, 5);
  e.special("time 0", 1, 1.8, start, 0.9, 0);
  e.special("before time 0", 1, 1.8, {0.3, 0.1, 2}, 0.9, -2);
  e.special("spun up from rest about the axis", 1, 1.8, {0.3, 0.1, 0}, 0.9, 3);
  e.special("no wobble", 1, 1.8, {0, 0, 2}, 0.9, 3);
  e.special("braked until the angle is undone", 1, 1.8, {0.3, 0.1, 2}, -0.9, 8);
  e.random("a random satellite", 10, [](Random& random) {
    const double I1 = random.uniform(0.5, 2);
    const double I3 = I1 * (random.sign() > 0 ? random.uniform(1.3, 1.9) : random.uniform(0.3, 0.7));
    const Vector3d omega = random.vector(2);
    const double t = random.uniform(0.5, 1.2);
    return tuple(I1, I3, omega, I3 * copysign(random.uniform(0.6, 2), omega[2]), t);
  });
  e.scale([](auto, auto I3, auto& w, auto torque, auto t) { return or_one(w.norm() + abs(torque / I3 * t)); });
  e.sweep<4>({"I₁ = 1, I₃ = 1.8 kg m², a torque of 0.9 N m about axis 3", "time (s)", "body component of ω (rad/s)"},
             {"omega_1", "omega_2", "omega_3"}, {0, 8, 121});

  e.wrong("(ω₁, ω₂) turns with the rate of the end all the time; the rate grows, and the angle is its integral.",
          "rate_of_the_end", turned_by([](auto w3, auto gain, auto t) { return (w3 + gain * t) * t; }));
  e.wrong("(ω₁, ω₂) turns with the rate of time 0; the rate grows with ω₃.", "rate_of_the_start",
          turned_by([](auto w3, auto, auto t) { return w3 * t; }));
  e.wrong("(ω₁, ω₂) turns the wrong way round; for I₃ > I₁ and ω₃ > 0 it goes from axis 1 towards axis 2.", "sense",
          turned_by([](auto w3, auto gain, auto t) { return -(w3 + gain * t / 2) * t; }));
  e.wrong("ω₁ and ω₂ keep their values here; that holds for a sphere only.", "no_turning",
          turned_by([](auto, auto, auto) { return 0; }));
  e.wrong("The rate of (ω₁, ω₂) is divided by I₃; the first two equations have the moment I₁.", "divided_by_I3",
          [](auto I1, auto I3, auto& w, auto torque, auto t) -> Vector3d {
            const double gain = torque / I3 * t;
            return turn(z_axis, (1 - I1 / I3) * (w[2] + gain / 2) * t) * w + gain * z_axis;
          });
  e.wrong_inputs("ω₃ grows by τ t; the torque is still to be divided by I₃.", "torque_not_divided",
                 [](auto, auto I3, auto&, auto& torque, auto) { torque *= I3; });
  e.wrong_input<2>("The phase of the start is lost: at t = 0 your ω does not equal omega0.", "phase_lost",
                   [](auto& w) { w = Vector3d(hypot(w[0], w[1]), 0, w[2]); });
  e.wrong_input<3>("The torque does not enter; ω₃ grows by τ t/I₃.", "no_torque", fixed(0.0));
  e.route("a complex number, and the energy of the spin", [](auto I1, auto I3, auto& w, auto torque, auto t) {
    const double end = w[2] + torque / I3 * t;
    const double twice_angle =
        torque == 0 ? 2 * (I3 / I1 - 1) * w[2] * t : (I3 / I1 - 1) * I3 / torque * (end - w[2]) * (end + w[2]);
    const auto across = std::complex(w[0], w[1]) * polar(1.0, twice_angle / 2);
    return Vector3d(across.real(), across.imag(), end);
  });
  e.route("Euler's equations, step by step", [](auto I1, auto I3, auto& w, auto torque, auto t) {
    return followed(w, t, 20000, [&](const Vector3d& now) {
      return euler_equations({I1, I1, I3}, now, torque * z_axis);
    });
  });
  e.route("the angle by Simpson's rule, then sine and cosine", [](auto I1, auto I3, auto& w, auto torque, auto t) {
    const auto rate = [&](double time) { return (I3 - I1) / I1 * (w[2] + torque / I3 * time); };
    const double angle = t / 6 * (rate(0) + 4 * rate(t / 2) + rate(t)), c = cos(angle), s = sin(angle);
    return Vector3d(c * w[0] - s * w[1], s * w[0] + c * w[1], w[2] + torque / I3 * t);
  });
}
