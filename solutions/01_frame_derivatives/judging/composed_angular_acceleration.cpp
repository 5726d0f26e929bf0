#include "solutions/01_frame_derivatives/shared.hpp"

void judge_composed_angular_acceleration(Lecture& lecture) {
  auto& e = lecture.exercise(
      &composed_angular_acceleration,
      {{"E", rotation}, {"omega", rad_per_s}, {"alpha", rad_per_s2}, {"spin", rad_per_s}, {"spin_rate", rad_per_s2}},
      {"alpha_rotor", rad_per_s2});
  const Matrix3d E0 = example_basis, along = Matrix3d::Identity();
  const Vector3d alpha0(0.05, 0.1, -0.04), spin0(2, -1, 4), spin_rate0(0.1, -0.3, 0.2);
  e.worked("a rotor on the basis of the lecture", E0, example_omega, alpha0, spin0, spin_rate0);
  e.worked("both rotate steadily", E0, example_omega, zero, spin0, zero);
  e.worked("a gyroscope lies on a turntable", along, {0, 0, 2}, zero, {30, 0, 0}, zero);
  e.special("the platform stands along the inertial axes", along, example_omega, alpha0, spin0, spin_rate0);
  e.special("the rotor rests on the platform", E0, example_omega, alpha0, zero, zero);
  e.special("the rotor begins to spin", E0, example_omega, alpha0, zero, spin_rate0);
  e.special("the platform is at rest", E0, zero, zero, spin0, spin_rate0);
  e.special("the rotor spins about the platform's axis of rotation", E0, 2 * E0 * spin0, alpha0, spin0, spin_rate0);
  e.limit("the rotor rests on the platform", alpha0,
          "It then turns as the platform does, and its angular velocity changes as that of the platform.");
  e.limit("the platform is at rest", E0 * spin_rate0,
          "Nothing is carried round: the spin changes as it is seen to change.");
  e.random("a random rotor", 10, &Random::rotation, any::vector(2), any::vector(2), any::vector(3), any::vector(2));
  e.scale([](auto&, auto& w, auto& alpha, auto& spin, auto& rate) {
    return or_one(alpha.norm() + rate.norm() + w.norm() * spin.norm());
  });
  e.sweep(
      {"A gyroscope of 30 rad/s on a turntable of 2 rad/s, both steady; its axis rises from the table to the vertical",
       "elevation of the gyroscope's axis (rad)", "angular acceleration (rad/s²)"},
      {"x", "y", "z"}, {0, pi / 2}, [](auto rise) {
        const Vector3d spin(30 * cos(rise), 0, 30 * sin(rise));
        return tuple(turn(z_axis, pi / 6), 2 * z_axis, zero, spin, zero);
      });

  e.term("the angular acceleration of the platform", 1, [](auto&, auto&, auto& alpha, auto&, auto&) { return alpha; });
  e.term("spin_rate on inertial axes", 1, [](auto& E, auto&, auto&, auto&, auto& rate) { return E * rate; });
  e.term("the spin, carried round by the platform", 1,
         [](auto& E, auto& w, auto&, auto& spin, auto&) { return cross(w, E * spin); });
  e.wrong_terms("The rate of the spin is that seen on the platform; the platform also carries the spin round.",
                "no_transport", {1, 1, 0});
  e.wrong_terms(
      "The spin is carried round the wrong way: a vector fixed on the platform turns with it, in the sense of ω.",
      "cross_reversed", {1, 1, -1});
  e.wrong_terms(
      "The carrying round of the spin enters twice; the 2 of the Coriolis term belongs to a second derivative.",
      "coriolis_two", {1, 1, 2});
  e.wrong_terms("spin_rate does not enter; the rotor may also change its spin on the platform.", "transport_only",
                {1, 0, 1});
  e.wrong_terms("alpha does not enter; the platform's own angular velocity changes too.", "platform_steady", {0, 1, 1});
  e.wrong_input<0>("spin and spin_rate enter as if their components were inertial; they are on the platform's axes.",
                   "platform_components", fixed<Matrix3d>(Matrix3d::Identity()));
  e.wrong_input<0>(
      "The transposed matrix turns inertial components into those on the platform; here the way back is needed.",
      "transposed", transposed);
  e.wrong("omega has inertial components, and is crossed with those of spin on the platform: first E spin.",
          "omega_on_platform", [](auto& E, auto& w, auto& alpha, auto& spin, auto& rate) -> Vector3d {
            return alpha + E * (rate + cross(w, spin));
          });
  e.wrong("This is the rate with components on the platform's axes; the inertial ones are asked for.",
          "result_on_platform",
          [](auto& E, auto&... others) { return E.transpose() * composed_angular_acceleration(E, others...); });
  e.route("the attitude of the rotor differentiated twice", [](auto& E, auto& w, auto& alpha, auto& spin, auto& rate) {
    // R = E B with B = 1 at this instant; R̈ Rᵀ is the cross matrix of the rate plus a symmetric square.
    const Matrix3d E_rate = skew(w) * E, E_rate2 = (skew(alpha) + skew(w) * skew(w)) * E;
    const Matrix3d R_rate2 = E_rate2 + 2 * E_rate * skew(spin) + E * (skew(rate) + skew(spin) * skew(spin));
    return axial_part(R_rate2 * E.transpose());
  });
  e.route("all on the axes of the platform", [](auto& E, auto& w, auto& alpha, auto& spin, auto& rate) {
    const Matrix3d to_platform = E.transpose();
    return E * (to_platform * alpha + rate - cross(spin, to_platform * w));
  });
  e.route("differences of the angular velocity", [](auto& E, auto& w, auto& alpha, auto& spin, auto& rate) {
    const double h = 1e-3 / or_one(w.norm());
    return derivative_at_0([&](double t) { return w + t * alpha + turn(w, w.norm() * t) * E * (spin + t * rate); }, h);
  });
}
