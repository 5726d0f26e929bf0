#include "solutions/10_attitude_of_a_free_body/shared.hpp"

void judge_poinsot(Lecture& lecture) {
  auto& e =
      lecture.exercise(&poinsot, {{"I", positive(kg_m2)}, {"omega", nonzero(rad_per_s)}}, {"distances", rad_per_s});
  e.worked("moments 1.2, 2, 2.7 kg m²", lecture_body, round_3);
  e.worked("ω nearly along L", {1, 2, 3}, {1e-5, 2e-5, 1});
  e.special("a spin about the middle axis", {1, 2, 3}, {0, -2, 0});
  e.special("a sphere", {2, 2, 2}, {0.3, -0.2, 0.5});
  e.special("a symmetric top", {1, 1, 1.8}, {0.4, 0, 2});
  e.special("moments in descending order", {3, 2, 1}, {0.3, -0.2, 0.5});
  e.limit("a sphere", {sqrt(0.38), 0}, "The ellipsoid is a ball, and it turns about the point at which it touches.");
  e.limit("a spin about the middle axis", {2, 0},
          "ω is along L and stays: the plane is |ω| away, and the point of contact is the foot.");
  e.random("a random motion", 10, &Random::principal_moments, any::vector(2));
  e.random("nearly along L", 4, [](Random& random) {
    const Vector3d I = random.principal_moments(), wobble = random.vector(1e-4);
    return tuple{I, random.sign() * Vector3d::Unit(random.whole(0, 2)) + wobble};
  });
  e.scale([](auto& I, auto& w) {
    // The second distance relative to itself, and where it is smaller than the contract says, to 10⁻¹² of ω.
    const Vector2d distances = poinsot(I, w);
    return Vector2d(distances[0], distances[1] >= 1e-5 * w.norm() ? distances[1] : 1e-3 * w.norm());
  });
  e.sweep<1>({"I = (1.2, 2, 2.7) kg m², ω of 1 rad/s in the plane of the axes 1 and 3", "angle of ω from axis 1 (rad)",
              "distance (rad/s)"},
             {"of the plane", "of the contact from the foot"}, {0, pi / 2},
             [](auto angle) { return Vector3d(cos(angle), 0, sin(angle)); });

  const char* const where = "attitude_height";
  e.wrong({"Your first distance is the reciprocal of the right one; look at its unit.", where}, "inverse",
          [](auto& I, auto& w) {
            const Vector3d L = L_of(I, w);
            return Vector2d(L.norm(), cross(w, L).norm()) / twice_T(I, w);
          });
  e.wrong_output(
      "Both are divided by the same number: your ellipsoid does not depend on the energy; asked for is the one on "
      "which ω lies.",
      "textbook_ellipsoid", [](auto& distances, auto& I, auto& w) { distances /= sqrt(twice_T(I, w)); });
  e.wrong({"Your plane is at half of the distance.", where}, "energy_once", [](auto& I, auto& w) {
    const double distance = twice_T(I, w) / 2 / L_of(I, w).norm();
    return Vector2d(distance, sqrt(w.squaredNorm() - distance * distance));
  });
  e.wrong_output(
      "The second is the length of ω, the distance of the contact from the centre; asked for is that from the foot.",
      "distance_of_contact", [](auto& distances, auto&, auto& w) { distances[1] = w.norm(); });
  e.wrong_output(
      "The second comes from a difference of two nearly equal squares, and digits are lost; a cross product has them.",
      "difference_of_squares", [](auto& distances, auto&, auto& w) {
        distances[1] = sqrt(max(w.squaredNorm() - distances[0] * distances[0], 0.0));
      });
  e.property(Is::nonnegative, "A distance is never negative.");
  e.route("the part of ω across L", [](auto& I, auto& w) {
    const Vector3d normal = L_of(I, w).normalized();
    return Vector2d(w.dot(normal), (w - w.dot(normal) * normal).norm());
  });
  e.route("the tangent plane by differences of the energy", [](auto& I, auto& w) {
    Vector3d gradient;  // T is quadratic, so the central difference is exact for any step
    for (int i = 0; i < 3; ++i) {
      const Vector3d ahead = w + w.norm() * Vector3d::Unit(i), behind = w - w.norm() * Vector3d::Unit(i);
      gradient[i] = twice_T(I, ahead) - twice_T(I, behind);
    }
    return Vector2d(w.dot(gradient), cross(gradient, w).norm()) / gradient.norm();
  });
  e.route("the angle between ω and L", [](auto& I, auto& w) {
    const Vector3d L = L_of(I, w);
    const double angle = atan2(cross(w, L).norm(), w.dot(L));
    return w.norm() * Vector2d(cos(angle), sin(angle));
  });
  e.route("the support function of the ellipsoid, and differences of moments", [](auto& I, auto& w) {
    const Vector3d normal = L_of(I, w).normalized();
    const double height = sqrt(twice_T(I, w) * normal.cwiseAbs2().cwiseQuotient(I).sum());
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += pow((I[(i + 1) % 3] - I[i]) * w[i] * w[(i + 1) % 3], 2);
    return Vector2d(height, sqrt(sum) / L_of(I, w).norm());
  });
  e.survivor("const Vector3d L =", "Only the direction of L counts.");
  e.survivor("L.cross(omega)", "Only the length of the product counts.");
  e.survivor("omega.cross( -L)", "Only the length of the product counts.");
}
