/// @file
/// How the exercises of lecture 08 are judged.
#include "rigid/kinetic_energy.hpp"
#include "solutions/judging/lecture.hpp"

#include <boost/math/differentiation/autodiff.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>

namespace {

using namespace rigid;
using namespace workbook;
using namespace workbook::judging;

using Complex = std::complex<double>;
using Motion = std::tuple<Vector3d, Vector3d, Vector3d>;
using SymmetricMotion = std::tuple<double, double, double, Vector3d>;

constexpr double pi = std::numbers::pi;

// One mistake, one sentence: these serve several exercises.
constexpr const char* moments_exchanged =
    "Your first two moments stand at each other's component of ω: this happens with z–x–z angles, and when I₁ and I₂ "
    "are exchanged.";
constexpr const char* phi_for_psi =
    "φ stands where ψ belongs: how the body's axes 1 and 2 lie is told by ψ, and φ does not enter.";
constexpr const char* treated_as_symmetric =
    "I₂ does not enter: I₁ stands in both places, which is right only for a symmetric top.";
constexpr const char* mixed_signs =
    "The mixed terms in φ̇ θ̇ have the wrong sign, as if θ or ψ were counted the other way round.";

/// E in ω = E q̇: the axes of φ̇, θ̇ and ψ̇ as columns, in body components.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> rate_axes(const Eigen::Matrix<Scalar, 3, 1>& angles) {
  const Scalar s = std::sin(angles[1]), c = std::cos(angles[1]), s_psi = std::sin(angles[2]),
               c_psi = std::cos(angles[2]);
  Eigen::Matrix<Scalar, 3, 3> E;
  E << -s * c_psi, s_psi, 0, s * s_psi, c_psi, 0, c, 0, 1;
  return E;
}

Vector3d omega_body(const Vector3d& angles, const Vector3d& rates) { return rate_axes(angles) * rates; }

/// A in V_inertial = A V_body.
Matrix3d attitude(const Vector3d& angles) {
  return (Eigen::AngleAxisd(angles[0], Vector3d::UnitZ()) * Eigen::AngleAxisd(angles[1], Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles[2], Vector3d::UnitZ()))
      .toRotationMatrix();
}

/// The matrix of the energy: T = ½ q̇·M q̇, p = M q̇.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> mass_matrix(const Vector3d& I, const Eigen::Matrix<Scalar, 3, 1>& angles) {
  const Eigen::Matrix<Scalar, 3, 3> E = rate_axes(angles);
  return E.transpose() * I.cast<Scalar>().asDiagonal() * E;
}

/// Derivative of a matrix of the angles while they change at the given rates, by a complex step: exact to rounding.
template <class Function>
Matrix3d derivative_along(const Function& matrix_of, const Vector3d& angles, const Vector3d& rates) {
  constexpr double step = 1e-100;
  const Eigen::Vector3cd ahead = angles.cast<Complex>() + Complex(0, step) * rates.cast<Complex>();
  return Eigen::Matrix3cd(matrix_of(ahead)).imag() / step;
}

Matrix3d rate_axes_derivative(const Vector3d& angles, const Vector3d& rates) {
  return derivative_along([](const Eigen::Vector3cd& q) -> Eigen::Matrix3cd { return rate_axes(q); }, angles, rates);
}

Matrix3d mass_matrix_derivative(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
  return derivative_along([&I](const Eigen::Vector3cd& q) -> Eigen::Matrix3cd { return mass_matrix(I, q); }, angles,
                          rates);
}

/// ∂T/∂q.
Vector3d energy_gradient(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
  Vector3d gradient;
  for (int i = 0; i < 3; ++i)
    gradient[i] = 0.5 * rates.dot(mass_matrix_derivative(I, angles, Vector3d::Unit(i)) * rates);
  return gradient;
}

Vector3d free_omega_rate(const Vector3d& I, const Vector3d& omega) {
  return I.cwiseProduct(omega).cross(omega).cwiseQuotient(I);
}

Vector3d exchanged(const Vector3d& I) { return {I[1], I[0], I[2]}; }
Vector3d equal_first_two(const Vector3d& I) { return {I[0], I[0], I[2]}; }
Vector3d phi_in_place_of_psi(const Vector3d& angles) { return {angles[2], angles[1], angles[0]}; }
Vector3d theta_negated(const Vector3d& angles) { return {angles[0], -angles[1], angles[2]}; }

/// z–x–z: body components of ω when the line of nodes is the new x axis.
Vector3d omega_body_zxz(const Vector3d& angles, const Vector3d& rates) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), s_psi = std::sin(angles[2]),
               c_psi = std::cos(angles[2]);
  return {rates[0] * s * s_psi + rates[1] * c_psi, rates[0] * s * c_psi - rates[1] * s_psi, rates[0] * c + rates[2]};
}

double energy(const Vector3d& I, const Vector3d& omega) { return 0.5 * I.dot(omega.cwiseAbs2()); }

/// T of the slides for any kind of number, so that it can be differentiated automatically.
template <class Number>
Number energy_formula(const Vector3d& I, const std::array<Number, 3>& q, const std::array<Number, 3>& v) {
  const Number first = -v[0] * sin(q[1]) * cos(q[2]) + v[1] * sin(q[2]);
  const Number second = v[0] * sin(q[1]) * sin(q[2]) + v[1] * cos(q[2]);
  const Number third = v[0] * cos(q[1]) + v[2];
  return 0.5 * (I[0] * first * first + I[1] * second * second + I[2] * third * third);
}

/// d/dt ∂T/∂q̇ − ∂T/∂q at constant rates, all by automatic differentiation.
Vector3d euler_lagrange_at_constant_rates(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
  using namespace boost::math::differentiation;
  const auto variables = make_ftuple<double, 1, 1>(0.0, 0.0);
  const auto& time = std::get<0>(variables);
  const auto& step = std::get<1>(variables);
  using Number = std::remove_cvref_t<decltype(time * step)>;
  Vector3d residual;
  for (int i = 0; i < 3; ++i) {
    std::array<Number, 3> q, q_stepped, v, v_stepped;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = static_cast<Eigen::Index>(k);
      const double here = index == i ? 1.0 : 0.0;
      q[k] = angles[index] + rates[index] * time;
      v[k] = rates[index];
      q_stepped[k] = angles[index] + here * step;
      v_stepped[k] = rates[index] + here * step;
    }
    residual[i] = energy_formula(I, q, v_stepped).derivative(1, 1) - energy_formula(I, q_stepped, v).derivative(0, 1);
  }
  return residual;
}

template <class Exercise>
void add_arguments(Exercise& exercise) {
  exercise.argument("I", units::moment_of_inertia)
      .argument("angles", units::radian)
      .argument("rates", units::radian_per_second);
}

Motion random_motion(Random& random) { return {random.principal_moments(), random.euler_angles(), random.vector(2.0)}; }

const Vector3d lecture_angles(0.3, 0.7, 1.1);
const Vector3d lecture_rates(0.5, -0.2, 0.9);

void describe_kinetic_energy_euler(Lecture& lecture) {
  auto& exercise = lecture.exercise("kinetic_energy_euler", &kinetic_energy_euler);
  add_arguments(exercise);
  exercise.result("T", units::joule);

  exercise.worked("moments 1, 2, 3 and the angles of the lecture", Vector3d(1, 2, 3), lecture_angles, lecture_rates);
  exercise.special("a symmetric top", Vector3d(1, 1, 3), lecture_angles, lecture_rates).blind();
  exercise.special("no nutation", Vector3d(1, 2, 3), lecture_angles, Vector3d(0.5, 0, 0.9)).blind();
  exercise.special("upright, θ = 0", Vector3d(1, 2, 2.5), Vector3d(0.4, 0, 1.1), Vector3d(0.5, -0.2, 0.9)).blind();
  exercise.special("upside down, θ = π", Vector3d(1, 2, 2.5), Vector3d(0.4, pi, 1.1), Vector3d(0.5, -0.2, 0.9)).blind();
  exercise
      .special("spin about the vertical undone, φ̇ = −ψ̇ at θ = 0", Vector3d(1, 2, 2.5), Vector3d(0.4, 0, 1.1),
               Vector3d(0.5, 0, -0.5))
      .blind();
  exercise.special("at rest", Vector3d(1, 2, 3), lecture_angles, Vector3d::Zero()).blind();
  exercise.random("a random body and motion", 16, random_motion);
  exercise.scale([](const Vector3d& I, const Vector3d&, const Vector3d& rates) {
    return 0.5 * I.maxCoeff() * std::max(rates.squaredNorm(), 1e-3);
  });

  exercise.misconception(
      "no_half", "The factor ½ is missing: T = ½ Σ Iᵢ ω̃ᵢ².", "kinetic_energy_angles",
      [](const Vector3d& I, const Vector3d& q, const Vector3d& v) { return 2 * kinetic_energy_euler(I, q, v); });
  exercise.misconception(
      "zxz_angles", moments_exchanged, "kinetic_energy_conventions",
      [](const Vector3d& I, const Vector3d& q, const Vector3d& v) { return energy(I, omega_body_zxz(q, v)); });
  exercise.misconception(
      "moments_exchanged", moments_exchanged, "kinetic_energy_conventions",
      [](const Vector3d& I, const Vector3d& q, const Vector3d& v) { return kinetic_energy_euler(exchanged(I), q, v); });
  exercise.misconception("rates_as_components",
                         "You take the rates for the components of ω; they turn the body about ê3⁰, ê2' and ê3, which "
                         "are not the body's axes.",
                         "kinetic_energy_angles",
                         [](const Vector3d& I, const Vector3d&, const Vector3d& v) { return energy(I, v); });
  exercise.misconception(
      "spin_and_precession_apart",
      "The term I₃ φ̇ ψ̇ cos θ is missing: φ̇ cos θ and ψ̇ add up along the body's axis before they are squared.",
      "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
        return kinetic_energy_euler(I, q, v) - I[2] * v[0] * v[2] * std::cos(q[1]);
      });
  exercise.misconception("spin_only", "Your third component is ψ̇ alone; the precession adds φ̇ cos θ to it.",
                         "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           Vector3d omega = omega_body(q, v);
                           omega[2] = v[2];
                           return energy(I, omega);
                         });
  exercise.misconception("nutation_and_precession_apart",
                         "The mixed terms in φ̇ θ̇ are missing: (a + b)² is more than a² + b².", "kinetic_energy_angles",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           return kinetic_energy_euler(I, q, v) -
                                  (I[1] - I[0]) * v[0] * v[1] * std::sin(q[1]) * std::sin(q[2]) * std::cos(q[2]);
                         });
  exercise.misconception("no_mixed_terms",
                         "All products of two different rates are missing: (a + b)² is more than a² + b².",
                         "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           return 0.5 * mass_matrix(I, q).diagonal().dot(v.cwiseAbs2());
                         });
  exercise.misconception("symmetric_formula", treated_as_symmetric, "kinetic_energy_symmetric_top",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           return kinetic_energy_euler(equal_first_two(I), q, v);
                         });
  exercise.misconception("first_sign",
                         "The two summands of your ω̃₁ have the wrong relative sign: it is −φ̇ sin θ cos ψ + θ̇ sin ψ.",
                         "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           Vector3d omega = omega_body(q, v);
                           omega[0] = v[0] * std::sin(q[1]) * std::cos(q[2]) + v[1] * std::sin(q[2]);
                           return energy(I, omega);
                         });
  exercise.misconception("second_sign",
                         "The two summands of your ω̃₂ have the wrong relative sign: it is φ̇ sin θ sin ψ + θ̇ cos ψ.",
                         "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           Vector3d omega = omega_body(q, v);
                           omega[1] = -v[0] * std::sin(q[1]) * std::sin(q[2]) + v[1] * std::cos(q[2]);
                           return energy(I, omega);
                         });
  exercise.misconception("mixed_signs", mixed_signs, "kinetic_energy_angles",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           return kinetic_energy_euler(I, theta_negated(q), v);
                         });
  exercise.misconception("sine_and_cosine_of_psi", "sin ψ and cos ψ are exchanged in your ω̃₁ and ω̃₂.",
                         "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           return kinetic_energy_euler(I, Vector3d(q[0], q[1], pi / 2 - q[2]), v);
                         });
  exercise.misconception("inertial_components",
                         "φ and ψ have changed places in your ω, as they do in its inertial components; the principal "
                         "moments need components on the body's axes.",
                         "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           return energy(I, attitude(q) * omega_body(q, v));
                         });
  exercise.misconception("phi_for_psi", phi_for_psi, "kinetic_energy_angles",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           return kinetic_energy_euler(I, phi_in_place_of_psi(q), v);
                         });
  exercise.misconception("rates_exchanged", "The rates of φ and ψ are exchanged; they come as (φ̇, θ̇, ψ̇).",
                         "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           return kinetic_energy_euler(I, q, Vector3d(v[2], v[1], v[0]));
                         });
  exercise.misconception(
      "sine_of_theta_lost",
      "φ̇ enters ω̃₁ and ω̃₂ without sin θ: only that part of the precession lies across the body's axis.",
      "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
        Vector3d omega = omega_body(Vector3d(q[0], pi / 2, q[2]), v);
        omega[2] = v[0] * std::cos(q[1]) + v[2];
        return energy(I, omega);
      });
  exercise.misconception("sine_and_cosine_of_theta", "sin θ and cos θ are exchanged in your ω.",
                         "kinetic_energy_angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
                           return kinetic_energy_euler(I, Vector3d(q[0], pi / 2 - q[1], q[2]), v);
                         });
  exercise.angles_read_as_degrees("kinetic_energy_angles");

  const auto summand = [&exercise](const char* name, double coefficient, auto function) {
    exercise.term(name, coefficient, [function](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
      return function(I, v, std::sin(q[1]), std::cos(q[1]), std::sin(q[2]), std::cos(q[2]));
    });
  };
  using V = const Vector3d&;
  summand("I₁ φ̇² sin²θ cos²ψ", 0.5,
          [](V I, V v, double s, double, double, double cp) { return I[0] * v[0] * v[0] * s * s * cp * cp; });
  summand("I₁ φ̇ θ̇ sin θ sin ψ cos ψ", -1,
          [](V I, V v, double s, double, double sp, double cp) { return I[0] * v[0] * v[1] * s * sp * cp; });
  summand("I₁ θ̇² sin²ψ", 0.5, [](V I, V v, double, double, double sp, double) { return I[0] * v[1] * v[1] * sp * sp; });
  summand("I₂ φ̇² sin²θ sin²ψ", 0.5,
          [](V I, V v, double s, double, double sp, double) { return I[1] * v[0] * v[0] * s * s * sp * sp; });
  summand("I₂ φ̇ θ̇ sin θ sin ψ cos ψ", 1,
          [](V I, V v, double s, double, double sp, double cp) { return I[1] * v[0] * v[1] * s * sp * cp; });
  summand("I₂ θ̇² cos²ψ", 0.5, [](V I, V v, double, double, double, double cp) { return I[1] * v[1] * v[1] * cp * cp; });
  summand("I₃ φ̇² cos²θ", 0.5, [](V I, V v, double, double c, double, double) { return I[2] * v[0] * v[0] * c * c; });
  summand("I₃ φ̇ ψ̇ cos θ", 1, [](V I, V v, double, double c, double, double) { return I[2] * v[0] * v[2] * c; });
  summand("I₃ ψ̇²", 0.5, [](V I, V v, double, double, double, double) { return I[2] * v[2] * v[2]; });
  exercise.property(PropertyKind::nonnegative, "A kinetic energy is never negative.", "kinetic_energy_angles");

  exercise.route("half of p·q̇", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
    return canonical_momenta(I, q, v).dot(v) / 2;
  });
  exercise.route("on inertial axes", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
    const Matrix3d A = attitude(q);
    const Vector3d node(-std::sin(q[0]), std::cos(q[0]), 0);
    const Vector3d omega = v[0] * Vector3d::UnitZ() + v[1] * node + v[2] * A.col(2);
    return 0.5 * omega.dot(A * I.asDiagonal() * A.transpose() * omega);
  });
  exercise.route("from the turning matrix", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
    // Aᵀ dA/dt is the cross matrix of ω̃; each factor of A is differentiated in its turn.
    const auto about = [](double angle, const Vector3d& axis) -> Matrix3d {
      return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    };
    const auto cross = [](const Vector3d& w) -> Matrix3d {
      return Matrix3d{{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}};
    };
    const Vector3d y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    const Matrix3d first = about(q[0], z), second = about(q[1], y), third = about(q[2], z);
    const Matrix3d A_rate =
        first *
        (v[0] * cross(z) * second + v[1] * second * cross(y) + v[2] * second * third * cross(z) * third.transpose()) *
        third;
    const Matrix3d W = (first * second * third).transpose() * A_rate;
    return energy(I, Vector3d(W(2, 1), W(0, 2), W(1, 0)));
  });
  exercise.route("by way of z–x–z angles", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
    return energy(I, omega_body_zxz(Vector3d(q[0] + pi / 2, q[1], q[2] - pi / 2), v));
  });

  exercise.sweep(
      {"The body of moments 1, 2, 3 kg m² turns about its own axis by ψ, at constant rates", "ψ (rad)", "T (J)"},
      {0, 2 * pi},
      [](double psi) {
        return Motion{Vector3d(1, 2, 3), Vector3d(0.3, 0.7, psi), Vector3d(1.5, 0.8, 0.4)};
      },
      {{"T", 0, 0}});
}

void describe_kinetic_energy_symmetric(Lecture& lecture) {
  auto& exercise = lecture.exercise("kinetic_energy_symmetric", &kinetic_energy_symmetric);
  exercise.argument("I1", units::moment_of_inertia)
      .argument("I3", units::moment_of_inertia)
      .argument("theta", units::radian);
  exercise.argument("rates", units::radian_per_second).result("T", units::joule);

  exercise.worked("moments 2 and 3", 2, 3, 0.7, lecture_rates);
  exercise.special("a sphere", 2, 2, 0.7, lecture_rates).blind();
  exercise.special("upright, θ = 0", 2, 3, 0, lecture_rates).blind();
  exercise.special("upside down, θ = π", 2, 3, pi, lecture_rates).blind();
  exercise.special("lying, θ = π/2", 2, 3, pi / 2, lecture_rates).blind();
  exercise.special("a thin rod, I₃ = 0", 2, 0, 0.7, lecture_rates).blind();
  exercise.special("at rest", 2, 3, 0.7, Vector3d::Zero()).blind();
  exercise.random("a random top and motion", 10, [](Random& random) {
    const double I1 = random.uniform(1, 3);
    const double flatness = random.sign() > 0 ? random.uniform(1.2, 1.9) : random.uniform(0.3, 0.8);
    return SymmetricMotion{I1, flatness * I1, random.euler_angles()[1], random.vector(2.0)};
  });
  exercise.scale([](double I1, double I3, double, const Vector3d& rates) {
    return 0.5 * std::max(I1, I3) * std::max(rates.squaredNorm(), 1e-3);
  });

  const auto with = [](double across, double nutation, double along, double I1, double I3) {
    return 0.5 * I1 * (across * across + nutation * nutation) + 0.5 * I3 * along * along;
  };
  const char* notes = "kinetic_energy_symmetric_top";
  exercise.misconception("no_half", "The factor ½ is missing.", notes,
                         [](double I1, double I3, double theta, const Vector3d& v) {
                           return 2 * kinetic_energy_symmetric(I1, I3, theta, v);
                         });
  exercise.misconception("sine_forgotten", "φ̇² enters without sin²θ: only φ̇ sin θ lies across the symmetry axis.",
                         notes, [with](double I1, double I3, double theta, const Vector3d& v) {
                           return with(v[0], v[1], v[0] * std::cos(theta) + v[2], I1, I3);
                         });
  exercise.misconception("sine_not_squared", "sin θ enters once; φ̇ sin θ is squared as a whole, so it is φ̇² sin²θ.",
                         notes, [](double I1, double I3, double theta, const Vector3d& v) {
                           const double along = v[0] * std::cos(theta) + v[2];
                           return 0.5 * I1 * (v[0] * v[0] * std::sin(theta) + v[1] * v[1]) + 0.5 * I3 * along * along;
                         });
  exercise.misconception("spin_only", "Your third component is ψ̇ alone; the precession adds φ̇ cos θ to it.", notes,
                         [with](double I1, double I3, double theta, const Vector3d& v) {
                           return with(v[0] * std::sin(theta), v[1], v[2], I1, I3);
                         });
  exercise.misconception("cosine_in_first_term",
                         "cos²θ stands with φ̇² in the I₁ term; across the symmetry axis lies φ̇ sin θ.", notes,
                         [with](double I1, double I3, double theta, const Vector3d& v) {
                           return with(v[0] * std::cos(theta), v[1], v[0] * std::cos(theta) + v[2], I1, I3);
                         });
  exercise.misconception("sine_and_cosine", "sin θ and cos θ are exchanged.", notes,
                         [with](double I1, double I3, double theta, const Vector3d& v) {
                           return with(v[0] * std::cos(theta), v[1], v[0] * std::sin(theta) + v[2], I1, I3);
                         });
  exercise.misconception("cosine_forgotten",
                         "Your third component is φ̇ + ψ̇; only φ̇ cos θ of the precession lies along the symmetry axis.",
                         notes, [with](double I1, double I3, double theta, const Vector3d& v) {
                           return with(v[0] * std::sin(theta), v[1], v[0] + v[2], I1, I3);
                         });
  exercise.misconception(
      "spin_and_precession_apart",
      "The term I₃ φ̇ ψ̇ cos θ is missing: φ̇ cos θ and ψ̇ add up along the body's axis before they are squared.", notes,
      [](double I1, double I3, double theta, const Vector3d& v) {
        return kinetic_energy_symmetric(I1, I3, theta, v) - I3 * v[0] * v[2] * std::cos(theta);
      });
  exercise.misconception("spin_against_precession",
                         "φ̇ cos θ and ψ̇ are subtracted; both count in the same sense about the body's axis.", notes,
                         [with](double I1, double I3, double theta, const Vector3d& v) {
                           return with(v[0] * std::sin(theta), v[1], v[0] * std::cos(theta) - v[2], I1, I3);
                         });
  exercise.misconception(
      "moments_exchanged", "I₁ and I₃ are exchanged.", notes,
      [](double I1, double I3, double theta, const Vector3d& v) { return kinetic_energy_symmetric(I3, I1, theta, v); });
  exercise.misconception("nutation_lost", "The term ½ I₁ θ̇² is missing.", notes,
                         [with](double I1, double I3, double theta, const Vector3d& v) {
                           return with(v[0] * std::sin(theta), 0, v[0] * std::cos(theta) + v[2], I1, I3);
                         });
  exercise.misconception("sine_with_nutation", "sin²θ multiplies θ̇² too; it belongs to φ̇² only.", notes,
                         [with](double I1, double I3, double theta, const Vector3d& v) {
                           return with(v[0] * std::sin(theta), v[1] * std::sin(theta), v[0] * std::cos(theta) + v[2],
                                       I1, I3);
                         });
  exercise.misconception(
      "rates_as_components",
      "You take the rates for the components of ω; they turn the body about ê3⁰, ê2' and ê3, which are not the body's "
      "axes.",
      notes, [with](double I1, double I3, double, const Vector3d& v) { return with(v[0], v[1], v[2], I1, I3); });
  exercise.misconception("rates_exchanged", "The rates of φ and ψ are exchanged; they come as (φ̇, θ̇, ψ̇).", notes,
                         [](double I1, double I3, double theta, const Vector3d& v) {
                           return kinetic_energy_symmetric(I1, I3, theta, Vector3d(v[2], v[1], v[0]));
                         });
  exercise.angles_read_as_degrees(notes);

  exercise.term("I₁ φ̇² sin²θ", 0.5, [](double I1, double, double theta, const Vector3d& v) {
    return I1 * std::pow(v[0] * std::sin(theta), 2);
  });
  exercise.term("I₁ θ̇²", 0.5, [](double I1, double, double, const Vector3d& v) { return I1 * v[1] * v[1]; });
  exercise.term("I₃ φ̇² cos²θ", 0.5, [](double, double I3, double theta, const Vector3d& v) {
    return I3 * std::pow(v[0] * std::cos(theta), 2);
  });
  exercise.term("I₃ φ̇ ψ̇ cos θ", 1,
                [](double, double I3, double theta, const Vector3d& v) { return I3 * v[0] * v[2] * std::cos(theta); });
  exercise.term("I₃ ψ̇²", 0.5, [](double, double I3, double, const Vector3d& v) { return I3 * v[2] * v[2]; });
  exercise.property(PropertyKind::nonnegative, "A kinetic energy is never negative.", notes);

  exercise.route("the general formula with some φ and ψ", [](double I1, double I3, double theta, const Vector3d& v) {
    return kinetic_energy_euler(Vector3d(I1, I1, I3), Vector3d(0.4, theta, 2.3), v);
  });
  exercise.route("length of ω", [](double I1, double I3, double theta, const Vector3d& v) {
    // |ω|² of any body needs no attitude but the angle between the axes of φ̇ and ψ̇.
    const double squared = v.squaredNorm() + 2 * v[0] * v[2] * std::cos(theta);
    const double along = v[0] * std::cos(theta) + v[2];
    return 0.5 * I1 * squared + 0.5 * (I3 - I1) * along * along;
  });
  exercise.route("half of p·q̇", [](double I1, double I3, double theta, const Vector3d& v) {
    const double p_psi = I3 * (v[2] + v[0] * std::cos(theta));
    const double p_phi = I1 * std::pow(std::sin(theta), 2) * v[0] + p_psi * std::cos(theta);
    return (p_phi * v[0] + I1 * v[1] * v[1] + p_psi * v[2]) / 2;
  });

  exercise.sweep({"A top with I₁ = 2, I₃ = 3 kg m² at ever other inclination, at the same rates", "θ (rad)", "T (J)"},
                 {0, pi},
                 [](double theta) {
                   return SymmetricMotion{2, 3, theta, Vector3d(1.5, 0.8, 0.6)};
                 },
                 {{"T", 0, 0}});
}

void describe_canonical_momenta(Lecture& lecture) {
  auto& exercise = lecture.exercise("canonical_momenta", &canonical_momenta);
  add_arguments(exercise);
  exercise.result("p", units::angular_momentum);

  exercise.worked("moments 1, 2, 3 and the angles of the lecture", Vector3d(1, 2, 3), lecture_angles, lecture_rates);
  exercise.special("a symmetric top", Vector3d(1, 1, 3), lecture_angles, lecture_rates).blind();
  exercise.special("no nutation", Vector3d(1, 2, 3), lecture_angles, Vector3d(0.5, 0, 0.9)).blind();
  exercise.special("upright, θ = 0: p_φ and p_ψ are one", Vector3d(1, 2, 2.5), Vector3d(0.4, 0, 1.1), lecture_rates)
      .blind();
  exercise.special("upside down, θ = π: p_φ = −p_ψ", Vector3d(1, 2, 2.5), Vector3d(0.4, pi, 1.1), lecture_rates)
      .blind();
  exercise.special("at rest", Vector3d(1, 2, 3), lecture_angles, Vector3d::Zero()).blind();
  exercise.random("a random body and motion", 10, random_motion);
  exercise.scale([](const Vector3d& I, const Vector3d&, const Vector3d& rates) {
    return I.maxCoeff() * std::max(rates.norm(), 1e-3);
  });

  const char* notes = "kinetic_energy_momenta";
  const auto L_body = [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
    return I.cwiseProduct(omega_body(q, v));
  };
  exercise.misconception(
      "body_components",
      "These are the components of L on the body's axes; the momenta are its components along ê3⁰, ê2' and ê3.", notes,
      L_body);
  exercise.misconception(
      "inertial_components",
      "These are the inertial components of L; the momenta are its components along ê3⁰, ê2' and ê3.", notes,
      [L_body](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
        return attitude(q) * L_body(I, q, v);
      });
  exercise.misconception(
      "inverse_for_transpose",
      "You apply E⁻¹ to L, which takes components apart along ê3⁰, ê2', ê3; p = Eᵀ L projects onto them.", notes,
      [L_body](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
        const Matrix3d E = rate_axes(q);
        return std::abs(E.determinant()) > 1e-9 ? Vector3d(E.partialPivLu().solve(L_body(I, q, v))) : Vector3d::Zero();
      });
  exercise.misconception("not_transposed", "You apply E to L; by the chain rule it is the transposed matrix, p = Eᵀ L.",
                         notes, [L_body](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return rate_axes(q) * L_body(I, q, v);
                         });
  exercise.misconception("zxz_angles", moments_exchanged, "kinetic_energy_conventions",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return canonical_momenta(exchanged(I), q, v);
                         });
  exercise.misconception(
      "moment_times_rate",
      "You multiply each moment with one rate; the momenta are derivatives of T, and the rates mix in T.", notes,
      [](const Vector3d& I, const Vector3d&, const Vector3d& v) -> Vector3d { return I.cwiseProduct(v); });
  exercise.misconception("half", "The factor ½ of T is still there; the derivative of a square brings a 2.", notes,
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return canonical_momenta(I, q, v) / 2;
                         });
  exercise.misconception("diagonal_only",
                         "Each of your momenta depends on its own rate only; the mixed terms of T add the others.",
                         notes, [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return mass_matrix(I, q).diagonal().cwiseProduct(v);
                         });
  exercise.misconception("spin_only", "Your ω̃₃ is ψ̇ alone; the precession adds φ̇ cos θ to it.", notes,
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           Vector3d omega = omega_body(q, v);
                           omega[2] = v[2];
                           return rate_axes(q).transpose() * I.cwiseProduct(omega);
                         });
  exercise.misconception("vertical_from_spin_only",
                         "Your p_φ is L̃₃ cos θ alone; L across the body's axis has a vertical part as well.", notes,
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           Vector3d p = canonical_momenta(I, q, v);
                           p[0] = p[2] * std::cos(q[1]);
                           return p;
                         });
  exercise.misconception("symmetric_formula", treated_as_symmetric, "kinetic_energy_symmetric_top",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return canonical_momenta(equal_first_two(I), q, v);
                         });
  exercise.misconception("reversed_order", "The momenta come in the order ψ, θ, φ; asked for is (p_φ, p_θ, p_ψ).",
                         notes, [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return canonical_momenta(I, q, v).reverse();
                         });
  exercise.misconception("phi_for_psi", phi_for_psi, "kinetic_energy_angles",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return canonical_momenta(I, phi_in_place_of_psi(q), v);
                         });
  exercise.misconception("mixed_signs", mixed_signs, "kinetic_energy_angles",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return canonical_momenta(I, theta_negated(q), v);
                         });
  exercise.angles_read_as_degrees("kinetic_energy_angles");

  const auto part = [&](const char* name, int row, int column) {
    exercise.term(name, 1, [row, column, L_body](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
      return rate_axes(q)(column, row) * L_body(I, q, v)[column] * Vector3d::Unit(row);
    });
  };
  part("−L̃₁ sin θ cos ψ in p_φ", 0, 0);
  part("L̃₂ sin θ sin ψ in p_φ", 0, 1);
  part("L̃₃ cos θ in p_φ", 0, 2);
  part("L̃₁ sin ψ in p_θ", 1, 0);
  part("L̃₂ cos ψ in p_θ", 1, 1);
  part("L̃₃ in p_ψ", 2, 2);

  exercise.route("components of L in space",
                 [L_body](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                   const Matrix3d A = attitude(q);
                   const Vector3d L = A * L_body(I, q, v);
                   return {L.z(), L.dot(Vector3d(-std::sin(q[0]), std::cos(q[0]), 0)), L.dot(Vector3d(A.col(2)))};
                 });
  exercise.route("differences of the energy", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
    Vector3d p;  // T is quadratic in the rates, so the central difference is exact for any step
    for (int i = 0; i < 3; ++i) {
      p[i] =
          (kinetic_energy_euler(I, q, v + Vector3d::Unit(i)) - kinetic_energy_euler(I, q, v - Vector3d::Unit(i))) / 2;
    }
    return p;
  });
  exercise.route(
      "matrix of the energy, entry by entry", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
        const double s = std::sin(q[1]), c = std::cos(q[1]), sp = std::sin(q[2]), cp = std::cos(q[2]);
        const double mixed = (I[1] - I[0]) * s * sp * cp;
        return {(s * s * (I[0] * cp * cp + I[1] * sp * sp) + I[2] * c * c) * v[0] + mixed * v[1] + I[2] * c * v[2],
                mixed * v[0] + (I[0] * sp * sp + I[1] * cp * cp) * v[1], I[2] * (c * v[0] + v[2])};
      });

  exercise.sweep({"Momenta while the body of moments 1, 2, 3 kg m² turns by ψ, at constant rates", "ψ (rad)",
                  "momentum (kg m²/s)"},
                 {0, 2 * pi},
                 [](double psi) {
                   return Motion{Vector3d(1, 2, 3), Vector3d(0.3, 0.7, psi), Vector3d(1.5, 0.8, 0.4)};
                 },
                 {{"p_φ", 0, 0}, {"p_θ", 1, 0}, {"p_ψ", 2, 0}});
}

void describe_euler_angle_accelerations(Lecture& lecture) {
  auto& exercise = lecture.exercise("euler_angle_accelerations", &euler_angle_accelerations);
  add_arguments(exercise);
  exercise.result("accelerations", units::radian_per_second_squared);

  exercise.worked("moments 1, 2, 3 and the angles of the lecture", Vector3d(1, 2, 3), lecture_angles, lecture_rates);
  exercise.special("a symmetric top", Vector3d(2, 2, 3), lecture_angles, lecture_rates).blind();
  exercise.special("a sphere: ω stays, the angles do not", Vector3d(2, 2, 2), lecture_angles, lecture_rates).blind();
  // A free symmetric top that precesses steadily: I₁ φ̇ cos θ = I₃ (φ̇ cos θ + ψ̇).
  exercise
      .special("steady precession of a symmetric top", Vector3d(1, 1, 1.8), Vector3d(0.3, 0.6, 1.1),
               Vector3d(2, 0, 2 * std::cos(0.6) * (1 - 1.8) / 1.8))
      .blind();
  exercise.special("spin about a principal axis", Vector3d(1, 2, 2.5), Vector3d(0.3, pi / 2, 0), Vector3d(-2, 0, 0))
      .blind();
  exercise.special("near the singular direction", Vector3d(1, 2, 2.5), Vector3d(0.3, 0.02, 1.1), lecture_rates).blind();
  exercise.random("a random body and motion", 10, random_motion);
  // φ̈ and ψ̈ grow as 1/sin θ towards the singular direction, and may cancel there.
  exercise.scale([](const Vector3d&, const Vector3d& angles, const Vector3d& rates) {
    return rates.squaredNorm() / std::abs(std::sin(angles[1]));
  });

  const char* notes = "kinetic_energy_accelerations";
  const auto solve = [](const Vector3d& q, const Vector3d& right) -> Vector3d {
    return rate_axes(q).partialPivLu().solve(right);
  };
  const auto omega_rate = [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
    return free_omega_rate(I, omega_body(q, v));
  };
  const auto from_turning_axes = [](const Vector3d& q, const Vector3d& v) -> Vector3d {
    return rate_axes_derivative(q, v) * v;
  };

  exercise.misconception("turning_axes_lost",
                         "You solve ω̇ = E q̈; E depends on the angles, so ω̇ = E q̈ + Ė q̇ has a second term.", notes,
                         [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return solve(q, omega_rate(I, q, v));
                         });
  exercise.misconception("turning_axes_added", "Ė q̇ enters with the wrong sign: E q̈ = ω̇ − Ė q̇.", notes,
                         [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return solve(q, omega_rate(I, q, v) + from_turning_axes(q, v));
                         });
  exercise.misconception(
      "omega_held",
      "You keep the body components of ω constant; without torque they still change, by Euler's equations.", notes,
      [=](const Vector3d&, const Vector3d& q, const Vector3d& v) -> Vector3d {
        return solve(q, -from_turning_axes(q, v));
      });
  exercise.misconception(
      "zero", "Your accelerations vanish; no torque keeps L constant, not the rates of the angles.", notes,
      [](const Vector3d&, const Vector3d&, const Vector3d&) -> Vector3d { return Vector3d::Zero(); });
  exercise.misconception("omega_rate",
                         "This is ω̇ on the body's axes; asked for are the second derivatives of the angles.", notes,
                         omega_rate);
  exercise.misconception("gyroscopic_sign", "Your ω̇ has the wrong sign: without torque I·ω̇ = −ω × (I·ω).", notes,
                         [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return solve(q, -omega_rate(I, q, v) - from_turning_axes(q, v));
                         });
  exercise.misconception("not_divided_by_moments",
                         "You take −ω × L for ω̇; each component must still be divided by its moment.", notes,
                         [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return solve(q, I.cwiseProduct(omega_rate(I, q, v)) - from_turning_axes(q, v));
                         });
  exercise.misconception("transpose_for_inverse",
                         "You apply Eᵀ where E must be inverted: its columns are not orthogonal.", notes,
                         [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return rate_axes(q).transpose() * (omega_rate(I, q, v) - from_turning_axes(q, v));
                         });
  exercise.misconception("zxz_angles", moments_exchanged, "kinetic_energy_conventions",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return euler_angle_accelerations(exchanged(I), q, v);
                         });
  exercise.misconception("phi_for_psi", phi_for_psi, "kinetic_energy_angles",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return euler_angle_accelerations(I, phi_in_place_of_psi(q), v);
                         });
  exercise.misconception("symmetric_formula", treated_as_symmetric, "kinetic_energy_symmetric_top",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return euler_angle_accelerations(equal_first_two(I), q, v);
                         });
  exercise.misconception("mass_matrix_held", "The term Ṁ q̇ is missing: p = M(q) q̇, so ṗ = M q̈ + Ṁ q̇.",
                         "kinetic_energy_lagrange",
                         [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return mass_matrix(I, q).ldlt().solve(energy_gradient(I, q, v));
                         });
  exercise.misconception(
      "all_angles_cyclic", "∂T/∂q is missing: you keep all three momenta constant, but only φ is cyclic.",
      "kinetic_energy_lagrange", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
        return mass_matrix(I, q).ldlt().solve(-mass_matrix_derivative(I, q, v) * v);
      });
  exercise.misconception(
      "gradient_sign", "∂T/∂q enters with the wrong sign: ṗ = +∂T/∂q.", "kinetic_energy_lagrange",
      [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
        return mass_matrix(I, q).ldlt().solve(-mass_matrix_derivative(I, q, v) * v - energy_gradient(I, q, v));
      });
  exercise.misconception("nutation_of_axes_lost", "In Ė only ψ changes; its entries depend on θ too.", notes,
                         [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return solve(q, omega_rate(I, q, v) - rate_axes_derivative(q, Vector3d(0, 0, v[2])) * v);
                         });
  exercise.misconception("spin_of_axes_lost", "In Ė only θ changes; its entries depend on ψ too.", notes,
                         [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                           return solve(q, omega_rate(I, q, v) - rate_axes_derivative(q, Vector3d(0, v[1], 0)) * v);
                         });
  exercise.angles_read_as_degrees("kinetic_energy_angles");

  exercise.term("E⁻¹ ω̇", 1, [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
    return solve(q, omega_rate(I, q, v));
  });
  exercise.term("E⁻¹ Ė q̇", -1, [=](const Vector3d&, const Vector3d& q, const Vector3d& v) -> Vector3d {
    return solve(q, from_turning_axes(q, v));
  });

  exercise.route("Lagrange's equations", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
    return mass_matrix(I, q).partialPivLu().solve(-euler_lagrange_at_constant_rates(I, q, v));
  });
  exercise.route("L stays in space", [](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
    // q̇ = E⁻¹ I⁻¹ Aᵀ L with constant L, differentiated along the motion by a complex step.
    const Vector3d L = attitude(q) * I.cwiseProduct(omega_body(q, v));
    constexpr double step = 1e-100;
    const Eigen::Vector3cd ahead = q.cast<Complex>() + Complex(0, step) * v.cast<Complex>();
    const Complex s = std::sin(ahead[1]), c = std::cos(ahead[1]), sp = std::sin(ahead[2]), cp = std::cos(ahead[2]);
    const Complex along = std::cos(ahead[0]) * L.x() + std::sin(ahead[0]) * L.y();
    const Complex across = -std::sin(ahead[0]) * L.x() + std::cos(ahead[0]) * L.y();
    const Complex first = c * along - s * L.z();  // L on the axes before ψ turns them
    const Complex w1 = (cp * first + sp * across) / I[0], w2 = (-sp * first + cp * across) / I[1];
    const Complex w3 = (s * along + c * L.z()) / I[2];
    const Complex phi_rate = (-w1 * cp + w2 * sp) / s;
    return Vector3d(phi_rate.imag(), (w1 * sp + w2 * cp).imag(), (w3 - c * phi_rate).imag()) / step;
  });
  exercise.route("E and its derivative as matrices",
                 [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) -> Vector3d {
                   const Vector3d right = omega_rate(I, q, v) - from_turning_axes(q, v);
                   return rate_axes(q).inverse() * right;
                 });

  exercise.sweep({"The free body of moments 1, 2, 3 kg m² at ever other inclination, at the same rates", "θ (rad)",
                  "acceleration (rad/s²)"},
                 {0.3, pi - 0.3},
                 [](double theta) {
                   return Motion{Vector3d(1, 2, 3), Vector3d(0.3, theta, 1.1), lecture_rates};
                 },
                 {{"φ̈", 0, 0}, {"θ̈", 1, 0}, {"ψ̈", 2, 0}});
}

}  // namespace

void workbook::judging::describe(Lecture& lecture) {
  describe_kinetic_energy_euler(lecture);
  describe_kinetic_energy_symmetric(lecture);
  describe_canonical_momenta(lecture);
  describe_euler_angle_accelerations(lecture);
}
