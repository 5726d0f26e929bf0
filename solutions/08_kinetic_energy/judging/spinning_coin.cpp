#include "solutions/08_kinetic_energy/shared.hpp"

namespace {

/// The attitude when the point of contact has gone round by `phase`: a node that rests in the table's directions, and a
/// coin that turns backwards so that its centre and the point of contact are at rest.
Matrix3d settling_coin(double inclination, double phase) {
  return attitude({phase, inclination, -phase * cos(inclination)});
}

/// The second derivative of a function of the phase at 0, by differences.
template <class Function>
auto second_difference(const Function& f) {
  constexpr double h = 0.02;
  return (270 * (f(h) + f(-h)) - 27 * (f(2 * h) + f(-2 * h)) + 2 * (f(3 * h) + f(-3 * h)) - 490 * f(0)) / (180 * h * h);
}

}  // namespace

void judge_spinning_coin(Lecture& lecture) {
  auto& e = lecture.exercise(&spinning_coin,
                             {{"radius", positive(metre)}, {"g", positive(m_per_s2)}, {"inclination", positive(rad)}},
                             {"Omega", rad_per_s});
  e.domain([](auto, auto, auto inclination) { return inclination < pi / 2; });
  e.worked("a coin at 20°", 0.0375, 9.81, 20 * degree);
  e.special("the rattle before the end, 1°", 0.0375, 9.81, 1 * degree);
  e.special("nearly upright, 80°", 0.0375, 9.81, 80 * degree);
  e.special("45°", 0.0375, 9.81, 45 * degree);
  e.special("on the Moon", 0.0375, 1.62, 20 * degree);
  e.special("all but upright, 89°", 0.0375, 9.81, 89 * degree);
  e.limit("all but upright, 89°", 2 * sqrt(9.81 / 0.0375),
          "A coin that spins about its upright diameter is held up when ¼MR²Ω², the torque that its leaning L needs, "
          "reaches MgR.");
  e.limit(
      "the rattle before the end, 1°", 2 * sqrt(9.81 / (0.0375 * degree)),
      "Nearly flat, L is only ¼MR²Ωα and level, and it goes round at Ω under the torque MgR: the flatter, the faster.");
  e.random("any coin", 8, [](Random& random) {
    const double inclination = random.sign() > 0 ? random.uniform(0.1, 0.7) : random.uniform(0.87, 1.3);
    return tuple{random.uniform(0.01, 0.1), random.uniform(1.5, 25), inclination};
  });
  e.sweep({"A coin of radius 37.5 mm on Earth", "inclination (rad)", "Ω (rad/s)"}, {"Ω"}, {0.02, 1.5},
          [](auto inclination) { return tuple(0.0375, 9.81, inclination); });

  e.wrong_output(
      "Your rate fits the moment of a disc about its own axis, or a radius twice as large; the coin turns about a "
      "diameter.",
      "polar_moment", times(sqrt(0.5)));
  e.wrong_output("Your rate fits a moment about the edge; the centre is at rest, and L is that about it.",
                 "about_the_edge", times(sqrt(0.2)));
  e.wrong_input<2>("Sine and cosine are exchanged, or the inclination is counted from the vertical.", "cosine",
                   complement);
  e.wrong_output("This is the angular velocity of the coin itself; the point of contact runs around faster.",
                 "spin_as_rate", [](auto& rate, auto, auto, auto inclination) { rate *= sin(inclination); });
  e.wrong_output("This is half of the rate, as if all mass were at the distance a from the diameter.",
                 "particle_on_cone", times(0.5));
  e.wrong_output("This is the rate at which the picture on the coin turns; the point of contact runs around faster.",
                 "picture", [](auto& rate, auto, auto, auto inclination) { rate *= 1 - cos(inclination); });
  e.wrong_output("This is in turns per second; radians per second are asked for.", "turns", times(0.5 / pi));
  e.wrong_output("The inclination does not enter your rate; ω is not as large as Ω.", "omega_as_rate",
                 [](auto& rate, auto, auto, auto inclination) { rate *= sqrt(sin(inclination)); });
  e.wrong_output("This is the square of the rate.", "squared", [](auto& rate) { rate *= rate; });
  e.wrong_output("The whole of L turns in your answer; only its level part changes its direction.", "all_of_L",
                 [](auto& rate, auto, auto, auto inclination) { rate *= sqrt(cos(inclination)); });
  e.angles_read_as_degrees("kinetic_energy_free_top");
  e.property(Is::nonnegative, "The rate is asked for with the positive sign.");
  e.route("change of L by differences", [](auto a, auto g, auto inclination) {
    const auto turned = [&](double phase) { return settling_coin(inclination, phase); };
    constexpr double h = 0.01;  // in units of the phase: Ω = 1
    const auto L = [&](double phase) {
      const auto rate = [&](double k) { return turned(phase + k * h) - turned(phase - k * h); };
      const Matrix3d A_rate = (45 * rate(1) - 9 * rate(2) + rate(3)) / (60 * h);
      const Vector3d omega = axial(A_rate * turned(phase).transpose());
      const Matrix3d A = turned(phase);
      return A * (Vector3d(0.25, 0.25, 0.5) * (a * a)).asDiagonal() * (A.transpose() * omega);
    };
    const Vector3d L_rate = (45 * (L(h) - L(-h)) - 9 * (L(2 * h) - L(-2 * h)) + L(3 * h) - L(-3 * h)) / (60 * h);
    return sqrt(g * a * cos(inclination) / L_rate.norm());
  });
  e.route("forces on points of the coin", [](auto a, auto g, auto inclination) {
    Vector3d torque = zero;  // of the masses' accelerations about the centre, at Ω = 1 and per unit mass
    for (const Vector3d& place : {x_axis, y_axis, Vector3d(-x_axis), Vector3d(-y_axis)}) {
      const auto at = [&](double phase) { return settling_coin(inclination, phase) * place * (a / sqrt(2)); };
      torque += cross(at(0), second_difference(at)) / 4;
    }
    return sqrt(g * a * cos(inclination) / torque.norm());
  });
  e.route("steady precession of a symmetric body", [](auto a, auto g, auto inclination) {
    // I₁ θ̈ = sin θ (I₁ φ̇² cos θ − I₃ ω₃ φ̇) + torque about the nodes, per unit mass, with ω₃ = φ̇ cos θ + ψ̇ = 0
    double below = 0, above = 1e3 * sqrt(g / (a * sin(inclination)));
    for (int i = 0; i < 200; ++i) {
      const double rate = (below + above) / 2;
      const double nodes = 0.25 * a * a * rate * rate * sin(inclination) * cos(inclination) - g * a * cos(inclination);
      (nodes < 0 ? below : above) = rate;
    }
    return (below + above) / 2;
  });
}
