#include "solutions/10_attitude_of_a_free_body/shared.hpp"

void judge_azimuth_rate(Lecture& lecture) {
  auto& e =
      lecture.exercise(&azimuth_rate, {{"I", positive(kg_m2)}, {"omega", nonzero(rad_per_s)}}, {"rate", rad_per_s});
  e.domain([](auto& I, auto& w) {
    const Vector3d L = L_of(I, w);
    return hypot(L[0], L[1]) >= 1e-5 * L.norm();
  });
  e.worked("moments 1.2, 2, 2.7 kg m²", lecture_body, round_3);
  e.worked("round axis 1", lecture_body, round_1);
  e.special("axis 3 nearly along L", {1, 2, 3}, {2e-5, 3e-5, 1});
  e.special("ω along axis 2", {1, 2, 3}, {0, -2, 0});
  e.special("a symmetric top", {1, 1, 1.8}, {0.4, 0, 2});
  e.special("a sphere", {2, 2, 2}, {0.3, -0.2, 0.5});
  e.random("any motion", 10, &Random::principal_moments, any::vector(2));
  e.random("axis 3 close to L", 4, [](Random& random) {
    const Vector3d I = random.principal_moments(), wobble = random.vector(1e-4);
    return tuple{I, random.sign() * z_axis + wobble};
  });
  e.sweep<1>({"I = (1.2, 2, 2.7) kg m², ω = (cos α, sin α, 0.5) rad/s", "α (rad)", "rate of axis 3 round L (rad/s)"},
             {"rate"}, {0, 2 * pi}, [](auto angle) { return Vector3d(cos(angle), sin(angle), 0.5); });

  e.wrong("This is the component of ω along L; the body also rotates about its axis 3, which is inclined to L.",
          "component_along_L", [](auto& I, auto& w) { return twice_T(I, w) / L_of(I, w).norm(); });
  e.wrong("This is the rate for a symmetric top with the moment I₁ across its axis; here I₁ and I₂ differ.",
          "symmetric_top", [](auto& I, auto& w) { return L_of(I, w).norm() / I[0]; });
  e.wrong(
      "This is L/I₃, the rate of a rotation about axis 3 alone; axis 3 moves only because the body also rotates "
      "about the others.",
      "L_over_I3", [](auto& I, auto& w) { return L_of(I, w).norm() / I[2]; });
  e.wrong(
      "The velocity round L is divided by the distance from the line of L once; the rate of an angle needs the "
      "square.",
      "distance_once", [](auto& I, auto& w) {
        const Vector3d L = L_of(I, w);
        return rate_about_L(I, w) * hypot(L[0], L[1]) / L.norm();
      });
  e.wrong("The distance of the tip from L is taken as 1: the squared sine of its angle is missing.", "no_distance",
          [](auto& I, auto& w) {
            const Vector3d L = L_of(I, w);
            return (L[0] * w[0] + L[1] * w[1]) / L.norm();
          });
  e.wrong("The third term of ω · L is counted too; a rotation about axis 3 does not carry axis 3 round L.", "all_terms",
          [](auto& I, auto& w) {
            const Vector3d L = L_of(I, w);
            return L.norm() * w.dot(L) / (L[0] * L[0] + L[1] * L[1]);
          });
  const char* const from_omega =
      "The angle of axis 3 is that from ω here, cos θ = ω₃/|ω|; it is that from L, cos θ = I₃ω₃/L.";
  e.wrong(from_omega, "sine_from_omega", [](auto& I, auto& w) {
    const Vector3d L = L_of(I, w);
    return (L[0] * w[0] + L[1] * w[1]) / L.norm() * w.squaredNorm() / w.template head<2>().squaredNorm();
  });
  e.wrong(from_omega, "angle_from_omega", [](auto& I, auto& w) {
    const Vector3d L = L_of(I, w);
    const double squared_sine = w.template head<2>().squaredNorm() / w.squaredNorm();
    return (w.dot(L) / L.norm() - w[2] * w[2] / w.norm()) / squared_sine;
  });
  e.wrong("I₃ times the length of ω stands for the length of L here; each component has its own moment.", "length_of_L",
          [](auto& I, auto& w) {
            const Vector3d L = L_of(I, w);
            return I[2] * w.norm() * (L[0] * w[0] + L[1] * w[1]) / (L[0] * L[0] + L[1] * L[1]);
          });
  e.wrong("The energy stands where twice the energy belongs: ω · L = 2T.", "energy_once", [](auto& I, auto& w) {
    const Vector3d L = L_of(I, w);
    return L.norm() * (w.dot(L) / 2 - L[2] * w[2]) / (L[0] * L[0] + L[1] * L[1]);
  });
  e.wrong(
      "All the speed of the tip is divided by its distance from L; the nutation, towards L and away from it, is no "
      "part of the azimuth's rate.",
      "whole_speed", [](auto& I, auto& w) {
        const Vector3d up = L_of(I, w).normalized();
        return hypot(w[0], w[1]) / hypot(up[0], up[1]);
      });
  e.wrong("This is how fast axis 1 goes round L; asked for is axis 3.", "axis_1",
          [](auto& I, auto& w) { return rate_about_L(I, w, 0); });
  e.wrong(
      "Numerator and denominator come from differences of nearly equal numbers where axis 3 is close to L, and "
      "digits are lost; sums of squares keep them.",
      "differences", [](auto& I, auto& w) {
        const Vector3d L = L_of(I, w);
        const double cosine = L[2] / L.norm();
        return (w.dot(L) / L.norm() - w[2] * cosine) / (1 - cosine * cosine);
      });
  e.property(Is::nonnegative, "Axis 3 goes round L in the positive sense always.");
  e.route("the azimuth of axis 3 by differences of the attitude", [](auto& I, auto& w) {
    const Vector3d up = L_of(I, w).normalized();
    const Vector3d round = cross(up, z_axis);
    // In a short time the body turns by the vector ω t, and L stands still; the way round is measured in radii.
    return derivative_at_0([&](double t) { return (turn(w, w.norm() * t) * z_axis).dot(round); }, 1e-3 / w.norm()) /
           round.squaredNorm();
  });
  e.route("the velocity of the tip", [](auto& I, auto& w) {
    const Vector3d up = L_of(I, w).normalized(), round = cross(up, z_axis);
    return cross(w, z_axis).dot(round) / round.squaredNorm();
  });
  e.route("from the rotation about axis 3 that is left over", [](auto& I, auto& w) {
    const Vector3d L = L_of(I, w);
    const double squared = L[0] * L[0] + L[1] * L[1];
    // ω across axis 3, which is φ̇ sin θ across the plane of L, by its component along the level part of L
    const double along = (w[0] * L[0] + w[1] * L[1]) / sqrt(squared);
    return along / (sqrt(squared) / L.norm());
  });
}
