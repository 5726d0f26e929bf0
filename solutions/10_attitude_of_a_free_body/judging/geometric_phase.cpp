#include "solutions/10_attitude_of_a_free_body/shared.hpp"

namespace {

/// What the body turns about L in a period, modulo whole turns, by integration: L is where it was, so any direction
/// across it shows the angle.
double turn_of_the_body(const Vector3d& I, const Vector3d& w) {
  const Matrix3d A = integrated(I, w, ExactTop(I, w).period()).A;
  const Vector3d axis = L_of(I, w).normalized(), across = axis.unitOrthogonal();
  return atan2(cross(axis, across).dot(A * across), across.dot(A * across));
}

/// ∮ f(sin²ϑ) dχ on the sphere about the axis that L circles, with ϑ at each azimuth χ from the energy: no motion.
template <class Integrand>
double around_the_axis(const Vector3d& I, const Vector3d& w, const Integrand& f) {
  const int c = is_round_3(I, w) ? 2 : 0;
  const double Ia = I[2 - c], Ib = I[1], Ic = I[c];
  constexpr int steps = 4000;
  double sum = 0;
  // 2T/L² = cos²ϑ/I_c + sin²ϑ (cos²χ/I_a + sin²χ/I_b), with 2T I_c − L² as a sum.
  const double above = (Ia * (Ic - Ia) * w[2 - c] * w[2 - c] + Ib * (Ic - Ib) * w[1] * w[1]) / L_of(I, w).squaredNorm();
  for (int i = 0; i < steps; ++i) {
    const double chi = 2 * pi * i / steps;
    const double sin2 = above / (pow(cos(chi), 2) * (Ic - Ia) / Ia + pow(sin(chi), 2) * (Ic - Ib) / Ib);
    sum += f(sin2);
  }
  return sum * 2 * pi / steps;
}

/// The solid angle: 1 − cos ϑ.
double area(const Vector3d& I, const Vector3d& w) {
  return around_the_axis(I, w, [](double sin2) { return sin2 / (1 + sqrt(1 - sin2)); });
}

}  // namespace

void judge_geometric_phase(Lecture& lecture) {
  auto& e = lecture.exercise(&geometric_phase, {{"I", ascending_moments}, {"omega0", rad_per_s}}, {"S", rad});
  either_side_of_separatrix(e);
  e.worked("round axis 1 in the other sense", lecture_body, {-0.9, -0.5, 0.2});
  e.special("round axis 3 in the other sense", lecture_body, {0.3, 0.02, -1});
  cases_of_a_period(e);
  e.limit("a small wobble about axis 3", pi * 0.0021333 / sqrt((1 / 1.2 - 1 / 2.7) * (1 / 2. - 1 / 2.7)) / 7.2972,
          "A small curve is an ellipse, with the area π a b; the smaller the wobble, the less it encloses.");
  e.limit("a small wobble about axis 1", pi * 0.0096375 / sqrt((1 / 1.2 - 1 / 2.) * (1 / 1.2 - 1 / 2.7)) / 1.461825,
          "A small curve is an ellipse, with the area π a b, longer along axis 2 than along axis 3.");
  e.scale(1);
  e.sweep<1>({"I = (1.2, 2, 2.7) kg m², ω = (0.5, 0.6, ω₃) rad/s: round axis 1 on the left, round axis 3 on the right",
              "ω₃ (rad/s)", "solid angle (sr)"},
             {"S"}, {0, 1.5, 76}, [](auto w3) { return Vector3d(0.5, 0.6, w3); });

  e.wrong("This is the turn about L itself without whole turns; its dynamical part is still in it.", "turn_itself",
          [](auto& I, auto& w) { return modulo(turn_per_period(I, w), 2 * pi); });
  e.wrong_output("This is what is missing from half of the sphere: the sense in which the curve runs is reversed.",
                 "wrong_sense", [](auto& S) { S = 2 * pi - S; });
  e.wrong("This fits motion round axis 3 only; round axis 1 the curve surrounds axis 1, and runs in the other sense.",
          "round_axis_3_always",
          [](auto& I, auto& w) { return modulo(dynamical_phase(I, w) - turn_per_period(I, w), 2 * pi); });
  e.wrong("This is the dynamical part of the turn without whole turns; asked for is the other part.", "dynamical_phase",
          [](auto& I, auto& w) { return modulo(dynamical_phase(I, w), 2 * pi); });
  e.wrong_output("This is the solid angle on the other side of the curve.", "other_side",
                 [](auto& S) { S = 4 * pi - S; });
  e.wrong("This is the area of the curve's projection on the plane across the axis, not that on the sphere.",
          "projected", [](auto& I, auto& w) { return around_the_axis(I, w, [](double sin2) { return sin2 / 2; }); });
  e.wrong("This is the solid angle of a circle through the start; the angle from the axis changes along the curve.",
          "circle",
          [](auto& I, auto& w) { return 2 * pi * (1 - abs(L_of(I, w).normalized()[is_round_3(I, w) ? 2 : 0])); });
  e.wrong("The mean of the two extreme cosines stands for the mean along the curve.", "mean_of_extremes",
          [](auto& I, auto& w) {
            double cosines = 0;
            const int c = is_round_3(I, w) ? 2 : 0;
            const Vector3d L = L_of(I, w);
            for (const int other : {1, 2 - c})  // L² − 2T I of the other axis, where the third component vanishes
              cosines += sqrt(I[c] * abs(L.dot(L - I[other] * w)) / abs(I[c] - I[other])) / L.norm();
            return 2 * pi * (1 - cosines / 2);
          });
  e.wrong("This is the solid angle of the direction of ω; asked for is that of the direction of L.", "of_omega",
          [](auto& I, auto& w) {
            const int a = is_round_3(I, w) ? 0 : 2, c = 2 - a;
            const double L2 = L_of(I, w).squaredNorm(), T2 = twice_T(I, w), along = (T2 * I[c] - L2) * I[c];
            constexpr int steps = 4000;
            double sum = 0;
            for (int i = 0; i < steps; ++i) {  // Σ Iᵢ (L² − 2T Iᵢ) ωᵢ² = 0
              const double chi = 2 * pi * i / steps;
              const double across =
                  (L2 - T2 * I[a]) * I[a] * pow(cos(chi), 2) + (L2 - T2 * I[1]) * I[1] * pow(sin(chi), 2);
              sum += 1 - sqrt(across / (along + across));
            }
            return sum * 2 * pi / steps;
          });
  e.property(Is::nonnegative, "The solid angle is counted from 0.");
  e.route("from the turn of the integrated body", [](auto& I, auto& w) {
    const double difference = dynamical_phase(I, w) - turn_of_the_body(I, w);
    return modulo(is_round_3(I, w) ? difference : -difference, 2 * pi);
  });
  e.route("the area from the energy alone", area);
  e.route("1 − cos ϑ along the motion", [](auto& I, auto& w) {
    const int c = is_round_3(I, w) ? 2 : 0;
    const Vector3d L0 = L_of(I, w);
    return over_a_period(I, w, [&](const Vector3d& now) {
      // The azimuth about axis c grows at (L × dL/dt)_c/(Lₐ² + L_b²), with dL/dt = L × ω on the axes of the body.
      const Vector3d L = L_of(I, now), rate = cross(L, now);
      const double across = L.squaredNorm() - L[c] * L[c],
                   chi = L[(c + 1) % 3] * rate[(c + 2) % 3] - L[(c + 2) % 3] * rate[(c + 1) % 3];
      const double one_minus_cosine = across / (L0.norm() * (L0.norm() + abs(L[c])));
      return one_minus_cosine * abs(chi) / across;
    });
  });
  e.survivor("-omega0", "Reversing ω reverses L and changes nothing else.");
  e.survivor("const double k = -", "The modulus enters squared.");
  e.survivor("round_3 >= round_1", "Zero is the separatrix, which is no legal input.");
  e.survivor("( -k", "The modulus enters squared.");
  e.survivor("isnan(k)", "Every legal motion has a modulus.");
}
