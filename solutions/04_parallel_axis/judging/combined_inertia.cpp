#include "solutions/04_parallel_axis/shared.hpp"

#include <numeric>

using Tensors = std::vector<Matrix3d>;

static Matrix3d sum_of(const Tensors& tensors) {
  return std::accumulate(tensors.begin(), tensors.end(), Matrix3d(Matrix3d::Zero()));
}

static Matrix3d as_points(const VectorXd& m, const Matrix3Xd& r) { return as_points(m, r, center_of_mass(m, r)); }

/// Two bodies at a distance d have the sum of their tensors and reduced mass · (d² 1 − d d) besides.
static Matrix3d one_after_another(const VectorXd& m, const Matrix3Xd& r, const Tensors& I) {
  Matrix3d whole = I[0];
  double mass = m[0];
  Vector3d place = r.col(0);
  for (int k = 1; k < m.size(); ++k) {
    whole += I[k] + mass * m[k] / (mass + m[k]) * of_unit_mass(r.col(k) - place);
    place = (mass * place + m[k] * r.col(k)) / (mass + m[k]);
    mass += m[k];
  }
  return whole;
}

void judge_combined_inertia(Lecture& lecture) {
  auto& e = lecture.exercise(&combined_inertia,
                             {{"masses", positive(kg)}, {"centers", metre}, {"tensors", inertia_tensor}}, {"I", kg_m2});
  e.domain([](auto& m, auto& r, auto& I) { return m.size() > 0 && r.cols() == m.size() && std::ssize(I) == m.size(); });
  const Matrix3d first = Vector3d(1, 2, 2.5).asDiagonal(), second_body = Vector3d(0.5, 0.6, 0.7).asDiagonal();
  e.worked("2 kg at the origin and 3 kg at (1, 2, 3) m", VectorXd{{2, 3}}, Matrix3Xd{{0, 1}, {0, 2}, {0, 3}},
           {first, second_body});
  e.special("one body alone, away from the origin", VectorXd{{2}}, Vector3d(1, -2, 3), {first});
  e.special("two bodies at one place", VectorXd{{2, 3}}, Vector3d(1, -2, 3).replicate<1, 2>(), {first, second_body});
  e.special("point masses only", VectorXd{{1, 2, 3, 4}}, Matrix3Xd{{1, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 3, 1}},
            Tensors(4, Matrix3d::Zero()));
  e.random("a random assembly", 8, [](Random& random) {
    const int count = random.whole(2, 5);
    tuple assembly{random.masses(count), Matrix3Xd(3, count), Tensors(count)};
    auto& [masses, centers, tensors] = assembly;
    masses[0] += 3;  // equal masses would put the centre of mass into the mean of the centres
    for (auto place : centers.colwise()) place = random.vector(2.0) + Vector3d(1, -2, 1.5);
    for (Matrix3d& tensor : tensors) tensor = random.inertia_tensor();
    return assembly;
  });
  e.sweep<1>({"The 3 kg body moves away from the 2 kg body along (1, 2, 3)", "distance of their centres (m)",
              "entry of I (kg m²)"},
             {"I_xx", {"I_zz", 2, 2}, {"I_yz", 1, 2}}, {0, 4},
             [](auto distance) { return Vector3d(1, 2, 3).normalized() * Eigen::RowVector2d(0, distance); });

  e.term("Σ Iₖ", 1, [](auto&, auto&, auto& I) { return sum_of(I); });
  e.term("Σ mₖ dₖ² 1", 1, [](auto& m, auto& r, auto&) { return unit(as_points(m, r).trace() / 2); });
  e.term("Σ mₖ dₖ dₖ", -1, [](auto& m, auto& r, auto) { return second_moment(m, r.colwise() - center_of_mass(m, r)); });
  e.wrong_terms("The tensors are added as they are; each is to be carried from its own centre to the common one.",
                "sum_of_tensors", {1, 0, 0});
  e.wrong("This is the tensor about the origin; asked for is the common centre of mass.", "about_origin",
          [](auto& m, auto& r, auto& I) { return sum_of(I) + as_points(m, r, zero); });
  e.wrong("The mean of the centres stands for the common centre of mass; each counts with its mass.", "mean_of_centers",
          [](auto& m, auto& r, auto& I) { return sum_of(I) + as_points(m, r, r.rowwise().mean()); });
  e.wrong("This is the tensor about the first body's centre; asked for is the common centre of mass.",
          "about_first_body", [](auto& m, auto& r, auto& I) { return sum_of(I) + as_points(m, r, r.col(0)); });
  e.wrong("Each body joins those before it at the first body's centre; what counts is the common centre of these.",
          "first_center_kept", [](auto& m, auto& r, auto& I) {
            Matrix3d whole = sum_of(I);
            double mass = m[0];
            for (int k = 1; k < m.size(); mass += m[k++])
              whole += mass * m[k] / (mass + m[k]) * of_unit_mass(r.col(k) - r.col(0));
            return whole;
          });
  e.wrong("A body that joins moves the common centre away from those before it too; their shift is missing.",
          "only_the_new_one_shifted", [](auto& m, auto& r, auto& I) {
            Matrix3d whole = sum_of(I);
            double mass = m[0];
            Vector3d place = r.col(0);
            for (int k = 1; k < m.size(); ++k) {
              place = (mass * place + m[k] * r.col(k)) / (mass + m[k]);
              whole += m[k] * of_unit_mass(r.col(k) - place);
              mass += m[k];
            }
            return whole;
          });
  e.wrong_terms("The bodies count as points; their own tensors are missing.", "points_only", {0, 1, -1});
  e.wrong_terms("m (d² 1 − d d) is subtracted here; away from a centre it is added.", "shift_subtracted", {1, -1, 1});
  e.wrong({"The products of the shifts have the wrong sign: each adds −m dᵢ dⱼ.", products_notes},
          "shift_products_positive",
          [](auto& m, auto& r, auto& I) { return sum_of(I) + products_flipped(as_points(m, r)); });
  e.wrong({"The shifts add nothing to your products of inertia; off the diagonal each adds −m dᵢ dⱼ.", products_notes},
          "shift_without_products",
          [](auto& m, auto& r, auto& I) { return sum_of(I) + diagonal_part(as_points(m, r)); });
  e.wrong_terms({"Each body adds m d² to every moment; it is m (d² 1 − d d).", theorem_notes}, "isotropic", {1, 1, 0});
  e.wrong_output({"Your result has no products of inertia; an assembly has them in general.", products_notes},
                 "diagonal_only", diagonal_part);
  e.wrong("The masses do not enter your shifts: each body adds m (d² 1 − d d).", "masses_dropped_in_shift",
          [](auto& m, auto& r, auto& I) { return sum_of(I) + as_points(m.cwiseQuotient(m), r, center_of_mass(m, r)); });
  e.wrong("Your shifts have the total mass each; that of a body has its own mass.", "total_mass_in_each_shift",
          [](auto& m, auto& r, auto& I) {
            return sum_of(I) + as_points(VectorXd::Constant(m.size(), m.sum()), r, center_of_mass(m, r));
          });
  e.wrong("The sum is shifted with the total mass; what counts is how far each body is from the centre.",
          "total_mass_at_center",
          [](auto& m, auto& r, auto& I) { return sum_of(I) + m.sum() * of_unit_mass(center_of_mass(m, r)); });
  e.is_inertia_tensor(theorem_notes, theorem_notes);
  e.route("about the origin, then to the centre of mass", [](auto& m, auto& r, auto& I) {
    return inertia_to_center_of_mass(sum_of(I) + as_points(m, r, zero), m.sum(), center_of_mass(m, r));
  });
  e.route("pair by pair", [](auto& m, auto& r, auto& I) {
    // The centre of mass is never needed: Σ m d d = Σ over pairs of m m' / M times the dyad of their distance.
    Matrix3d sum = sum_of(I);
    for (int k = 0; k < m.size(); ++k) {
      for (int l = 0; l < k; ++l) sum += m[k] * m[l] / m.sum() * of_unit_mass(r.col(k) - r.col(l));
    }
    return sum;
  });
  e.route("one body after another", one_after_another);
  e.route("six equivalent masses for each body", [](auto& m, auto& r, auto& I) {
    Matrix3d sum = Matrix3d::Zero();
    for (int k = 0; k < m.size(); ++k) sum += six_equivalent_masses(I[k], m[k], r.col(k) - center_of_mass(m, r));
    return sum;
  });
}
