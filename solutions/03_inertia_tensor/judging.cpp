/// @file
/// How the exercises of lecture 03 are judged.
#include "rigid/inertia_tensor.hpp"
#include "solutions/judging/lecture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace {

using namespace rigid;
using namespace workbook;
using namespace workbook::judging;

using Points = std::tuple<VectorXd, Matrix3Xd>;
using TensorAndOmega = std::tuple<Matrix3d, Vector3d>;
using Cuboid = std::tuple<double, double, double, double>;

/// The four masses of the lecture's running example.
Points four_masses() {
  VectorXd m(4);
  m << 1, 2, 3, 4;
  Matrix3Xd r(3, 4);
  r.col(0) << 1, 0, 0;
  r.col(1) << 0, 2, 0;
  r.col(2) << 0, 0, 3;
  r.col(3) << 1, 1, 1;
  return {m, r};
}

Matrix3d tensor_of_four_masses() { return std::apply(inertia_of_points, four_masses()); }

Matrix3d diagonal_part(const Matrix3d& I) { return I.diagonal().asDiagonal(); }

/// The tensor with the signs of its products of inertia flipped.
Matrix3d products_flipped(const Matrix3d& I) { return 2 * diagonal_part(I) - I; }

Matrix3d about(const Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// The attitude with the Euler angles (0.3, 0.7, 1.1) of the notation page.
Matrix3d example_attitude() {
  return about(Vector3d::UnitZ(), 0.3) * about(Vector3d::UnitY(), 0.7) * about(Vector3d::UnitZ(), 1.1);
}

/// Eigenvalues from the characteristic polynomial by its trigonometric solution: a route without an eigensolver.
Vector3d moments_by_cubic_formula(const Matrix3d& I) {
  const double mean = I.trace() / 3;
  const Matrix3d deviator = I - mean * Matrix3d::Identity();
  const double p = std::sqrt(deviator.squaredNorm() / 6);
  if (p == 0) return Vector3d::Constant(mean);
  const double angle = std::acos(std::clamp((deviator / p).determinant() / 2, -1.0, 1.0)) / 3;
  const double third = 2 * std::numbers::pi / 3;
  return {mean + 2 * p * std::cos(angle + third), mean + 2 * p * std::cos(angle - third),
          mean + 2 * p * std::cos(angle)};
}

/// Eigenvalues and eigenvectors by Jacobi rotations, in ascending order; right-handed.
Matrix3d axes_by_jacobi_rotations(Matrix3d I) {
  Matrix3d axes = Matrix3d::Identity();
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        const double angle = 0.5 * std::atan2(2 * I(p, q), I(q, q) - I(p, p));
        Matrix3d turn = Matrix3d::Identity();
        turn(p, p) = turn(q, q) = std::cos(angle);
        turn(p, q) = std::sin(angle);
        turn(q, p) = -std::sin(angle);
        I = turn.transpose() * I * turn;
        axes = axes * turn;
      }
    }
  }
  Eigen::Vector3i order(0, 1, 2);
  std::sort(order.begin(), order.end(), [&](int i, int j) { return I(i, i) < I(j, j); });
  Matrix3d sorted;
  for (int i = 0; i < 3; ++i) sorted.col(i) = axes.col(order[i]);
  sorted.col(2) = sorted.col(0).cross(sorted.col(1));
  return sorted;
}

void describe_inertia_of_points(Lecture& lecture) {
  const auto [masses, points] = four_masses();
  auto& exercise = lecture.exercise("inertia_of_points", &inertia_of_points);
  exercise.argument("m", units::kilogram).argument("r", units::metre).result("I", units::moment_of_inertia);

  exercise.worked("the four masses of the lecture", masses, points);
  exercise.special("one mass on the z axis", VectorXd::Constant(1, 2.0), Matrix3Xd(Vector3d(0, 0, 3)));
  exercise.special("no mass at all", VectorXd(0), Matrix3Xd(3, 0));
  exercise.random("a cloud of points", 8, [](Random& random) {
    const int count = random.whole(3, 8);
    const Vector3d center = random.vector(2.0);
    return Points{random.masses(count), random.points(count, center)};
  });
  exercise.scale([](const VectorXd& m, const Matrix3Xd& r) {
    const double size = (r.colwise().squaredNorm() * m).sum();
    return size > 0 ? size : 1.0;  // no points: any scale tells zero from something
  });

  exercise.misconception(
      "products_positive",
      "Your products of inertia have the wrong sign: off the diagonal it is −Σ m xᵢxⱼ, with a minus.",
      "inertia_tensor_products",
      [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d { return products_flipped(inertia_of_points(m, r)); });
  exercise.misconception("plus_dyad", "You add m r r where the tensor subtracts it: I = Σ m (r² 1 − r r).",
                         "inertia_tensor_dyad", [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
                           return 2 * (r.colwise().squaredNorm() * m).sum() * Matrix3d::Identity() -
                                  inertia_of_points(m, r);
                         });
  exercise.misconception(
      "second_moment",
      "This is Σ m r r, the second moment of the mass: the term with r² 1 is missing, and the dyad enters with +.",
      "inertia_tensor_dyad",
      [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d { return r * m.asDiagonal() * r.transpose(); });
  exercise.misconception("diagonal_only", "Your products of inertia are zero; they vanish only on principal axes.",
                         "inertia_tensor_products", [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
                           return diagonal_part(inertia_of_points(m, r));
                         });
  exercise.misconception(
      "own_coordinate_on_diagonal",
      "Your diagonal holds Σ m x² instead of Σ m (y² + z²): what counts is the distance from the axis.",
      "inertia_tensor_dyad", [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
        const Matrix3d second = r * m.asDiagonal() * r.transpose();
        return 2 * diagonal_part(second) - second;
      });
  exercise.misconception(
      "masses_dropped", "The masses do not enter: every point counts with mass 1.", "inertia_tensor_dyad",
      [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d { return inertia_of_points(VectorXd::Ones(m.size()), r); });
  exercise.misconception("last_point_lost", "The last point is left out of the sum.", "inertia_tensor_dyad",
                         [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
                           const auto count = std::max<Eigen::Index>(m.size() - 1, 0);
                           return inertia_of_points(m.head(count), r.leftCols(count));
                         });
  exercise.misconception("first_point_lost", "The first point is left out of the sum: indices start at 0.",
                         "inertia_tensor_dyad", [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
                           const auto count = std::max<Eigen::Index>(m.size() - 1, 0);
                           return inertia_of_points(m.tail(count), r.rightCols(count));
                         });
  exercise.misconception("about_center_of_mass",
                         "This is the tensor about the centre of mass; asked for is the tensor about the origin.",
                         "inertia_tensor_origin", [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
                           if (m.size() == 0) return Matrix3d::Zero();
                           const Vector3d center = r * m / m.sum();
                           return inertia_of_points(m, r.colwise() - center);
                         });

  exercise.term("Σ m r² 1", 1.0, [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
    return (r.colwise().squaredNorm() * m).sum() * Matrix3d::Identity();
  });
  exercise.term("Σ m r r", -1.0,
                [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d { return r * m.asDiagonal() * r.transpose(); });
  exercise.property(PropertyKind::symmetric, "An inertia tensor is symmetric: I_xy = I_yx.", "inertia_tensor_dyad");
  exercise.property(PropertyKind::positive_semidefinite,
                    "An inertia tensor has no negative eigenvalue: no rotation has negative energy.",
                    "inertia_tensor_energy");

  exercise.route("minus the square of the cross matrix", [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
    Matrix3d I = Matrix3d::Zero();
    for (int p = 0; p < m.size(); ++p) {
      Matrix3d cross;
      cross << 0, -r(2, p), r(1, p), r(2, p), 0, -r(0, p), -r(1, p), r(0, p), 0;
      I -= m[p] * cross * cross;
    }
    return I;
  });
  exercise.route("entry by entry", [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
    Matrix3d I = Matrix3d::Zero();
    for (int p = static_cast<int>(m.size()) - 1; p >= 0; --p) {
      const double x = r(0, p), y = r(1, p), z = r(2, p);
      Matrix3d one;
      one << y * y + z * z, -x * y, -x * z, -x * y, x * x + z * z, -y * z, -x * z, -y * z, x * x + y * y;
      I += m[p] * one;
    }
    return I;
  });
  exercise.route("trace of the second moment", [](const VectorXd& m, const Matrix3Xd& r) -> Matrix3d {
    const Matrix3d second = r * m.asDiagonal() * r.transpose();
    return second.trace() * Matrix3d::Identity() - second;
  });

  exercise.sweep({"The mass of 4 kg moves out along its diagonal", "distance of the fourth mass along (1, 1, 1) (m)",
                  "entry of I (kg m²)"},
                 {0, 3},
                 [](double distance) {
                   auto [m, r] = four_masses();
                   r.col(3) = distance * Vector3d::Ones().normalized();
                   return Points{m, r};
                 },
                 {{"I_xx", 0, 0}, {"I_zz", 2, 2}, {"I_xy", 0, 1}});
}

void describe_kinetic_energy(Lecture& lecture) {
  auto& exercise = lecture.exercise("kinetic_energy", &kinetic_energy);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega", units::radian_per_second)
      .result("T", units::joule);

  exercise.worked("the four masses of the lecture", tensor_of_four_masses(), Vector3d(0.3, -0.2, 0.5));
  exercise.special("rotation about a principal axis", Vector3d(1, 2, 3).asDiagonal(), Vector3d(0, 2, 0));
  exercise.special("no rotation", tensor_of_four_masses(), Vector3d::Zero());
  exercise.random("a random body", 8, [](Random& random) {
    return TensorAndOmega{random.inertia_tensor(), random.vector(3.0)};
  });
  exercise.scale(
      [](const Matrix3d& I, const Vector3d& omega) { return I.norm() * std::max(omega.squaredNorm(), 1e-3) / 2; });

  exercise.misconception("no_half", "The factor ½ is missing: T = ½ ω·I·ω.", "inertia_tensor_energy",
                         [](const Matrix3d& I, const Vector3d& omega) { return omega.dot(I * omega); });
  exercise.misconception(
      "diagonal_only", "The products of inertia do not enter your energy; ω·I·ω has nine terms, not three.",
      "inertia_tensor_energy",
      [](const Matrix3d& I, const Vector3d& omega) { return kinetic_energy(diagonal_part(I), omega); });
  exercise.misconception(
      "mean_moment",
      "You use one number for the inertia, a third of the trace; the moment depends on the direction of ω.",
      "inertia_tensor_axis",
      [](const Matrix3d& I, const Vector3d& omega) { return 0.5 * I.trace() / 3 * omega.squaredNorm(); });
  exercise.misconception(
      "product_of_norms", "You multiply the lengths of L and ω; the energy needs their dot product, T = ½ L·ω.",
      "inertia_tensor_energy",
      [](const Matrix3d& I, const Vector3d& omega) { return 0.5 * (I * omega).norm() * omega.norm(); });
  exercise.misconception(
      "products_flipped", "You change the sign of the products of inertia; the tensor already carries their minus.",
      "inertia_tensor_products",
      [](const Matrix3d& I, const Vector3d& omega) { return kinetic_energy(products_flipped(I), omega); });
  exercise.misconception("omega_not_squared", "Your energy is linear in ω; it must be quadratic.",
                         "inertia_tensor_energy", [](const Matrix3d& I, const Vector3d& omega) {
                           const double speed = omega.norm();
                           return speed > 0 ? kinetic_energy(I, omega) / speed : 0.0;
                         });
  exercise.misconception("upper_triangle_once",
                         "Each product of inertia enters once; in ω·I·ω it enters twice, as I_xy and as I_yx.",
                         "inertia_tensor_energy", [](const Matrix3d& I, const Vector3d& omega) {
                           return 0.5 * omega.dot(Matrix3d(I.triangularView<Eigen::Upper>()) * omega);
                         });

  exercise.term("Σ Iᵢᵢ ωᵢ²", 0.5,
                [](const Matrix3d& I, const Vector3d& omega) { return I.diagonal().dot(omega.cwiseAbs2()); });
  exercise.term("Σ Iᵢⱼ ωᵢ ωⱼ (i < j)", 1.0, [](const Matrix3d& I, const Vector3d& omega) {
    return I(0, 1) * omega[0] * omega[1] + I(0, 2) * omega[0] * omega[2] + I(1, 2) * omega[1] * omega[2];
  });
  exercise.property(PropertyKind::nonnegative, "A kinetic energy is never negative.", "inertia_tensor_energy");

  exercise.route("half of L·ω",
                 [](const Matrix3d& I, const Vector3d& omega) { return angular_momentum(I, omega).dot(omega) / 2; });
  exercise.route("entry by entry", [](const Matrix3d& I, const Vector3d& omega) {
    double twice = 0;
    for (int j = 2; j >= 0; --j) {
      for (int i = 2; i >= 0; --i) twice += omega[i] * omega[j] * I(i, j);
    }
    return twice / 2;
  });
  exercise.route("on principal axes", [](const Matrix3d& I, const Vector3d& omega) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
    return 0.5 * solver.eigenvalues().dot((solver.eigenvectors().transpose() * omega).cwiseAbs2());
  });

  exercise.sweep(
      {"Energy over the direction of ω, |ω| = 1 rad/s", "angle of ω from the x axis in the xy plane (rad)", "T (J)"},
      {0, 2 * std::numbers::pi},
      [](double angle) {
        return TensorAndOmega{tensor_of_four_masses(), Vector3d(std::cos(angle), std::sin(angle), 0)};
      },
      {{"T", 0, 0}});
}

void describe_angular_momentum(Lecture& lecture) {
  auto& exercise = lecture.exercise("angular_momentum", &angular_momentum);
  exercise.argument("I", units::moment_of_inertia)
      .argument("omega", units::radian_per_second)
      .result("L", units::angular_momentum);

  exercise.worked("the four masses of the lecture", tensor_of_four_masses(), Vector3d(0.3, -0.2, 0.5));
  exercise.special("rotation about a principal axis", Vector3d(1, 2, 3).asDiagonal(), Vector3d(0, 2, 0));
  exercise.special("no rotation", tensor_of_four_masses(), Vector3d::Zero());
  exercise.random("a random body", 8, [](Random& random) {
    return TensorAndOmega{random.inertia_tensor(), random.vector(3.0)};
  });
  exercise.scale([](const Matrix3d& I, const Vector3d& omega) { return I.norm() * std::max(omega.norm(), 1e-3); });

  exercise.misconception("parallel_to_omega",
                         "Your L points along ω; that holds only when ω lies along a principal axis.",
                         "inertia_tensor_momentum", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
                           if (omega.isZero()) return Vector3d::Zero();
                           return moment_about_axis(I, omega) * omega;
                         });
  exercise.misconception(
      "diagonal_only", "The products of inertia do not enter your L; each component needs a whole row of I.",
      "inertia_tensor_momentum",
      [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return I.diagonal().cwiseProduct(omega); });
  exercise.misconception("mean_moment",
                         "You use one number for the inertia, a third of the trace, so your L is parallel to ω.",
                         "inertia_tensor_momentum",
                         [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return I.trace() / 3 * omega; });
  exercise.misconception(
      "products_flipped", "You change the sign of the products of inertia; the tensor already carries their minus.",
      "inertia_tensor_products",
      [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return products_flipped(I) * omega; });
  exercise.misconception(
      "rate_of_change", "This is ω × L, the rate at which L turns; asked for is L itself.", "inertia_tensor_momentum",
      [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return omega.cross(Vector3d(I * omega)); });
  exercise.misconception("inverse_tensor", "You solve I x = ω; the angular momentum is the product I ω.",
                         "inertia_tensor_momentum",
                         [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return I.ldlt().solve(omega); });

  exercise.term("Iᵢᵢ ωᵢ (diagonal)", 1.0,
                [](const Matrix3d& I, const Vector3d& omega) -> Vector3d { return I.diagonal().cwiseProduct(omega); });
  exercise.term("Σ Iᵢⱼ ωⱼ (j ≠ i)", 1.0, [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
    return I * omega - I.diagonal().cwiseProduct(omega);
  });

  exercise.route("row by row", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
    return {I.row(0).dot(omega), I.row(1).dot(omega), I.row(2).dot(omega)};
  });
  exercise.route("sum of columns", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
    return omega[2] * I.col(2) + omega[1] * I.col(1) + omega[0] * I.col(0);
  });
  exercise.route("gradient of the energy", [](const Matrix3d& I, const Vector3d& omega) -> Vector3d {
    // T is quadratic, so the central difference is exact for any step.
    Vector3d gradient;
    for (int i = 0; i < 3; ++i) {
      const Vector3d step = Vector3d::Unit(i);
      gradient[i] = (kinetic_energy(I, omega + step) - kinetic_energy(I, omega - step)) / 2;
    }
    return gradient;
  });

  exercise.sweep({"Angular momentum while ω turns in the xy plane, |ω| = 1 rad/s", "angle of ω from the x axis (rad)",
                  "component of L (kg m²/s)"},
                 {0, 2 * std::numbers::pi},
                 [](double angle) {
                   return TensorAndOmega{tensor_of_four_masses(), Vector3d(std::cos(angle), std::sin(angle), 0)};
                 },
                 {{"L_x", 0, 0}, {"L_y", 1, 0}, {"L_z", 2, 0}});
}

void describe_moment_about_axis(Lecture& lecture) {
  auto& exercise = lecture.exercise("moment_about_axis", &moment_about_axis);
  exercise.argument("I", units::moment_of_inertia)
      .argument("axis", units::none)
      .result("I_n", units::moment_of_inertia);

  exercise.worked("the four masses about (1, 2, 2)", tensor_of_four_masses(), Vector3d(1, 2, 2));
  exercise.special("a coordinate axis", tensor_of_four_masses(), Vector3d::UnitX());
  exercise.special("a very short axis vector", tensor_of_four_masses(), Vector3d(1e-5, 2e-5, -2e-5));
  exercise.random("a random body and axis", 8, [](Random& random) {
    return TensorAndOmega{random.inertia_tensor(), random.vector(random.uniform(1.5, 4))};
  });

  exercise.misconception(
      "not_normalised", "The axis is not normalised: divide by |n|², so that a longer arrow gives the same moment.",
      "inertia_tensor_axis", [](const Matrix3d& I, const Vector3d& axis) { return axis.dot(I * axis); });
  exercise.misconception("normalised_once", "You divide by |n| once; n stands twice in n·I·n, so divide by |n|².",
                         "inertia_tensor_axis",
                         [](const Matrix3d& I, const Vector3d& axis) { return axis.dot(I * axis) / axis.norm(); });
  exercise.misconception(
      "length_of_image",
      "This is |I n|, the length of the angular momentum; the moment about the axis is its component along n.",
      "inertia_tensor_axis", [](const Matrix3d& I, const Vector3d& axis) { return (I * axis).norm() / axis.norm(); });
  exercise.misconception(
      "diagonal_only", "The products of inertia do not enter; about a tilted axis they matter.", "inertia_tensor_axis",
      [](const Matrix3d& I, const Vector3d& axis) { return moment_about_axis(diagonal_part(I), axis); });
  exercise.misconception(
      "products_flipped", "You change the sign of the products of inertia; the tensor already carries their minus.",
      "inertia_tensor_products",
      [](const Matrix3d& I, const Vector3d& axis) { return moment_about_axis(products_flipped(I), axis); });
  exercise.misconception("energy", "This is half of n·I·n, an energy; the moment has no factor ½.",
                         "inertia_tensor_axis",
                         [](const Matrix3d& I, const Vector3d& axis) { return 0.5 * moment_about_axis(I, axis); });
  exercise.misconception("inverse", "You use the inverse tensor: 1/(n·I⁻¹·n) is another number than n·I·n.",
                         "inertia_tensor_axis", [](const Matrix3d& I, const Vector3d& axis) {
                           const Vector3d n = axis.normalized();
                           return 1 / n.dot(Vector3d(I.ldlt().solve(n)));
                         });

  exercise.term("Σ Iᵢᵢ nᵢ²", 1.0, [](const Matrix3d& I, const Vector3d& axis) {
    return I.diagonal().dot(axis.normalized().cwiseAbs2());
  });
  exercise.term("Σ Iᵢⱼ nᵢ nⱼ (i < j)", 2.0, [](const Matrix3d& I, const Vector3d& axis) {
    const Vector3d n = axis.normalized();
    return I(0, 1) * n[0] * n[1] + I(0, 2) * n[0] * n[2] + I(1, 2) * n[1] * n[2];
  });
  exercise.property(PropertyKind::nonnegative, "A moment of inertia is never negative.", "inertia_tensor_axis");

  exercise.route("n·I·n / n·n",
                 [](const Matrix3d& I, const Vector3d& axis) { return axis.dot(I * axis) / axis.squaredNorm(); });
  exercise.route("twice the energy at unit speed",
                 [](const Matrix3d& I, const Vector3d& axis) { return 2 * kinetic_energy(I, axis / axis.norm()); });
  exercise.route("entry of the turned tensor", [](const Matrix3d& I, const Vector3d& axis) {
    const Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(axis, Vector3d::UnitZ()).toRotationMatrix();
    return rotated_inertia(I, turn)(2, 2);
  });

  exercise.sweep(
      {"Moment about an axis that turns from x to y and beyond", "angle of the axis from x (rad)", "moment (kg m²)"},
      {0, std::numbers::pi},
      [](double angle) {
        return TensorAndOmega{tensor_of_four_masses(), 2 * Vector3d(std::cos(angle), std::sin(angle), 0)};
      },
      {{"I_n", 0, 0}});
}

void describe_cuboid_about_corner(Lecture& lecture) {
  const auto cuboid = [](double M, double a, double b, double c, double diagonal, double product) -> Matrix3d {
    const Vector3d edges(a, b, c);
    Matrix3d I = product * M * edges * edges.transpose();
    I.diagonal() = diagonal * M * (edges.squaredNorm() - edges.array().square());
    return I;
  };
  auto& exercise = lecture.exercise("cuboid_about_corner", &cuboid_about_corner);
  exercise.argument("M", units::kilogram)
      .argument("a", units::metre)
      .argument("b", units::metre)
      .argument("c", units::metre);
  exercise.result("I", units::moment_of_inertia);

  exercise.worked("6 kg, edges 1 m, 2 m, 3 m", 6, 1, 2, 3);
  exercise.special("the cube of the slides", 1, 1, 1, 1).blind();
  exercise.special("a thin rod along x", 2, 3, 0, 0);
  exercise.random("a random cuboid", 8, [](Random& random) {
    return Cuboid{random.uniform(1.5, 5), random.uniform(0.5, 1), random.uniform(1.2, 1.8), random.uniform(2, 3)};
  });

  exercise.misconception(
      "products_positive", "The products of inertia have the wrong sign: I_xy = −¼ M ab, with a minus.",
      "inertia_tensor_products",
      [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 3, 1. / 4); });
  exercise.misconception("diagonal_about_center",
                         "Your diagonal has 1/12, which belongs to the centre of the cuboid; about a corner it is 1/3.",
                         "inertia_tensor_cuboid", [cuboid](double M, double a, double b, double c) {
                           return cuboid(M, a, b, c, 1. / 12, -1. / 4);
                         });
  exercise.misconception("about_center", "This is the tensor about the centre of the cuboid; asked for is the corner.",
                         "inertia_tensor_cuboid",
                         [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 12, 0); });
  exercise.misconception(
      "products_third", "Your products have −1/3; the mean of xy over the body is ½a·½b, which gives −1/4.",
      "inertia_tensor_cuboid",
      [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 3, -1. / 3); });
  exercise.misconception(
      "products_half", "Your products have −1/2; the mean of xy over the body is ½a·½b, which gives −1/4.",
      "inertia_tensor_cuboid",
      [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 3, -1. / 2); });
  exercise.misconception("no_products",
                         "The products of inertia are missing; the corner's axes are not principal axes.",
                         "inertia_tensor_products",
                         [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 3, 0); });
  exercise.misconception(
      "diagonal_in_wrong_place",
      "I_xx holds a² + b²; about the x axis the other two edges count, b² + c² (and so on, in turn).",
      "inertia_tensor_cuboid", [cuboid](double M, double a, double b, double c) -> Matrix3d {
        Matrix3d I = cuboid(M, a, b, c, 1. / 3, -1. / 4);
        I.diagonal() = M / 3 * Vector3d(a * a + b * b, b * b + c * c, a * a + c * c);
        return I;
      });
  exercise.misconception("diagonal_reversed",
                         "I_xx holds a² + b² and I_zz holds b² + c²: the first and the last are exchanged.",
                         "inertia_tensor_cuboid", [cuboid](double M, double a, double b, double c) -> Matrix3d {
                           Matrix3d I = cuboid(M, a, b, c, 1. / 3, -1. / 4);
                           std::swap(I(0, 0), I(2, 2));
                           return I;
                         });
  exercise.misconception(
      "mass_dropped", "The mass does not enter.", "inertia_tensor_cuboid",
      [cuboid](double, double a, double b, double c) { return cuboid(1, a, b, c, 1. / 3, -1. / 4); });
  exercise.misconception("mass_as_density", "You take M for a density and multiply by the volume; M is the whole mass.",
                         "inertia_tensor_cuboid", [cuboid](double M, double a, double b, double c) {
                           return cuboid(M * a * b * c, a, b, c, 1. / 3, -1. / 4);
                         });

  exercise.term("M (b² + c²), M (a² + c²), M (a² + b²) on the diagonal", 1. / 3,
                [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1, 0); });
  exercise.term("M ab, M ac, M bc off the diagonal", -1. / 4,
                [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 0, 1); });
  exercise.property(PropertyKind::symmetric, "An inertia tensor is symmetric: I_xy = I_yx.", "inertia_tensor_dyad");
  exercise.property(PropertyKind::positive_semidefinite,
                    "An inertia tensor has no negative eigenvalue: no rotation has negative energy.",
                    "inertia_tensor_energy");

  exercise.route("Gauss quadrature over the body", [](double M, double a, double b, double c) -> Matrix3d {
    // Two Gauss points per edge integrate squares and products exactly: the cuboid acts as eight point masses.
    Matrix3Xd r(3, 8);
    for (int p = 0; p < 8; ++p) {
      const auto node = [p](int bit) { return 0.5 + ((p >> bit & 1) ? 0.5 : -0.5) / std::sqrt(3.0); };
      r.col(p) << a * node(0), b * node(1), c * node(2);
    }
    return inertia_of_points(VectorXd::Constant(8, M / 8), r);
  });
  exercise.route("centre and parallel axes", [cuboid](double M, double a, double b, double c) -> Matrix3d {
    const Vector3d d = Vector3d(a, b, c) / 2;
    return cuboid(M, a, b, c, 1. / 12, 0) + M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  });
  exercise.route("all nine entries", [](double M, double a, double b, double c) -> Matrix3d {
    Matrix3d I;
    I << (b * b + c * c) / 3, -a * b / 4, -a * c / 4, -a * b / 4, (a * a + c * c) / 3, -b * c / 4, -a * c / 4,
        -b * c / 4, (a * a + b * b) / 3;
    return M * I;
  });

  exercise.sweep({"A cuboid of 1 kg with edges a, 2 m, 3 m grows along x", "edge a (m)", "entry of I (kg m²)"}, {0, 4},
                 [](double a) {
                   return Cuboid{1, a, 2, 3};
                 },
                 {{"I_xx", 0, 0}, {"I_yy", 1, 1}, {"I_xy", 0, 1}});
}

/// Tensors with a double or triple moment, near and exact, that every eigensolver must survive.
template <class Exercise>
void add_tensors(Exercise& exercise) {
  exercise.worked("the cuboid of 6 kg with edges 1 m, 2 m, 3 m", cuboid_about_corner(6, 1, 2, 3));
  exercise.worked("the four masses of the lecture", tensor_of_four_masses());
  exercise.special("the cube about its corner (two equal moments)", cuboid_about_corner(1, 1, 1, 1));
  exercise.special("a sphere (three equal moments)", 2 * Matrix3d::Identity());
  exercise.special("already diagonal, not in order", Vector3d(3, 1, 2).asDiagonal());
  exercise.random("a random body", 8, [](Random& random) { return std::tuple<Matrix3d>{random.inertia_tensor()}; });
}

void describe_principal_moments(Lecture& lecture) {
  auto& exercise = lecture.exercise("principal_moments", &principal_moments);
  exercise.argument("I", units::moment_of_inertia).result("moments", units::moment_of_inertia);
  add_tensors(exercise);
  exercise.special("two moments nearly equal", Matrix3d(Vector3d(1, 1 + 1e-7, 1.5).asDiagonal()));
  exercise.tolerance_of_last_case(
      1e-7, "Where two moments nearly agree, the closed formula for the roots of a cubic loses half of its digits.");
  exercise.special("the cube about its corner, by a closed formula too", cuboid_about_corner(2, 1.5, 1.5, 1.5));
  exercise.tolerance_of_last_case(1e-7, "");

  exercise.misconception("diagonal_sorted",
                         "You sort the diagonal of I; it holds the principal moments only if the products vanish.",
                         "inertia_tensor_principal", [](const Matrix3d& I) -> Vector3d {
                           Vector3d moments = I.diagonal();
                           std::sort(moments.begin(), moments.end());
                           return moments;
                         });
  exercise.misconception("diagonal",
                         "You return the diagonal of I; it holds the principal moments only if the products vanish.",
                         "inertia_tensor_principal", [](const Matrix3d& I) -> Vector3d { return I.diagonal(); });
  exercise.misconception("descending", "The moments come in descending order; ascending is asked for.",
                         "inertia_tensor_principal",
                         [](const Matrix3d& I) -> Vector3d { return principal_moments(I).reverse(); });
  exercise.misconception(
      "products_flipped", "You change the sign of the products of inertia; the tensor already carries their minus.",
      "inertia_tensor_products", [](const Matrix3d& I) -> Vector3d { return principal_moments(products_flipped(I)); });
  exercise.misconception("squared", "These are the squares of the principal moments.", "inertia_tensor_principal",
                         [](const Matrix3d& I) -> Vector3d { return principal_moments(I).cwiseAbs2(); });
  exercise.misconception("lower_triangle_twice",
                         "Only one of I_xy and I_yx enters your matrix; give the solver the whole symmetric tensor.",
                         "inertia_tensor_principal", [](const Matrix3d& I) -> Vector3d {
                           const Matrix3d halved = 0.5 * (I + diagonal_part(I));
                           return principal_moments(halved);
                         });
  exercise.property(PropertyKind::ascending, "The moments are asked for in ascending order.",
                    "inertia_tensor_principal");
  exercise.property(PropertyKind::nonnegative, "A principal moment is never negative.", "inertia_tensor_principal");

  exercise.route("roots of the characteristic polynomial", &moments_by_cubic_formula);
  exercise.route("Jacobi rotations", [](const Matrix3d& I) -> Vector3d {
    const Matrix3d axes = axes_by_jacobi_rotations(I);
    return (axes.transpose() * I * axes).diagonal();
  });
  exercise.route("singular values", [](const Matrix3d& I) -> Vector3d {
    return Eigen::JacobiSVD<Matrix3d>(I).singularValues().reverse();
  });

  exercise.sweep(
      {"Principal moments of a 1 kg cuboid (a, 1 m, 2 m) about its corner", "edge a (m)", "principal moment (kg m²)"},
      {0.1, 3}, [](double a) { return std::tuple<Matrix3d>{cuboid_about_corner(1, a, 1, 2)}; },
      {{"I_1", 0, 0}, {"I_2", 1, 0}, {"I_3", 2, 0}});
}

void describe_principal_axes(Lecture& lecture) {
  auto& exercise = lecture.exercise("principal_axes", &principal_axes);
  exercise.argument("I", units::moment_of_inertia).result("axes", units::none);
  exercise.compare(Comparison::eigenvectors);
  add_tensors(exercise);

  exercise.misconception("rows", "The axes are the rows of your matrix; the columns are asked for (transpose it).",
                         "inertia_tensor_principal",
                         [](const Matrix3d& I) -> Matrix3d { return principal_axes(I).transpose(); });
  exercise.misconception("left_handed", "Your axes form a left-handed triad (determinant −1): turn one of them round.",
                         "inertia_tensor_principal", [](const Matrix3d& I) -> Matrix3d { return -principal_axes(I); });
  exercise.misconception(
      "unnormalised",
      "Your columns point along the principal axes but are not unit vectors: the third component is set to 1.",
      "inertia_tensor_principal", [](const Matrix3d& I) -> Matrix3d {
        Matrix3d axes = principal_axes(I);
        for (auto axis : axes.colwise()) axis /= axis[2];
        return axes;
      });
  exercise.misconception("descending", "The axes come in the order of descending moments; ascending is asked for.",
                         "inertia_tensor_principal", [](const Matrix3d& I) -> Matrix3d {
                           Matrix3d axes = principal_axes(I).rowwise().reverse();
                           axes.col(2) = -axes.col(2);
                           return axes;
                         });
  exercise.misconception(
      "products_flipped", "You change the sign of the products of inertia; the tensor already carries their minus.",
      "inertia_tensor_products", [](const Matrix3d& I) -> Matrix3d { return principal_axes(products_flipped(I)); });
  exercise.misconception(
      "identity", "You return the coordinate axes; they are principal axes only if the products of inertia vanish.",
      "inertia_tensor_principal", [](const Matrix3d&) -> Matrix3d { return Matrix3d::Identity(); });
  exercise.property(PropertyKind::rotation_matrix,
                    "Principal axes form an orthonormal, right-handed triad: VᵀV = 1, det V = +1.",
                    "inertia_tensor_principal");

  exercise.route("Jacobi rotations", &axes_by_jacobi_rotations);
  exercise.route("singular vectors", [](const Matrix3d& I) -> Matrix3d {
    Matrix3d axes = Eigen::JacobiSVD<Matrix3d>(I, Eigen::ComputeFullU).matrixU().rowwise().reverse();
    if (axes.determinant() < 0) axes.col(1) = -axes.col(1);
    return axes;
  });
  exercise.route("other signs", [](const Matrix3d& I) -> Matrix3d {
    Matrix3d axes = principal_axes(I);
    axes.col(0) = -axes.col(0);
    axes.col(1) = -axes.col(1);
    return axes;
  });

  exercise.sweep({"Axis of the smallest moment of a 1 kg cuboid (a, 1 m, 2 m) about its corner", "edge a (m)",
                  "component of the first axis, squared sign free"},
                 {0.1, 3}, [](double a) { return std::tuple<Matrix3d>{cuboid_about_corner(1, a, 1, 2)}; },
                 {{"e1_x", 0, 0}, {"e1_y", 1, 0}, {"e1_z", 2, 0}});
}

void describe_rotated_inertia(Lecture& lecture) {
  using Turned = std::tuple<Matrix3d, Matrix3d>;
  auto& exercise = lecture.exercise("rotated_inertia", &rotated_inertia);
  exercise.argument("I_body", units::moment_of_inertia)
      .argument("A", units::none)
      .result("I", units::moment_of_inertia);

  const Matrix3d moments = Vector3d(1, 2, 3).asDiagonal();
  exercise.worked("moments 1, 2, 3 and the attitude (0.3, 0.7, 1.1)", moments, example_attitude());
  exercise.special("no rotation", moments, Matrix3d::Identity());
  exercise.special("half a turn about z", tensor_of_four_masses(), about(Vector3d::UnitZ(), std::numbers::pi));
  exercise.random("a random body and attitude", 8, [](Random& random) {
    return Turned{random.inertia_tensor(), random.rotation()};
  });

  exercise.misconception("inverse_rotation", "You turn the tensor the wrong way: AᵀIA goes from inertial to body axes.",
                         "inertia_tensor_rotated",
                         [](const Matrix3d& I, const Matrix3d& A) -> Matrix3d { return A.transpose() * I * A; });
  exercise.misconception(
      "left_only", "You turn only one side: a tensor has two indices, so it takes A on the left and Aᵀ on the right.",
      "inertia_tensor_rotated", [](const Matrix3d& I, const Matrix3d& A) -> Matrix3d { return A * I; });
  exercise.misconception(
      "right_only",
      "You turn only the right side: a tensor has two indices, so it takes A on the left and Aᵀ on the right.",
      "inertia_tensor_rotated", [](const Matrix3d& I, const Matrix3d& A) -> Matrix3d { return I * A.transpose(); });
  exercise.misconception(
      "no_transpose", "A stands on both sides without a transpose: A I A; on the right it must be Aᵀ.",
      "inertia_tensor_rotated", [](const Matrix3d& I, const Matrix3d& A) -> Matrix3d { return A * I * A; });
  exercise.misconception("not_turned",
                         "You return the body's tensor unchanged; on inertial axes it depends on the attitude.",
                         "inertia_tensor_rotated", [](const Matrix3d& I, const Matrix3d&) -> Matrix3d { return I; });
  exercise.misconception(
      "diagonal_only", "You keep only the diagonal of the turned tensor; on general axes it has products.",
      "inertia_tensor_rotated",
      [](const Matrix3d& I, const Matrix3d& A) -> Matrix3d { return diagonal_part(rotated_inertia(I, A)); });
  exercise.property(PropertyKind::symmetric, "An inertia tensor is symmetric on every set of axes.",
                    "inertia_tensor_rotated");

  exercise.route("with the inverse",
                 [](const Matrix3d& I, const Matrix3d& A) -> Matrix3d { return A * (I * A.inverse()); });
  exercise.route("with a quaternion", [](const Matrix3d& I, const Matrix3d& A) -> Matrix3d {
    const Eigen::Quaterniond q(A);
    Matrix3d turned;
    for (int j = 0; j < 3; ++j) turned.col(j) = q * Vector3d(I * (q.conjugate() * Vector3d(Vector3d::Unit(j))));
    return turned;
  });
  exercise.route("turned principal axes", [](const Matrix3d& I, const Matrix3d& A) -> Matrix3d {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
    const Matrix3d axes = A * solver.eigenvectors();
    return axes * solver.eigenvalues().asDiagonal() * axes.transpose();
  });

  exercise.sweep({"The tensor diag(1, 2, 3) kg m² turned about the direction (1, 1, 1)", "angle of rotation (rad)",
                  "entry of I (kg m²)"},
                 {0, 2 * std::numbers::pi},
                 [moments](double angle) {
                   return Turned{moments, about(Vector3d::Ones(), angle)};
                 },
                 {{"I_xx", 0, 0}, {"I_xy", 0, 1}, {"I_xz", 0, 2}});
}

}  // namespace

void workbook::judging::describe(Lecture& lecture) {
  describe_inertia_of_points(lecture);
  describe_kinetic_energy(lecture);
  describe_angular_momentum(lecture);
  describe_moment_about_axis(lecture);
  describe_cuboid_about_corner(lecture);
  describe_principal_moments(lecture);
  describe_principal_axes(lecture);
  describe_rotated_inertia(lecture);
}
