#include "solutions/03_inertia_tensor/shared.hpp"

void judge_inertia_of_points(Lecture& lecture) {
  auto& e = lecture.exercise(&inertia_of_points, {{"m", positive(kg)}, {"r", metre}}, {"I", kg_m2});
  e.domain([](auto& m, auto& r) { return m.size() == r.cols(); });
  const auto [masses, points] = four_masses();
  e.worked("the four masses of the lecture", masses, points);
  e.special("one mass on the z axis", VectorXd{{2}}, Vector3d(0, 0, 3));
  e.special("no mass at all", VectorXd(0), Matrix3Xd(3, 0));
  e.random("a cloud of points", 8, [](auto& r) {
    const int count = r.whole(3, 8);
    const Vector3d center = r.vector(2.0);
    return tuple{r.masses(count), r.points(count, center)};
  });
  e.scale([](auto& m, auto& r) { return or_one(second_moment(m, r).trace()); });
  e.sweep({"The mass of 4 kg moves out along its diagonal", "distance of the fourth mass along (1, 1, 1) (m)",
           "entry of I (kg m²)"},
          {"I_xx", {"I_zz", 2, 2}, {"I_xy", 0, 1}}, {0, 3}, [](auto distance) {
            auto [m, r] = four_masses();
            r.col(3) = distance * Vector3d::Ones().normalized();
            return tuple(m, r);
          });

  e.term("Σ m r² 1", 1, [](auto& m, auto& r) { return second_moment(m, r).trace() * Matrix3d::Identity(); });
  e.term("Σ m r r", -1, [](auto& m, auto& r) { return second_moment(m, r); });
  e.wrong_output({"Your products of inertia have the wrong sign: I_xy = −Σ m x y.", "inertia_tensor_products"},
                 "products_positive", products_flipped);
  e.wrong_terms("The dyad m r r enters with a plus; it is I = Σ m (r² 1 − r r).", "plus_dyad", {1, 1});
  e.wrong_terms("This is Σ m r r, the second moment: the term with r² 1 is missing, and the dyad has a plus.",
                "second_moment", {0, 1});
  e.wrong_output({"Your products of inertia are zero; they vanish only on principal axes.", "inertia_tensor_products"},
                 "diagonal_only", diagonal_part);
  e.wrong("Your diagonal holds Σ m x² instead of Σ m (y² + z²): what counts is the distance from the axis.",
          "own_coordinate_on_diagonal", [](auto& m, auto& r) { return products_flipped(second_moment(m, r)); });
  e.wrong_input<0>("The masses do not enter: each point counts as 1.", "masses_dropped", [](auto& m) { m.setOnes(); });
  e.wrong_input<0>("The last point is left out of the sum.", "last_point_lost",
                   [](auto& m) { m.tail(min<Eigen::Index>(m.size(), 1)).setZero(); });
  e.wrong_input<0>("The first point is left out of the sum: indices start at 0.", "first_point_lost",
                   [](auto& m) { m.head(min<Eigen::Index>(m.size(), 1)).setZero(); });
  e.wrong_inputs({"This is the tensor about the centre of mass; asked for is the origin.", "inertia_tensor_origin"},
                 "about_center_of_mass", [](auto& m, auto& r) { r.colwise() -= center_of_mass(m, r); });
  e.is_inertia_tensor("", "inertia_tensor_energy");
  e.route("minus the square of the cross matrix", [](auto& m, auto& r) {
    Matrix3d I = Matrix3d::Zero();
    for (int p = 0; p < m.size(); ++p) I -= m[p] * skew(r.col(p)) * skew(r.col(p));
    return I;
  });
  e.route("entry by entry", [](auto& m, auto& r) {
    Matrix3d I = Matrix3d::Zero();
    for (int p = static_cast<int>(m.size()) - 1; p >= 0; --p) I += m[p] * of_unit_mass_by_entries(r.col(p));
    return I;
  });
  e.route("trace of the second moment", [](auto& m, auto& r) { return tensor_of_moment(second_moment(m, r)); });
  e.survivor("r_p = - r.col(p)", "Every term holds r_p twice.");
}
