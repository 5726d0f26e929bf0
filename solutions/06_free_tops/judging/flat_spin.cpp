#include "solutions/06_free_tops/shared.hpp"

/// Heat and rate if L ends up along an axis with this moment.
static Vector2d ending_with(double moment, const Vector3d& I, const Vector3d& w) {
  const double L = I.cwiseProduct(w).norm();
  return {I.dot(w.cwiseAbs2()) / 2 - L * L / (2 * moment), L / moment};
}

void judge_flat_spin(Lecture& lecture) {
  auto& e = lecture.exercise(&flat_spin, {{"I", positive(kg_m2)}, {"omega", rad_per_s}}, {"heat_and_rate", joule});
  e.result_units({joule, rad_per_s});
  e.domain([](auto& I, auto&) { return is_inertia_tensor(I.asDiagonal()); });
  e.worked("the largest moment comes first", {2.7, 1.2, 2}, {0.3, 5, -0.4});
  e.worked("a slender satellite", {0.03, 14, 14}, {78.5, 0, 0.01});
  e.special("a flattened symmetric body", {1, 1, 1.8}, {0.4, 0, 2});
  e.special("a sphere", {2, 2, 2}, {1, 2, 3});
  e.special("exactly about the smallest moment", {1.2, 2, 2.7}, {-3, 0, 0});
  e.special("exactly about the middle moment", {1.2, 2, 2.7}, {0, 3, 0});
  e.special("exactly about the largest moment", {1.2, 2, 2.7}, {0, 0, 3});
  e.special("at rest", {1.2, 2, 2.7}, zero);
  e.limit("exactly about the largest moment", {0, 3}, "With this L no motion has less energy.");
  e.limit("a sphere", {0, sqrt(14)}, "Every axis has the largest moment: there is nothing to lose.");
  e.random("a random satellite", 10, &Random::principal_moments, any::vector(4));
  e.scale([](auto& I, auto& w) {
    return Vector2d(or_one(I.dot(w.cwiseAbs2()) / 2), or_one(I.cwiseProduct(w).norm() / I.maxCoeff()));
  });
  e.sweep({"Moments 1, 2, 3 kg m², 1 rad/s at the start about an axis between axis 1 and axis 3",
           "angle of ω from axis 1 (rad)", "heat (J)"},
          {{"heat"}}, {0, pi / 2},
          [](auto angle) { return tuple(Vector3d(1, 2, 3), Vector3d(cos(angle), 0, sin(angle))); });

  e.wrong("The rate is kept here; what friction inside the body cannot change is L.", "omega_kept",
          [](auto& I, auto& w) {
            return Vector2d(I.dot(w.cwiseAbs2()) / 2 - I.maxCoeff() * w.squaredNorm() / 2, w.norm());
          });
  e.wrong("The energy is kept here, and no heat is produced; the bending of the aerials takes energy, and L stays.",
          "energy_kept", [](auto& I, auto& w) { return Vector2d(0, sqrt(I.dot(w.cwiseAbs2()) / I.maxCoeff())); });
  e.wrong("This ends about the axis of the smallest moment, where the energy at given L is largest.", "smallest_axis",
          [](auto& I, auto& w) { return ending_with(I.minCoeff(), I, w); });
  e.wrong(
      "This ends about the axis round which L goes at first; with friction the axis of the smallest moment is not "
      "stable either.",
      "first_axis", [](auto& I, auto& w) {
        Vector3d moments = I;
        std::sort(moments.begin(), moments.end());
        const Vector3d L = I.cwiseProduct(w);
        return ending_with(L.squaredNorm() < L.dot(w) * moments[1] ? moments[0] : moments[2], I, w);
      });
  e.wrong("This ends about axis 3, whichever moment it has; the moments come in any order.", "third_axis",
          [](auto& I, auto& w) { return ending_with(I[2], I, w); });
  e.wrong("The component about the axis of the largest moment is kept here, and the others stop; what stays is L.",
          "component_kept", [](auto& I, auto& w) {
            int axis = 0;
            const double largest = I.maxCoeff(&axis);
            return Vector2d((I.dot(w.cwiseAbs2()) - largest * w[axis] * w[axis]) / 2, abs(w[axis]));
          });
  e.wrong("The components of L are added here; the length of L is the root of the sum of their squares.",
          "sum_for_length", [](auto& I, auto& w) {
            const double L = I.dot(w);
            return Vector2d(I.dot(w.cwiseAbs2()) / 2 - L * L / (2 * I.maxCoeff()), abs(L) / I.maxCoeff());
          });
  e.wrong_output("Your first number is the energy that is left; asked for is the heat.", "left_over",
                 [](auto& both, auto& I, auto& w) { both[0] = I.dot(w.cwiseAbs2()) / 2 - both[0]; });
  e.property(Is::nonnegative, "Friction takes energy from the rotation: the heat is not negative, and no rate is.");
  e.route("the difference of two energies", [](auto& I, auto& w) { return ending_with(I.maxCoeff(), I, w); });
  e.route("the least energy of three spins with this L", [](auto& I, auto& w) {
    const Vector3d L = I.cwiseProduct(w);
    const Vector3d energies = L.squaredNorm() / 2 * I.cwiseInverse();
    const double least = energies.minCoeff();
    return Vector2d(L.dot(w) / 2 - least, over(2 * least, L.norm()));
  });
  e.route("friction followed to its end", [](auto& I, auto& w) {
    // dL/dt = κ L × (L × ω) keeps |L|, and the components decay like exp(−κL²t/Iᵢ) before L is brought to this length.
    Vector3d L = I.cwiseProduct(w);
    const double size = L.norm(), energy = L.dot(w) / 2;
    if (size == 0) return Vector2d(0, 0);
    for (double& component : L) component += component == 0 ? 1e-9 * size : 0;  // the slight disturbance
    const Vector3d excess = I.cwiseInverse().array() - I.cwiseInverse().minCoeff();
    for (int k = 0; k < 3; ++k) L[k] *= std::exp(-excess[k] * 1e12 * I.maxCoeff());
    L *= size / L.norm();
    return Vector2d(energy - L.dot(L.cwiseQuotient(I)) / 2, L.cwiseQuotient(I).norm());
  });
}
