#include "solutions/05_euler_equations/shared.hpp"

namespace {

const Matrix3d rotor{{0.05, 0.002, -0.004}, {0.002, 0.06, 0.003}, {-0.004, 0.003, 0.08}};
const Vector3d rotor_center(0.001, -0.002, 0.1);
const Vector2d rotor_bearings(-0.1, 0.35);

Matrix3d about_point(const Matrix3d& I_cm, double M, const Vector3d& from_point) {
  return I_cm + M * of_unit_mass(from_point);
}

/// Two forces across the shaft with this sum and this torque about the origin.
Matrix3Xd two_forces(const Vector3d& sum, const Vector3d& torque, const Vector2d& z) {
  const Eigen::Matrix2d balance{{1, 1}, {z[0], z[1]}};
  const Eigen::Matrix2d inverse = balance.inverse();
  Matrix3Xd forces = Matrix3Xd::Zero(3, 2);
  forces.row(0) = (inverse * Vector2d(sum[0], torque[1])).transpose();
  forces.row(1) = (inverse * Vector2d(sum[1], -torque[0])).transpose();
  return forces;
}

}  // namespace

void judge_bearing_forces(Lecture& lecture) {
  auto& e = lecture.exercise(
      &bearing_forces,
      {{"I_cm", inertia_tensor}, {"M", positive(kg)}, {"r_cm", metre}, {"rate", rad_per_s}, {"bearings", metre}},
      {"forces", newton});
  e.domain([](auto&, auto, auto&, auto, auto& z) { return z[0] != z[1]; });
  e.generated([](auto&, auto, auto&, auto, auto& z) { return abs(z[0] - z[1]) > 0.01 * z.norm(); });
  e.worked("a rotor out of balance", rotor, 4, rotor_center, 300, rotor_bearings);
  e.worked("its centre of mass on the shaft", rotor, 4, {0, 0, 0.1}, 300, rotor_bearings);
  e.special("no products of inertia", diagonal_part(rotor), 4, rotor_center, 300, rotor_bearings);
  e.special("balanced both ways", diagonal_part(rotor), 4, {0, 0, 0.1}, 300, rotor_bearings);
  e.special("both bearings on one side", rotor, 4, rotor_center, -300, {0.2, 0.5});
  e.special("a thin rod askew", of_unit_mass({0.1, 0.2, 0.3}), 2, zero, 100, rotor_bearings);
  e.special("at rest", rotor, 4, rotor_center, 0, rotor_bearings);
  e.limit("at rest", Matrix3Xd::Zero(3, 2), "A shaft that does not turn needs no forces besides those of the weight.");
  e.limit("balanced both ways", Matrix3Xd::Zero(3, 2),
          "The centre of mass does not move, and L stays along the shaft.");
  e.random("a random rotor", 10, &Random::inertia_tensor, any::uniform(2, 9), any::vector(0.5), any::spin(5, 50),
           [](Random& random) {
             const double z = random.uniform(-0.6, 0.4);
             return Vector2d(z, z + random.sign() * random.uniform(0.2, 0.7));
           });
  e.scale([](auto& I, auto M, auto& r, auto rate, auto& z) {
    const double off_axis = r.template head<2>().norm(), distance = abs(z[0] - z[1]);
    const double unbalance = hypot(I(0, 2), I(1, 2)) + M * off_axis * (abs(r[2]) + z.norm());
    return or_one(rate * rate * (unbalance > 0 ? unbalance : I.norm() + M * r.squaredNorm()) / distance);
  });
  e.sweep<2>(
      {"A rotor out of balance at 300 rad/s, bearings at z = −0.1 and 0.35 m: where along the shaft is its mass?",
       "z of the centre of mass (m)", "x component of the force (N)"},
      {{"bearing at −0.1 m", 0, 0}, {"bearing at 0.35 m", 0, 1}}, {-0.3, 0.55},
      [](auto z) { return Vector3d(0.001, -0.002, z); });

  e.wrong_output("These are the forces of the shaft on the bearings; those of the bearings on the shaft are opposite.",
                 "on_the_bearings", negated);
  e.wrong_input<0>(
      "The products of inertia about the centre of mass do not enter: this holds if the shaft is parallel "
      "to a principal axis.",
      "static_only", diagonal_part);
  e.wrong_input<2>(
      "This is as if the centre of mass lay in the plane of the origin: its tensor serves about a point of the shaft "
      "without a change of origin.",
      "no_parallel_axes", zeroed(2));
  e.wrong_input<0>(products_sign, "products_sign", products_flipped);
  e.wrong_input<2>(
      "This is a couple, for a centre of mass on the shaft; off the shaft it moves on a circle, and that "
      "takes a force.",
      "couple_only", [](auto& r) { r = Vector3d(0, 0, r[2]); });
  e.wrong_output("The two columns are exchanged: the first belongs to the bearing at bearings[0].", "exchanged",
                 [](auto& forces) -> Matrix3Xd { return forces.rowwise().reverse(); });
  e.wrong(
      "The torque along x is put down to the forces along x here; these exert one along y, and those along y one "
      "along −x.",
      "torque_along_the_force", [](auto& I, auto M, auto& r_cm, auto rate, auto& z) {
        const Vector3d omega = rate * z_axis, torque = cross(omega, Vector3d(about_point(I, M, r_cm) * omega));
        return two_forces(M * cross(omega, cross(omega, r_cm)), {-torque[1], torque[0], 0}, z);
      });
  e.route("six masses, each on its circle", [](auto& I, auto M, auto& r_cm, auto rate, auto& z) {
    Vector3d sum = zero, torque = zero;
    const Matrix3Xd points = six_points(I, M).colwise() + r_cm;
    for (const Vector3d r : points.colwise()) {
      const Vector3d force = -M / 6 * rate * rate * Vector3d(r[0], r[1], 0);
      sum += force;
      torque += cross(r, force);
    }
    return two_forces(sum, torque, z);
  });
  e.route("torques about either bearing", [](auto& I, auto M, auto& r_cm, auto rate, auto& z) {
    Matrix3Xd forces(3, 2);
    for (int k = 0; k < 2; ++k) {  // about the other bearing only this one's force has a torque
      const Matrix3d about_other = about_point(I, M, r_cm - z[1 - k] * z_axis);
      const Vector3d torque = torque_to_hold_rotation(about_other, rate * z_axis);
      forces.col(k) = cross(torque, z_axis) / (z[k] - z[1 - k]);
    }
    return forces;
  });
  e.route("momentum and angular momentum a little later", [](auto& I, auto M, auto& r_cm, auto rate, auto& z) {
    const Vector3d L = rate * about_point(I, M, r_cm).col(2), p = M * rate * cross(z_axis, r_cm);
    const auto rate_of = [&](const Vector3d& vector) {
      return rate * derivative_at_0([&](double angle) { return turn(z_axis, angle) * vector; }, 0.005);
    };
    return two_forces(rate_of(p), rate_of(L), z);
  });
  e.survivor("bearings[1 - 0.5 * k]", "A half is cut off to 0 as an index.");
}
