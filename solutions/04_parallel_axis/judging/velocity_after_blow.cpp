#include "solutions/04_parallel_axis/shared.hpp"

/// Six equal masses with this tensor. The velocity V and the rotation ω after the blow make the kinetic energy minus
/// impulse · velocity of the struck point stationary: six linear equations.
static Vector3d by_stationary_energy(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                                     const Vector3d& p) {
  using Velocity = Eigen::Matrix<double, 3, 6>;  // of a point, from V and ω
  const auto velocity_at = [](const Vector3d& place) {
    Velocity velocity;
    velocity << Matrix3d::Identity(), -skew(place);
    return velocity;
  };
  Eigen::Matrix<double, 6, 6> masses = Eigen::Matrix<double, 6, 6>::Zero();
  const Matrix3Xd points = six_points(I_cm, M);
  for (const auto place : points.colwise()) masses += M / 6 * (velocity_at(place).transpose() * velocity_at(place));
  return velocity_at(p) * solution_of(masses, velocity_at(r).transpose() * impulse);
}

void judge_velocity_after_blow(Lecture& lecture) {
  auto& e = lecture.exercise(
      &velocity_after_blow,
      {{"M", positive(kg)}, {"I_cm", regular_tensor}, {"r", metre}, {"impulse", newton * second}, {"p", metre}},
      {"v", m_per_s});
  e.scale([](auto M, auto& I, auto& r, auto& impulse, auto& p) {
    return or_one(impulse.norm() / M + (I.inverse() * cross(r, impulse)).norm() * p.norm());
  });
  const Matrix3d I = central_tensor_of_four_masses;
  const Matrix3d bat = Vector3d(0.001, 0.045, 0.045).asDiagonal();
  const Vector3d struck(0.5, -0.3, 0.8), impulse(2, -1, 4), grip(-0.4, 0, 0);
  e.worked("the four masses of lecture 03", 10, I, struck, impulse, {-0.7, 0.4, 0.2});
  e.special("the struck point itself", 10, I, struck, impulse, struck);
  e.special("a bat that does not jerk the hands", 0.9, bat, {0.125, 0, 0}, {0, 3, 0}, grip);
  e.special("the bat struck at its centre of mass", 0.9, bat, zero, {0, 3, 0}, grip);
  e.special("the centre of mass", 10, I, struck, impulse, zero);
  e.special("no blow", 10, I, struck, zero, struck);
  e.limit("the centre of mass", impulse / 10,
          "The centre of mass moves as if all mass were there and the blow struck there.");
  e.limit("no blow", zero, "Nothing happens.");
  e.random("a random blow", 10, any::uniform(2, 6), &Random::inertia_tensor, any::vector(2), any::vector(5),
           any::vector(2));
  e.sweep({"A bat of 0.9 kg is struck across with 3 N s", "where it is struck, from the centre of mass (m)",
           "velocity of the grip, 0.4 m on the other side (m/s)"},
          {{"v_y", 1, 0}}, {-0.2, 0.4},
          [=](auto x) { return tuple(0.9, bat, Vector3d(x, 0, 0), Vector3d(0, 3, 0), grip); });

  e.term("the velocity of the centre of mass", 1,
         [](auto M, auto&, auto&, auto& J, auto&) -> Vector3d { return J / M; });
  e.term("the velocity by the rotation", 1,
         [](auto, auto& tensor, auto& r, auto& J, auto& p) { return cross(tensor.inverse() * cross(r, J), p); });
  e.wrong_terms("This is the velocity of the centre of mass; the blow also makes the body rotate.", "no_rotation",
                {1, 0});
  e.wrong_terms("Only the rotation enters; the centre of mass moves too.", "rotation_only", {0, 1});
  e.wrong_terms("The rotation enters with the wrong sign, either where the blow starts it or where it moves the point.",
                "p_cross_omega", {1, -1});
  e.wrong_input<1>("The products of inertia do not enter; ω follows from the whole tensor.", "diagonal", diagonal_part);
  e.wrong("The rotation is taken about the struck point, as if that point moved like the centre of mass.",
          "relative_to_blow", [](auto M, auto& tensor, auto& r, auto& J, auto& p) -> Vector3d {
            return J / M + cross(tensor.inverse() * cross(r, J), p - r);
          });
  e.route("stationary energy of six masses", by_stationary_energy);
  e.route("reciprocity", [](auto M, auto& tensor, auto& r, auto& J, auto& p) -> Vector3d {
    // A unit impulse at p moves r as much in the direction of J as J at r moves p along the unit impulse.
    Vector3d v;
    for (int i = 0; i < 3; ++i) v[i] = J.dot(velocity_after_blow(M, tensor, p, Vector3d::Unit(i), r));
    return v;
  });
  e.route("on principal axes", [](auto M, auto& tensor, auto& r, auto& J, auto& p) -> Vector3d {
    const auto [moments, axes] = PrincipalFrame(tensor);
    const Vector3d torque = axes.transpose() * cross(r, J);
    return J / M + cross(axes * torque.cwiseQuotient(moments), p);
  });
}
