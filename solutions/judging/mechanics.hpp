/// @file
/// What the judging of several lectures needs: small formulas, the notes' running example, and what a quantity is: its
/// unit, and which values are legal, up to rounding.
#pragma once

#include "checker/data/unit.hpp"
#include "checker/data/value.hpp"
#include "rigid/vocabulary.hpp"
#include "solutions/judging/algebra.hpp"

#include <cmath>
#include <numbers>

namespace workbook::judging {

using namespace rigid;

inline constexpr double pi = std::numbers::pi;
inline constexpr double degree = pi / 180;

inline const Vector3d zero(0, 0, 0), x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

/// The angular velocity of the running example.
inline const Vector3d example_omega(0.3, -0.2, 0.5);

/// The four masses of lecture 03 about the origin: 10 kg at (0.5, 0.8, 1.3) m.
inline const Matrix3d tensor_of_four_masses{{43, -4, -4}, {-4, 36, -4}, {-4, -4, 17}};

Vector3d cross(const Vector3d& a, const Vector3d& b);

Matrix3d columns(const Vector3d& a, const Vector3d& b, const Vector3d& c);

/// The matrix that does what w× does, and back.
Matrix3d skew(const Vector3d& w);
Vector3d axial(const Matrix3d& W);
Vector3d axial_part(const Matrix3d& W);

Vector3d in_xy_plane(double angle);

/// L and 2T on principal axes, and the rates of change of ω without a torque.
Vector3d L_of(const Vector3d& I, const Vector3d& w);
double twice_T(const Vector3d& I, const Vector3d& w);
Vector3d free_rate(const Vector3d& I, const Vector3d& w);

/// x in A x = b, of any size: Eigen's decompositions take seconds to compile for each.
VectorXd solution_of(const Eigen::MatrixXd& A, const VectorXd& b);

/// r r, the matrix with entries rᵢ rⱼ.
Matrix3d dyad(const Vector3d& r);

/// The active rotation about an axis of any length; about the zero vector nothing turns.
Matrix3d turn(const Vector3d& axis, double angle);

/// The attitude with these Euler angles: A in V_inertial = A V_body.
Matrix3d attitude(const Vector3d& angles);

Matrix3d diagonal_part(const Matrix3d& I);

/// The tensor with the signs of its products of inertia flipped.
Matrix3d products_flipped(const Matrix3d& I);

/// The tensor of a unit mass at r: r² 1 − r r.
Matrix3d of_unit_mass(const Vector3d& r);
Matrix3d of_unit_mass_by_entries(const Vector3d& r);

/// Σ m r r; and the tensor of a body with such second moments, tr C 1 − C, and back.
Matrix3d second_moment(const VectorXd& m, const Matrix3Xd& r);
Matrix3d tensor_of_moment(const Matrix3d& C);
Matrix3d moment_of_tensor(const Matrix3d& I);

/// Six points about the centre of mass; with a sixth of the mass each they have the tensor of a given body.
Matrix3Xd six_points(const Matrix3d& I_cm, double M);

Vector3d center_of_mass(const VectorXd& m, const Matrix3Xd& r);

/// M (b² + c²) and so on with the factor `diagonal`, M ab and so on with the factor `product` off the diagonal.
Matrix3d of_cuboid(double M, const Vector3d& edges, double diagonal, double product);

/// Eight points about the centre of a cuboid; with an eighth of its mass each they have its second moments.
Matrix3Xd gauss_points_of_cuboid(const Vector3d& edges);

/// Principal moments in ascending order, and the axes as columns of a right-handed triad.
struct PrincipalFrame {
  explicit PrincipalFrame(const Matrix3d& I);
  Vector3d moments;
  Matrix3d axes;
};

/// A symmetric matrix from its quadratic form, as the tensor is read off the energy; exact for any quadratic function.
template <class QuadraticForm>
Matrix3d from_quadratic_form(const QuadraticForm& form) {
  return Matrix3d::NullaryExpr([&](Eigen::Index i, Eigen::Index j) {
    const Vector3d one = Vector3d::Unit(i), other = Vector3d::Unit(j);
    return (form(one + other) - form(one - other)) / 4;
  });
}

/// The derivative of a function at 0, by central differences extrapolated to h = 0 (Richardson).
template <class Function>
auto derivative_at_0(const Function& f, double h) {
  const auto difference = [&](double t) { return (f(t) - f(-t)) / (2 * t); };
  return (64 * difference(h) - 20 * difference(2 * h) + difference(4 * h)) / 45;
}

/// One step of the classical Runge-Kutta method.
template <class State, class RateOf>
State one_step_on(const State& state, double h, const RateOf& rate) {
  const State k1 = rate(state), k2 = rate(State(state + h / 2 * k1)), k3 = rate(State(state + h / 2 * k2));
  return state + h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(State(state + h * k3)));
}

/// So many of these steps, over the time t.
template <class State, class RateOf>
State followed(State state, double t, int steps, const RateOf& rate) {
  for (int i = 0; i < steps; ++i) state = one_step_on(state, t / steps, rate);
  return state;
}

/// A quantity that vanishes needs some natural size all the same.
inline double or_one(double size) { return size > 0 ? size : 1.0; }

namespace legal {
bool is_inertia_tensor(const Matrix3d& I);
bool positive(const Value& value);
bool not_negative(const Value& value);
bool nonzero(const Value& value);
bool ascending(const Value& value);
bool inertia_tensors(const Value& value);
bool regular_tensors(const Value& value);
bool rotation(const Value& value);
bool latitude(const Value& value);
bool off_gimbal_lock(const Value& value);
}  // namespace legal
using legal::is_inertia_tensor;

/// A unit, and which values are legal: all finite ones if there is no predicate.
struct Sort {
  constexpr Sort(Unit of, bool (*predicate)(const Value&) = nullptr) : unit(of), is_legal(predicate) {}
  Unit unit;
  bool (*is_legal)(const Value&);
};

inline constexpr Unit none{}, kg = units::kilogram, metre = units::metre, second = units::second, rad = units::radian;
inline constexpr Unit per_s = none / second, rad_per_s = rad / second, rad_per_s2 = rad_per_s / second;
inline constexpr Unit m_per_s = metre / second, m_per_s2 = m_per_s / second, newton = kg * m_per_s2;
inline constexpr Unit joule = newton * metre, newton_metre = workbook::units::newton_metre, kg_m2 = kg * metre * metre;
inline constexpr Unit kg_m2_per_s = kg_m2 / second;

/// Every number of it is > 0, or ≥ 0; a vector of any length but 0.
constexpr Sort positive(Unit unit) { return {unit, legal::positive}; }
constexpr Sort not_negative(Unit unit) { return {unit, legal::not_negative}; }
constexpr Sort nonzero(Unit unit) { return {unit, legal::nonzero}; }

/// 0 < I₁ ≤ I₂ ≤ I₃; one tensor or several, symmetric and with positive semidefinite ½ tr I − I; not that of a body on
/// one straight line through the origin; |λ| ≤ π/2; |sin θ| > 10⁻⁶.
inline constexpr Sort ascending_moments{kg_m2, legal::ascending}, inertia_tensor{kg_m2, legal::inertia_tensors},
    regular_tensor{kg_m2, legal::regular_tensors}, rotation{none, legal::rotation},
    latitude_angle{rad, legal::latitude}, angles_off_gimbal_lock{rad, legal::off_gimbal_lock};

}  // namespace workbook::judging
