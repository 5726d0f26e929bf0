/// @file
/// How the exercises of lecture 01 are judged.
#include "rigid/frame_derivatives.hpp"
#include "solutions/judging/lecture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace {

using namespace rigid;
using namespace workbook;
using namespace workbook::judging;

using RateOmegaVector = std::tuple<Vector3d, Vector3d, Vector3d>;
using BasisOmegaTime = std::tuple<Matrix3d, Vector3d, double>;
using BasisAndRate = std::tuple<Matrix3d, Matrix3d>;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
constexpr Unit per_second{.second = -1};

/// The angular velocity of the lecture's running example.
const Vector3d example_omega(0.3, -0.2, 0.5);

Matrix3d turn(const Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.stableNormalized()).toRotationMatrix();
}

/// The basis of the running example: turned from the inertial one by the rotation vector (0.2, 0.5, −0.3).
Matrix3d example_basis() {
  const Vector3d rotation_vector(0.2, 0.5, -0.3);
  return turn(rotation_vector, rotation_vector.norm());
}

/// The vector whose cross matrix is the antisymmetric W.
Vector3d vector_of(const Matrix3d& W) { return {W(2, 1), W(0, 2), W(1, 0)}; }

/// exp(W) by halving W until its series is short, and squaring the result: a route without axis and angle.
Matrix3d exponential(const Matrix3d& W) {
  const int halvings = std::max(0, static_cast<int>(std::ceil(std::log2(std::max(W.norm(), 1e-300)))) + 4);
  const Matrix3d small = W / std::exp2(halvings);
  Matrix3d power = Matrix3d::Identity();
  Matrix3d result = Matrix3d::Identity();
  for (int k = 1; k <= 14; ++k) {
    power = power * small / k;
    result += power;
  }
  for (int k = 0; k < halvings; ++k) result = result * result;
  return result;
}

void describe_cross_matrix(Lecture& lecture) {
  using Omega = std::tuple<Vector3d>;
  auto& exercise = lecture.exercise("cross_matrix", &cross_matrix);
  exercise.argument("omega", units::radian_per_second).result("[omega]x", units::radian_per_second);

  exercise.worked("the angular velocity of the lecture", example_omega);
  exercise.special("rotation about z", Vector3d(0, 0, 2));
  exercise.special("no rotation", Vector3d::Zero());
  exercise.special("the component about y is zero", Vector3d(1.5, 0, -0.5));
  exercise.random("a random angular velocity", 8, [](Random& random) { return Omega{random.vector(3.0)}; });
  exercise.scale([](const Vector3d& omega) { return omega.isZero() ? 1.0 : omega.norm(); });

  const char* const anchor = "frame_derivatives_cross";
  exercise.misconception("transposed",
                         "All signs are the wrong way round: your matrix computes V × ω instead of ω × V.", anchor,
                         [](const Vector3d& omega) -> Matrix3d { return cross_matrix(omega).transpose(); });
  exercise.misconception("symmetric",
                         "Your matrix has no minus signs; each component of ω must stand once with + and once with −.",
                         anchor, [](const Vector3d& w) -> Matrix3d {
                           return Matrix3d{{0, w[2], w[1]}, {w[2], 0, w[0]}, {w[1], w[0], 0}};
                         });
  exercise.misconception("row_y_sign",
                         "The signs of your second row are reversed: when ω × V is written as a determinant, the "
                         "middle one takes a minus.",
                         anchor, [](const Vector3d& omega) -> Matrix3d {
                           Matrix3d W = cross_matrix(omega);
                           W.row(1) = -W.row(1);
                           return W;
                         });
  exercise.misconception(
      "omega_y_sign",
      "The two entries with ω_y have the wrong sign: going round cyclically, +ω_y stands in row x, column z.", anchor,
      [](const Vector3d& w) -> Matrix3d {
        return cross_matrix({w[0], -w[1], w[2]});
      });
  exercise.misconception("order_of_components",
                         "ω_x and ω_z have changed places: the entries in rows and columns x and y hold ω_z.", anchor,
                         [](const Vector3d& w) -> Matrix3d {
                           return cross_matrix({w[2], w[1], w[0]});
                         });
  exercise.misconception("order_and_sign",
                         "Your matrix has ω_x and −ω_y where +ω_z and +ω_y belong: fill in what ω × x̂ = (0, ω_z, −ω_y) "
                         "is, column by column.",
                         anchor, [](const Vector3d& w) -> Matrix3d {
                           return cross_matrix({w[2], -w[1], w[0]});
                         });
  exercise.misconception(
      "diagonal",
      "A diagonal matrix multiplies component by component; ω × V mixes the components and has zeros on the diagonal.",
      anchor, [](const Vector3d& omega) -> Matrix3d { return omega.asDiagonal(); });
  exercise.misconception(
      "upper_only", "The entries below the diagonal are missing: they are minus those above it.", anchor,
      [](const Vector3d& omega) -> Matrix3d { return cross_matrix(omega).triangularView<Eigen::Upper>(); });
  exercise.misconception(
      "lower_only", "The entries above the diagonal are missing: they are minus those below it.", anchor,
      [](const Vector3d& omega) -> Matrix3d { return cross_matrix(omega).triangularView<Eigen::Lower>(); });
  exercise.misconception(
      "unit_vector", "Your entries are those of the unit vector ω/|ω|; ω × V also grows with the length of ω.", anchor,
      [](const Vector3d& omega) -> Matrix3d { return cross_matrix(omega.stableNormalized()); });

  for (int i = 0; i < 3; ++i) {
    const char* const names[] = {"ω_x in rows and columns y, z", "ω_y in rows and columns z, x",
                                 "ω_z in rows and columns x, y"};
    exercise.term(names[i], 1.0,
                  [i](const Vector3d& omega) -> Matrix3d { return cross_matrix(omega[i] * Vector3d::Unit(i)); });
  }
  exercise.property(PropertyKind::antisymmetric,
                    "The matrix of ω× is antisymmetric, because ω × V is perpendicular to V for every V.", anchor);

  exercise.route("column by column", [](const Vector3d& omega) -> Matrix3d {
    Matrix3d W;
    for (int i = 0; i < 3; ++i) W.col(i) = omega.cross(Vector3d(Vector3d::Unit(i)));
    return W;
  });
  exercise.route("upper triangle less its mirror image", [](const Vector3d& omega) -> Matrix3d {
    Matrix3d upper = Matrix3d::Zero();
    upper(0, 1) = -omega.z();
    upper(0, 2) = omega.y();
    upper(1, 2) = -omega.x();
    return upper - upper.transpose();
  });
  exercise.route("the permutation symbol", [](const Vector3d& omega) -> Matrix3d {
    Matrix3d W = Matrix3d::Zero();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) W(i, k) += (i - j) * (j - k) * (k - i) / 2.0 * omega[j];
      }
    }
    return W;
  });

  exercise.sweep({"ω of 1 rad/s turns in the x–y plane, with 0.5 rad/s along z beside it",
                  "direction of ω in the plane (rad)", "entry of the matrix (rad/s)"},
                 {0, 2 * pi}, [](double angle) { return Omega{Vector3d(std::cos(angle), std::sin(angle), 0.5)}; },
                 {{"row x, column y", 0, 1}, {"row x, column z", 0, 2}, {"row y, column z", 1, 2}});
}

void describe_inertial_rate(Lecture& lecture) {
  auto& exercise = lecture.exercise("inertial_rate", &inertial_rate);
  // V stands for any vector; here it is taken for a position.
  exercise.argument("rate_body", units::metre_per_second)
      .argument("omega", units::radian_per_second)
      .argument("V", units::metre);
  exercise.result("rate", units::metre_per_second);

  exercise.worked("the vectors of the lecture", Vector3d(0.4, -0.3, 0.6), example_omega, Vector3d(1, 2, -1));
  exercise.special("V is fixed in the turning frame", Vector3d::Zero(), example_omega, Vector3d(1, 2, -1));
  exercise.special("V is fixed in the inertial frame", Vector3d(0.8, -0.8, -0.8), example_omega, Vector3d(1, 2, -1));
  exercise.special("the frame does not turn", Vector3d(0.4, -0.3, 0.6), Vector3d::Zero(), Vector3d(1, 2, -1));
  exercise.special("V lies along ω", Vector3d(0.4, -0.3, 0.6), example_omega, Vector3d(2 * example_omega));
  exercise.random("a random vector", 8, [](Random& random) {
    return RateOmegaVector{random.vector(2.0), random.vector(3.0), random.vector(2.0)};
  });
  exercise.scale([](const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
    return rate_body.norm() + omega.norm() * V.norm();
  });

  const char* const anchor = "frame_derivatives_transport";
  exercise.misconception(
      "sign",
      "ω × V enters with the wrong sign: from the body's rate to the inertial one it is added (and V × ω = −ω × V).",
      anchor,
      [](const Vector3d& rate, const Vector3d& omega, const Vector3d& V) -> Vector3d { return rate - omega.cross(V); });
  exercise.misconception("body_rate_only", "You return the body's rate; the turning of the basis vectors adds ω × V.",
                         anchor,
                         [](const Vector3d& rate, const Vector3d&, const Vector3d&) -> Vector3d { return rate; });
  exercise.misconception(
      "cross_only",
      "You return ω × V alone; that is the rate of a vector fixed in the turning frame, and this one also changes "
      "there.",
      anchor, [](const Vector3d&, const Vector3d& omega, const Vector3d& V) -> Vector3d { return omega.cross(V); });
  exercise.misconception("cross_with_rate", "You cross ω with the rate of V; it must be crossed with V itself.", anchor,
                         [](const Vector3d& rate, const Vector3d& omega, const Vector3d&) -> Vector3d {
                           return rate + omega.cross(rate);
                         });
  exercise.misconception(
      "rate_sign", "The body's rate enters with the wrong sign: both parts are added.", anchor,
      [](const Vector3d& rate, const Vector3d& omega, const Vector3d& V) -> Vector3d { return omega.cross(V) - rate; });
  exercise.misconception("both_signs", "The whole result has the wrong sign: both parts are added.", anchor,
                         [](const Vector3d& rate, const Vector3d& omega, const Vector3d& V) -> Vector3d {
                           return -inertial_rate(rate, omega, V);
                         });
  exercise.misconception("factor_two",
                         "ω × V enters twice; the factor 2 belongs to the Coriolis term of the second derivative.",
                         anchor, [](const Vector3d& rate, const Vector3d& omega, const Vector3d& V) -> Vector3d {
                           return rate + 2 * omega.cross(V);
                         });
  exercise.misconception("componentwise", "You multiply ω and V component by component; a cross product is needed.",
                         anchor, [](const Vector3d& rate, const Vector3d& omega, const Vector3d& V) -> Vector3d {
                           return rate + omega.cwiseProduct(V);
                         });
  exercise.misconception("speed_times_vector",
                         "You add |ω| V, which points along V; a turning vector changes across itself, by ω × V.",
                         anchor, [](const Vector3d& rate, const Vector3d& omega, const Vector3d& V) -> Vector3d {
                           return rate + omega.norm() * V;
                         });

  exercise.term("the body's rate", 1.0,
                [](const Vector3d& rate, const Vector3d&, const Vector3d&) -> Vector3d { return rate; });
  exercise.term("ω × V", 1.0,
                [](const Vector3d&, const Vector3d& omega, const Vector3d& V) -> Vector3d { return omega.cross(V); });

  exercise.route("with the cross matrix",
                 [](const Vector3d& rate, const Vector3d& omega, const Vector3d& V) -> Vector3d {
                   return cross_matrix(omega) * V + rate;
                 });
  exercise.route("the sum over turning basis vectors",
                 [](const Vector3d& rate, const Vector3d& omega, const Vector3d& V) -> Vector3d {
                   Vector3d sum = Vector3d::Zero();
                   for (int i = 0; i < 3; ++i)
                     sum += rate[i] * Vector3d::Unit(i) + V[i] * omega.cross(Vector3d(Vector3d::Unit(i)));
                   return sum;
                 });
  exercise.route("component by component", [](const Vector3d& rate, const Vector3d& w, const Vector3d& V) -> Vector3d {
    return {rate[0] - (w[2] * V[1] - w[1] * V[2]), rate[1] - (w[0] * V[2] - w[2] * V[0]),
            rate[2] - (w[1] * V[0] - w[0] * V[1])};
  });

  exercise.sweep({"A vector of 2 m turns in the x–y plane of a frame with ω = (0.3, −0.2, 0.5) rad/s, at 1 rad/s",
                  "direction of V (rad)", "inertial rate (m/s)"},
                 {0, 2 * pi},
                 [](double angle) {
                   const Vector3d V(2 * std::cos(angle), 2 * std::sin(angle), 0);
                   return RateOmegaVector{Vector3d(-V.y(), V.x(), 0), example_omega, V};
                 },
                 {{"x", 0, 0}, {"y", 1, 0}, {"z", 2, 0}});
}

void describe_rotated_basis(Lecture& lecture) {
  auto& exercise = lecture.exercise("rotated_basis", &rotated_basis);
  exercise.argument("E", units::none).argument("omega", units::radian_per_second).argument("dt", units::second);
  exercise.result("basis", units::none);

  const Vector3d unit = example_omega.normalized();
  exercise.worked("the basis of the lecture, after 0.8 s", example_basis(), example_omega, 0.8);
  exercise.special("no time passes", example_basis(), example_omega, 0.0);
  exercise.special("no rotation", example_basis(), Vector3d::Zero(), 0.8);
  exercise.special("from the inertial basis", Matrix3d::Identity(), example_omega, 0.8);
  exercise.special("an angle of 1e-8", example_basis(), unit, 1e-8);
  exercise.special("a very slow rotation", example_basis(), Vector3d(1e-9 * unit), 0.8);
  exercise.special("just short of half a turn", example_basis(), unit, pi - 1e-8);
  exercise.special("half a turn", example_basis(), unit, pi);
  exercise.special("just short of a full turn", example_basis(), unit, 2 * pi - 1e-8);
  exercise.worked("back in time", example_basis(), example_omega, -0.8);
  exercise.worked("many turns", example_basis(), example_omega, 60.0);
  exercise.random("a random basis and angular velocity", 8, [](Random& random) {
    return BasisOmegaTime{random.rotation(), random.vector(2.0), random.uniform(0.3, 1.2)};
  });
  exercise.scale([](const Matrix3d&, const Vector3d&, double) { return 1.0; });

  const char* const finite = "frame_derivatives_finite";
  const char* const small = "frame_derivatives_small";
  exercise.misconception("first_order",
                         "This is the first-order step E + ω × E dt; it leaves the circle, so the vectors grow and are "
                         "no longer orthonormal.",
                         small, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           return E + dt * cross_matrix(omega) * E;
                         });
  exercise.misconception("second_order",
                         "You stop the series of the rotation after dt²; the sum of the whole series is needed, which "
                         "is Rodrigues' formula.",
                         finite, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           const Matrix3d W = dt * cross_matrix(omega);
                           return E + W * E + 0.5 * W * W * E;
                         });
  exercise.misconception("first_order_normalised",
                         "You take the first-order step and make its columns unit vectors; they then have the right "
                         "length, but not the right direction.",
                         small, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           Matrix3d step = E + dt * cross_matrix(omega) * E;
                           step.colwise().normalize();
                           return step;
                         });
  exercise.misconception("body_components",
                         "You multiply the rotation from the right, so ω acts as if its components were on the body "
                         "axes; they are inertial.",
                         finite, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           return E * turn(omega, omega.norm() * dt);
                         });
  exercise.misconception(
      "inverse_rotation",
      "Your basis turns backwards: the slides' matrix with +sin above its diagonal acts on the list of basis vectors, "
      "and its transpose on components.",
      "frame_derivatives_transposed",
      [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d { return rotated_basis(E, omega, -dt); });
  exercise.misconception("body_components_backwards",
                         "You multiply the rotation from the right and turn backwards; ω has inertial components, so "
                         "the rotation by +ω dt stands on the left of E.",
                         finite, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           return E * turn(omega, -omega.norm() * dt);
                         });
  exercise.misconception("degrees", "You convert the angle from degrees, but |ω| dt already is in radians.", finite,
                         [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           return rotated_basis(E, omega, dt * degree);
                         });
  exercise.misconception("to_degrees",
                         "You convert the angle to degrees; sine, cosine and Eigen's AngleAxisd want radians.", finite,
                         [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           return rotated_basis(E, omega, dt / degree);
                         });
  exercise.misconception(
      "angle_is_dt", "You turn by the angle dt; the angle is |ω| dt.", finite,
      [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d { return turn(omega, dt) * E; });
  exercise.misconception(
      "angle_is_omega", "You turn by the angle |ω|, whatever the time; the angle is |ω| dt.", finite,
      [](const Matrix3d& E, const Vector3d& omega, double) -> Matrix3d { return turn(omega, omega.norm()) * E; });
  exercise.misconception(
      "axis_not_unit",
      "The axis of your rotation is ω itself; Rodrigues' formula and Eigen's AngleAxisd want the unit vector ω/|ω|.",
      finite, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
        return Eigen::AngleAxisd(omega.norm() * dt, omega).toRotationMatrix() * E;
      });
  exercise.misconception(
      "three_turns",
      "You turn about x, y and z one after the other; finite rotations do not commute, so this is another rotation.",
      finite, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
        return turn(Vector3d::UnitX(), omega.x() * dt) * turn(Vector3d::UnitY(), omega.y() * dt) *
               turn(Vector3d::UnitZ(), omega.z() * dt) * E;
      });
  exercise.misconception(
      "three_turns_other_order",
      "You turn about x, y and z one after the other; finite rotations do not commute, so this is another rotation.",
      finite, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
        return turn(Vector3d::UnitZ(), omega.z() * dt) * turn(Vector3d::UnitY(), omega.y() * dt) *
               turn(Vector3d::UnitX(), omega.x() * dt) * E;
      });
  exercise.misconception("no_parallel_part",
                         "In your answer the part of e along the axis shrinks with cos θ; the term (1 − cos θ) n "
                         "(n·e), which keeps it as it is, is missing.",
                         finite, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           const double angle = omega.norm() * dt;
                           return std::cos(angle) * E + std::sin(angle) * cross_matrix(omega.stableNormalized()) * E;
                         });
  exercise.misconception(
      "rotation_only", "You return the rotation itself; the basis E that is to be turned does not enter.", finite,
      [](const Matrix3d&, const Vector3d& omega, double dt) -> Matrix3d { return turn(omega, omega.norm() * dt); });
  exercise.misconception("rows",
                         "Your basis vectors are the rows of the result; the columns are asked for (transpose it).",
                         finite, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           return rotated_basis(E, omega, dt).transpose();
                         });
  exercise.misconception("rows_turned", "You take the rows of E for the basis vectors; they are its columns.", finite,
                         [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                           return rotated_basis(E.transpose(), omega, dt);
                         });
  exercise.misconception("not_turned", "You return the basis as it was at the start.", finite,
                         [](const Matrix3d& E, const Vector3d&, double) -> Matrix3d { return E; });

  exercise.term("e", 1.0, [](const Matrix3d& E, const Vector3d&, double) -> Matrix3d { return E; });
  exercise.term("sin θ n × e", 1.0, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
    return std::sin(omega.norm() * dt) * cross_matrix(omega.stableNormalized()) * E;
  });
  exercise.term("(1 − cos θ) n × (n × e)", 1.0, [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
    const Matrix3d N = cross_matrix(omega.stableNormalized());
    return 2 * std::pow(std::sin(omega.norm() * dt / 2), 2) * N * N * E;
  });
  exercise.property(PropertyKind::rotation_matrix,
                    "Basis vectors that turn stay orthonormal and right-handed: EᵀE = 1, det E = +1.", finite);

  exercise.route("exponential of the cross matrix",
                 [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                   return exponential(dt * cross_matrix(omega)) * E;
                 });
  exercise.route("unit quaternion", [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
    const double half = 0.5 * omega.norm() * dt;
    Eigen::Quaterniond q;
    q.w() = std::cos(half);
    q.vec() = std::sin(half) * omega.stableNormalized();
    Matrix3d turned;
    for (int i = 0; i < 3; ++i) turned.col(i) = q * Vector3d(E.col(i));
    return turned;
  });
  exercise.route("parallel and perpendicular part",
                 [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                   if (omega.isZero(0)) return E;
                   const Vector3d n = omega.normalized();
                   const double angle = omega.norm() * dt;
                   Matrix3d turned;
                   for (int i = 0; i < 3; ++i) {
                     const Vector3d e = E.col(i);
                     const Vector3d along = n * n.dot(e);
                     turned.col(i) = along + std::cos(angle) * (e - along) + std::sin(angle) * n.cross(e);
                   }
                   return turned;
                 });
  exercise.route("on the body axes, from the right",
                 [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
                   return E * turn(E.transpose() * omega, omega.norm() * dt);
                 });
  exercise.route("a thousand small turns", [](const Matrix3d& E, const Vector3d& omega, double dt) -> Matrix3d {
    const Matrix3d step = turn(omega, omega.norm() * dt / 1000);
    Matrix3d turned = E;
    for (int k = 0; k < 1000; ++k) turned = step * turned;
    return turned;
  });

  exercise.sweep({"The first basis vector during one turn with ω = (0.3, −0.2, 0.5) rad/s", "time (s)",
                  "component of the first basis vector"},
                 {0, 2 * pi / example_omega.norm(), 121},
                 [](double dt) {
                   return BasisOmegaTime{example_basis(), example_omega, dt};
                 },
                 {{"x", 0, 0}, {"y", 1, 0}, {"z", 2, 0}});
}

void describe_angular_velocity_of_basis(Lecture& lecture) {
  auto& exercise = lecture.exercise("angular_velocity_of_basis", &angular_velocity_of_basis);
  exercise.argument("E", units::none).argument("E_rate", per_second).result("omega", units::radian_per_second);

  const auto turning = [](const Matrix3d& E, const Vector3d& omega) {
    return BasisAndRate{E, cross_matrix(omega) * E};
  };
  const Matrix3d E = example_basis();
  exercise.worked("the basis of the lecture", E, Matrix3d(cross_matrix(example_omega) * E));
  exercise.special("the basis stands along the inertial axes", Matrix3d::Identity(), cross_matrix(example_omega));
  exercise.special("no rotation", E, Matrix3d::Zero());
  exercise.special("the basis turns about its own first vector", E, Matrix3d(cross_matrix(2 * E.col(0)) * E));
  exercise.special("after half a turn about y", turn(Vector3d::UnitY(), pi),
                   Matrix3d(cross_matrix(example_omega) * turn(Vector3d::UnitY(), pi)));
  exercise.random("a random basis and angular velocity", 8, [turning](Random& random) {
    const Matrix3d basis = random.rotation();
    return turning(basis, random.vector(3.0));
  });
  exercise.scale([](const Matrix3d&, const Matrix3d& E_rate) { return E_rate.isZero() ? 1.0 : E_rate.norm(); });

  const char* const anchor = "frame_derivatives_omega";
  exercise.misconception(
      "body_components", "These are the components of ω on the basis E itself; asked for are the inertial ones.",
      anchor,
      [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d { return vector_of(basis.transpose() * rate); });
  exercise.misconception(
      "sign", "Your ω has the wrong sign: it is Ė Eᵀ (not E Ėᵀ), and e × ė (not ė × e).", anchor,
      [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d { return -angular_velocity_of_basis(basis, rate); });
  exercise.misconception("no_half",
                         "Your ω is twice too large: ω has only two components across each basis vector, so the sum "
                         "over three counts it twice.",
                         anchor, [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
                           return 2 * angular_velocity_of_basis(basis, rate);
                         });
  exercise.misconception(
      "half_too_much", "Your ω is half of what it should be; a single entry of Ė Eᵀ already is a whole component of ω.",
      anchor, [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
        return 0.5 * angular_velocity_of_basis(basis, rate);
      });
  exercise.misconception(
      "body_components_backwards",
      "These are the components of ω on the basis E itself, and with the wrong sign; asked for are the inertial ones.",
      anchor,
      [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d { return -vector_of(basis.transpose() * rate); });
  exercise.misconception("first_column_only",
                         "You use e₁ × ė₁ alone; one basis vector cannot tell how fast the frame turns about it.",
                         anchor, [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
                           return Vector3d(basis.col(0)).cross(Vector3d(rate.col(0)));
                         });
  exercise.misconception("omega_y_sign", "ω_y has the wrong sign: in Ė Eᵀ it stands with + in row x, column z.",
                         "frame_derivatives_cross", [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
                           const Vector3d omega = angular_velocity_of_basis(basis, rate);
                           return {omega.x(), -omega.y(), omega.z()};
                         });
  exercise.misconception("order_of_components",
                         "ω_x and ω_z have changed places: in Ė Eᵀ rows and columns x and y hold ω_z.",
                         "frame_derivatives_cross", [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
                           return angular_velocity_of_basis(basis, rate).reverse();
                         });
  exercise.misconception(
      "no_transpose", "You multiply Ė with E as it stands; the inverse of E is needed, which is its transpose.", anchor,
      [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d { return vector_of(rate * basis); });
  exercise.misconception("rate_as_matrix",
                         "You read ω off Ė itself; that is [ω]× only if the basis stands along the inertial axes.",
                         anchor, [](const Matrix3d&, const Matrix3d& rate) -> Vector3d { return vector_of(rate); });
  exercise.misconception(
      "speed_of_columns", "You return the speeds of the tips of the three basis vectors; they are no components of ω.",
      anchor, [](const Matrix3d&, const Matrix3d& rate) -> Vector3d { return rate.colwise().norm().transpose(); });

  for (int i = 0; i < 3; ++i) {
    const char* const names[] = {"e₁ × ė₁", "e₂ × ė₂", "e₃ × ė₃"};
    exercise.term(names[i], 0.5, [i](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
      return Vector3d(basis.col(i)).cross(Vector3d(rate.col(i)));
    });
  }

  exercise.route("read off Ė Eᵀ", [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
    return vector_of(rate * basis.transpose());
  });
  exercise.route("least squares", [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
    // ė = ω × e = −[e]× ω: nine equations for three unknowns.
    Eigen::Matrix<double, 9, 3> equations;
    Eigen::Matrix<double, 9, 1> rates;
    for (Eigen::Index i = 0; i < 3; ++i) {
      equations.middleRows<3>(3 * i) = -cross_matrix(basis.col(i));
      rates.segment<3>(3 * i) = rate.col(i);
    }
    return equations.colPivHouseholderQr().solve(rates);
  });
  exercise.route("components on the basis first", [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
    const Vector3d on_basis(rate.col(1).dot(basis.col(2)), rate.col(2).dot(basis.col(0)),
                            rate.col(0).dot(basis.col(1)));
    return basis * on_basis;
  });
  exercise.route("with the inverse", [](const Matrix3d& basis, const Matrix3d& rate) -> Vector3d {
    const Matrix3d W = rate * basis.inverse();
    return vector_of((W - W.transpose()) / 2);
  });

  exercise.sweep({"ω = (0.3, −0.2, 0.5) rad/s seen from bases turned about (1, 1, 1)",
                  "angle by which the basis is turned (rad)", "component of ω (rad/s)"},
                 {0, 2 * pi}, [turning](double angle) { return turning(turn(Vector3d::Ones(), angle), example_omega); },
                 {{"ω_x", 0, 0}, {"ω_y", 1, 0}, {"ω_z", 2, 0}});
}

}  // namespace

void workbook::judging::describe(Lecture& lecture) {
  describe_cross_matrix(lecture);
  describe_inertial_rate(lecture);
  describe_rotated_basis(lecture);
  describe_angular_velocity_of_basis(lecture);
}
