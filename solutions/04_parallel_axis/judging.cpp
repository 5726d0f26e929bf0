/// @file
/// How the exercises of lecture 04 are judged.
#include "rigid/parallel_axis.hpp"
#include "solutions/judging/lecture.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace {

using namespace rigid;
using namespace workbook;
using namespace workbook::judging;

using TensorMassVector = std::tuple<Matrix3d, double, Vector3d>;
using Shift = std::tuple<Matrix3d, double, Vector3d, Vector3d>;
using Cuboid = std::tuple<double, double, double, double>;
using Tensors = std::vector<Matrix3d>;
using Assembly = std::tuple<VectorXd, Matrix3Xd, Tensors>;

/// The four masses of lecture 03: tensor about the origin, total mass, centre of mass.
struct FourMasses {
  Matrix3d I_origin{{43, -4, -4}, {-4, 36, -4}, {-4, -4, 17}};
  double M = 10;
  Vector3d r_cm{0.5, 0.8, 1.3};
  Matrix3d I_cm = inertia_to_center_of_mass(I_origin, M, r_cm);
};

Matrix3d diagonal_part(const Matrix3d& I) { return I.diagonal().asDiagonal(); }

/// The tensor with the signs of its products of inertia flipped.
Matrix3d products_flipped(const Matrix3d& I) { return 2 * diagonal_part(I) - I; }

Matrix3d unit(double size) { return size * Matrix3d::Identity(); }

/// r r, the matrix with entries rᵢ rⱼ.
Matrix3d dyad(const Vector3d& r) { return r * r.transpose(); }

/// Tensor of a unit mass at r.
Matrix3d of_unit_mass(const Vector3d& r) { return unit(r.squaredNorm()) - dyad(r); }

Matrix3d cross_matrix(const Vector3d& r) {
  return Matrix3d{{0, -r.z(), r.y()}, {r.z(), 0, -r.x()}, {-r.y(), r.x(), 0}};
}

/// Six equal masses with the mass, centre of mass (the origin) and inertia tensor of a given body: nothing that turns
/// can tell the two apart.
Matrix3Xd six_equivalent_positions(const Matrix3d& I_cm, double M) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> second_moment(unit(I_cm.trace() / 2) - I_cm);
  Matrix3Xd positions(3, 6);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double reach = std::sqrt(3 * std::max(second_moment.eigenvalues()[i], 0.0) / M);
    positions.col(2 * i) = reach * second_moment.eigenvectors().col(i);
    positions.col(2 * i + 1) = -positions.col(2 * i);
  }
  return positions;
}

/// Tensor of equal masses about the origin, straight from its definition.
Matrix3d of_equal_masses(double M, const Matrix3Xd& positions) {
  Matrix3d I = Matrix3d::Zero();
  for (const auto& position : positions.colwise())
    I += M / static_cast<double>(positions.cols()) * of_unit_mass(position);
  return I;
}

/// A symmetric matrix from its quadratic form, as the tensor is read off the energy.
template <class QuadraticForm>
Matrix3d from_quadratic_form(const QuadraticForm& form) {
  Matrix3d I;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3d sum = Vector3d::Unit(i) + Vector3d::Unit(j), difference = Vector3d::Unit(i) - Vector3d::Unit(j);
      I(i, j) = (form(sum) - form(difference)) / 4;
    }
  }
  return I;
}

template <class Exercise>
void add_properties(Exercise& exercise) {
  exercise.property(PropertyKind::symmetric, "An inertia tensor is symmetric: I_xy = I_yx.", "parallel_axis_theorem");
  exercise.property(PropertyKind::positive_semidefinite,
                    "An inertia tensor has no negative eigenvalue: no rotation has negative energy.",
                    "parallel_axis_theorem");
}

void describe_inertia_from_center_of_mass(Lecture& lecture) {
  const FourMasses body;
  auto& exercise = lecture.exercise("inertia_from_center_of_mass", &inertia_from_center_of_mass);
  exercise.argument("I_cm", units::moment_of_inertia).argument("M", units::kilogram).argument("d", units::metre);
  exercise.result("I", units::moment_of_inertia);

  exercise.worked("the four masses of lecture 03, seen from (1, −1, 2)", body.I_cm, body.M, Vector3d(1, -1, 2));
  exercise.special("no displacement", body.I_cm, body.M, Vector3d::Zero());
  exercise.special("a displacement along z only", body.I_cm, body.M, Vector3d(0, 0, 1.5)).blind();
  exercise.special("a point mass", Matrix3d::Zero(), 2, Vector3d(1, 2, 3));
  exercise.random("a random body and displacement", 8, [](Random& random) {
    return TensorMassVector{random.inertia_tensor(), random.uniform(1.5, 5), random.vector(2.0)};
  });

  exercise.misconception(
      "subtracted", "You subtract M (d² 1 − d d); going away from the centre of mass the moments grow, so it is added.",
      "parallel_axis_theorem",
      [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d { return I - M * of_unit_mass(d); });
  exercise.misconception("dyad_only", "You add only M d d; the theorem adds M (d² 1 − d d).", "parallel_axis_theorem",
                         [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d { return I + M * dyad(d); });
  exercise.misconception("dyad_added", "The dyad enters with the wrong sign: M (d² 1 − d d), with a minus.",
                         "parallel_axis_theorem", [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d {
                           return I + unit(M * d.squaredNorm()) + M * dyad(d);
                         });
  exercise.misconception(
      "isotropic",
      "You add M d² to every moment; what counts is the distance of each axis, so the dyad M d d must be taken off.",
      "parallel_axis_theorem",
      [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d { return I + unit(M * d.squaredNorm()); });
  exercise.misconception(
      "shift_without_products",
      "The products of inertia do not change in your result; off the diagonal the shift adds −M dᵢ dⱼ.",
      "parallel_axis_products", [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d {
        return I + diagonal_part(M * of_unit_mass(d));
      });
  exercise.misconception(
      "diagonal_only",
      "Your result has no products of inertia; the body's own and those of the shift both belong there.",
      "parallel_axis_products", [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d {
        return diagonal_part(I + M * of_unit_mass(d));
      });
  exercise.misconception(
      "shift_products_positive",
      "The products of the shift have the wrong sign: off the diagonal it adds −M dᵢ dⱼ, with a minus.",
      "parallel_axis_products", [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d {
        return I + M * products_flipped(of_unit_mass(d));
      });
  exercise.misconception(
      "own_coordinate",
      "The moment about x gains M d_x² in your result; it gains M (d_y² + d_z²), the squared distance from the axis.",
      "parallel_axis_theorem",
      [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d { return I + M * products_flipped(dyad(d)); });
  exercise.misconception("own_tensor_lost",
                         "This is the tensor of a single mass M at d; the body's own I_cm is missing.",
                         "parallel_axis_theorem",
                         [](const Matrix3d&, double M, const Vector3d& d) -> Matrix3d { return M * of_unit_mass(d); });
  exercise.misconception("mass_dropped", "The mass does not enter your shift: M (d² 1 − d d).", "parallel_axis_theorem",
                         [](const Matrix3d& I, double, const Vector3d& d) -> Matrix3d { return I + of_unit_mass(d); });

  exercise.term("I_cm", 1.0, [](const Matrix3d& I, double, const Vector3d&) -> Matrix3d { return I; });
  exercise.term("M d² 1", 1.0,
                [](const Matrix3d&, double M, const Vector3d& d) -> Matrix3d { return unit(M * d.squaredNorm()); });
  exercise.term("M d d", -1.0, [](const Matrix3d&, double M, const Vector3d& d) -> Matrix3d { return M * dyad(d); });
  add_properties(exercise);

  exercise.route("six equivalent masses", [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d {
    return of_equal_masses(M, six_equivalent_positions(I, M).colwise() - d);
  });
  exercise.route("minus the square of the cross matrix",
                 [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d {
                   return I - M * cross_matrix(d) * cross_matrix(d);
                 });
  exercise.route("read off the energy", [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d {
    return from_quadratic_form(
        [&](const Vector3d& omega) { return omega.dot(I * omega) + M * omega.cross(d).squaredNorm(); });
  });
  exercise.route("entry by entry", [](const Matrix3d& I, double M, const Vector3d& d) -> Matrix3d {
    const double x = d.x(), y = d.y(), z = d.z();
    return I + M * Matrix3d{{y * y + z * z, -x * y, -x * z},
                            {-x * y, x * x + z * z, -y * z},
                            {-x * z, -y * z, x * x + y * y}};
  });

  exercise.sweep({"The point moves from the centre of mass along (1, 2, −1)", "distance from the centre of mass (m)",
                  "entry of I (kg m²)"},
                 {0, 3},
                 [body](double distance) {
                   return TensorMassVector{body.I_cm, body.M, distance * Vector3d(1, 2, -1).normalized()};
                 },
                 {{"I_xx", 0, 0}, {"I_yy", 1, 1}, {"I_xy", 0, 1}});
}

void describe_inertia_to_center_of_mass(Lecture& lecture) {
  const FourMasses body;
  auto& exercise = lecture.exercise("inertia_to_center_of_mass", &inertia_to_center_of_mass);
  exercise.argument("I_origin", units::moment_of_inertia).argument("M", units::kilogram).argument("r_cm", units::metre);
  exercise.result("I_cm", units::moment_of_inertia);

  exercise.worked("the four masses of lecture 03", body.I_origin, body.M, body.r_cm);
  exercise.special("already at the centre of mass", body.I_cm, body.M, Vector3d::Zero());
  exercise.special("a cuboid of 6 kg with edges 1 m, 2 m, 3 m, from its corner",
                   Matrix3d{{26, -3, -4.5}, {-3, 20, -9}, {-4.5, -9, 10}}, 6, Vector3d(0.5, 1, 1.5));
  exercise
      .special("a centre of mass on the z axis", Matrix3d(Vector3d(2.55, 2.55, 0.3).asDiagonal()), 1,
               Vector3d(0, 0, 1.5))
      .blind();
  exercise.random("a random body off the origin", 8, [](Random& random) {
    const double M = random.uniform(1.5, 5);
    const Vector3d r_cm = random.vector(2.0);
    return TensorMassVector{random.inertia_tensor() + M * of_unit_mass(r_cm), M, r_cm};
  });
  // What is taken off can be much larger than what is left.
  exercise.scale([](const Matrix3d& I, double, const Vector3d&) { return I.norm(); });

  exercise.misconception(
      "added", "You add M (r_CM² 1 − r_CM r_CM); towards the centre of mass the moments shrink, so it is subtracted.",
      "parallel_axis_back",
      [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d { return I + M * of_unit_mass(r); });
  exercise.misconception(
      "subtracted_twice", "You subtract M (r_CM² 1 − r_CM r_CM) twice; once leads to the centre of mass.",
      "parallel_axis_back",
      [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d { return I - 2 * M * of_unit_mass(r); });
  exercise.misconception("isotropic",
                         "You take M r_CM² off every moment; what counts is the distance of each axis, so the dyad M "
                         "r_CM r_CM comes back.",
                         "parallel_axis_back", [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d {
                           return I - unit(M * r.squaredNorm());
                         });
  exercise.misconception("dyad_only", "You take off only M r_CM r_CM; it is M (r_CM² 1 − r_CM r_CM).",
                         "parallel_axis_back",
                         [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d { return I - M * dyad(r); });
  exercise.misconception(
      "dyad_subtracted",
      "The dyad enters with the wrong sign: I − M (r_CM² 1 − r_CM r_CM), so r_CM r_CM comes back with a plus.",
      "parallel_axis_back", [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d {
        return I - unit(M * r.squaredNorm()) - M * dyad(r);
      });
  exercise.misconception("shift_without_products",
                         "The products of inertia do not change in your result; off the diagonal the shift gives +M xᵢ "
                         "xⱼ of the centre of mass.",
                         "parallel_axis_products", [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d {
                           return I - diagonal_part(M * of_unit_mass(r));
                         });
  exercise.misconception("diagonal_only",
                         "Your result has no products of inertia; the shift to the centre of mass does not make a "
                         "tensor diagonal in general.",
                         "parallel_axis_products", [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d {
                           return diagonal_part(I - M * of_unit_mass(r));
                         });
  exercise.misconception(
      "shift_products_flipped",
      "The products of the shift have the wrong sign: off the diagonal it is I_ij + M xᵢ xⱼ of the centre of mass.",
      "parallel_axis_products", [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d {
        return I - M * products_flipped(of_unit_mass(r));
      });
  exercise.misconception("mass_dropped", "The mass does not enter your shift: M (r_CM² 1 − r_CM r_CM).",
                         "parallel_axis_back",
                         [](const Matrix3d& I, double, const Vector3d& r) -> Matrix3d { return I - of_unit_mass(r); });
  exercise.misconception("not_shifted", "You return the tensor about the origin unchanged.", "parallel_axis_back",
                         [](const Matrix3d& I, double, const Vector3d&) -> Matrix3d { return I; });

  exercise.term("I_origin", 1.0, [](const Matrix3d& I, double, const Vector3d&) -> Matrix3d { return I; });
  exercise.term("M r_cm² 1", -1.0,
                [](const Matrix3d&, double M, const Vector3d& r) -> Matrix3d { return unit(M * r.squaredNorm()); });
  exercise.term("M r_cm r_cm", 1.0,
                [](const Matrix3d&, double M, const Vector3d& r) -> Matrix3d { return M * dyad(r); });
  add_properties(exercise);

  exercise.route("by the second moment", [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d {
    const Matrix3d second_moment = unit(I.trace() / 2) - I - M * dyad(r);
    return unit(second_moment.trace()) - second_moment;
  });
  exercise.route("plus the square of the cross matrix", [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d {
    return I + M * cross_matrix(r) * cross_matrix(r);
  });
  exercise.route("the slides' formula with R = −r_cm", [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d {
    return inertia_about_shifted_origin(I, M, r, -r);
  });
  exercise.route("read off the energy", [](const Matrix3d& I, double M, const Vector3d& r) -> Matrix3d {
    return from_quadratic_form(
        [&](const Vector3d& omega) { return omega.dot(I * omega) - M * omega.cross(r).squaredNorm(); });
  });

  const double M = 6;
  exercise.sweep(
      {"Back to the centre of a cuboid (1 m, 2 m, 3 m) whose tensor is known about ever farther points",
       "distance of the centre along (1, 2, −1) (m)", "entry of I_cm (kg m²)"},
      {0, 3},
      [M](double distance) {
        const Vector3d r_cm = distance * Vector3d(1, 2, -1).normalized();
        return TensorMassVector{inertia_from_center_of_mass(cuboid_about_center(M, 1, 2, 3), M, r_cm), M, r_cm};
      },
      {{"I_xx", 0, 0}, {"I_zz", 2, 2}, {"I_xy", 0, 1}});
}

void describe_inertia_about_shifted_origin(Lecture& lecture) {
  const FourMasses body;
  auto& exercise = lecture.exercise("inertia_about_shifted_origin", &inertia_about_shifted_origin);
  exercise.argument("I_origin", units::moment_of_inertia).argument("M", units::kilogram);
  exercise.argument("r_cm", units::metre).argument("R", units::metre).result("I", units::moment_of_inertia);

  exercise.worked("the four masses of lecture 03 with R = (0.5, −1, 2)", body.I_origin, body.M, body.r_cm,
                  Vector3d(0.5, -1, 2));
  exercise.special("to the centre of mass, R = −r_cm", body.I_origin, body.M, body.r_cm, -body.r_cm).blind();
  exercise.special("from the centre of mass, r_cm = 0", body.I_cm, body.M, Vector3d::Zero(), Vector3d(1, -1, 2))
      .blind();
  exercise.special("no shift", body.I_origin, body.M, body.r_cm, Vector3d::Zero());
  exercise.special("to the mirror point, R = −2 r_cm", body.I_origin, body.M, body.r_cm, -2 * body.r_cm);
  exercise.random("a random body and shift", 8, [](Random& random) {
    const double M = random.uniform(1.5, 5);
    const Vector3d r_cm = random.vector(1.5);
    return Shift{random.inertia_tensor() + M * of_unit_mass(r_cm), M, r_cm, random.vector(2.0)};
  });
  // The terms cancel where the new origin lies near the centre of mass, so their size is the scale.
  exercise.scale([](const Matrix3d& I, double M, const Vector3d& r_cm, const Vector3d& R) {
    return I.norm() + M * R.norm() * (R.norm() + 2 * r_cm.norm());
  });

  const auto mixed = [](const Vector3d& r, const Vector3d& R) -> Matrix3d {
    return unit(2 * r.dot(R)) - r * R.transpose() - R * r.transpose();
  };
  exercise.misconception(
      "no_mixed_terms",
      "The terms with r_CM are missing: without them the formula holds only if the old origin is the centre of mass.",
      "parallel_axis_shift", [](const Matrix3d& I, double M, const Vector3d&, const Vector3d& R) -> Matrix3d {
        return I + M * of_unit_mass(R);
      });
  exercise.misconception("direction_of_R",
                         "The terms with r_CM have the wrong sign: R points from the new origin to the old one, so "
                         "positions become r + R.",
                         "parallel_axis_direction",
                         [](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
                           return inertia_about_shifted_origin(I, M, r, -R);
                         });
  exercise.misconception(
      "one_scalar_product", "r_CM·R enters once on your diagonal; it comes from 2 r·R in |r + R|², so it enters twice.",
      "parallel_axis_shift", [mixed](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
        return I + M * (of_unit_mass(R) + mixed(r, R) - unit(r.dot(R)));
      });
  exercise.misconception(
      "one_dyad_r_R", "Only one of the two dyads r_CM R and R r_CM enters, so your tensor is not symmetric.",
      "parallel_axis_shift", [mixed](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
        return I + M * (of_unit_mass(R) + mixed(r, R) + R * r.transpose());
      });
  exercise.misconception(
      "one_dyad_R_r", "Only one of the two dyads r_CM R and R r_CM enters, so your tensor is not symmetric.",
      "parallel_axis_shift", [mixed](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
        return I + M * (of_unit_mass(R) + mixed(r, R) + r * R.transpose());
      });
  exercise.misconception("no_scalar_product", "The term 2 r_CM·R on the diagonal is missing.", "parallel_axis_shift",
                         [mixed](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
                           return I + M * (of_unit_mass(R) + mixed(r, R) - unit(2 * r.dot(R)));
                         });
  exercise.misconception("no_dyads", "The dyads r_CM R and R r_CM are missing; they change the products of inertia.",
                         "parallel_axis_shift",
                         [](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
                           return I + M * (of_unit_mass(R) + unit(2 * r.dot(R)));
                         });
  exercise.misconception(
      "special_case",
      "You subtract M (R² 1 − R R), which is right only for R = −r_CM, the shift to the centre of mass.",
      "parallel_axis_back", [](const Matrix3d& I, double M, const Vector3d&, const Vector3d& R) -> Matrix3d {
        return I - M * of_unit_mass(R);
      });
  exercise.misconception("center_of_mass", "This is the tensor about the centre of mass; asked for is the point at −R.",
                         "parallel_axis_shift",
                         [](const Matrix3d& I, double M, const Vector3d& r, const Vector3d&) -> Matrix3d {
                           return I - M * of_unit_mass(r);
                         });
  exercise.misconception("displacement_from_center",
                         "You step from the centre of mass by R alone; its distance from the new origin is r_CM + R.",
                         "parallel_axis_shift",
                         [](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
                           return I - M * of_unit_mass(r) + M * of_unit_mass(R);
                         });
  exercise.misconception("origin_taken_for_center",
                         "You add M ((r_CM + R)² 1 − …) to the tensor about the old origin; it must be added to the "
                         "one about the centre of mass.",
                         "parallel_axis_shift",
                         [](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
                           return I + M * of_unit_mass(r + R);
                         });
  exercise.misconception("mixed_without_mass", "The mass does not enter the terms with r_CM.", "parallel_axis_shift",
                         [mixed](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
                           return I + M * of_unit_mass(R) + mixed(r, R);
                         });
  exercise.misconception("mass_dropped", "The mass does not enter your shift.", "parallel_axis_shift",
                         [mixed](const Matrix3d& I, double, const Vector3d& r, const Vector3d& R) -> Matrix3d {
                           return I + of_unit_mass(R) + mixed(r, R);
                         });
  exercise.misconception(
      "diagonal_only", "Your result has no products of inertia; a shift makes a tensor diagonal only in special cases.",
      "parallel_axis_products", [](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
        return diagonal_part(inertia_about_shifted_origin(I, M, r, R));
      });
  exercise.misconception("not_shifted", "You return the tensor about the old origin unchanged.", "parallel_axis_shift",
                         [](const Matrix3d& I, double, const Vector3d&, const Vector3d&) -> Matrix3d { return I; });

  exercise.term("I_origin", 1.0,
                [](const Matrix3d& I, double, const Vector3d&, const Vector3d&) -> Matrix3d { return I; });
  exercise.term("M R² 1", 1.0, [](const Matrix3d&, double M, const Vector3d&, const Vector3d& R) -> Matrix3d {
    return unit(M * R.squaredNorm());
  });
  exercise.term("M R R", -1.0,
                [](const Matrix3d&, double M, const Vector3d&, const Vector3d& R) -> Matrix3d { return M * dyad(R); });
  exercise.term("M r_cm·R 1", 2.0, [](const Matrix3d&, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
    return unit(M * r.dot(R));
  });
  exercise.term("M r_cm R", -1.0, [](const Matrix3d&, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
    return M * r * R.transpose();
  });
  exercise.term("M R r_cm", -1.0, [](const Matrix3d&, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
    return M * R * r.transpose();
  });
  add_properties(exercise);

  exercise.route("over the centre of mass",
                 [](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
                   return inertia_from_center_of_mass(inertia_to_center_of_mass(I, M, r), M, r + R);
                 });
  exercise.route(
      "six equivalent masses", [](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
        return of_equal_masses(M, six_equivalent_positions(inertia_to_center_of_mass(I, M, r), M).colwise() + (r + R));
      });
  exercise.route("squares of cross matrices",
                 [](const Matrix3d& I, double M, const Vector3d& r, const Vector3d& R) -> Matrix3d {
                   const Matrix3d before = cross_matrix(r), after = cross_matrix(r + R);
                   return I + M * (before * before - after * after);
                 });

  exercise.sweep({"The origin moves by s along (1, 2, −1)", "s, with R = −s (1, 2, −1)/√6 (m)", "entry of I (kg m²)"},
                 {-2, 3},
                 [body](double s) {
                   return Shift{body.I_origin, body.M, body.r_cm, -s * Vector3d(1, 2, -1).normalized()};
                 },
                 {{"I_xx", 0, 0}, {"I_yy", 1, 1}, {"I_xy", 0, 1}});
}

void describe_cuboid_about_center(Lecture& lecture) {
  // M × factor × (b² + c², a² + c², a² + b²) on the diagonal.
  const auto cuboid = [](double M, double a, double b, double c, double factor) -> Matrix3d {
    return Vector3d(factor * M * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b)).asDiagonal();
  };
  auto& exercise = lecture.exercise("cuboid_about_center", &cuboid_about_center);
  exercise.argument("M", units::kilogram)
      .argument("a", units::metre)
      .argument("b", units::metre)
      .argument("c", units::metre);
  exercise.result("I", units::moment_of_inertia);

  exercise.worked("6 kg, edges 1 m, 2 m, 3 m", 6, 1, 2, 3);
  exercise.special("a cube", 1, 1, 1, 1).blind();
  exercise.special("a thin rod along x", 2, 3, 0, 0);
  exercise.special("a thin plate across z", 2, 1, 3, 0);
  exercise.random("a random cuboid", 8, [](Random& random) {
    return Cuboid{random.uniform(1.5, 5), random.uniform(0.5, 1), random.uniform(1.2, 1.8), random.uniform(2, 3)};
  });

  exercise.misconception("third",
                         "Your moments have 1/3 instead of 1/12, four times too much: 1/3 belongs to half edges, or to "
                         "an axis along an edge.",
                         "parallel_axis_cuboid",
                         [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 3); });
  exercise.misconception(
      "sixth", "Your moments have 1/6 instead of 1/12: 1/6 is the cube's moment, where b² + c² is 2a².",
      "parallel_axis_cuboid", [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 6); });
  exercise.misconception(
      "halved_edges",
      "Your moments have 1/48 instead of 1/12, four times too little: a, b, c are the whole edges, not to be halved.",
      "parallel_axis_cuboid", [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 48); });
  exercise.misconception(
      "ellipsoid",
      "Your moments have 1/5, which belongs to an ellipsoid with half axes a, b, c; for a cuboid it is 1/12.",
      "parallel_axis_cuboid", [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 5); });
  exercise.misconception(
      "fourth_of_corner", "Your moments have 1/4, which is only what the shift takes off: 1/3 − 1/4 = 1/12 is left.",
      "parallel_axis_cuboid", [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1. / 4); });
  exercise.misconception("about_corner",
                         "This is the tensor about a corner; asked for is the centre, where the products vanish.",
                         "parallel_axis_cuboid", [cuboid](double M, double a, double b, double c) -> Matrix3d {
                           return inertia_from_center_of_mass(cuboid(M, a, b, c, 1. / 12), M, Vector3d(a, b, c) / 2);
                         });
  exercise.misconception("products_of_corner",
                         "Your diagonal is right, but about the centre the products of inertia vanish.",
                         "parallel_axis_cuboid", [cuboid](double M, double a, double b, double c) -> Matrix3d {
                           const Matrix3d shift = M / 4 * dyad(Vector3d(a, b, c));
                           return cuboid(M, a, b, c, 1. / 12) - shift + diagonal_part(shift);
                         });
  exercise.misconception(
      "own_edge", "I_xx holds only a²; about the x axis the other two edges count, b² + c² (and so on, in turn).",
      "parallel_axis_cuboid", [](double M, double a, double b, double c) -> Matrix3d {
        return Vector3d(M / 12 * Vector3d(a * a, b * b, c * c)).asDiagonal();
      });
  exercise.misconception(
      "all_edges", "All three edges enter each of your moments; about the x axis only b and c count.",
      "parallel_axis_cuboid",
      [](double M, double a, double b, double c) -> Matrix3d { return unit(M / 12 * (a * a + b * b + c * c)); });
  exercise.misconception(
      "edges_shifted", "I_xx holds a² + b²; about the x axis the other two edges count, b² + c² (and so on, in turn).",
      "parallel_axis_cuboid", [](double M, double a, double b, double c) -> Matrix3d {
        return Vector3d(M / 12 * Vector3d(a * a + b * b, b * b + c * c, a * a + c * c)).asDiagonal();
      });
  exercise.misconception("edges_reversed",
                         "I_xx holds a² + b² and I_zz holds b² + c²: the first and the last are exchanged.",
                         "parallel_axis_cuboid", [](double M, double a, double b, double c) -> Matrix3d {
                           return Vector3d(M / 12 * Vector3d(a * a + b * b, a * a + c * c, b * b + c * c)).asDiagonal();
                         });
  exercise.misconception("mass_dropped", "The mass does not enter.", "parallel_axis_cuboid",
                         [cuboid](double, double a, double b, double c) { return cuboid(1, a, b, c, 1. / 12); });
  exercise.misconception("mass_as_density", "You take M for a density and multiply by the volume; M is the whole mass.",
                         "parallel_axis_cuboid", [cuboid](double M, double a, double b, double c) {
                           return cuboid(M * a * b * c, a, b, c, 1. / 12);
                         });
  exercise.misconception(
      "integer_division",
      "Your tensor is zero; if you wrote 1/12, that is 0 in C++, a quotient of two integers: write 1.0/12.",
      "parallel_axis_cuboid", [](double, double, double, double) -> Matrix3d { return Matrix3d::Zero(); });

  exercise.term("M (b² + c²), M (a² + c²), M (a² + b²) on the diagonal", 1. / 12,
                [cuboid](double M, double a, double b, double c) { return cuboid(M, a, b, c, 1); });
  add_properties(exercise);

  exercise.route("Gauss quadrature over the body", [](double M, double a, double b, double c) -> Matrix3d {
    // Two Gauss points per edge integrate squares exactly: the cuboid acts as eight point masses.
    Matrix3Xd corners(3, 8);
    for (int p = 0; p < 8; ++p) {
      const auto node = [p](int bit) { return ((p >> bit & 1) ? 0.5 : -0.5) / std::sqrt(3.0); };
      corners.col(p) << a * node(0), b * node(1), c * node(2);
    }
    return of_equal_masses(M, corners);
  });
  exercise.route("from the corner, by the slides", [](double M, double a, double b, double c) -> Matrix3d {
    const Matrix3d corner = M * Matrix3d{{(b * b + c * c) / 3, -a * b / 4, -a * c / 4},
                                         {-a * b / 4, (a * a + c * c) / 3, -b * c / 4},
                                         {-a * c / 4, -b * c / 4, (a * a + b * b) / 3}};
    const Vector3d center(a / 2, b / 2, c / 2);
    return inertia_about_shifted_origin(corner, M, center, -center);
  });
  exercise.route("cut into eight, again and again", [](double M, double a, double b, double c) -> Matrix3d {
    // A cuboid is eight cuboids of half its size at a quarter of its edges. If I = x M a², then x = x/4 + 1/16.
    double x = 0;
    for (int cut = 0; cut < 40; ++cut) x = x / 4 + 1.0 / 16;
    return Vector3d(x * M * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b)).asDiagonal();
  });

  exercise.sweep({"A cuboid of 1 kg with edges a, 2 m, 3 m grows along x", "edge a (m)", "entry of I (kg m²)"}, {0, 4},
                 [](double a) {
                   return Cuboid{1, a, 2, 3};
                 },
                 {{"I_xx", 0, 0}, {"I_yy", 1, 1}, {"I_zz", 2, 2}});
}

void describe_combined_inertia(Lecture& lecture) {
  auto& exercise = lecture.exercise("combined_inertia", &combined_inertia);
  exercise.argument("masses", units::kilogram)
      .argument("centers", units::metre)
      .argument("tensors", units::moment_of_inertia);
  exercise.result("I", units::moment_of_inertia);

  const auto sum_of_tensors = [](const Tensors& tensors) -> Matrix3d {
    Matrix3d sum = Matrix3d::Zero();
    for (const Matrix3d& I : tensors) sum += I;
    return sum;
  };
  // Σ m (d² 1 − d d) for the distances from any one point.
  const auto as_points_about = [](const VectorXd& m, const Matrix3Xd& r, const Vector3d& point) -> Matrix3d {
    Matrix3d sum = Matrix3d::Zero();
    for (int k = 0; k < m.size(); ++k) sum += m[k] * of_unit_mass(r.col(k) - point);
    return sum;
  };
  const auto center = [](const VectorXd& m, const Matrix3Xd& r) -> Vector3d { return r * m / m.sum(); };

  const Matrix3d first = Vector3d(1, 2, 2.5).asDiagonal(), second = Vector3d(0.5, 0.6, 0.7).asDiagonal();
  Matrix3Xd two_places(3, 2);
  two_places << 0, 1, 0, 2, 0, 3;
  exercise.worked("2 kg at the origin and 3 kg at (1, 2, 3) m", VectorXd{{2, 3}}, two_places, Tensors{first, second});
  exercise.special("one body alone, away from the origin", VectorXd{{2}}, Matrix3Xd(Vector3d(1, -2, 3)),
                   Tensors{first});
  exercise.special("two bodies at one place", VectorXd{{2, 3}}, Matrix3Xd(Vector3d(1, -2, 3).replicate<1, 2>()),
                   Tensors{first, second});
  exercise.special("point masses only", VectorXd{{1, 2, 3, 4}}, Matrix3Xd{{1, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 3, 1}},
                   Tensors(4, Matrix3d::Zero()));
  exercise.random("a random assembly", 8, [](Random& random) {
    const int count = random.whole(2, 5);
    Assembly assembly{random.masses(count), Matrix3Xd(3, count), Tensors{}};
    auto& [masses, centers, tensors] = assembly;
    masses[0] += 3;  // equal masses would put the centre of mass into the mean of the centres
    for (auto place : centers.colwise()) place = random.vector(2.0) + Vector3d(1, -2, 1.5);
    for (int k = 0; k < count; ++k) tensors.push_back(random.inertia_tensor());
    return assembly;
  });

  exercise.misconception(
      "sum_of_tensors",
      "You add the tensors as they are; each belongs to its own centre and must first be carried to the common one.",
      "parallel_axis_combined",
      [sum_of_tensors](const VectorXd&, const Matrix3Xd&, const Tensors& tensors) -> Matrix3d {
        return sum_of_tensors(tensors);
      });
  exercise.misconception("about_origin", "This is the tensor about the origin; asked for is the common centre of mass.",
                         "parallel_axis_combined",
                         [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
                           return sum_of_tensors(tensors) + as_points_about(m, r, Vector3d::Zero());
                         });
  exercise.misconception(
      "mean_of_centers",
      "You take the mean of the centres for the common centre of mass; each centre counts with its mass.",
      "parallel_axis_combined", [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
        return sum_of_tensors(tensors) + as_points_about(m, r, r.rowwise().mean());
      });
  exercise.misconception(
      "about_first_body",
      "This is the tensor about the centre of the first body; asked for is the common centre of mass.",
      "parallel_axis_combined", [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
        return sum_of_tensors(tensors) + as_points_about(m, r, r.col(0));
      });
  exercise.misconception("points_only", "You treat the bodies as points; their own tensors are missing from the sum.",
                         "parallel_axis_combined",
                         [=](const VectorXd& m, const Matrix3Xd& r, const Tensors&) -> Matrix3d {
                           return as_points_about(m, r, center(m, r));
                         });
  exercise.misconception(
      "shift_subtracted",
      "You subtract m (d² 1 − d d); the step leads away from each body's own centre of mass, so it is added.",
      "parallel_axis_combined", [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
        return sum_of_tensors(tensors) - as_points_about(m, r, center(m, r));
      });
  exercise.misconception(
      "shift_products_positive",
      "The products of the shifts have the wrong sign: off the diagonal each adds −m dᵢ dⱼ, with a minus.",
      "parallel_axis_products", [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
        return sum_of_tensors(tensors) + products_flipped(as_points_about(m, r, center(m, r)));
      });
  exercise.misconception("shift_without_products",
                         "The shifts add nothing to your products of inertia; off the diagonal each adds −m dᵢ dⱼ.",
                         "parallel_axis_products",
                         [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
                           return sum_of_tensors(tensors) + diagonal_part(as_points_about(m, r, center(m, r)));
                         });
  exercise.misconception(
      "isotropic",
      "Each body adds m d² to every moment in your result; what counts is the distance of each axis, m (d² 1 − d d).",
      "parallel_axis_theorem", [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
        return sum_of_tensors(tensors) + unit(as_points_about(m, r, center(m, r)).trace() / 2);
      });
  exercise.misconception("diagonal_only", "Your result has no products of inertia; an assembly has them in general.",
                         "parallel_axis_products",
                         [](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
                           return diagonal_part(combined_inertia(m, r, tensors));
                         });
  exercise.misconception(
      "masses_dropped_in_shift", "The masses do not enter your shifts: each body adds m (d² 1 − d d).",
      "parallel_axis_combined", [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
        return sum_of_tensors(tensors) + as_points_about(VectorXd::Ones(m.size()), r, center(m, r));
      });
  exercise.misconception("total_mass_at_center",
                         "You add the shift of the total mass to the sum of the tensors; what counts is how far each "
                         "body is from the common centre.",
                         "parallel_axis_combined",
                         [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
                           return sum_of_tensors(tensors) + m.sum() * of_unit_mass(center(m, r));
                         });

  exercise.term("Σ Iₖ", 1.0, [sum_of_tensors](const VectorXd&, const Matrix3Xd&, const Tensors& tensors) -> Matrix3d {
    return sum_of_tensors(tensors);
  });
  exercise.term("Σ mₖ dₖ² 1", 1.0, [=](const VectorXd& m, const Matrix3Xd& r, const Tensors&) -> Matrix3d {
    return unit(as_points_about(m, r, center(m, r)).trace() / 2);
  });
  exercise.term("Σ mₖ dₖ dₖ", -1.0, [center](const VectorXd& m, const Matrix3Xd& r, const Tensors&) -> Matrix3d {
    const Matrix3Xd d = r.colwise() - center(m, r);
    return d * m.asDiagonal() * d.transpose();
  });
  add_properties(exercise);

  exercise.route("about the origin, then to the centre of mass",
                 [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
                   const Matrix3d about_origin = sum_of_tensors(tensors) + as_points_about(m, r, Vector3d::Zero());
                   return inertia_to_center_of_mass(about_origin, m.sum(), center(m, r));
                 });
  exercise.route("pair by pair", [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
    // The centre of mass is never needed: Σ m d d = Σ over pairs of m m' / M times the dyad of their distance.
    Matrix3d I = sum_of_tensors(tensors);
    for (int k = 0; k < m.size(); ++k) {
      for (int l = 0; l < k; ++l) I += m[k] * m[l] / m.sum() * of_unit_mass(r.col(k) - r.col(l));
    }
    return I;
  });
  exercise.route("one body after another",
                 [](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
                   Matrix3d I = tensors[0];
                   double mass = m[0];
                   Vector3d place = r.col(0);
                   for (int k = 1; k < m.size(); ++k) {
                     const double reduced = mass * m[k] / (mass + m[k]);
                     I += tensors[static_cast<std::size_t>(k)] + reduced * of_unit_mass(r.col(k) - place);
                     place = (mass * place + m[k] * r.col(k)) / (mass + m[k]);
                     mass += m[k];
                   }
                   return I;
                 });
  exercise.route("six equivalent masses for each body",
                 [=](const VectorXd& m, const Matrix3Xd& r, const Tensors& tensors) -> Matrix3d {
                   Matrix3d I = Matrix3d::Zero();
                   for (int k = 0; k < m.size(); ++k) {
                     const Vector3d d = r.col(k) - center(m, r);
                     I += of_equal_masses(
                         m[k], six_equivalent_positions(tensors[static_cast<std::size_t>(k)], m[k]).colwise() + d);
                   }
                   return I;
                 });

  exercise.sweep({"The 3 kg body moves away from the 2 kg body along (1, 2, 3)", "distance of their centres (m)",
                  "entry of I (kg m²)"},
                 {0, 4},
                 [first, second](double distance) {
                   Matrix3Xd places = Matrix3Xd::Zero(3, 2);
                   places.col(1) = distance * Vector3d(1, 2, 3).normalized();
                   return Assembly{VectorXd{{2, 3}}, places, Tensors{first, second}};
                 },
                 {{"I_xx", 0, 0}, {"I_zz", 2, 2}, {"I_yz", 1, 2}});
}

}  // namespace

void workbook::judging::describe(Lecture& lecture) {
  describe_inertia_from_center_of_mass(lecture);
  describe_inertia_to_center_of_mass(lecture);
  describe_inertia_about_shifted_origin(lecture);
  describe_cuboid_about_center(lecture);
  describe_combined_inertia(lecture);
}
