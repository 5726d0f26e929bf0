/// @file
/// How the exercises of lecture 05 are judged.
#include "rigid/euler_equations.hpp"
#include "solutions/judging/exact_top.hpp"
#include "solutions/judging/lecture.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <vector>

namespace {

using namespace rigid;
using namespace workbook;
using namespace workbook::judging;

using MomentsOmegaTorque = std::tuple<Vector3d, Vector3d, Vector3d>;
using TensorOmegaVector = std::tuple<Matrix3d, Vector3d, Vector3d>;
using TensorAndOmega = std::tuple<Matrix3d, Vector3d>;
using MomentsAndOmega = std::tuple<Vector3d, Vector3d>;
using FreeMotion = std::tuple<Vector3d, Vector3d, VectorXd>;

const Vector3d example_moments(1, 2, 3);
const Vector3d example_omega(0.3, -0.2, 0.5);
const Vector3d example_torque(0.2, -0.1, 0.3);

/// The tensor of lecture 03's four masses.
Matrix3d tensor_of_four_masses() { return Matrix3d{{43, -4, -4}, {-4, 36, -4}, {-4, -4, 17}}; }

Matrix3d diagonal_part(const Matrix3d& I) { return I.diagonal().asDiagonal(); }

Matrix3d products_flipped(const Matrix3d& I) { return 2 * diagonal_part(I) - I; }

/// ω × L as a difference of two products: (ω₂L₃, ω₃L₁, ω₁L₂) less (ω₃L₂, ω₁L₃, ω₂L₁).
Vector3d first_products(const Vector3d& omega, const Vector3d& L) {
  return {omega[1] * L[2], omega[2] * L[0], omega[0] * L[1]};
}
Vector3d second_products(const Vector3d& omega, const Vector3d& L) {
  return {omega[2] * L[1], omega[0] * L[2], omega[1] * L[0]};
}

Vector3d cross_of(const Vector3d& a, const Vector3d& b) { return a.cross(b); }

/// Principal moments and axes, the axes as columns of a right-handed triad; a solver does not care for handedness.
struct PrincipalFrame {
  explicit PrincipalFrame(const Matrix3d& I) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
    moments = solver.eigenvalues();
    axes = solver.eigenvectors();
    if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  }
  Vector3d moments;
  Matrix3d axes;
};

/// ω × L on principal axes, as the slides write it: (ω₂ω₃(I₃ − I₂), ω₃ω₁(I₁ − I₃), ω₁ω₂(I₂ − I₁)).
Vector3d gyration(const Vector3d& I, const Vector3d& omega) {
  return {omega[1] * omega[2] * (I[2] - I[1]), omega[2] * omega[0] * (I[0] - I[2]),
          omega[0] * omega[1] * (I[1] - I[0])};
}

Matrix3d cross_matrix_of(const Vector3d& omega) {
  Matrix3d cross;
  cross << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  return cross;
}

/// The components moved on by one place: (a₂, a₃, a₁).
Vector3d shifted(const Vector3d& a) { return {a[1], a[2], a[0]}; }

/// The slides' products of ω, each with the difference of moments of the next equation.
Vector3d gyration_with_shifted_differences(const Vector3d& I, const Vector3d& omega) {
  const Vector3d differences(I[2] - I[1], I[0] - I[2], I[1] - I[0]);
  const Vector3d products(omega[1] * omega[2], omega[2] * omega[0], omega[0] * omega[1]);
  return products.cwiseProduct(shifted(differences));
}

const char* const wrong_sign_of_gyration =
    "The sign of ω × (Iω) is wrong: it stands with + on the side of I dω/dt, so it goes with − to the side of the "
    "torque.";
const char* const gyration_missing =
    "You solve I dω/dt = τ; the term ω × (Iω), which the turning of the body's axes adds, is missing.";
const char* const torque_missing = "The torque does not enter your rates; it drives them: I dω/dt = τ − ω × (Iω).";
const char* const torque_sign = "The sign of the torque is wrong: I dω/dt = τ − ω × (Iω).";
const char* const inertia_not_divided =
    "You return τ − ω × (Iω), which is I dω/dt, the rate of L seen from the body; it is still to be divided by the "
    "inertia.";
const char* const products_do_not_enter =
    "The products of inertia do not enter: you use the diagonal of I as if these were principal axes.";
const char* const products_sign =
    "You change the sign of the products of inertia; the tensor already carries their minus.";

void describe_euler_equations(Lecture& lecture) {
  auto& exercise = lecture.exercise("euler_equations", &euler_equations);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega", units::radian_per_second)
      .argument("torque", units::newton_metre)
      .result("omega_rate", units::radian_per_second_squared);

  exercise.worked("moments 1, 2, 3 under a torque", example_moments, example_omega, example_torque);
  exercise.special("no torque", example_moments, example_omega, Vector3d::Zero());
  exercise.special("a sphere", Vector3d(2, 2, 2), example_omega, example_torque);
  exercise.special("rotation about a principal axis", example_moments, Vector3d(0, 1.5, 0), example_torque);
  exercise.special("a body at rest, no torque", example_moments, Vector3d::Zero(), Vector3d::Zero());
  exercise.special("a symmetric body", Vector3d(1, 1, 1.8), example_omega, example_torque);
  exercise.special("a flat body", Vector3d(1, 2, 3), Vector3d(2, -1, 0), Vector3d(0, 0, -1));
  exercise.random("a random body", 10, [](Random& random) {
    const Vector3d I = random.principal_moments();
    return MomentsOmegaTorque{I, random.vector(2.0), random.vector(4.0)};
  });
  exercise.scale([](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
    return std::max((torque.norm() + I.maxCoeff() * omega.squaredNorm()) / I.minCoeff(), 1e-3);
  });

  exercise.misconception("sign_of_gyration", wrong_sign_of_gyration, "euler_equations_rate",
                         [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return (torque + cross_of(omega, I.cwiseProduct(omega))).cwiseQuotient(I);
                         });
  exercise.misconception(
      "no_gyration", gyration_missing, "euler_equations_rate",
      [](const Vector3d& I, const Vector3d&, const Vector3d& torque) -> Vector3d { return torque.cwiseQuotient(I); });
  exercise.misconception("not_divided", inertia_not_divided, "euler_equations_principal",
                         [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return torque - cross_of(omega, I.cwiseProduct(omega));
                         });
  exercise.misconception(
      "indices_shifted",
      "The differences of moments are shifted by one place: with ω₂ω₃ goes I₃ − I₂, the two indices of the product.",
      "euler_equations_principal", [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
        return (torque - gyration_with_shifted_differences(I, omega)).cwiseQuotient(I);
      });
  exercise.misconception("no_torque", torque_missing, "euler_equations_principal",
                         [](const Vector3d& I, const Vector3d& omega, const Vector3d&) -> Vector3d {
                           return -cross_of(omega, I.cwiseProduct(omega)).cwiseQuotient(I);
                         });
  exercise.misconception("sign_of_torque", torque_sign, "euler_equations_principal",
                         [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return (-torque - cross_of(omega, I.cwiseProduct(omega))).cwiseQuotient(I);
                         });
  exercise.misconception(
      "torque_not_divided",
      "The torque stands undivided beside the quotient: both summands of τᵢ − (ω × L)ᵢ are divided by Iᵢ.",
      "euler_equations_principal", [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
        return torque - cross_of(omega, I.cwiseProduct(omega)).cwiseQuotient(I);
      });
  exercise.misconception("gyration_not_divided",
                         "You divide only the torque by the moments: both summands of τᵢ − (ω × L)ᵢ are divided by Iᵢ.",
                         "euler_equations_principal",
                         [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return torque.cwiseQuotient(I) - cross_of(omega, I.cwiseProduct(omega));
                         });
  exercise.misconception(
      "wrong_divisor", "Each equation is divided by another axis's moment: the rate of ω₁ takes I₁, and so on.",
      "euler_equations_principal", [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
        return (torque - cross_of(omega, I.cwiseProduct(omega))).cwiseQuotient(shifted(I));
      });
  exercise.misconception(
      "multiplied", "You multiply by the moments where you should divide: dωᵢ/dt = (τᵢ − (ω × L)ᵢ) / Iᵢ.",
      "euler_equations_principal", [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
        return (torque - cross_of(omega, I.cwiseProduct(omega))).cwiseProduct(I);
      });

  exercise.term("τᵢ/Iᵢ", 1.0, [](const Vector3d& I, const Vector3d&, const Vector3d& torque) -> Vector3d {
    return torque.cwiseQuotient(I);
  });
  exercise.term("ω₂L₃/I₁ (and cyclically)", -1.0,
                [](const Vector3d& I, const Vector3d& omega, const Vector3d&) -> Vector3d {
                  return first_products(omega, I.cwiseProduct(omega)).cwiseQuotient(I);
                });
  exercise.term("ω₃L₂/I₁ (and cyclically)", 1.0,
                [](const Vector3d& I, const Vector3d& omega, const Vector3d&) -> Vector3d {
                  return second_products(omega, I.cwiseProduct(omega)).cwiseQuotient(I);
                });

  exercise.route("the slides' three equations",
                 [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                   return (torque - gyration(I, omega)).cwiseQuotient(I);
                 });
  exercise.route("with the whole tensor",
                 [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                   return euler_equations_general(I.asDiagonal(), omega, torque);
                 });
  exercise.route("with the cross matrix",
                 [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                   const Matrix3d tensor = I.asDiagonal();
                   return tensor.inverse() * (torque - cross_matrix_of(omega) * tensor * omega);
                 });
  exercise.route("turned into other axes and back",
                 [](const Vector3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                   const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2) / 3).toRotationMatrix();
                   const Matrix3d tensor = turn * I.asDiagonal() * turn.transpose();
                   return turn.transpose() * euler_equations_general(tensor, turn * omega, turn * torque);
                 });

  exercise.sweep({"Moments 1, 2, 3 kg m², τ = (0.2, 0, 0) N m: ω = (cos α, sin α, 0.5) rad/s goes round axis 3",
                  "angle α (rad)", "rate of ω (rad/s²)"},
                 {0, 6.3},
                 [](double angle) {
                   return MomentsOmegaTorque{example_moments, Vector3d(std::cos(angle), std::sin(angle), 0.5),
                                             Vector3d(0.2, 0, 0)};
                 },
                 {{"dω_1/dt", 0, 0}, {"dω_2/dt", 1, 0}, {"dω_3/dt", 2, 0}});
}

void describe_euler_equations_general(Lecture& lecture) {
  auto& exercise = lecture.exercise("euler_equations_general", &euler_equations_general);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega", units::radian_per_second)
      .argument("torque", units::newton_metre)
      .result("omega_rate", units::radian_per_second_squared);

  exercise.worked("the four masses of lecture 03 under a torque", tensor_of_four_masses(), example_omega,
                  example_torque);
  exercise.special("principal axes", example_moments.asDiagonal(), example_omega, example_torque);
  exercise.special("no torque", tensor_of_four_masses(), example_omega, Vector3d::Zero());
  exercise.special("a sphere", 2 * Matrix3d::Identity(), example_omega, example_torque);
  exercise.special("a body at rest, no torque", tensor_of_four_masses(), Vector3d::Zero(), Vector3d::Zero());
  exercise.special("just the torque that holds the rotation", tensor_of_four_masses(), example_omega,
                   Vector3d(3.58, 3.42, -0.78));
  exercise.random("a random body", 10, [](Random& random) {
    const Matrix3d I = random.inertia_tensor();
    return TensorOmegaVector{I, random.vector(2.0), random.vector(4.0)};
  });
  exercise.scale([](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
    return std::max((torque.norm() + I.norm() * omega.squaredNorm()) * I.inverse().norm(), 1e-3);
  });

  exercise.misconception("sign_of_gyration", wrong_sign_of_gyration, "euler_equations_rate",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return I.inverse() * (torque + cross_of(omega, I * omega));
                         });
  exercise.misconception(
      "no_gyration", gyration_missing, "euler_equations_rate",
      [](const Matrix3d& I, const Vector3d&, const Vector3d& torque) -> Vector3d { return I.inverse() * torque; });
  exercise.misconception("diagonal_formula", products_do_not_enter, "euler_equations_general",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return euler_equations(I.diagonal(), omega, torque);
                         });
  exercise.misconception("not_divided", inertia_not_divided, "euler_equations_general",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return torque - cross_of(omega, I * omega);
                         });
  exercise.misconception("divided_by_diagonal",
                         "You divide by the diagonal entries of I; with products of inertia, I dω/dt = τ − ω × (Iω) is "
                         "a system of three coupled equations.",
                         "euler_equations_general",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return (torque - cross_of(omega, I * omega)).cwiseQuotient(I.diagonal());
                         });
  exercise.misconception(
      "diagonal_momentum", "Your L in ω × L leaves out the products of inertia: L = Iω takes the whole tensor.",
      "euler_equations_general", [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
        return I.inverse() * (torque - cross_of(omega, diagonal_part(I) * omega));
      });
  exercise.misconception(
      "moments_for_tensor",
      "You put the principal moments into Euler's equations, but ω and τ come on axes that are not principal.",
      "euler_equations_general", [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
        return euler_equations(PrincipalFrame(I).moments, omega, torque);
      });
  exercise.misconception("products_flipped", products_sign, "euler_equations_general",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return euler_equations_general(products_flipped(I), omega, torque);
                         });
  exercise.misconception("no_torque", torque_missing, "euler_equations_general",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d&) -> Vector3d {
                           return -I.inverse() * cross_of(omega, I * omega);
                         });
  exercise.misconception("sign_of_torque", torque_sign, "euler_equations_general",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                           return I.inverse() * (-torque - cross_of(omega, I * omega));
                         });
  exercise.misconception(
      "multiplied",
      "You multiply by I where you should solve for dω/dt: I stands before dω/dt in I dω/dt = τ − ω × (Iω).",
      "euler_equations_general", [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
        return I * (torque - cross_of(omega, I * omega));
      });

  exercise.term("I⁻¹ τ", 1.0, [](const Matrix3d& I, const Vector3d&, const Vector3d& torque) -> Vector3d {
    return I.inverse() * torque;
  });
  exercise.term("I⁻¹ (ω × L)", -1.0, [](const Matrix3d& I, const Vector3d& omega, const Vector3d&) -> Vector3d {
    return I.inverse() * cross_of(omega, I * omega);
  });

  exercise.route(
      "on principal axes and back", [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
        const PrincipalFrame frame(I);
        return frame.axes *
               euler_equations(frame.moments, frame.axes.transpose() * omega, frame.axes.transpose() * torque);
      });
  exercise.route("by the inverse matrix",
                 [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                   return I.inverse() * (torque + cross_of(I * omega, omega));
                 });
  exercise.route("by Cramer's rule", [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
    const Vector3d right = torque - cross_of(omega, I * omega);
    Vector3d rate;
    for (int j = 0; j < 3; ++j) {
      Matrix3d replaced = I;
      replaced.col(j) = right;
      rate[j] = replaced.determinant() / I.determinant();
    }
    return rate;
  });
  exercise.route("by a pivoted decomposition",
                 [](const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) -> Vector3d {
                   return I.fullPivLu().solve(torque) - I.fullPivLu().solve(cross_of(omega, I * omega));
                 });

  exercise.sweep({"The four masses, turning free of torque: ω goes round in the xy plane, |ω| = 1 rad/s",
                  "angle of ω from the x axis (rad)", "rate of ω (rad/s²)"},
                 {0, 6.3},
                 [](double angle) {
                   return TensorOmegaVector{tensor_of_four_masses(), Vector3d(std::cos(angle), std::sin(angle), 0),
                                            Vector3d::Zero()};
                 },
                 {{"dω_x/dt", 0, 0}, {"dω_y/dt", 1, 0}, {"dω_z/dt", 2, 0}});
}

void describe_torque_to_hold_rotation(Lecture& lecture) {
  auto& exercise = lecture.exercise("torque_to_hold_rotation", &torque_to_hold_rotation);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega", units::radian_per_second)
      .result("torque", units::newton_metre);

  exercise.worked("the four masses of lecture 03", tensor_of_four_masses(), example_omega);
  exercise.special("rotation about a principal axis", example_moments.asDiagonal(), Vector3d(0, 2, 0));
  exercise.special("a sphere", 2 * Matrix3d::Identity(), example_omega);
  exercise.special("principal axes, oblique ω", example_moments.asDiagonal(), example_omega);
  exercise.special("no rotation", tensor_of_four_masses(), Vector3d::Zero());
  exercise.random("a random body", 10, [](Random& random) {
    const Matrix3d I = random.inertia_tensor();
    return TensorAndOmega{I, random.vector(3.0)};
  });
  exercise.scale(
      [](const Matrix3d& I, const Vector3d& omega) { return I.norm() * std::max(omega.squaredNorm(), 1e-3); });

  exercise.misconception("zero", "You say that no torque is needed because ω is constant; but L turns with the body.",
                         "euler_equations_hold",
                         [](const Matrix3d&, const Vector3d&) -> Vector3d { return Vector3d::Zero(); });
  exercise.misconception("sign",
                         "The sign is wrong: this is the torque that the body exerts on its bearings; asked for is the "
                         "torque on the body, ω × L.",
                         "euler_equations_hold", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
                           return cross_of(I * omega, omega);
                         });
  exercise.misconception("momentum", "This is L = Iω; the torque is the rate at which it turns, ω × L.",
                         "euler_equations_hold",
                         [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return I * omega; });
  exercise.misconception(
      "diagonal_only", products_do_not_enter, "euler_equations_hold",
      [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return cross_of(omega, diagonal_part(I) * omega); });
  exercise.misconception("products_flipped", products_sign, "euler_equations_hold",
                         [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
                           return cross_of(omega, products_flipped(I) * omega);
                         });
  exercise.misconception("lengths_multiplied",
                         "You multiply the length of ω with L; the cross product ω × L leaves only the part of L "
                         "across ω, and turns it by a right angle.",
                         "euler_equations_hold", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
                           return omega.norm() * (I * omega);
                         });
  exercise.misconception(
      "acceleration",
      "This is the angular acceleration of the body left alone; asked for is the torque that prevents it.",
      "euler_equations_hold",
      [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return -I.inverse() * cross_of(omega, I * omega); });

  exercise.term("(ω_y L_z, ω_z L_x, ω_x L_y)", 1.0,
                [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return first_products(omega, I * omega); });
  exercise.term("(ω_z L_y, ω_x L_z, ω_y L_x)", -1.0,
                [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return second_products(omega, I * omega); });
  exercise.perpendicular_to(1,
                            "The torque stands at right angles to ω, for the energy stays the same: it does no work.",
                            "euler_equations_hold");

  exercise.route("Euler's equations read backwards", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
    return -(I * euler_equations_general(I, omega, Vector3d::Zero()));
  });
  exercise.route("with the cross matrix", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
    return (cross_matrix_of(omega) * I) * omega;
  });
  exercise.route("on principal axes and back", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
    const PrincipalFrame frame(I);
    return frame.axes * gyration(frame.moments, frame.axes.transpose() * omega);
  });
  exercise.route("the turning of L in a short time", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
    // L turned by ±h, and the central difference extrapolated to h = 0 (Richardson).
    const Vector3d L = I * omega;
    const double speed = omega.norm();
    if (speed == 0) return Vector3d::Zero();
    const auto difference = [&](double h) -> Vector3d {
      const Eigen::AngleAxisd turn(h, omega / speed);
      return speed * (turn * L - turn.inverse() * L) / (2 * h);
    };
    return (64 * difference(0.005) - 20 * difference(0.01) + difference(0.02)) / 45;
  });

  exercise.sweep({"The torque on the four masses while ω points round the xy plane, |ω| = 1 rad/s",
                  "angle of ω from the x axis (rad)", "component of the torque (N m)"},
                 {0, 6.3},
                 [](double angle) {
                   return TensorAndOmega{tensor_of_four_masses(), Vector3d(std::cos(angle), std::sin(angle), 0)};
                 },
                 {{"τ_x", 0, 0}, {"τ_y", 1, 0}, {"τ_z", 2, 0}});
}

void describe_angular_momentum_rate(Lecture& lecture) {
  auto& exercise = lecture.exercise("angular_momentum_rate", &angular_momentum_rate);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega", units::radian_per_second)
      .argument("omega_rate", units::radian_per_second_squared)
      .result("L_rate", units::newton_metre);

  exercise.worked("the four masses of lecture 03", tensor_of_four_masses(), example_omega, Vector3d(0.1, 0.2, -0.3));
  exercise.special("steady rotation", tensor_of_four_masses(), example_omega, Vector3d::Zero());
  exercise.special("set off from rest", tensor_of_four_masses(), Vector3d::Zero(), Vector3d(0.1, 0.2, -0.3));
  exercise.special("a sphere", 2 * Matrix3d::Identity(), example_omega, Vector3d(0.1, 0.2, -0.3));
  exercise.special("principal axes", example_moments.asDiagonal(), example_omega, Vector3d(0.1, 0.2, -0.3));
  exercise.special("a free body, where L stays", example_moments.asDiagonal(), example_omega,
                   euler_equations(example_moments, example_omega, Vector3d::Zero()));
  exercise.random("a random body", 10, [](Random& random) {
    const Matrix3d I = random.inertia_tensor();
    return TensorOmegaVector{I, random.vector(2.0), random.vector(4.0)};
  });
  exercise.scale([](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) {
    return I.norm() * std::max(omega.squaredNorm() + rate.norm(), 1e-3);
  });

  exercise.misconception("body_rate_only",
                         "You return I dω/dt, the rate seen from the body; in the inertial frame the tensor turns too, "
                         "and ω × L is added.",
                         "euler_equations_rate",
                         [](const Matrix3d& I, const Vector3d&, const Vector3d& rate) -> Vector3d { return I * rate; });
  exercise.misconception(
      "sign", "The sign of ω × L is wrong: (d/dt) in the inertial frame is (d/dt) in the body *plus* ω×.",
      "euler_equations_rate", [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
        return I * rate - cross_of(omega, I * omega);
      });
  exercise.misconception("cross_of_rate", "You return ω × (I dω/dt); the two summands are I dω/dt and ω × (Iω).",
                         "euler_equations_rate",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
                           return cross_of(omega, I * rate);
                         });
  exercise.misconception("cross_of_rate_added", "You add ω × (I dω/dt); what ω crosses is L = Iω itself.",
                         "euler_equations_rate",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
                           return I * rate + cross_of(omega, I * rate);
                         });
  exercise.misconception(
      "turning_only", "You return ω × L; when ω changes too, I dω/dt is added.", "euler_equations_rate",
      [](const Matrix3d& I, const Vector3d& omega, const Vector3d&) -> Vector3d { return cross_of(omega, I * omega); });
  exercise.misconception("diagonal_only", products_do_not_enter, "euler_equations_general",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
                           return angular_momentum_rate(diagonal_part(I), omega, rate);
                         });
  exercise.misconception("products_flipped", products_sign, "euler_equations_general",
                         [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
                           return angular_momentum_rate(products_flipped(I), omega, rate);
                         });
  exercise.misconception(
      "tensor_rate_doubled", "The turning of the axes is counted twice: ω × L enters with the factor 1, not 2.",
      "euler_equations_rate", [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
        return I * rate + 2 * cross_of(omega, I * omega);
      });
  exercise.misconception(
      "rate_crossed", "You take dω/dt × L; the axes turn with ω, so it is ω × L that is added to I dω/dt.",
      "euler_equations_rate", [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
        return I * rate + cross_of(rate, I * omega);
      });

  exercise.term("I dω/dt", 1.0,
                [](const Matrix3d& I, const Vector3d&, const Vector3d& rate) -> Vector3d { return I * rate; });
  exercise.term("ω × L", 1.0, [](const Matrix3d& I, const Vector3d& omega, const Vector3d&) -> Vector3d {
    return cross_of(omega, I * omega);
  });

  exercise.route("the tensor's own rate, [ω]I − I[ω]",
                 [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
                   const Matrix3d cross = cross_matrix_of(omega);
                   return I * rate + (cross * I - I * cross) * omega;
                 });
  exercise.route("on principal axes, as on the slides",
                 [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
                   const PrincipalFrame frame(I);
                   const Vector3d body_rate = frame.moments.cwiseProduct(frame.axes.transpose() * rate);
                   return frame.axes * (body_rate + gyration(frame.moments, frame.axes.transpose() * omega));
                 });
  exercise.route("the torque that does it",
                 [](const Matrix3d& I, const Vector3d& omega, const Vector3d& rate) -> Vector3d {
                   // Euler's equations are linear in the torque: solve them for the torque that gives this rate.
                   const Vector3d without = euler_equations_general(I, omega, Vector3d::Zero());
                   return I * (rate - without);
                 });

  exercise.sweep({"The four masses at ω = (0.3, −0.2, 0.5) rad/s, speeded up along ω", "rate of |ω| (rad/s²)",
                  "component of dL/dt (N m)"},
                 {-1, 1},
                 [](double rate) {
                   return TensorOmegaVector{tensor_of_four_masses(), example_omega, rate * example_omega.normalized()};
                 },
                 {{"x", 0, 0}, {"y", 1, 0}, {"z", 2, 0}});
}

void describe_rotation_invariants(Lecture& lecture) {
  auto& exercise = lecture.exercise("rotation_invariants", &rotation_invariants);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega", units::radian_per_second)
      .result("invariants", std::vector<Unit>{units::joule, units::angular_momentum * units::angular_momentum});

  exercise.worked("moments 1, 2, 3", example_moments, example_omega);
  exercise.special("rotation about a principal axis", example_moments, Vector3d(0, 0, -2));
  exercise.special("a sphere", Vector3d(2, 2, 2), example_omega);
  exercise.special("no rotation", example_moments, Vector3d::Zero());
  exercise.random("a random body", 10, [](Random& random) {
    const Vector3d I = random.principal_moments();
    return MomentsAndOmega{I, random.vector(2.0)};
  });
  exercise.scales([](const Vector3d& I, const Vector3d& omega) {
    const double speed_squared = std::max(omega.squaredNorm(), 1e-3);
    return std::vector<double>{I.maxCoeff() * speed_squared / 2, I.cwiseAbs2().maxCoeff() * speed_squared};
  });

  exercise.misconception("twice_the_energy",
                         "Your second number is Σ I ω² = 2T; L² = Σ I² ω² takes each moment squared.",
                         "euler_equations_invariants", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
                           return {rotation_invariants(I, omega)[0], I.dot(omega.cwiseAbs2())};
                         });
  exercise.misconception("no_half", "The factor ½ of the kinetic energy is missing: T = ½ Σ I ω².",
                         "euler_equations_invariants", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
                           return {I.dot(omega.cwiseAbs2()), rotation_invariants(I, omega)[1]};
                         });
  exercise.misconception("root", "Your second number is the length L; its square L² is asked for.",
                         "euler_equations_invariants", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
                           return {rotation_invariants(I, omega)[0], I.cwiseProduct(omega).norm()};
                         });
  exercise.misconception(
      "exchanged", "The two numbers are exchanged: T comes first, then L².", "euler_equations_invariants",
      [](const Vector3d& I, const Vector3d& omega) -> Vector2d { return rotation_invariants(I, omega).reverse(); });
  exercise.misconception("square_of_sum", "You square the sum of the components of L; L² is the sum of their squares.",
                         "euler_equations_invariants", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
                           return {rotation_invariants(I, omega)[0], std::pow(I.dot(omega), 2)};
                         });
  exercise.misconception("half_of_square", "There is no ½ in L² = Σ I² ω²; only T has one.",
                         "euler_equations_invariants", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
                           const Vector2d right = rotation_invariants(I, omega);
                           return {right[0], right[1] / 2};
                         });
  exercise.misconception("neither_square_nor_half",
                         "You give 2T and the length L; asked for are T = ½ Σ I ω² and L² = Σ I² ω².",
                         "euler_equations_invariants", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
                           return {I.dot(omega.cwiseAbs2()), I.cwiseProduct(omega).norm()};
                         });
  exercise.misconception("energy_from_momentum_squared",
                         "Your T is L²/2, with the moments squared; T = ½ Σ I ω² takes each moment once.",
                         "euler_equations_invariants", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
                           const double square = I.cwiseProduct(omega).squaredNorm();
                           return {square / 2, square};
                         });
  exercise.misconception("moments_dropped_once", "Your T is ½ Σ ω², without the moments; T = ½ Σ I ω².",
                         "euler_equations_invariants", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
                           return {omega.squaredNorm() / 2, rotation_invariants(I, omega)[1]};
                         });

  exercise.term("Σ I ω² in T", 0.5, [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
    return {I.dot(omega.cwiseAbs2()), 0};
  });
  exercise.term("Σ I² ω² in L²", 1.0, [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
    return {0, I.cwiseProduct(omega).squaredNorm()};
  });
  exercise.property(PropertyKind::nonnegative, "Neither a kinetic energy nor a square is negative.",
                    "euler_equations_invariants");

  exercise.route("with the whole tensor", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
    const Matrix3d tensor = I.asDiagonal();
    return {0.5 * omega.transpose() * tensor * omega, omega.transpose() * tensor * tensor * omega};
  });
  exercise.route("component by component", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
    Vector2d sums = Vector2d::Zero();
    for (int i = 2; i >= 0; --i) {
      sums[0] += I[i] * std::pow(omega[i], 2) / 2;
      sums[1] += std::pow(I[i] * omega[i], 2);
    }
    return sums;
  });
  exercise.route("from L alone", [](const Vector3d& I, const Vector3d& omega) -> Vector2d {
    const Vector3d L = I.cwiseProduct(omega);
    return {L.cwiseQuotient(I).dot(L) / 2, L.dot(L)};
  });

  exercise.sweep({"A body with moments 1, 2, 3 kg m², ω turned from axis 1 to axis 3, |ω| = 1 rad/s",
                  "angle of ω from axis 1 (rad)", "T (J), L² (kg² m⁴/s²)"},
                 {0, 1.5707963267948966},
                 [](double angle) {
                   return MomentsAndOmega{example_moments, Vector3d(std::cos(angle), 0, std::sin(angle))};
                 },
                 {{"T", 0, 0}, {"L²", 1, 0}});
}

// ---- free_rotation --------------------------------------------------------------------------------------------------

using Rate = std::function<Vector3d(const Vector3d&)>;

/// The times from 0 outwards, so that an integration passes each stretch once.
std::vector<Eigen::Index> outwards(const VectorXd& times) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(times.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto j, auto k) { return std::abs(times[j]) < std::abs(times[k]); });
  return order;
}

/// A quantity followed by the classical Runge-Kutta method with steps of at most `longest`, in both directions of time.
template <class State, class RateOf>
std::vector<State> runge_kutta(const State& start, const VectorXd& times, double longest, const RateOf& rate) {
  std::vector<State> states(static_cast<std::size_t>(times.size()), start);
  for (const double direction : {1.0, -1.0}) {
    State state = start;
    double now = 0;
    for (const Eigen::Index k : outwards(times)) {
      if ((times[k] >= 0) != (direction > 0)) continue;
      const int steps = 1 + static_cast<int>(std::abs(times[k] - now) / longest);
      const double h = (times[k] - now) / steps;
      for (int i = 0; i < steps; ++i) {
        const State k1 = rate(state);
        const State k2 = rate(state + h / 2 * k1);
        const State k3 = rate(state + h / 2 * k2);
        const State k4 = rate(state + h * k3);
        state += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      }
      now = times[k];
      states[static_cast<std::size_t>(k)] = state;
    }
  }
  return states;
}

Matrix3Xd in_columns(const std::vector<Vector3d>& vectors) {
  Matrix3Xd columns(3, static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t k = 0; k < vectors.size(); ++k) columns.col(static_cast<Eigen::Index>(k)) = vectors[k];
  return columns;
}

/// The free motion under another rate than the right one, integrated well.
Matrix3Xd follow(const Vector3d& omega0, const VectorXd& times, const Rate& rate) {
  return in_columns(runge_kutta(omega0, times, 0.01, rate));
}

/// One step of the explicit Euler method from each given time to the next, the first one from `start`.
Matrix3Xd euler_steps(const Vector3d& I, const Vector3d& omega0, const VectorXd& times, double start) {
  Matrix3Xd omega(3, times.size());
  Vector3d state = omega0;
  double now = start;
  for (Eigen::Index k = 0; k < times.size(); ++k) {
    state += (times[k] - now) * euler_equations(I, state, Vector3d::Zero());
    now = times[k];
    omega.col(k) = state;
  }
  return omega;
}

VectorXd sorted(VectorXd times) {
  std::sort(times.begin(), times.end());
  return times;
}

/// Times in no order, of both signs, none of them a whole number, neighbours and zero kept apart.
VectorXd scattered_times(Random& random, int count, double longest) {
  VectorXd times(count);
  for (int k = 0; k < count; ++k) {
    const double share = (k + random.uniform(0.3, 0.7)) / count;
    times[k] = longest * share * (k % 2 == 0 ? 1 : -1);
  }
  for (int k = count - 1; k > 0; --k) std::swap(times[k], times[random.whole(0, k)]);
  return times;
}

void describe_free_rotation(Lecture& lecture) {
  // The expected numbers are exact: elliptic functions, no integration.
  auto& exercise = lecture.exercise("free_rotation", &exact_free_rotation);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega0", units::radian_per_second)
      .argument("times", units::second)
      .result("omega", units::radian_per_second);

  const Vector3d omega0(0.1, 1, 0.1);
  exercise.worked("moments 1, 2, 3 after 20 s", example_moments, omega0, VectorXd{{20.0}});
  exercise.worked("moments 1, 2, 3, a faster start", example_moments, Vector3d(1, 0.5, 0.25),
                  VectorXd{{5.0, 10.0, 20.0}});
  exercise.special("no times", example_moments, omega0, VectorXd(0));
  exercise.special("time 0", example_moments, omega0, VectorXd{{0.0}});
  exercise.special("only the past", example_moments, omega0, VectorXd{{-3.0, -8.0}});
  exercise.special("the same time twice", example_moments, omega0, VectorXd{{4.0, 4.0, -1.0, 4.0}});
  exercise.special("a sphere", Vector3d(2, 2, 2), example_omega, VectorXd{{-5.0, 1.0, 10.0}});
  exercise.special("a symmetric body", Vector3d(1, 1, 1.8), Vector3d(0.4, 0, 2), VectorXd{{0.7, 3.0, -2.0}});
  exercise.special("a symmetric body, its axis first", Vector3d(0.6, 1, 1), Vector3d(1.5, -0.3, 0.8),
                   VectorXd{{6.0, -6.0}});
  exercise.special("rotation about the middle axis", example_moments, Vector3d(0, 1, 0), VectorXd{{2.0, 9.0}});
  exercise.special("no rotation", example_moments, Vector3d::Zero(), VectorXd{{1.0, 2.0}});
  exercise.special("almost about the middle axis", example_moments, Vector3d(0, 1, 1e-3), VectorXd{{10.0, 14.0, 20.0}});
  exercise.special("on the separatrix", Vector3d(3, 5, 6), Vector3d(0.5, 0.25, 0.5), VectorXd{{-4.0, 4.0, 8.0}});
  exercise.special("two moments nearly equal", Vector3d(1, 1 + 1e-7, 1.5), Vector3d(0.3, 0.5, 0.8),
                   VectorXd{{3.0, 12.0}});
  exercise.random("times in no order", 6, [](Random& random) {
    const Vector3d I = random.principal_moments();
    const Vector3d start = random.vector(1.5);
    return FreeMotion{I, start, scattered_times(random, 4, 4.0)};
  });
  exercise.random("a longer run", 3, [](Random& random) {
    const Vector3d I = random.principal_moments();
    const Vector3d start = random.vector(0.8);
    return FreeMotion{I, start, sorted(scattered_times(random, 4, 14.0).cwiseAbs())};
  });
  exercise.tolerance(
      1e-6,
      "The answer is integrated in steps: a method of fourth order with steps of some hundredths of a second stays "
      "within a millionth of the exact solution by elliptic functions.");
  exercise.scale([](const Vector3d&, const Vector3d& start, const VectorXd&) { return std::max(start.norm(), 1e-3); });

  exercise.misconception("given_times_as_steps",
                         "You take one explicit Euler step from each time to the next; the times are moments, and "
                         "between them the integration needs many small steps.",
                         "euler_equations_free",
                         [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
                           return euler_steps(I, start, times, 0.0);
                         });
  exercise.misconception(
      "one_step_each",
      "You reach each time by one explicit Euler step from ω at t = 0; between them the integration needs many small "
      "steps.",
      "euler_equations_free", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        return start.replicate(1, times.size()) + euler_equations(I, start, Vector3d::Zero()) * times.transpose();
      });
  exercise.misconception(
      "sign_of_gyration",
      "The motion runs backwards: the sign of ω × (Iω) is wrong, for a free body I dω/dt = −ω × (Iω).",
      "euler_equations_rate", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        return exact_free_rotation(I, start, -times);
      });
  exercise.misconception("no_motion", "Every column repeats omega0: without a torque L is constant, but ω is not.",
                         "euler_equations_free",
                         [](const Vector3d&, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
                           return start.replicate(1, times.size());
                         });
  exercise.misconception(
      "times_count_steps", "You take the times as numbers of steps of 0.01 s; they are moments in seconds.",
      "euler_equations_free", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        return exact_free_rotation(I, start, 0.01 * times);
      });
  exercise.misconception(
      "whole_seconds", "You cut the times to whole numbers; they are moments in seconds, fractions included.",
      "euler_equations_free", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        return exact_free_rotation(I, start, times.array().unaryExpr([](double t) { return std::trunc(t); }).matrix());
      });
  exercise.misconception("column_numbers", "Your column k holds ω at k seconds; it should hold ω at times[k].",
                         "euler_equations_free",
                         [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
                           VectorXd numbers(times.size());
                           std::iota(numbers.begin(), numbers.end(), 0.0);
                           return exact_free_rotation(I, start, numbers);
                         });
  exercise.misconception(
      "sorted", "Your columns follow the times in ascending order; they are asked for in the order given.",
      "euler_equations_free", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        return exact_free_rotation(I, start, sorted(times));
      });
  exercise.misconception("no_past", "You run negative times forwards; at t = −3 s the body was where it came from.",
                         "euler_equations_free",
                         [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
                           return exact_free_rotation(I, start, times.cwiseAbs());
                         });
  exercise.misconception(
      "past_not_run",
      "At negative times you give back omega0; the integration runs into the past as well, with negative steps.",
      "euler_equations_free", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        return exact_free_rotation(I, start, times.cwiseMax(0.0));
      });
  exercise.misconception(
      "starts_at_first_time", "You let omega0 belong to the first of the times; it belongs to t = 0.",
      "euler_equations_free", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        if (times.size() == 0) return Matrix3Xd(3, 0);
        return exact_free_rotation(I, start, (times.array() - times[0]).matrix());
      });
  exercise.misconception("each_from_the_last",
                         "You run each column from the one before by the whole of times[k]; only the difference of the "
                         "two times is left to run.",
                         "euler_equations_free",
                         [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
                           VectorXd sums(times.size());
                           std::partial_sum(times.begin(), times.end(), sums.begin());
                           return exact_free_rotation(I, start, sums);
                         });
  exercise.misconception(
      "not_divided", "Your rate is −ω × (Iω) without the division by the moments: that is I dω/dt, not dω/dt.",
      "euler_equations_principal", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        return follow(start, times,
                      [&](const Vector3d& omega) -> Vector3d { return -cross_of(omega, I.cwiseProduct(omega)); });
      });
  exercise.misconception(
      "indices_shifted",
      "The differences of moments are shifted by one place: with ω₂ω₃ goes I₃ − I₂, the two indices of the product.",
      "euler_equations_principal", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        return follow(start, times, [&](const Vector3d& omega) -> Vector3d {
          return -gyration_with_shifted_differences(I, omega).cwiseQuotient(I);
        });
      });
  exercise.misconception("momentum_returned", "Your columns hold L = Iω; asked for is ω.", "euler_equations_free",
                         [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
                           return I.asDiagonal() * exact_free_rotation(I, start, times);
                         });

  exercise.conserves("In free rotation the kinetic energy keeps its value from t = 0: Σ Iᵢωᵢ² stays the same.",
                     "euler_equations_invariants", [](const Vector3d& I, const Vector3d&, const VectorXd&) {
                       return std::vector<double>(I.begin(), I.end());
                     });
  exercise.conserves("In free rotation L keeps its length from t = 0: Σ Iᵢ²ωᵢ² stays the same.",
                     "euler_equations_invariants", [](const Vector3d& I, const Vector3d&, const VectorXd&) {
                       const Vector3d squares = I.cwiseAbs2();
                       return std::vector<double>(squares.begin(), squares.end());
                     });

  exercise.route("a controlled integration of high order", &free_rotation);
  exercise.route("the classical Runge-Kutta method",
                 [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
                   return follow(start, times, [&](const Vector3d& omega) -> Vector3d {
                     return euler_equations(I, omega, Vector3d::Zero());
                   });
                 });
  exercise.route(
      "L in the body, then divided", [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
        const Vector3d L0 = I.cwiseProduct(start);
        const Matrix3Xd L = follow(
            L0, times, [&](const Vector3d& momentum) -> Vector3d { return momentum.cross(momentum.cwiseQuotient(I)); });
        return I.cwiseInverse().asDiagonal() * L;
      });
  exercise.route("the attitude, with L at rest in space",
                 [](const Vector3d& I, const Vector3d& start, const VectorXd& times) -> Matrix3Xd {
                   // A quaternion follows the body; ω is read off the constant L on the body's axes.
                   using Coefficients = Eigen::Vector4d;  // x, y, z, w
                   const Vector3d L = I.cwiseProduct(start);
                   const auto omega_at = [&](const Coefficients& q) -> Vector3d {
                     return (Eigen::Quaterniond(q).normalized().conjugate() * L).cwiseQuotient(I);
                   };
                   const auto attitudes =
                       runge_kutta(Coefficients(0, 0, 0, 1), times, 0.01, [&](const Coefficients& q) -> Coefficients {
                         const Vector3d half = omega_at(q) / 2;
                         return (Eigen::Quaterniond(q) * Eigen::Quaterniond(0, half.x(), half.y(), half.z())).coeffs();
                       });
                   Matrix3Xd omega(3, times.size());
                   for (Eigen::Index k = 0; k < times.size(); ++k)
                     omega.col(k) = omega_at(attitudes[static_cast<std::size_t>(k)]);
                   return omega;
                 });

  exercise.sweep({"Free rotation with moments 1, 2, 3 kg m² from ω = (0.1, 1, 0.1) rad/s", "time (s)",
                  "body component of ω (rad/s)"},
                 {-5, 25, 91},
                 [omega0](double t) {
                   return FreeMotion{example_moments, omega0, VectorXd::Constant(1, t)};
                 },
                 {{"ω_1", 0, 0}, {"ω_2", 1, 0}, {"ω_3", 2, 0}});
}

}  // namespace

void workbook::judging::describe(Lecture& lecture) {
  describe_angular_momentum_rate(lecture);
  describe_euler_equations(lecture);
  describe_euler_equations_general(lecture);
  describe_torque_to_hold_rotation(lecture);
  describe_rotation_invariants(lecture);
  describe_free_rotation(lecture);
}
