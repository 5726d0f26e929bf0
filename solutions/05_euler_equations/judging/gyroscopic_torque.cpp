#include "solutions/05_euler_equations/shared.hpp"

static Matrix3d rotor_tensor(double I1, double I3) { return Vector3d(I1, I1, I3).asDiagonal(); }

/// The torque that turns an L which stands still on the vehicle's axes.
template <class Momentum>
static auto turning(const Momentum& L) {
  return [L](auto I1, auto I3, auto spin, auto& n) { return cross(n, L(I1, I3, spin, n)); };
}

void judge_gyroscopic_torque(Lecture& lecture) {
  auto& e = lecture.exercise(
      &gyroscopic_torque, {{"I1", positive(kg_m2)}, {"I3", positive(kg_m2)}, {"spin", rad_per_s}, {"turn", rad_per_s}},
      {"torque", newton_metre});
  e.worked("a rotor in a vehicle that turns obliquely", 0.35, 0.6, 40, {0.3, -0.5, 2});
  e.worked("a propeller in a level turn", 2.1, 4, 250, {0, 0.2, 0});
  e.special("no spin: a body carried round", 0.35, 0.6, 0, {0.3, -0.5, 2});
  e.special("the vehicle turns about the rotor's axis", 0.35, 0.6, 40, {0, 0, 3});
  e.special("a vehicle that does not turn", 0.35, 0.6, 40, zero);
  e.special("a spin that undoes the turn about axis 3", 0.35, 0.6, -2, {0.3, -0.5, 2});
  e.special("a sphere", 0.5, 0.5, 40, {0.3, -0.5, 2});
  e.limit("a vehicle that does not turn", zero, "The angular momentum of the rotor stays, whatever its spin.");
  e.limit("the vehicle turns about the rotor's axis", zero,
          "The axis of the rotor keeps its direction, and so does its angular momentum.");
  e.random(
      "a random rotor", 10,
      [](Random& random) {
        const double I1 = random.uniform(0.3, 2);
        return tuple(I1, I1 * (random.sign() > 0 ? random.uniform(1.2, 1.9) : random.uniform(0.3, 0.8)));
      },
      any::spin(3, 20), any::vector(3));
  e.scale([](auto I1, auto I3, auto spin, auto& n) { return or_one((I1 + I3) * n.norm() * (n.norm() + abs(spin))); });
  e.sweep({"I₁ = 0.35, I₃ = 0.6 kg m², spin 4 rad/s: the vehicle turns with 3 rad/s about an axis in its plane 1–3",
           "angle between this axis and axis 3 (rad)", "component of the torque on axis 2 (N m)"},
          {{"torque_2", 1, 0}}, {0, pi},
          [](auto angle) { return tuple(0.35, 0.6, 4, Vector3d(3 * sin(angle), 0, 3 * cos(angle))); });

  e.wrong_output("This is the torque of the rotor on the vehicle; that of the vehicle on the rotor is opposite.",
                 "on_the_vehicle", negated);
  e.wrong(
      "This is the torque of the spin alone; the rotor also turns with the vehicle, with I₃ along its axis and I₁ "
      "across.",
      "spin_only", turning([](auto, auto I3, auto spin, auto&) { return Vector3d(0, 0, I3 * spin); }));
  e.wrong(
      "Your L has no part across the axis; the rotor turns with the vehicle about axes 1 and 2, with the moment I₁.",
      "no_transverse", turning([](auto, auto I3, auto spin, auto& n) { return Vector3d(0, 0, I3 * (n[2] + spin)); }));
  e.wrong(
      "Your L turns with the rotor; it turns with the vehicle, for on the vehicle's axes its components are constant.",
      "rotor_omega", [](auto I1, auto I3, auto spin, auto& n) {
        return torque_to_hold_rotation(rotor_tensor(I1, I3), n + spin * z_axis);
      });
  e.wrong("The spin serves as the whole of ω₃; it is relative to the vehicle, which turns about axis 3 as well.",
          "spin_is_total",
          turning([](auto I1, auto I3, auto spin, auto& n) { return Vector3d(I1 * n[0], I1 * n[1], I3 * spin); }));
  e.perpendicular_to(3, "L goes round the axis about which the vehicle turns, so the torque is at right angles to it.");
  e.route("the general law, with the rotor's own ω and its rate", [](auto I1, auto I3, auto spin, auto& n) {
    // On the vehicle's axes ω is constant; in space it goes round with the vehicle.
    const Vector3d omega = n + spin * z_axis;
    return angular_momentum_rate(rotor_tensor(I1, I3), omega, cross(n, omega));
  });
  e.route("a body carried round, and the spin besides", [](auto I1, auto I3, auto spin, auto& n) {
    return torque_to_hold_rotation(rotor_tensor(I1, I3), n) + I3 * spin * Vector3d(n[1], -n[0], 0);
  });
  e.route("the rotor in space a little later", [](auto I1, auto I3, auto spin, auto& n) {
    const auto L_at = [&](double t) {
      const Matrix3d vehicle = turn(n, n.norm() * t), A = vehicle * turn(z_axis, spin * t);
      return A * rotor_tensor(I1, I3) * A.transpose() * (n + spin * Vector3d(vehicle.col(2)));
    };
    return derivative_at_0(L_at, 0.005 / or_one(n.norm()));
  });
}
