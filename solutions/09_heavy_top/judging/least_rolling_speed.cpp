#include "solutions/09_heavy_top/shared.hpp"

namespace {

using Six = Eigen::Matrix<double, 6, 1>;

/// The rates of the axle and of ω, in space, of a wheel of radius and mass 1 with gravity 1 that rolls on the plane
/// z = 0: the force of the ground is eliminated by the velocity of the centre.
Six rates(double axial, double transverse, const Six& now) {
  const Vector3d e = now.head<3>().normalized(), omega = now.tail<3>(), up = z_axis;
  const auto lowest = [&](const Vector3d& axle) { return Vector3d((axle.dot(up) * axle - up).normalized()); };
  const Vector3d r = lowest(e), e_rate = cross(omega, e);
  // dr/dt, by the chain rule on the unit vector
  const Vector3d d = e.dot(up) * e - up, d_rate = e_rate.dot(up) * e + e.dot(up) * e_rate;
  const Vector3d r_rate = (d_rate - r * r.dot(d_rate)) / d.norm();
  // v = r × ω and F = dv/dt + up; A dω/dt + (C − A)((dω/dt·e) e + (ω·e) de/dt) = r × F
  const Matrix3d inertia = transverse * Matrix3d::Identity() + (axial - transverse) * dyad(e) + of_unit_mass(r);
  const Vector3d torque = cross(r, cross(r_rate, omega) + up) - (axial - transverse) * omega.dot(e) * e_rate;
  Six rate;
  rate << e_rate, inertia.inverse() * torque;
  return rate;
}

/// λ̈/λ of a small lean, for a rolling with this spin: half of the trace of the square of the linearised equations.
double growth(double axial, double transverse, double spin) {
  Eigen::Matrix<double, 6, 6> J;
  Six upright;
  upright << y_axis, spin * y_axis;
  for (int i = 0; i < 6; ++i)
    J.col(i) =
        derivative_at_0([&](double h) -> Six { return rates(axial, transverse, upright + h * Six::Unit(i)); }, 5e-3);
  return (J * J).trace() / 2;
}

/// λ̈/λ at a lean of 10⁻⁵ whose heading has turned as the conserved part of L demands.
double acceleration(double axial, double transverse, double spin) {
  constexpr double lean = 1e-5;
  const Vector3d axle(0, cos(lean), sin(lean));
  // L_z = 0 with ω = spin e + turning (z − (z·e) e)
  const double turning = -axial * spin * axle[2] / (transverse * pow(axle[1], 2));
  Six now;
  now << axle, spin * axle + turning * (z_axis - axle[2] * axle);
  const Vector3d omega = now.tail<3>(), omega_rate = rates(axial, transverse, now).tail<3>();
  return (cross(omega_rate, axle) + cross(omega, cross(omega, axle)))[2] / lean;
}

/// The spin at which a function that is linear in its square vanishes.
template <class Function>
double vanishes_at(const Function& f, double guess) {
  const double low = f(0.5 * guess), high = f(1.5 * guess);
  return guess * sqrt(0.25 + 2 * low / (low - high));
}

}  // namespace

void judge_least_rolling_speed(Lecture& lecture) {
  auto& e = lecture.exercise(&least_rolling_speed,
                             {{"radius", positive(metre)},
                              {"g", positive(m_per_s2)},
                              {"axial", positive(none)},
                              {"transverse", positive(none)}},
                             {"speed", m_per_s});
  e.domain([](auto, auto, auto axial, auto transverse) { return is_top(transverse, axial); });
  e.generated([](auto, auto, auto axial, auto transverse) { return axial > 1e-2 && axial < 10 && transverse < 10; });
  e.worked("a coin", 0.01, 9.81, 0.5, 0.25);
  e.worked("a hula hoop", 0.45, 9.81, 1, 0.5);
  e.special("a coin on the Moon", 0.01, 1.62, 0.5, 0.25);
  e.special("a wheel with a long axle", 0.3, 9.81, 0.6, 2);
  e.special("a wheel with its mass near the hub", 0.3, 9.81, 0.05, 0.025);
  e.limit("a coin on the Moon", sqrt(1.62 * 0.01 / 3),
          "For a thin disc the textbooks have v² > ga/3, here with the g of the Moon.");
  e.limit("a hula hoop", sqrt(9.81 * 0.45 / 4),
          "For a hoop they have v² > ga/4: with its mass far out it has more angular momentum.");
  e.random("any wheel", 8, [](Random& random) {
    const double axial = random.uniform(0.3, 1);
    return tuple{random.uniform(0.05, 0.5), random.uniform(1.5, 25), axial, axial * random.uniform(0.6, 1.5)};
  });
  e.sweep({"A flat wheel of radius 0.3 m on Earth", "moment about the axle over mass times radius squared",
           "least speed (m/s)"},
          {"v"}, {0.05, 1, 96}, [](auto axial) { return tuple(0.3, 9.81, axial, axial / 2); });

  e.wrong(
      "This holds for a wheel on ice; a centre that rolls goes round a curve when the heading turns, and the ground "
      "turns its momentum too.",
      "on_ice", [](auto radius, auto g, auto axial, auto transverse) { return sqrt(g * radius * transverse) / axial; });
  e.wrong("The heading turns with the moment about the edge here; it turns about the vertical through the centre.",
          "about_the_edge", [](auto radius, auto g, auto axial, auto transverse) {
            return sqrt(g * radius * (transverse + 1) / (axial * (axial + 1)));
          });
  e.wrong(
      {"This is the top that sleeps on its tip; a wheel does not stand on a point of its axle.", "heavy_top_sleeping"},
      "sleeping_top",
      [](auto radius, auto g, auto axial, auto transverse) { return 2 * sqrt(g * radius * transverse) / axial; });
  e.wrong(
      "This compares energies, that of the motion and that of the height; nothing of the shape of the wheel enters.",
      "energies", [](auto radius, auto g, auto, auto) { return sqrt(2 * g * radius); });
  e.wrong_inputs("The moments about the axle and about a diameter are exchanged.", "exchanged",
                 [](auto, auto, auto& axial, auto& transverse) { swap(axial, transverse); });
  e.wrong_output("This is the angular velocity; asked for is the speed of the centre.", "angular_velocity",
                 [](auto& speed, auto radius, auto, auto, auto) { speed /= radius; });
  e.wrong_output("This is the square of the speed.", "squared", [](auto& speed) { speed *= speed; });
  e.property(Is::nonnegative, "A speed is not negative.");
  e.route("eigenvalues of the rolling motion, linearised by differences",
          [](auto radius, auto g, auto axial, auto transverse) {
            const double guess = least_rolling_speed(1, 1, axial, transverse);
            const auto f = [&](double spin) { return growth(axial, transverse, spin); };
            return sqrt(g * radius) * vanishes_at(f, guess);
          });
  e.route("the acceleration of a small lean", [](auto radius, auto g, auto axial, auto transverse) {
    const auto f = [&](double spin) { return acceleration(axial, transverse, spin); };
    return sqrt(g * radius) * vanishes_at(f, 1);
  });
  e.route("lean and heading, by bisection", [](auto radius, auto g, auto axial, auto transverse) {
    double low = 0, high = 1e3;
    for (int i = 0; i < 200; ++i) {
      const double spin = (low + high) / 2;  // e^{st}: the determinant over transverse s²
      const double s2 = (1 - (axial + 1) * spin * axial * spin / transverse) / (transverse + 1);
      (s2 > 0 ? low : high) = spin;
    }
    return sqrt(g * radius) * (low + high) / 2;
  });
}
