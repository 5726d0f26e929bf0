#include "solutions/03_inertia_tensor/shared.hpp"

static double largest_entry(const Matrix3d& I) { return I.cwiseAbs().maxCoeff(); }
static double asymmetry(const Matrix3d& I) { return largest_entry(I - I.transpose()); }

/// The smallest second moment, with the symmetric part of I.
static double smallest_spread(const Matrix3d& I) {
  return PrincipalFrame(moment_of_tensor(0.5 * (I + I.transpose()))).moments[0];
}

static int is_symmetric_and(const Matrix3d& I, bool holds) { return holds && asymmetry(I) <= 1e-9 * largest_entry(I); }

static int by_principal_minors(const Matrix3d& I) {
  const double size = or_one(largest_entry(I));
  const Matrix3d C = moment_of_tensor(I) / size;
  bool holds = C.determinant() >= -1e-9;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    holds = holds && C(i, i) >= -1e-9 && C(i, i) * C(j, j) - C(i, j) * C(j, i) >= -1e-9;
  }
  return is_symmetric_and(I, holds);
}

/// Six masses of ½ kg on the principal axes have this tensor, if any body has it.
static int by_building_a_body(const Matrix3d& I) {
  const Matrix3d built = inertia_of_points(VectorXd::Constant(6, 0.5), six_points(I, 3));
  return is_symmetric_and(I, largest_entry(built - I) <= 2e-9 * largest_entry(I));
}

/// On axes that are turned at random.
static Matrix3d on_turned_axes(Random& random, const Vector3d& moments) {
  const Matrix3d A = random.rotation();
  const Matrix3d I = A * moments.asDiagonal() * A.transpose();
  return (I + I.transpose()) / 2;
}

void judge_is_inertia_tensor(Lecture& lecture) {
  auto& e = lecture.exercise(&rigid::is_inertia_tensor, {{"I", kg_m2}}, {"answer", none});
  e.domain([](auto& I) {
    const double violation = max(asymmetry(I), -2 * smallest_spread(I)) / or_one(largest_entry(I));
    return violation < 5e-10 || violation > 1e-6;
  });
  e.scale(1.0);
  const auto diagonal = [](double x, double y, double z) -> Matrix3d { return Vector3d(x, y, z).asDiagonal(); };
  const Matrix3d A = attitude({0.3, 0.7, 1.1});
  e.worked("the four masses of the lecture", tensor_of_four_masses);
  e.worked("a harmless diagonal", Matrix3d{{2, -0.8, 0}, {-0.8, 2, -0.8}, {0, -0.8, 2}});
  e.worked("one moment too large", diagonal(10, 10, 30));
  e.worked("another moment too large", diagonal(30, 10, 10));
  e.worked("positive entries and positive moments", Matrix3d{{3, 2, 2}, {2, 3, 2}, {2, 2, 3}});
  e.worked("not symmetric", Matrix3d{{3, 1, 0}, {-1, 3, 0}, {0, 0, 3}});
  e.worked("a flat body on turned axes", A * diagonal(1, 2, 3) * A.transpose());
  e.special("a rod on turned axes", A * diagonal(0, 2, 2) * A.transpose());
  e.special("a flat body", diagonal(3, 1, 2));
  e.special("very small, and no body", 1e-12 * diagonal(2, 2, 5));
  e.special("very small, a body", 1e-12 * diagonal(2, 4, 5));
  e.special("hardly asymmetric", Matrix3d{{3, 1, 0}, {1 + 1e-5, 3, 0}, {0, 0, 3}});
  e.special("hardly too large", diagonal(2, 3, 5 + 1e-5));
  e.special("flat but for rounding", diagonal(1, 2, 3 * (1 + 3e-10)));
  e.special("symmetric but for rounding", Matrix3d{{3, 1, 0}, {1 + 3e-10, 3, 0}, {0, 0, 3}});
  e.special("a negative moment", diagonal(3, -1, 3));
  e.special("negative throughout", diagonal(-2, -2, -3));
  e.special("a single point at the origin", Matrix3d::Zero());
  e.limit("a single point at the origin", 1, "A mass at the origin has no moment about any axis, and that is allowed.");
  e.limit("a negative moment", 0, "A moment is a sum of masses times squares of distances.");
  e.random("a body on turned axes", 4, &Random::inertia_tensor);
  e.random("a flat body, turned", 3, [](Random& random) {
    const double x = random.uniform(0.5, 1.5), y = random.uniform(0.5, 1.5);
    return on_turned_axes(random, {x, y, x + y});
  });
  e.random("one moment too large, turned", 4, [](Random& random) {
    const double x = random.uniform(0.5, 1.5), y = random.uniform(0.5, 1.5);
    return on_turned_axes(random, {x, y, random.uniform(1.05, 1.6) * (x + y)});
  });
  e.random("a body's tensor that lost its symmetry", 3, [](Random& random) -> Matrix3d {
    return random.inertia_tensor() + random.uniform(0.01, 0.1) * skew(random.vector());
  });
  e.sweep({"3 kg m² on the diagonal and p in every other place", "product of inertia p (kg m²)", "1: some body has it"},
          {"answer"}, {-3, 3}, [](auto p) {
            return Matrix3d{{3, p, p}, {p, 3, p}, {p, p, 3}};
          });

  e.wrong(
      "This comes out when every symmetric matrix without negative eigenvalues is accepted; a body obeys a stronger "
      "condition.",
      "positive_only", [](auto& I) { return is_symmetric_and(I, PrincipalFrame(I).moments[0] >= 0); });
  e.wrong(
      "This comes out when the triangle inequalities are asked of the diagonal entries; on rotated axes they are not "
      "enough.",
      "diagonal_only", [](auto& I) {
        const Vector3d entries = I.diagonal();
        return is_symmetric_and(I, entries.sum() - 2 * entries.maxCoeff() >= -1e-9 * largest_entry(I));
      });
  e.wrong({"This comes out when matrices that are not symmetric are accepted.", "inertia_tensor_dyad"},
          "symmetry_not_asked", [](auto& I) { return smallest_spread(I) >= -1e-9 * largest_entry(I) ? 1 : 0; });
  e.wrong("This comes out when flat bodies are refused: equality is allowed, and rounding may violate it by a little.",
          "flat_refused", [](auto& I) { return is_symmetric_and(I, smallest_spread(I) > 1e-9 * largest_entry(I)); });
  e.wrong("This comes out when one of the three inequalities is asked for only.", "one_inequality",
          [](auto& I) { return is_symmetric_and(I, I(0, 0) + I(1, 1) - I(2, 2) >= -1e-9 * largest_entry(I)); });
  e.wrong_output("Yes and no are exchanged: 1 is asked for where a body has this tensor.", "exchanged",
                 [](auto& answer) { return 1 - answer; });
  e.route("eigenvalues of the second moments",
          [](auto& I) { return is_symmetric_and(I, smallest_spread(I) >= -1e-9 * largest_entry(I)); });
  e.route("principal minors of the second moments", by_principal_minors);
  e.route("a body of six masses", by_building_a_body);
  e.survivor("rounding = ",
             "Every bound between 1e-9 and 1e-6 of the largest entry is right; the largest entry of a tensor is on its "
             "diagonal.");
  e.survivor("I.transpose()).maxCoeff()", "With an entry, I − Iᵀ holds its opposite.");
  e.survivor("moments = ", "The bound may be twice as large or half.");
  e.survivor("- 2.0 *rounding", "The bound may be twice as large.");
  e.survivor("- 0.5 *rounding", "The bound may be half as large.");
}
