/// @file
/// How the exercises of lecture 07 are judged.
#include "rigid/euler_angles.hpp"
#include "solutions/judging/lecture.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>

namespace {

using namespace rigid;
using namespace workbook;
using namespace workbook::judging;

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Angles = std::tuple<Vector3d>;
using TwoVectors = std::tuple<Vector3d, Vector3d>;

constexpr double pi = std::numbers::pi;

const Vector3d example_angles(0.3, 0.7, 1.1);
const Vector3d example_rates(0.5, -0.2, 0.9);

// ---- elementary matrices, passive as on the slides ------------------------------------------------------------------

Matrix3d about_x(double angle) { return AngleAxisd(-angle, Vector3d::UnitX()).toRotationMatrix(); }
Matrix3d about_y(double angle) { return AngleAxisd(-angle, Vector3d::UnitY()).toRotationMatrix(); }
Matrix3d about_z(double angle) { return AngleAxisd(-angle, Vector3d::UnitZ()).toRotationMatrix(); }

// ---- the rotation matrix, misread -----------------------------------------------------------------------------------

Vector3d exchanged(const Vector3d& angles) { return {angles[2], angles[1], angles[0]}; }

Vector3d theta_negated(const Vector3d& angles) { return {angles[0], -angles[1], angles[2]}; }

/// Three turns about z, x and z, as in Goldstein, Landau and Wikipedia's figure.
Matrix3d zxz(const Vector3d& angles) { return about_z(angles[2]) * about_x(angles[1]) * about_z(angles[0]); }

/// Yaw, pitch and roll, as for aircraft: three turns about z, y and x.
Matrix3d zyx(const Vector3d& angles) { return about_x(angles[2]) * about_y(angles[1]) * about_z(angles[0]); }

/// R_φ R_θ R_ψ: what turns first stands on the left.
Matrix3d order_reversed(const Vector3d& angles) { return rotation_matrix(exchanged(angles)); }

// ---- other routes ---------------------------------------------------------------------------------------------------

Quaterniond body_to_inertial(const Vector3d& angles) {
  return AngleAxisd(angles[0], Vector3d::UnitZ()) * AngleAxisd(angles[1], Vector3d::UnitY()) *
         AngleAxisd(angles[2], Vector3d::UnitZ());
}

/// The three turns done on a triad, each about an axis of the triad as it stands by then. Columns: the body axes.
Matrix3d turned_triad(const Vector3d& angles) {
  Matrix3d axes = Matrix3d::Identity();
  axes = AngleAxisd(angles[0], Vector3d(axes.col(2))) * axes;
  axes = AngleAxisd(angles[1], Vector3d(axes.col(1))) * axes;
  axes = AngleAxisd(angles[2], Vector3d(axes.col(2))) * axes;
  return axes;
}

/// The rotation matrix and its rate of change, by a step along the imaginary axis: nothing is subtracted, so no digit
/// is lost however small the step.
std::pair<Matrix3d, Matrix3d> matrix_and_rate(const Vector3d& angles, const Vector3d& rates) {
  using Complex = std::complex<double>;
  constexpr double step = 1e-30;
  const auto about = [&](int axis, int angle) {
    const Complex z(angles[angle], step * rates[angle]);
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    Eigen::Matrix3cd turn = Eigen::Matrix3cd::Zero();
    turn(axis, axis) = 1;
    turn(j, j) = turn(k, k) = std::cos(z);
    turn(j, k) = std::sin(z);
    turn(k, j) = -std::sin(z);
    return turn;
  };
  const Eigen::Matrix3cd R = about(2, 2) * about(1, 1) * about(2, 0);
  return {R.real(), R.imag() / step};
}

Vector3d axis_of(const Matrix3d& antisymmetric) {
  return {antisymmetric(2, 1), antisymmetric(0, 2), antisymmetric(1, 0)};
}

/// The matrix E with the three axes of rotation as columns, in body components: ω = E (rates).
Matrix3d rates_to_omega(const Vector3d& angles) {
  const Matrix3d R = turned_triad(angles).transpose();
  Matrix3d E;
  E << R.col(2), about_z(angles[2]).col(1), Vector3d::UnitZ();
  return E;
}

/// A random attitude that no simple symmetry marks out, and rates or components of generic size.
TwoVectors angles_and_vector(Random& random) {
  const Vector3d angles = random.euler_angles();
  return {angles, random.vector(3.0)};
}

void describe_rotation_matrix(Lecture& lecture) {
  auto& exercise = lecture.exercise("rotation_matrix", &rotation_matrix);
  exercise.argument("angles", units::radian).result("R", units::none);

  exercise.worked("the angles of the lecture", example_angles);
  exercise.special("no turn at all", Vector3d::Zero());
  exercise.special("θ = 0: the turns φ and ψ add up", Vector3d(0.4, 0, 0.9));
  exercise.special("θ = π: upside down", Vector3d(0.4, pi, 0.9));
  exercise.special("a quarter turn of each", Vector3d::Constant(pi / 2));
  exercise.special("a tiny θ", Vector3d(-2.5, 1e-8, 0.3));
  exercise.special("more than a full turn", Vector3d(7.5, 0.7, -8.2));
  exercise.random("any attitude", 8, [](Random& random) { return Angles{random.euler_angles()}; });
  exercise.scale([](const Vector3d&) { return 1.0; });

  exercise.misconception(
      "order_reversed",
      "Your matrix is R_φ R_θ R_ψ, with φ and ψ exchanged; the turn that comes first stands on the right: R_ψ R_θ R_φ.",
      "euler_angles_matrix", &order_reversed);
  exercise.misconception(
      "angles_exchanged",
      "Your matrix is R_φ R_θ R_ψ, with φ and ψ exchanged; the turn that comes first stands on the right: R_ψ R_θ R_φ.",
      "euler_angles_matrix", [](const Vector3d& angles) -> Matrix3d { return rotation_matrix(exchanged(angles)); });
  exercise.misconception(
      "transposed",
      "This is the transpose of R, which takes body components to inertial ones; asked for is V_body = R V_inertial.",
      "euler_angles_matrix", [](const Vector3d& angles) -> Matrix3d { return rotation_matrix(angles).transpose(); });
  exercise.misconception("active_turns",
                         "Each of your three turns goes the wrong way round: the slides' matrices are passive, so all "
                         "three angles appear negated.",
                         "euler_angles_matrix",
                         [](const Vector3d& angles) -> Matrix3d { return rotation_matrix(-angles); });
  exercise.misconception("theta_negated",
                         "The middle turn goes the wrong way round: in R_θ the entry −sin θ stands at the upper right, "
                         "sin θ at the lower left.",
                         "euler_angles_matrix",
                         [](const Vector3d& angles) -> Matrix3d { return rotation_matrix(theta_negated(angles)); });
  exercise.misconception(
      "only_theta_right",
      "The turns φ and ψ go the wrong way round: in R_φ and R_ψ the sine stands above the diagonal with a plus.",
      "euler_angles_matrix",
      [](const Vector3d& angles) -> Matrix3d { return rotation_matrix(-theta_negated(angles)); });
  exercise.misconception(
      "z_x_z", "Your middle turn is about the x axis (z–x–z); on the slides the line of nodes is the y′ axis (z–y–z).",
      "euler_angles_zxz", &zxz);
  exercise.misconception("yaw_pitch_roll",
                         "Your last turn is about the x axis (yaw, pitch and roll); on the slides it is about z again.",
                         "euler_angles_zxz", &zyx);
  exercise.misconception(
      "space_fixed_x_y_z",
      "Your turns go about x, y and z; on the slides the first and the last go about z, the middle one about y′.",
      "euler_angles_zxz",
      [](const Vector3d& angles) -> Matrix3d { return about_z(angles[2]) * about_y(angles[1]) * about_x(angles[0]); });
  exercise.misconception(
      "phi_left_out", "φ does not enter: the first turn is missing.", "euler_angles_matrix",
      [](const Vector3d& angles) -> Matrix3d { return rotation_matrix(Vector3d(0, angles[1], angles[2])); });
  exercise.misconception(
      "psi_left_out", "ψ does not enter: the last turn is missing.", "euler_angles_matrix",
      [](const Vector3d& angles) -> Matrix3d { return rotation_matrix(Vector3d(angles[0], angles[1], 0)); });
  exercise.angles_read_as_degrees("euler_angles_turns");
  exercise.property(PropertyKind::rotation_matrix, "A rotation matrix has orthonormal columns and determinant +1.",
                    "euler_angles_matrix");

  exercise.route("a triad turned about its own axes",
                 [](const Vector3d& angles) -> Matrix3d { return turned_triad(angles).transpose(); });
  exercise.route("a quaternion", [](const Vector3d& angles) -> Matrix3d {
    return body_to_inertial(angles).conjugate().toRotationMatrix();
  });
  exercise.route("entry by entry", [](const Vector3d& angles) -> Matrix3d {
    const double cf = std::cos(angles[0]), ct = std::cos(angles[1]), cp = std::cos(angles[2]);
    const double sf = std::sin(angles[0]), st = std::sin(angles[1]), sp = std::sin(angles[2]);
    Matrix3d R;
    R << cp * ct * cf - sp * sf, cp * ct * sf + sp * cf, -cp * st,  //
        -sp * ct * cf - cp * sf, -sp * ct * sf + cp * cf, sp * st,  //
        st * cf, st * sf, ct;
    return R;
  });
  exercise.route("z–x–z with its own angles",
                 [](const Vector3d& angles) -> Matrix3d { return zxz(angles + Vector3d(pi / 2, 0, -pi / 2)); });

  exercise.sweep({"R while θ grows, φ = 0.3, ψ = 1.1", "θ (rad)", "entry of R"}, {-pi, 2 * pi},
                 [](double theta) { return Angles{Vector3d(0.3, theta, 1.1)}; },
                 {{"R_13", 0, 2}, {"R_31", 2, 0}, {"R_33", 2, 2}});
}

void describe_inertial_components(Lecture& lecture) {
  auto& exercise = lecture.exercise("inertial_components", &inertial_components);
  exercise.argument("V_body", units::metre).argument("angles", units::radian).result("V_inertial", units::metre);

  exercise.worked("the vector (1, 2, 3) at the angles of the lecture", Vector3d(1, 2, 3), example_angles);
  exercise.special("no turn at all", Vector3d(1, 2, 3), Vector3d::Zero());
  exercise.special("the zero vector", Vector3d::Zero(), example_angles);
  exercise.special("θ = 0: the turns φ and ψ add up", Vector3d(1, -2, 3), Vector3d(0.4, 0, 0.9));
  exercise.special("θ = π: upside down", Vector3d(1, -2, 3), Vector3d(0.4, pi, 0.9));
  exercise.special("φ = ψ", Vector3d(1, -2, 3), Vector3d(0.6, 1.2, 0.6));
  exercise.random("any vector and attitude", 8, [](Random& random) {
    const auto [angles, vector] = angles_and_vector(random);
    return TwoVectors{vector, angles};
  });
  exercise.scale([](const Vector3d& V, const Vector3d&) { return std::max(V.norm(), 1e-3); });

  const std::string wrong_order =
      "Your three turns come in the wrong order: the inverse of R undoes ψ first, then θ, then φ, and negating the "
      "angles alone does not reverse the order.";
  exercise.misconception(
      "not_inverted", "You apply R, which takes inertial to body components; the way back is its transpose.",
      "euler_angles_components",
      [](const Vector3d& V, const Vector3d& angles) -> Vector3d { return rotation_matrix(angles) * V; });
  exercise.misconception(
      "order_reversed", wrong_order, "euler_angles_components",
      [](const Vector3d& V, const Vector3d& angles) -> Vector3d { return order_reversed(angles).transpose() * V; });
  exercise.misconception(
      "angles_negated", wrong_order, "euler_angles_components",
      [](const Vector3d& V, const Vector3d& angles) -> Vector3d { return rotation_matrix(-angles) * V; });
  exercise.misconception(
      "order_reversed_and_not_inverted",
      "You apply R_φ R_θ R_ψ: the order is right for the way back, but each factor still has to be transposed.",
      "euler_angles_components",
      [](const Vector3d& V, const Vector3d& angles) -> Vector3d { return order_reversed(angles) * V; });
  exercise.misconception("theta_negated", "The turn θ goes the wrong way round: R_θᵀ has +sin θ at the upper right.",
                         "euler_angles_components", [](const Vector3d& V, const Vector3d& angles) -> Vector3d {
                           return inertial_components(V, theta_negated(angles));
                         });
  exercise.misconception(
      "z_x_z", "Your middle turn is about the x axis (z–x–z); on the slides the line of nodes is the y′ axis (z–y–z).",
      "euler_angles_zxz",
      [](const Vector3d& V, const Vector3d& angles) -> Vector3d { return zxz(angles).transpose() * V; });
  exercise.misconception(
      "yaw_pitch_roll", "Your last turn is about the x axis (yaw, pitch and roll); on the slides it is about z again.",
      "euler_angles_zxz",
      [](const Vector3d& V, const Vector3d& angles) -> Vector3d { return zyx(angles).transpose() * V; });
  exercise.misconception(
      "phi_left_out",
      "φ does not enter, so your components belong to the axes after the first turn, not to the inertial ones.",
      "euler_angles_components", [](const Vector3d& V, const Vector3d& angles) -> Vector3d {
        return inertial_components(V, Vector3d(0, angles[1], angles[2]));
      });
  exercise.misconception("not_turned",
                         "You return the body components unchanged; the inertial ones depend on the attitude.",
                         "euler_angles_components", [](const Vector3d& V, const Vector3d&) -> Vector3d { return V; });
  exercise.angles_read_as_degrees("euler_angles_turns");

  const auto along = [](int axis) {
    return [axis](const Vector3d& V, const Vector3d& angles) -> Vector3d {
      return V[axis] * turned_triad(angles).col(axis);
    };
  };
  exercise.term("V₁ ê₁", 1.0, along(0));
  exercise.term("V₂ ê₂", 1.0, along(1));
  exercise.term("V₃ ê₃", 1.0, along(2));

  exercise.route("transpose of the matrix", [](const Vector3d& V, const Vector3d& angles) -> Vector3d {
    return rotation_matrix(angles).transpose() * V;
  });
  exercise.route("solving R x = V", [](const Vector3d& V, const Vector3d& angles) -> Vector3d {
    return rotation_matrix(angles).partialPivLu().solve(V);
  });
  exercise.route("a quaternion",
                 [](const Vector3d& V, const Vector3d& angles) -> Vector3d { return body_to_inertial(angles) * V; });
  exercise.route("sum over the body axes",
                 [](const Vector3d& V, const Vector3d& angles) -> Vector3d { return turned_triad(angles) * V; });

  exercise.sweep(
      {"The body axis ê₃ + ½ ê₁ while the body spins about ê₃, φ = 0.3, θ = 0.7", "ψ (rad)", "inertial component"},
      {0, 2 * pi},
      [](double psi) {
        return TwoVectors{Vector3d(0.5, 0, 1), Vector3d(0.3, 0.7, psi)};
      },
      {{"V_x", 0, 0}, {"V_y", 1, 0}, {"V_z", 2, 0}});
}

/// θ = 0 but for rounding errors in the entries that ought to vanish.
Matrix3d upright_up_to_rounding() {
  Matrix3d R = about_z(0.9);
  R(2, 0) = 3e-17;
  R(2, 1) = -2e-17;
  R(0, 2) = -4e-17;
  R(1, 2) = -1e-17;
  return R;
}

void describe_euler_angles(Lecture& lecture) {
  auto& exercise = lecture.exercise("euler_angles", &euler_angles);
  exercise.argument("R", units::none).result("angles", units::radian);
  exercise.compare(Comparison::attitude_by_angles);

  exercise.worked("θ beyond a right angle", rotation_matrix(Vector3d(0.3, 2.4, 1.1)));
  exercise.worked("φ beyond a right angle", rotation_matrix(Vector3d(2, 0.7, 1.1)));
  exercise.worked("ψ beyond a right angle", rotation_matrix(Vector3d(0.4, 0.9, -2.5)));
  exercise.special("no turn at all", Matrix3d::Identity());
  exercise.special("θ = 0: a turn about the vertical, only φ + ψ counts", about_z(0.9));
  exercise.special("θ = π: upside down, only ψ − φ counts", Matrix3d(about_z(0.4) * Vector3d(-1, 1, -1).asDiagonal()));
  exercise.special("θ = π/2", rotation_matrix(Vector3d(0.4, pi / 2, -2.9)));
  exercise.special("φ = ψ = 0", rotation_matrix(Vector3d(0, 1.2, 0)));
  const std::string arccosine = "At θ within 1e-8 of 0 or π an arccosine loses half of its digits.";
  exercise.special("θ = 1e-8", rotation_matrix(Vector3d(0.3, 1e-8, 1.1)));
  exercise.tolerance_of_last_case(1e-7, arccosine);
  exercise.special("θ = π − 1e-8", rotation_matrix(Vector3d(0.3, pi - 1e-8, 1.1)));
  exercise.tolerance_of_last_case(1e-7, "");
  exercise.special("θ = 0 up to rounding", upright_up_to_rounding());
  exercise.tolerance_of_last_case(1e-7, "");
  exercise.random("any attitude", 8,
                  [](Random& random) { return std::tuple<Matrix3d>{rotation_matrix(random.euler_angles())}; });
  exercise.scale([](const Matrix3d&) { return 1.0; });

  // All wrong answers but the first few start from the right angles and spoil them, so they are defined at θ = 0 too.
  const auto spoilt = [](auto spoil) {
    return [spoil](const Matrix3d& R) -> Vector3d { return spoil(R, euler_angles(R)); };
  };
  exercise.misconception(
      "theta_by_arcsine",
      "An arcsine finds θ only up to a right angle; θ runs to π, so take its cosine R₃₃ into account.",
      "euler_angles_recovery", spoilt([](const Matrix3d& R, const Vector3d& angles) -> Vector3d {
        return {angles[0], std::asin(std::min(1.0, std::hypot(R(2, 0), R(2, 1)))), angles[2]};
      }));
  exercise.misconception("theta_from_corner",
                         "You take θ from R₁₃, but that is −sin θ cos ψ; the entry that holds θ alone is R₃₃ = cos θ.",
                         "euler_angles_recovery", spoilt([](const Matrix3d& R, const Vector3d& angles) -> Vector3d {
                           return {angles[0], std::asin(std::clamp(R(0, 2), -1.0, 1.0)), angles[2]};
                         }));
  exercise.misconception("theta_from_corner_negated",
                         "You take θ from R₁₃, but that is −sin θ cos ψ; the entry that holds θ alone is R₃₃ = cos θ.",
                         "euler_angles_recovery", spoilt([](const Matrix3d& R, const Vector3d& angles) -> Vector3d {
                           return {angles[0], std::asin(std::clamp(-R(0, 2), -1.0, 1.0)), angles[2]};
                         }));
  exercise.misconception(
      "yaw_pitch_roll", "These are yaw, pitch and roll (z–y–x); on the slides the last turn is about z again (z–y–z).",
      "euler_angles_zxz", [](const Matrix3d& R) -> Vector3d {
        return {std::atan2(R(0, 1), R(0, 0)), std::asin(std::clamp(-R(0, 2), -1.0, 1.0)), std::atan2(R(1, 2), R(2, 2))};
      });
  exercise.misconception("exchanged", "φ and ψ are exchanged: φ stands in the third row of R, ψ in the third column.",
                         "euler_angles_recovery",
                         spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d { return exchanged(angles); }));
  exercise.misconception("exchanged_sign_lost",
                         "φ and ψ are exchanged: φ stands in the third row of R, ψ in the third column.",
                         "euler_angles_recovery", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {pi - angles[2], angles[1], angles[0]};
                         }));
  exercise.misconception("phi_from_column",
                         "You take φ from the third column of R, which holds ψ; φ stands in the third row.",
                         "euler_angles_recovery", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {angles[2], angles[1], angles[2]};
                         }));
  exercise.misconception("phi_from_column_sign_lost",
                         "You take φ from the third column of R, which holds ψ; φ stands in the third row.",
                         "euler_angles_recovery", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {pi - angles[2], angles[1], angles[2]};
                         }));
  exercise.misconception("psi_from_row",
                         "You take ψ from the third row of R, which holds φ; ψ stands in the third column.",
                         "euler_angles_recovery", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {angles[0], angles[1], angles[0]};
                         }));
  exercise.misconception(
      "transposed", "These are the angles of Rᵀ, as if R led from body to inertial components; it leads the other way.",
      "euler_angles_recovery",
      spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d { return -exchanged(angles); }));
  exercise.misconception(
      "negated",
      "All three angles have the wrong sign: the slides' matrices are passive, Eigen's rotations are active.",
      "euler_angles_recovery", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d { return -angles; }));
  exercise.misconception(
      "psi_sign_lost",
      "Your ψ is π minus the right one: the third column begins with −sin θ cos ψ, so ψ = atan2(R₂₃, −R₁₃).",
      "euler_angles_recovery", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d {
        return {angles[0], angles[1], pi - angles[2]};
      }));
  exercise.misconception("psi_negated", "Your ψ has the wrong sign: in the third column sin θ sin ψ comes with a plus.",
                         "euler_angles_recovery", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {angles[0], angles[1], -angles[2]};
                         }));
  exercise.misconception("phi_negated",
                         "Your φ has the wrong sign: the third row is (sin θ cos φ, sin θ sin φ, cos θ).",
                         "euler_angles_recovery", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {-angles[0], angles[1], angles[2]};
                         }));
  exercise.misconception(
      "sine_of_theta_negated",
      "Your angles give R with sin θ negated: with θ in [0, π] take φ = atan2(R₃₂, R₃₁) and ψ = atan2(R₂₃, −R₁₃).",
      "euler_angles_recovery",
      spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d { return theta_negated(angles); }));
  exercise.misconception("atan2_arguments", "The sine comes first in atan2(y, x): yours gives π/2 − φ and π/2 − ψ.",
                         "euler_angles_recovery", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {pi / 2 - angles[0], angles[1], pi / 2 - angles[2]};
                         }));
  const auto one_half_turn = [](double angle) { return std::atan(std::tan(angle)); };
  const std::string quadrant =
      "An arctangent of a quotient cannot tell opposite quadrants: use atan2(y, x) with both signs.";
  exercise.misconception("arctangent_for_phi", quadrant, "euler_angles_recovery",
                         spoilt([one_half_turn](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {one_half_turn(angles[0]), angles[1], angles[2]};
                         }));
  exercise.misconception("arctangent_for_psi", quadrant, "euler_angles_recovery",
                         spoilt([one_half_turn](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {angles[0], angles[1], one_half_turn(angles[2])};
                         }));
  exercise.misconception("arctangent_for_both", quadrant, "euler_angles_recovery",
                         spoilt([one_half_turn](const Matrix3d&, const Vector3d& angles) -> Vector3d {
                           return {one_half_turn(angles[0]), angles[1], one_half_turn(angles[2])};
                         }));
  exercise.misconception(
      "z_x_z", "These are the angles of three turns about z, x and z; on the slides the middle turn is about y′.",
      "euler_angles_zxz", spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d {
        return angles + Vector3d(pi / 2, 0, -pi / 2);
      }));
  exercise.misconception(
      "in_degrees", "Your angles come in degrees; radians are asked for.", "euler_angles_turns",
      spoilt([](const Matrix3d&, const Vector3d& angles) -> Vector3d { return angles * (180 / pi); }));

  exercise.route("Eigen's angles of the transpose",
                 [](const Matrix3d& R) -> Vector3d { return R.transpose().eulerAngles(2, 1, 2); });
  exercise.route("arccosine, and φ = 0 where sin θ vanishes", [](const Matrix3d& R) -> Vector3d {
    const double theta = std::acos(std::clamp(R(2, 2), -1.0, 1.0));
    if (std::hypot(R(2, 0), R(2, 1)) < 1e-12) return {0, theta, std::atan2(R(0, 1), R(1, 1))};
    return {std::atan2(R(2, 1), R(2, 0)), theta, std::atan2(R(1, 2), -R(0, 2))};
  });
  exercise.route("half angles of the quaternion", [](const Matrix3d& R) -> Vector3d {
    const Quaterniond q(Matrix3d(R.transpose()));
    const double half_sum = std::atan2(q.z(), q.w());
    const double half_difference = std::atan2(q.x(), q.y());  // of ψ − φ
    return {half_sum - half_difference, 2 * std::atan2(std::hypot(q.x(), q.y()), std::hypot(q.z(), q.w())),
            half_sum + half_difference};
  });
  exercise.route("with θ negative and a full turn more", [](const Matrix3d& R) -> Vector3d {
    const Vector3d angles = euler_angles(R);
    return {angles[0] - pi, -angles[1], angles[2] + 3 * pi};
  });

  exercise.sweep({"A steady turn about an axis almost level: φ and ψ leap where θ is nearly 0 or π",
                  "angle turned (rad)", "Euler angle (rad)"},
                 {-1, 4},
                 [](double angle) {
                   const Vector3d axis(0.4, 1, 0.06);
                   return std::tuple<Matrix3d>{AngleAxisd(-angle, axis.normalized()).toRotationMatrix()};
                 },
                 {{"φ", 0, 0}, {"θ", 1, 0}, {"ψ", 2, 0}});
}

void describe_line_of_nodes(Lecture& lecture) {
  auto& exercise = lecture.exercise("line_of_nodes", &line_of_nodes);
  exercise.argument("psi", units::radian).result("e2'", units::none);

  exercise.worked("ψ of the lecture", 1.1);
  exercise.special("ψ = 0", 0);
  exercise.special("ψ = π", pi);
  exercise.special("ψ = π/4, where sine and cosine agree", pi / 4);
  exercise.special("a tiny ψ", 1e-8);
  exercise.random("any ψ", 8, [](Random& random) {
    // Away from multiples of π/4.
    return std::tuple<double>{random.whole(-4, 3) * pi / 2 + pi / 4 + random.sign() * random.uniform(0.15, 0.65)};
  });

  exercise.misconception("x_axis",
                         "This is ê₁′, the line of nodes of z–x–z angles; on the slides the second turn is about ê₂′.",
                         "euler_angles_zxz", [](double psi) -> Vector3d {
                           return {std::cos(psi), -std::sin(psi), 0};
                         });
  exercise.misconception(
      "turned_backwards",
      "ê₂′ is turned the wrong way: R_ψ turns the axes by ψ, so seen from them the line of nodes goes back by ψ.",
      "euler_angles_nodes", [](double psi) -> Vector3d {
        return {-std::sin(psi), std::cos(psi), 0};
      });
  exercise.misconception(
      "polar_angle",
      "ψ is the angle from the line of nodes to ê₂; (cos ψ, sin ψ, 0) would be a line at the angle ψ from ê₁.",
      "euler_angles_nodes", [](double psi) -> Vector3d {
        return {std::cos(psi), std::sin(psi), 0};
      });
  exercise.misconception("opposite", "Your arrow points the opposite way: at ψ = 0 the line of nodes is ê₂, not −ê₂.",
                         "euler_angles_nodes", [](double psi) -> Vector3d {
                           return {-std::sin(psi), -std::cos(psi), 0};
                         });
  exercise.misconception("not_turned", "ψ does not enter: (0, 1, 0) are the components before the last turn.",
                         "euler_angles_nodes", [](double) -> Vector3d { return Vector3d::UnitY(); });
  exercise.misconception("body_axis",
                         "This is ê₃, the axis of the third turn; the line of nodes is perpendicular to it.",
                         "euler_angles_nodes", [](double) -> Vector3d { return Vector3d::UnitZ(); });
  exercise.angles_read_as_degrees("euler_angles_turns");

  exercise.term("sin ψ ê₁", 1.0, [](double psi) -> Vector3d { return std::sin(psi) * Vector3d::UnitX(); });
  exercise.term("cos ψ ê₂", 1.0, [](double psi) -> Vector3d { return std::cos(psi) * Vector3d::UnitY(); });
  exercise.property(PropertyKind::unit_norm, "ê₂′ is a unit vector.", "euler_angles_nodes");

  exercise.route("R_ψ (0, 1, 0)", [](double psi) -> Vector3d { return about_z(psi) * Vector3d::UnitY(); });
  exercise.route("i exp(−iψ)", [](double psi) -> Vector3d {
    const std::complex<double> node = std::complex<double>(0, 1) * std::polar(1.0, -psi);
    return {node.real(), node.imag(), 0};
  });
  exercise.route("across the two vertical axes", [](double psi) -> Vector3d {
    return Vector3d(about_z(psi) * about_y(1.0) * Vector3d::UnitZ()).cross(Vector3d::UnitZ()).normalized();
  });

  exercise.sweep({"The line of nodes seen from the body", "ψ (rad)", "component on the body axis"}, {0, 2 * pi},
                 [](double psi) { return std::tuple<double>{psi}; }, {{"along ê_1", 0, 0}, {"along ê_2", 1, 0}});
}

void describe_vertical_in_body(Lecture& lecture) {
  using TwoAngles = std::tuple<double, double>;
  auto& exercise = lecture.exercise("vertical_in_body", &vertical_in_body);
  exercise.argument("theta", units::radian).argument("psi", units::radian).result("e3_0", units::none);

  exercise.worked("θ and ψ of the lecture", 0.7, 1.1);
  exercise.special("upright", 0, 1.1);
  exercise.special("upside down", pi, 1.1);
  exercise.special("lying down", pi / 2, 1.1);
  exercise.special("a tiny θ", 1e-8, -2.0);
  exercise.special("ψ = 0", 0.7, 0);
  exercise.random("any attitude", 8, [](Random& random) {
    const Vector3d angles = random.euler_angles();
    const double psi = random.whole(-4, 3) * pi / 2 + pi / 4 + random.sign() * random.uniform(0.15, 0.65);
    return TwoAngles{angles[1], psi};
  });

  exercise.misconception("first_sign",
                         "The first component has the wrong sign: it is −sin θ cos ψ; with a plus you have the polar "
                         "angles of ê₃ seen from inertial axes.",
                         "euler_angles_vertical", [](double theta, double psi) -> Vector3d {
                           return {std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta)};
                         });
  exercise.misconception("body_axis_in_inertial_components",
                         "The first component has the wrong sign: it is −sin θ cos ψ; with a plus you have the polar "
                         "angles of ê₃ seen from inertial axes.",
                         "euler_angles_vertical", [](double theta, double psi) -> Vector3d {
                           return rotation_matrix(Vector3d(psi, theta, 0)).row(2).transpose();
                         });
  exercise.misconception("z_x_z",
                         "This is the vertical for z–x–z angles; on the slides the turn θ is about the y′ axis.",
                         "euler_angles_zxz", [](double theta, double psi) -> Vector3d {
                           return {std::sin(theta) * std::sin(psi), std::sin(theta) * std::cos(psi), std::cos(theta)};
                         });
  exercise.misconception("sine_and_cosine_of_psi",
                         "sin ψ and cos ψ are exchanged: at ψ = 0 the vertical leans towards −ê₁.",
                         "euler_angles_vertical", [](double theta, double psi) -> Vector3d {
                           return {-std::sin(theta) * std::sin(psi), std::sin(theta) * std::cos(psi), std::cos(theta)};
                         });
  exercise.misconception("sine_and_cosine_of_theta", "sin θ and cos θ are exchanged: at θ = 0 the vertical is ê₃.",
                         "euler_angles_vertical", [](double theta, double psi) -> Vector3d {
                           return {-std::cos(theta) * std::cos(psi), std::cos(theta) * std::sin(psi), std::sin(theta)};
                         });
  exercise.misconception(
      "theta_negated",
      "The part across ê₃ has the wrong sign: the body leans to one side, so the vertical leans to the other.",
      "euler_angles_vertical", [](double theta, double psi) -> Vector3d { return vertical_in_body(-theta, psi); });
  exercise.misconception("psi_backwards", "The turn ψ goes the wrong way: the second component is +sin θ sin ψ.",
                         "euler_angles_vertical",
                         [](double theta, double psi) -> Vector3d { return vertical_in_body(theta, -psi); });
  exercise.misconception(
      "psi_left_out",
      "ψ does not enter: −sin θ ê₁′ + cos θ ê₃ is right, but ê₁′ still has to be written on the body axes.",
      "euler_angles_vertical", [](double theta, double) -> Vector3d { return vertical_in_body(theta, 0); });
  exercise.misconception("primes_read_literally",
                         "Your vertical is just ê₃: read as the axis before the turn θ, ê₁′ has no share in it; the "
                         "slide means the axis after θ.",
                         "euler_angles_vertical", [](double, double) -> Vector3d { return Vector3d::UnitZ(); });
  exercise.misconception("exchanged", "θ and ψ are exchanged; the function takes θ first.", "euler_angles_vertical",
                         [](double theta, double psi) -> Vector3d { return vertical_in_body(psi, theta); });
  exercise.angles_read_as_degrees("euler_angles_turns");

  exercise.term("sin θ ê₁′", -1.0, [](double theta, double psi) -> Vector3d {
    return std::sin(theta) * Vector3d(std::cos(psi), -std::sin(psi), 0);
  });
  exercise.term("cos θ ê₃", 1.0, [](double theta, double) -> Vector3d { return std::cos(theta) * Vector3d::UnitZ(); });
  exercise.property(PropertyKind::unit_norm, "ê₃⁰ is a unit vector.", "euler_angles_vertical");

  exercise.route("R_ψ R_θ (0, 0, 1)", [](double theta, double psi) -> Vector3d {
    return about_z(psi) * (about_y(theta) * Vector3d::UnitZ());
  });
  exercise.route("third column of R, at any φ", [](double theta, double psi) -> Vector3d {
    return rotation_matrix(Vector3d(-1.7, theta, psi)).col(2);
  });
  exercise.route("a quaternion", [](double theta, double psi) -> Vector3d {
    return body_to_inertial(Vector3d(0.8, theta, psi)).conjugate() * Vector3d::UnitZ();
  });

  exercise.sweep(
      {"The vertical seen from a body that spins about ê₃, θ = 0.7", "ψ (rad)", "component on the body axis"},
      {0, 2 * pi},
      [](double psi) {
        return TwoAngles{0.7, psi};
      },
      {{"along ê_1", 0, 0}, {"along ê_2", 1, 0}, {"along ê_3", 2, 0}});
}

/// The cases that both angular velocities share.
template <class Exercise>
void add_angles_and_rates(Exercise& exercise) {
  exercise.argument("angles", units::radian)
      .argument("rates", units::radian_per_second)
      .result("omega", units::radian_per_second);
  exercise.worked("angles and rates of the lecture", example_angles, example_rates);
  exercise.special("at rest", example_angles, Vector3d::Zero());
  exercise.special("all angles zero", Vector3d::Zero(), example_rates);
  exercise.special("θ = 0: φ̇ and ψ̇ add up", Vector3d(0.4, 0, 0.9), example_rates);
  exercise.special("θ = π: φ̇ and ψ̇ are opposed", Vector3d(0.4, pi, 0.9), example_rates);
  exercise.special("θ = π/2", Vector3d(0.4, pi / 2, 0.9), example_rates);
  exercise.special("φ = ψ and equal rates of both", Vector3d(0.6, 1.2, 0.6), Vector3d(0.5, 0.3, 0.5));
  exercise.special("a tiny θ", Vector3d(-2.5, 1e-8, 0.3), example_rates);
  exercise.random("any attitude and rates", 8, &angles_and_vector);
  exercise.scale([](const Vector3d&, const Vector3d& rates) { return std::max(rates.norm(), 1e-3); });
}

/// ω in body components with the angles and rates of φ and ψ exchanged.
Vector3d body_formula_exchanged(const Vector3d& angles, const Vector3d& rates) {
  return angular_velocity_body(exchanged(angles), exchanged(rates));
}

void describe_angular_velocity_body(Lecture& lecture) {
  auto& exercise = lecture.exercise("angular_velocity_body", &angular_velocity_body);
  add_angles_and_rates(exercise);

  exercise.misconception(
      "z_x_z", "This is ω for z–x–z angles (Goldstein, Landau); on the slides the line of nodes is the y′ axis.",
      "euler_angles_zxz", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
        const Vector3d omega = angular_velocity_body(angles, rates);
        return {omega[1], -omega[0], omega[2]};
      });
  exercise.misconception("yaw_pitch_roll",
                         "This is ω for yaw, pitch and roll (z–y–x); on the slides the last turn is about z again.",
                         "euler_angles_zxz", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           const Matrix3d last = about_x(angles[2]);
                           return rates[0] * (last * about_y(angles[1]) * Vector3d::UnitZ()) +
                                  rates[1] * (last * Vector3d::UnitY()) + rates[2] * Vector3d::UnitX();
                         });
  exercise.misconception(
      "order_reversed",
      "φ and ψ are exchanged, as if the turns came in the order ψ, θ, φ; the turn φ about the vertical comes first.",
      "euler_angles_omega", &body_formula_exchanged);
  exercise.misconception("phi_for_psi", "φ stands where ψ belongs: the body components depend on θ and ψ, never on φ.",
                         "euler_angles_omega", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return angular_velocity_body(exchanged(angles), rates);
                         });
  exercise.misconception("inertial", "These are the inertial components of ω; asked for are those on the body axes.",
                         "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return angular_velocity_inertial(angles, rates);
                         });
  exercise.misconception("negated",
                         "ω points the opposite way: with V_body = R V_inertial the product (dR/dt) Rᵀ is the cross "
                         "matrix of −ω, not of ω.",
                         "euler_angles_omega", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return -angular_velocity_body(angles, rates);
                         });
  exercise.misconception(
      "negated_inertial",
      "These are the inertial components of −ω, as if R led from body to inertial components; it leads the other way.",
      "euler_angles_omega", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
        return -angular_velocity_inertial(angles, rates);
      });
  exercise.misconception("first_sign",
                         "In ω₁ the term with φ̇ has the wrong sign: the vertical has the component −sin θ cos ψ on ê₁.",
                         "euler_angles_vertical", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return angular_velocity_body(angles, rates) +
                                  Vector3d(2 * rates[0] * std::sin(angles[1]) * std::cos(angles[2]), 0, 0);
                         });
  exercise.misconception(
      "nodes_first_sign", "In ω₁ the term with θ̇ has the wrong sign: the line of nodes has the component +sin ψ on ê₁.",
      "euler_angles_nodes", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
        return angular_velocity_body(angles, rates) - Vector3d(2 * rates[1] * std::sin(angles[2]), 0, 0);
      });
  exercise.misconception("sine_and_cosine_of_psi",
                         "sin ψ and cos ψ are exchanged: at ψ = 0 the line of nodes is ê₂, so θ̇ stands in ω₂.",
                         "euler_angles_nodes", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           const double s = std::sin(angles[1]), cp = std::cos(angles[2]), sp = std::sin(angles[2]);
                           return {-rates[0] * s * sp + rates[1] * cp, rates[0] * s * cp + rates[1] * sp,
                                   rates[0] * std::cos(angles[1]) + rates[2]};
                         });
  exercise.misconception("sine_and_cosine_of_theta", "sin θ and cos θ are exchanged: at θ = 0 all of φ̇ goes into ω₃.",
                         "euler_angles_vertical", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           const Vector3d wrong(-std::cos(angles[1]) * std::cos(angles[2]),
                                                std::cos(angles[1]) * std::sin(angles[2]), std::sin(angles[1]));
                           return rates[0] * wrong + rates[1] * line_of_nodes(angles[2]) + rates[2] * Vector3d::UnitZ();
                         });
  exercise.misconception("theta_rate_along_body_axis",
                         "θ̇ goes along ê₂, but the body has turned by ψ since: the axis is the line of nodes ê₂′.",
                         "euler_angles_nodes", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return rates[0] * vertical_in_body(angles[1], angles[2]) + rates[1] * Vector3d::UnitY() +
                                  rates[2] * Vector3d::UnitZ();
                         });
  exercise.misconception("vertical_along_body_axis",
                         "φ̇ goes along ê₃, but its axis is the vertical ê₃⁰, which leans by θ.",
                         "euler_angles_vertical", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return rates[1] * line_of_nodes(angles[2]) + (rates[0] + rates[2]) * Vector3d::UnitZ();
                         });
  exercise.misconception("psi_left_out", "ψ does not enter: these are components on the axes before the last turn.",
                         "euler_angles_vertical", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return angular_velocity_body(Vector3d(angles[0], angles[1], 0), rates);
                         });
  exercise.misconception(
      "vertical_with_unturned_axis",
      "The vertical is written with ê₁′ as if it were ê₁: after the turn ψ, ê₁′ is cos ψ ê₁ − sin ψ ê₂.",
      "euler_angles_vertical", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
        return rates[0] * vertical_in_body(angles[1], 0) + rates[1] * line_of_nodes(angles[2]) +
               rates[2] * Vector3d::UnitZ();
      });
  exercise.misconception(
      "rates_unchanged", "You return the rates themselves; they belong to three axes that are not the body's.",
      "euler_angles_omega", [](const Vector3d&, const Vector3d& rates) -> Vector3d { return rates; });
  exercise.angles_read_as_degrees("euler_angles_turns");

  exercise.term("φ̇ ê₃⁰", 1.0, [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
    return rates[0] * vertical_in_body(angles[1], angles[2]);
  });
  exercise.term("θ̇ ê₂′", 1.0, [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
    return rates[1] * line_of_nodes(angles[2]);
  });
  exercise.term("ψ̇ ê₃", 1.0,
                [](const Vector3d&, const Vector3d& rates) -> Vector3d { return rates[2] * Vector3d::UnitZ(); });

  exercise.route("from Aᵀ dA/dt, differentiated along the imaginary axis",
                 [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                   const auto [R, R_rate] = matrix_and_rate(angles, rates);
                   return axis_of(R * R_rate.transpose());
                 });
  exercise.route("from the rate of a quaternion", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
    const Quaterniond phi(AngleAxisd(angles[0], Vector3d::UnitZ())), theta(AngleAxisd(angles[1], Vector3d::UnitY())),
        psi(AngleAxisd(angles[2], Vector3d::UnitZ()));
    const auto turning = [](double rate, const Vector3d& axis) {
      return Quaterniond(0, rate * axis.x() / 2, rate * axis.y() / 2, rate * axis.z() / 2);
    };
    const Eigen::Vector4d rate = (turning(rates[0], Vector3d::UnitZ()) * phi * theta * psi).coeffs() +
                                 (phi * turning(rates[1], Vector3d::UnitY()) * theta * psi).coeffs() +
                                 (phi * theta * turning(rates[2], Vector3d::UnitZ()) * psi).coeffs();
    return 2 * ((phi * theta * psi).conjugate() * Quaterniond(rate)).vec();
  });
  exercise.route(
      "the matrix of the three axes times the rates",
      [](const Vector3d& angles, const Vector3d& rates) -> Vector3d { return rates_to_omega(angles) * rates; });
  exercise.route("R times the inertial components", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
    return rotation_matrix(angles) * angular_velocity_inertial(angles, rates);
  });

  exercise.sweep({"ω seen from a body that spins about ê₃: θ = 0.7, rates 0.5, −0.2 and 0.9 rad/s", "ψ (rad)",
                  "body component of ω (rad/s)"},
                 {0, 2 * pi},
                 [](double psi) {
                   return TwoVectors{Vector3d(0.3, 0.7, psi), example_rates};
                 },
                 {{"ω_1", 0, 0}, {"ω_2", 1, 0}, {"ω_3", 2, 0}});
}

void describe_angular_velocity_inertial(Lecture& lecture) {
  auto& exercise = lecture.exercise("angular_velocity_inertial", &angular_velocity_inertial);
  add_angles_and_rates(exercise);

  exercise.misconception(
      "body", "These are the body components of ω; asked for are those on the inertial axes.", "euler_angles_inertial",
      [](const Vector3d& angles, const Vector3d& rates) -> Vector3d { return angular_velocity_body(angles, rates); });
  exercise.misconception("not_transposed",
                         "You apply R to the body components; R leads from inertial to body, so the way back is Rᵀ.",
                         "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return rotation_matrix(angles) * angular_velocity_body(angles, rates);
                         });
  exercise.misconception(
      "body_formula_exchanged",
      "This is the body formula with φ and ψ exchanged; the first component must change its sign as well.",
      "euler_angles_inertial", &body_formula_exchanged);
  exercise.misconception("negated",
                         "ω points the opposite way: with V_body = R V_inertial the product Rᵀ (dR/dt) is the cross "
                         "matrix of −ω, not of ω.",
                         "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return -angular_velocity_inertial(angles, rates);
                         });
  exercise.misconception(
      "negated_body",
      "These are the body components of −ω, as if R led from body to inertial components; it leads the other way.",
      "euler_angles_inertial",
      [](const Vector3d& angles, const Vector3d& rates) -> Vector3d { return -angular_velocity_body(angles, rates); });
  exercise.misconception(
      "z_x_z", "This is ω for z–x–z angles (Goldstein, Landau); on the slides the line of nodes is the y′ axis.",
      "euler_angles_zxz", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
        const Vector3d omega = angular_velocity_inertial(angles, rates);
        return {omega[1], -omega[0], omega[2]};
      });
  exercise.misconception("psi_for_phi",
                         "ψ stands where φ belongs: the inertial components depend on θ and φ, never on ψ.",
                         "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return angular_velocity_inertial(exchanged(angles), rates);
                         });
  exercise.misconception(
      "nodes_first_sign", "In the first component the term with θ̇ has the wrong sign: ê₂′ is (−sin φ, cos φ, 0).",
      "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
        return angular_velocity_inertial(angles, rates) + Vector3d(2 * rates[1] * std::sin(angles[0]), 0, 0);
      });
  exercise.misconception("sine_and_cosine_of_phi",
                         "sin φ and cos φ are exchanged: at φ = 0 the line of nodes is the y axis.",
                         "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           const double s = std::sin(angles[1]), cf = std::cos(angles[0]), sf = std::sin(angles[0]);
                           return {-rates[1] * cf + rates[2] * s * sf, rates[1] * sf + rates[2] * s * cf,
                                   rates[0] + rates[2] * std::cos(angles[1])};
                         });
  exercise.misconception("theta_negated",
                         "The tilt goes the wrong way: ê₃ is (sin θ cos φ, sin θ sin φ, cos θ) in inertial components.",
                         "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return angular_velocity_inertial(theta_negated(angles), rates);
                         });
  exercise.misconception(
      "theta_rate_along_fixed_axis", "θ̇ goes along the fixed y axis, but its axis, the line of nodes, has turned by φ.",
      "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
        return angular_velocity_inertial(angles, Vector3d(rates[0], 0, rates[2])) + rates[1] * Vector3d::UnitY();
      });
  exercise.misconception("spin_along_vertical",
                         "ψ̇ goes along the vertical, but its axis is the body's ê₃, which leans by θ.",
                         "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           return angular_velocity_inertial(angles, Vector3d(rates[0] + rates[2], rates[1], 0));
                         });
  exercise.misconception("cosine_at_wrong_rate",
                         "In ω_z the factor cos θ stands at φ̇; the vertical is φ̇'s own axis, so cos θ belongs to ψ̇.",
                         "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                           const Vector3d omega = angular_velocity_inertial(angles, rates);
                           return {omega[0], omega[1], rates[0] * std::cos(angles[1]) + rates[2]};
                         });
  exercise.misconception(
      "rates_unchanged", "You return the rates themselves; they belong to three axes that are not the inertial ones.",
      "euler_angles_omega", [](const Vector3d&, const Vector3d& rates) -> Vector3d { return rates; });
  exercise.angles_read_as_degrees("euler_angles_turns");

  const auto share = [](int which) {
    return [which](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
      return angular_velocity_inertial(angles, rates[which] * Vector3d::Unit(which));
    };
  };
  exercise.term("φ̇ ê₃⁰", 1.0, share(0));
  exercise.term("θ̇ ê₂′", 1.0, share(1));
  exercise.term("ψ̇ ê₃", 1.0, share(2));

  exercise.route("from dA/dt Aᵀ, differentiated along the imaginary axis",
                 [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
                   const auto [R, R_rate] = matrix_and_rate(angles, rates);
                   return axis_of(R_rate.transpose() * R);
                 });
  exercise.route("Rᵀ times the body components", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
    return rotation_matrix(angles).transpose() * angular_velocity_body(angles, rates);
  });
  exercise.route("the axes of the turned triad", [](const Vector3d& angles, const Vector3d& rates) -> Vector3d {
    const Vector3d nodes = turned_triad(Vector3d(angles[0], 0, 0)).col(1);
    return rates[0] * Vector3d::UnitZ() + rates[1] * nodes + rates[2] * turned_triad(angles).col(2);
  });

  exercise.sweep({"ω seen from the inertial frame while the body goes round: θ = 0.7, rates 0.5, −0.2 and 0.9 rad/s",
                  "φ (rad)", "inertial component of ω (rad/s)"},
                 {0, 2 * pi},
                 [](double phi) {
                   return TwoVectors{Vector3d(phi, 0.7, 1.1), example_rates};
                 },
                 {{"ω_x", 0, 0}, {"ω_y", 1, 0}, {"ω_z", 2, 0}});
}

void describe_euler_angle_rates(Lecture& lecture) {
  auto& exercise = lecture.exercise("euler_angle_rates", &euler_angle_rates);
  exercise.argument("angles", units::radian)
      .argument("omega_body", units::radian_per_second)
      .result("rates", units::radian_per_second);

  exercise.worked("angles and rates of the lecture", example_angles,
                  angular_velocity_body(example_angles, example_rates));
  exercise.special("at rest", example_angles, Vector3d::Zero());
  exercise.special("θ = π/2", Vector3d(0.4, pi / 2, 0.9), Vector3d(0.7, -1.1, 0.4));
  exercise.special("θ negative", Vector3d(0.4, -0.8, 0.9), Vector3d(0.7, -1.1, 0.4));
  exercise.special("ψ = 0", Vector3d(0.4, 0.8, 0), Vector3d(0.7, -1.1, 0.4));
  exercise.special("a spin about ê₃ only", example_angles, Vector3d(0, 0, 2));
  exercise.special("close to gimbal lock, θ = 0.001", Vector3d(0.3, 1e-3, 1.1), Vector3d(0.7, -1.1, 0.4));
  exercise.special("close to gimbal lock, θ = π − 0.001", Vector3d(0.3, pi - 1e-3, 1.1), Vector3d(0.7, -1.1, 0.4));
  exercise.random("any attitude and angular velocity", 8, &angles_and_vector);
  exercise.scale([](const Vector3d& angles, const Vector3d& omega) {
    return std::max(omega.norm(), 1e-3) / std::abs(std::sin(angles[1]));
  });

  // φ̇, θ̇ and ψ̇ put together from the share of ω along the line of nodes, across it, and along ê₃.
  const auto along = [](const Vector3d& angles, const Vector3d& omega) { return omega.dot(line_of_nodes(angles[2])); };
  const auto across = [](const Vector3d& angles, const Vector3d& omega) {
    return -omega[0] * std::cos(angles[2]) + omega[1] * std::sin(angles[2]);
  };

  exercise.misconception("transposed",
                         "You multiply by the transpose of the rate matrix; its columns are not orthogonal, so its "
                         "inverse is another matrix.",
                         "euler_angles_gimbal", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           return rates_to_omega(angles).transpose() * omega;
                         });
  exercise.misconception(
      "not_inverted", "You treat ω as if it were the rates and compute ω from it; asked for is the way back.",
      "euler_angles_gimbal",
      [](const Vector3d& angles, const Vector3d& omega) -> Vector3d { return angular_velocity_body(angles, omega); });
  exercise.misconception("z_x_z",
                         "These are the rates of z–x–z angles; on the slides the line of nodes is the y′ axis.",
                         "euler_angles_zxz", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           // With equal angles ω(z–x–z) = (ω₂, −ω₁, ω₃); so undo that before inverting.
                           return euler_angle_rates(angles, Vector3d(-omega[1], omega[0], omega[2]));
                         });
  exercise.misconception(
      "spin_is_third_component",
      "Your ψ̇ is ω₃; that forgets the share φ̇ cos θ of the turn about the vertical: ψ̇ = ω₃ − φ̇ cos θ.",
      "euler_angles_gimbal", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
        const Vector3d rates = euler_angle_rates(angles, omega);
        return {rates[0], rates[1], omega[2]};
      });
  exercise.misconception("spin_plus", "In ψ̇ the term with cos θ has the wrong sign: ψ̇ = ω₃ − φ̇ cos θ.",
                         "euler_angles_gimbal", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           const Vector3d rates = euler_angle_rates(angles, omega);
                           return {rates[0], rates[1], 2 * omega[2] - rates[2]};
                         });
  exercise.misconception("spin_without_cosine",
                         "You subtract φ̇ from ω₃; only its share along ê₃ counts: ψ̇ = ω₃ − φ̇ cos θ.",
                         "euler_angles_gimbal", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           const Vector3d rates = euler_angle_rates(angles, omega);
                           return {rates[0], rates[1], omega[2] - rates[0]};
                         });
  exercise.misconception("tangent", "In ψ̇ stands tan θ where cot θ belongs.", "euler_angles_gimbal",
                         [across](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           const Vector3d rates = euler_angle_rates(angles, omega);
                           return {rates[0], rates[1], omega[2] - std::tan(angles[1]) * across(angles, omega)};
                         });
  exercise.misconception(
      "sine_not_divided",
      "φ̇ is not divided by sin θ: only that share of the turn about the vertical shows across the line of nodes.",
      "euler_angles_gimbal", [across](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
        const Vector3d rates = euler_angle_rates(angles, omega);
        return {across(angles, omega), rates[1], rates[2]};
      });
  exercise.misconception(
      "sine_not_divided_twice",
      "φ̇ is not divided by sin θ, and ψ̇ inherits it: only the share sin θ of φ̇ shows across the line of nodes.",
      "euler_angles_gimbal", [along, across](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
        const double phi_rate = across(angles, omega);
        return {phi_rate, along(angles, omega), omega[2] - phi_rate * std::cos(angles[1])};
      });
  exercise.misconception("sine_multiplied", "You multiply by sin θ in φ̇ where you should divide.",
                         "euler_angles_gimbal", [across](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           const Vector3d rates = euler_angle_rates(angles, omega);
                           return {across(angles, omega) * std::sin(angles[1]), rates[1], rates[2]};
                         });
  exercise.misconception("phi_rate_negated", "φ̇ has the wrong sign: the vertical has the component −sin θ cos ψ on ê₁.",
                         "euler_angles_vertical", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           const Vector3d rates = euler_angle_rates(angles, omega);
                           return {-rates[0], rates[1], rates[2]};
                         });
  exercise.misconception("phi_rate_negated_twice",
                         "φ̇ has the wrong sign, and ψ̇ inherits it: the vertical has the component −sin θ cos ψ on ê₁.",
                         "euler_angles_vertical", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           const Vector3d rates = euler_angle_rates(angles, omega);
                           return {-rates[0], rates[1], 2 * omega[2] - rates[2]};
                         });
  exercise.misconception("sine_and_cosine_of_psi",
                         "sin ψ and cos ψ are exchanged: at ψ = 0 the line of nodes is ê₂, so θ̇ = ω₂.",
                         "euler_angles_nodes", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           return euler_angle_rates(Vector3d(angles[0], angles[1], pi / 2 - angles[2]), omega);
                         });
  exercise.misconception("psi_backwards",
                         "ψ enters with the wrong sign: the line of nodes is (sin ψ, cos ψ, 0) on the body axes.",
                         "euler_angles_nodes", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           return euler_angle_rates(Vector3d(angles[0], angles[1], -angles[2]), omega);
                         });
  exercise.misconception("phi_for_psi",
                         "φ stands where ψ belongs: from body components the rates depend on θ and ψ, never on φ.",
                         "euler_angles_gimbal", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           return euler_angle_rates(exchanged(angles), omega);
                         });
  exercise.misconception("inertial_omega", "You take ω for inertial components; it comes on the body axes.",
                         "euler_angles_inertial", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                           return euler_angle_rates(angles, rotation_matrix(angles) * omega);
                         });
  exercise.misconception(
      "omega_unchanged", "You return ω itself; its components belong to the body axes, the rates to three other axes.",
      "euler_angles_omega", [](const Vector3d&, const Vector3d& omega) -> Vector3d { return omega; });
  exercise.angles_read_as_degrees("euler_angles_turns");

  exercise.term("(−ω₁ cos ψ + ω₂ sin ψ)/sin θ in φ̇", 1.0,
                [across](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                  return {across(angles, omega) / std::sin(angles[1]), 0, 0};
                });
  exercise.term("ω₁ sin ψ + ω₂ cos ψ in θ̇", 1.0, [along](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
    return {0, along(angles, omega), 0};
  });
  exercise.term("ω₃ in ψ̇", 1.0, [](const Vector3d&, const Vector3d& omega) -> Vector3d { return {0, 0, omega[2]}; });
  exercise.term("cot θ (ω₁ cos ψ − ω₂ sin ψ) in ψ̇", 1.0,
                [across](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
                  return {0, 0, -across(angles, omega) / std::tan(angles[1])};
                });

  exercise.route("solving E (rates) = ω", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
    return rates_to_omega(angles).colPivHouseholderQr().solve(omega);
  });
  exercise.route("the reciprocal triad", [](const Vector3d& angles, const Vector3d& omega) -> Vector3d {
    const Matrix3d E = rates_to_omega(angles);
    const Vector3d a = E.col(0), b = E.col(1), c = E.col(2);
    return Vector3d(omega.dot(b.cross(c)), omega.dot(c.cross(a)), omega.dot(a.cross(b))) / a.dot(b.cross(c));
  });
  exercise.route("through inertial components", [](const Vector3d& angles, const Vector3d& omega_body) -> Vector3d {
    const Vector3d omega = turned_triad(angles) * omega_body;
    const double cf = std::cos(angles[0]), sf = std::sin(angles[0]);
    const double psi_rate = (omega[0] * cf + omega[1] * sf) / std::sin(angles[1]);
    return {omega[2] - psi_rate * std::cos(angles[1]), -omega[0] * sf + omega[1] * cf, psi_rate};
  });

  exercise.sweep(
      {"Rates that one and the same ω demands: φ̇ and ψ̇ grow without bound at θ = 0 and π", "θ (rad)", "rate (rad/s)"},
      {0.05, pi - 0.05},
      [](double theta) {
        return TwoVectors{Vector3d(0.3, theta, 1.1), Vector3d(-0.3, 0.2, 1.3)};
      },
      {{"dφ/dt", 0, 0}, {"dθ/dt", 1, 0}, {"dψ/dt", 2, 0}});
}

}  // namespace

void workbook::judging::describe(Lecture& lecture) {
  describe_rotation_matrix(lecture);
  describe_inertial_components(lecture);
  describe_euler_angles(lecture);
  describe_line_of_nodes(lecture);
  describe_vertical_in_body(lecture);
  describe_angular_velocity_body(lecture);
  describe_angular_velocity_inertial(lecture);
  describe_euler_angle_rates(lecture);
}
