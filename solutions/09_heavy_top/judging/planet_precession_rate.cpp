#include "solutions/09_heavy_top/shared.hpp"

namespace {

constexpr double mars_spin = 2 * pi / 88642.663, mars_orbital_rate = 2 * pi / (686.98 * 86400);

/// The axis of rotation, in a frame whose third axis is the normal of the orbit.
Vector3d axis_of(double obliquity) { return {sin(obliquity), 0, cos(obliquity)}; }

/// The rate at which a torque moves the axis round the normal, by dL/dt = τ with L along the axis.
double rate_of(const Vector3d& torque, double L, double obliquity) {
  return torque.dot(cross(z_axis, axis_of(obliquity))) / (L * pow(sin(obliquity), 2));
}

/// The mean of f(direction of the sun) over the orbit; exact for what is quadratic in the direction.
template <class Function>
Vector3d over_the_year(const Function& f) {
  Vector3d sum = zero;
  for (int month = 0; month < 12; ++month) sum += f(Vector3d(cos(month * pi / 6), sin(month * pi / 6), 0));
  return sum / 12;
}

Matrix3d tensor_of(double I1, double I3, double obliquity) {
  return I1 * Matrix3d::Identity() + (I3 - I1) * dyad(axis_of(obliquity));
}

/// The torque of tidal forces on six masses with the moments I1, I1 and I3.
Vector3d torque_on_six_masses(double I1, double I3, double n, double obliquity, const Vector3d& sun) {
  const Vector3d axis = axis_of(obliquity), across = y_axis, other = cross(axis, across);
  // Two masses ±1 m away on each axis: the three sums of squares are I₃/2, I₃/2 and I₁ − I₃/2.
  Vector3d torque = zero;
  for (const auto& [direction, mass] : {std::pair{across, I3 / 4}, {other, I3 / 4}, {axis, I1 / 2 - I3 / 4}}) {
    const Vector3d force = mass * n * n * (3 * sun.dot(direction) * sun - direction);
    torque += 2 * cross(direction, force);
  }
  return torque;
}

}  // namespace

void judge_planet_precession_rate(Lecture& lecture) {
  auto& e = lecture.exercise(&planet_precession_rate,
                             {{"I1", positive(kg_m2)},
                              {"I3", positive(kg_m2)},
                              {"spin", positive(rad_per_s)},
                              {"orbital_rate", positive(rad_per_s)},
                              {"obliquity", positive(rad)}},
                             {"rate", rad_per_s});
  e.domain([](auto I1, auto I3, auto, auto, auto obliquity) { return I1 <= I3 && is_top(I1, I3) && obliquity < pi; });
  e.generated([](auto, auto, auto, auto, auto obliquity) { return sin(obliquity) > 1e-3; });
  e.worked("Mars", 0.99462, 1, mars_spin, mars_orbital_rate, 25.19 * degree);
  e.special("rotating against its orbital motion", 0.99462, 1, mars_spin, mars_orbital_rate, 110 * degree);
  e.special("equal moments", 1, 1, mars_spin, mars_orbital_rate, 25.19 * degree);
  e.special("a disc", 1, 2, 1e-4, 1e-7, 1);
  e.special("axis in the plane of the orbit", 0.9, 1, 1e-4, 1e-7, pi / 2);
  e.limit("equal moments", 0, "The pull at a sphere has no torque about its centre.");
  e.limit("axis in the plane of the orbit", 0,
          "A quarter of a year later the torque has the opposite direction: nothing is left in the mean.");
  e.random("a flattened planet", 10, [](Random& random) {
    const double tilt = random.sign() > 0 ? random.uniform(0.2, 0.65) : random.uniform(0.9, 1.3);
    return tuple{random.uniform(0.6, 0.9), random.uniform(1, 1.1), random.uniform(1e-5, 2e-4),
                 random.uniform(1e-9, 1e-6), random.sign() > 0 ? tilt : pi - tilt};
  });
  e.scale([](auto I1, auto I3, auto spin, auto orbital_rate, auto) {
    return 1.5 * orbital_rate * orbital_rate / spin * max((I3 - I1) / I3, 1e-4);
  });
  e.sweep<4>({"Mars at other obliquities", "obliquity (rad)", "rate (rad/s)"}, {"rate"}, {0.01, 3.13});

  e.wrong_output("This is twice the rate, as with the largest torque of the year in place of its mean.", "not_averaged",
                 times(2));
  e.wrong_output("The sense is reversed: the torque draws the equator towards the orbit.", "sign", negated);
  e.wrong_output("The cosine of the obliquity is missing.", "no_cosine",
                 [](auto& rate, auto, auto, auto, auto, auto obliquity) { rate /= cos(obliquity); });
  e.wrong_output(
      "The difference of the moments is divided by the wrong moment; the spin is about the axis of symmetry.",
      "over_I1", [](auto& rate, auto I1, auto I3, auto, auto, auto) { rate *= I3 / I1; });
  e.wrong_output("This is torque over L; only a part of L goes round the normal.", "torque_as_rate",
                 [](auto& rate, auto, auto, auto, auto, auto obliquity) { rate *= sin(obliquity); });
  e.wrong_output("The sine of the obliquity stands where the cosine belongs.", "sine",
                 [](auto& rate, auto, auto, auto, auto, auto obliquity) { rate *= tan(obliquity); });
  e.wrong_output(
      "This is a third of the rate, as when the force of the sun changes across the planet in size and not in "
      "direction.",
      "no_three", times(1.0 / 3));
  e.wrong_output("This is in degrees per second; radians per second are asked for.", "in_degrees", times(1 / degree));
  e.wrong_input<3>("The orbital rate enters once; the torque goes with its square, as Kepler's third law says.",
                   "orbital_rate_once", [](double& rate) { rate = sqrt(rate); });
  e.angles_read_as_degrees();
  e.route("tidal forces on six masses, over twelve months", [](auto I1, auto I3, auto spin, auto orbital_rate,
                                                               auto obliquity) {
    const Vector3d torque =
        over_the_year([&](const Vector3d& sun) { return torque_on_six_masses(I1, I3, orbital_rate, obliquity, sun); });
    return rate_of(torque, I3 * spin, obliquity);
  });
  e.route("the sun spread over its orbit", [](auto I1, auto I3, auto spin, auto orbital_rate, auto obliquity) {
    // 3 n² ⟨s × I s⟩ with ⟨s s⟩ = (1 − ẑẑ)/2
    const Matrix3d I = tensor_of(I1, I3, obliquity);
    const Vector3d torque = -1.5 * orbital_rate * orbital_rate * cross(z_axis, I * z_axis);
    return rate_of(torque, I3 * spin, obliquity);
  });
  e.route("the slope of the mean potential energy", [](auto I1, auto I3, auto spin, auto orbital_rate, auto obliquity) {
    // φ̇ = ∂⟨V⟩/∂p_φ with p_φ = I₃ω cos ε and V = (3/2) n² s·I s
    const auto mean_potential = [&](double at) {
      return over_the_year([&](const Vector3d& sun) -> Vector3d {
               const double square = pow(sun.dot(axis_of(at)), 2);  // the part that depends on the direction
               return 1.5 * orbital_rate * orbital_rate * square * x_axis;
             })
          .x();
    };
    const double h = 0.1;  // it is a + b cos 2ε: this difference is exact
    const double slope = (mean_potential(obliquity + h) - mean_potential(obliquity - h)) / sin(2 * h);
    return -(I3 - I1) * slope / (I3 * spin * sin(obliquity));
  });
}
