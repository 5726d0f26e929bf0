#include "solutions/10_attitude_of_a_free_body/shared.hpp"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>

namespace {

/// The closed form with the parameter n of motion round axis 3 always.
double same_n(const Vector3d& I, const Vector3d& w) {
  const double L2 = L_of(I, w).squaredNorm(), L = sqrt(L2), below = twice_T(I, w) * I[2] - L2;
  const double above = L2 - twice_T(I, w) * I[0], P = ExactTop(I, w).period(), rate = ExactTop(I, w).rate();
  const double m = 1 - ExactTop(I, w).complementary_parameter(), n = -m * I[2] * above / (I[0] * below);
  return L * P / I[2] + 4 * L * (I[2] - I[0]) / (I[0] * I[2] * rate) * std::comp_ellint_3(sqrt(m), n);
}

/// The wrong answers that are known.
template <class Exercise>
void mistakes_of_turn_per_period(Exercise& e) {
  e.wrong({"This is the mean rate of rotation about L times the period; axis 3 goes round at another rate, because the "
           "body also rotates about it.",
           "attitude_phase"},
          "mean_rate", dynamical_phase);
  e.wrong("This is the rate of a rotation about axis 3 alone, times the period.", "L_over_I3",
          [](auto& I, auto& w) { return L_of(I, w).norm() / I[2] * ExactTop(I, w).period(); });
  e.wrong(
      "This is the rate at which the axis of a symmetric top goes round L, times the period; yours has three moments.",
      "L_over_I1", [](auto& I, auto& w) { return L_of(I, w).norm() / I[0] * ExactTop(I, w).period(); });
  e.wrong("The velocity of the tip of axis 3 is not divided by the squared distance of the tip from the line of L.",
          "no_distance", [](auto& I, auto& w) {
            return over_a_period(I, w, [&](const Vector3d& now) {
              const Vector3d L = L_of(I, now);
              return (L[0] * now[0] + L[1] * now[1]) / L.norm();
            });
          });
  e.wrong({"The characteristic of the elliptic integral is that of motion round axis 3, for motion round axis 1 too.",
           "attitude_third"},
          "same_n", same_n);
  e.wrong_output("Whole turns are missing: this is the angle modulo 2π.", "modulo",
                 [](auto& angle) { angle = modulo(angle, 2 * pi); });
  e.wrong_output("This is half of the angle: after half a period two components of ω are reversed.", "half_period",
                 times(0.5));
  e.wrong("This is the rate of the start times the period; the rate changes along the motion.", "start_rate",
          [](auto& I, auto& w) { return rate_about_L(I, w) * ExactTop(I, w).period(); });
  e.wrong({"Round axis 1 this is how far axis 1 goes round L, as if both names were exchanged; axis 3 is asked for.",
           "attitude_third"},
          "labels_exchanged", [](auto& I, auto& w) {
            const int axis = is_round_3(I, w) ? 2 : 0;
            return over_a_period(I, w, [&](const Vector3d& now) { return rate_about_L(I, now, axis); });
          });
  e.wrong("This is how far axis 1 goes round L; asked for is axis 3, that of the largest moment.", "axis_1",
          [](auto& I, auto& w) {
            return over_a_period(I, w, [&](const Vector3d& now) { return rate_about_L(I, now, 0); });
          });
}

}  // namespace

void judge_turn_per_period(Lecture& lecture) {
  auto& e = lecture.exercise(&turn_per_period, {{"I", ascending_moments}, {"omega0", rad_per_s}}, {"angle", rad});
  either_side_of_separatrix(e);
  e.worked("backwards about axis 3", lecture_body, {0.3, 0.02, -1});
  e.special("starting with ω₁ = 0", lecture_body, {0, -0.7, 0.8});
  cases_of_a_period(e);
  e.limit("a small wobble about axis 3", 2 * pi * (1 + 1 / sqrt(1.5 * 0.7 / (1.2 * 2))),
          "While L goes once round axis 3 on the body, the body rotates about this axis at 1 rad/s: axis 3 goes round "
          "L through this angle, and a full turn more.");
  e.limit("a small wobble about axis 1", 2 * pi / sqrt(0.8 * 1.5 / (2 * 2.7)),
          "Axis 3 is nearly across L and turns as the body does, at 1 rad/s.");
  e.sweep<1>({"I = (1.2, 2, 2.7) kg m², ω = (0.5, 0.6, ω₃) rad/s: round axis 1 on the left, round axis 3 on the right",
              "ω₃ (rad/s)", "turn about L in a period (rad)"},
             {"turn"}, {0, 1.5, 76}, [](auto w3) { return Vector3d(0.5, 0.6, w3); });

  mistakes_of_turn_per_period(e);
  e.property(Is::nonnegative, "Axis 3 goes round L in the positive sense all the time.");
  e.route("the rate summed over a period", [](auto& I, auto& w) {
    return over_a_period(I, w, [&](const Vector3d& now) {
      const Vector3d L = L_of(I, now);
      return L.norm() * (L[0] * now[0] + L[1] * now[1]) / (L[0] * L[0] + L[1] * L[1]);
    });
  });
  e.route("the attitude integrated, and axis 3 followed", [](auto& I, auto& w) {
    const Vector3d axis = L_of(I, w).normalized();
    constexpr int steps = 200;
    const double h = ExactTop(I, w).period() / steps;
    double angle = 0;
    Moved now{w, Matrix3d::Identity()};
    for (int i = 0; i < steps; ++i) {
      const Moved step = integrated(I, now.omega, h);
      const Matrix3d A = now.A * step.A;
      const Vector3d before = cross(axis, now.A.col(2)), after = cross(axis, A.col(2));
      angle += modulo(atan2(axis.dot(cross(before, after)), before.dot(after)), 2 * pi);
      now = {step.omega, A};
    }
    return angle;
  });
  e.route("Carlson's integrals", [](auto& I, auto& w) {
    const double L2 = L_of(I, w).squaredNorm(), below = twice_T(I, w) * I[2] - L2, above = L2 - twice_T(I, w) * I[0];
    const double round_3_part = above * (I[2] - I[1]), round_1_part = below * (I[1] - I[0]);
    const double larger = max(round_3_part, round_1_part), m = min(round_3_part, round_1_part) / larger;
    const double ratio = I[2] * above / (I[0] * below), n = is_round_3(I, w) ? -m * ratio : -ratio;
    const double K = boost::math::ellint_rf(0.0, 1 - m, 1.0), J = boost::math::ellint_rj(0.0, 1 - m, 1.0, 1 - n);
    return 4 * sqrt(L2 * I.prod() / larger) / I[2] * (K + (I[2] - I[0]) / I[0] * (K + n / 3 * J));
  });
  e.survivor("-omega0", "Reversing ω reverses L and changes nothing else.");
  e.survivor("const double k = -", "The modulus enters squared.");
  e.survivor("round_3 >= round_1", "Zero is the separatrix, which is no legal input.");
  e.survivor("( -k", "The modulus enters squared.");
  e.survivor("isnan(k)", "Every legal motion has a modulus.");
}
