#include "solutions/10_attitude_of_a_free_body/shared.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

namespace {

using boost::math::ellint_1;

/// The textbook's constants of the motion, from T and L²; c is the axis that ω circles.
struct Elliptic {
  Elliptic(const Vector3d& I, const Vector3d& w) : c(is_round_3(I, w) ? 2 : 0) {
    const double Ia = I[2 - c], Ib = I[1], Ic = I[c], L2 = L_of(I, w).squaredNorm();
    const double below = twice_T(I, w) * Ic - L2, above = L2 - twice_T(I, w) * Ia, s = copysign(1, w[c]);
    parts = Vector3d(sqrt(below / (Ia * (Ic - Ia))), s * sqrt(below / (Ib * (Ic - Ib))),
                     s * sqrt(above / (Ic * (Ic - Ia))));
    rate = sqrt(above * (Ic - Ib) / I.prod());
    k = sqrt(below * (Ib - Ia) / (above * (Ic - Ib)));
    phase = atan2(w[1] / parts[1], w[2 - c] / parts[0]);
  }
  /// ω from the three functions of time.
  Vector3d omega(double cn, double sn, double dn) const {
    const Vector3d ordered = parts.cwiseProduct(Vector3d(cn, sn, dn));
    return c == 2 ? ordered : Vector3d(ordered.reverse());
  }
  Vector3d jacobi(double modulus, double u) const {
    double cn = 0, dn = 0;
    const double sn = boost::math::jacobi_elliptic(modulus, u, &cn, &dn);
    return omega(cn, sn, dn);
  }
  int c;
  Vector3d parts;  // of cn, sn and dn
  double rate = 0, k = 0, phase = 0;
};

/// The wrong answers that are known.
template <class Exercise>
void mistakes_of_exact_rotation(Exercise& e) {
  e.wrong("This starts with a vanishing ω₂, as if the phase were zero.", "phase_lost", [](auto& I, auto& w, auto t) {
    const Elliptic top(I, w);
    return top.jacobi(top.k, top.rate * t);
  });
  e.wrong({"The phase of the start has lost its quadrant: an arcsine of ω₂ alone does not tell the sign of the cosine.",
           "attitude_exact_rotation"},
          "quadrant_lost", [](auto& I, auto& w, auto t) {
            const Elliptic top(I, w);
            return top.jacobi(top.k, top.rate * t + ellint_1(top.k, asin(sin(top.phase))));
          });
  e.wrong("The component along the axis that ω circles is always positive; it keeps the sign of the start.",
          "sign_of_axis", [](auto& I, auto& w, auto t) {
            Elliptic top(I, w);
            top.parts = top.parts.cwiseAbs();
            top.phase = atan2(w[1] / top.parts[1], w[2 - top.c] / top.parts[0]);
            return top.jacobi(top.k, top.rate * t + ellint_1(top.k, top.phase));
          });
  e.wrong_output({"Round axis 1 the components 1 and 3 are exchanged; the labels must be exchanged back at the end.",
                  "attitude_exact_rotation"},
                 "not_exchanged_back", [](auto& omega, auto& I, auto& w, auto) {
                   if (!is_round_3(I, w)) omega = Vector3d(omega.reverse());
                 });
  e.wrong("This comes out with the parameter where the library expects the modulus.", "modulus",
          [](auto& I, auto& w, auto t) {
            const Elliptic top(I, w);
            const double m = top.k * top.k;
            return top.jacobi(m, top.rate * t + ellint_1(m, top.phase));
          });
  e.template wrong_input<2>("Your motion runs backwards in time.", "sense", negated);
  e.wrong("These are sine, cosine and a constant; that is the motion at small amplitude only.", "sine_and_cosine",
          [](auto& I, auto& w, auto t) {
            const Elliptic top(I, w);
            const double angle = top.rate * t + top.phase;
            return top.omega(cos(angle), sin(angle), 1);
          });
  e.wrong("The angular velocity of the start is returned; without a torque L is constant in space, but ω is not.",
          "constant", [](auto&, auto& w, auto) { return w; });
}

}  // namespace

void judge_exact_rotation(Lecture& lecture) {
  auto& e = lecture.exercise(&exact_rotation, {{"I", ascending_moments}, {"omega0", rad_per_s}, {"t", second}},
                             {"omega", rad_per_s});
  either_side_of_separatrix(e);
  e.domain([](auto& I, auto& w, auto t) { return tumbles(I, w, 0.01) && abs(t) <= 1e6; });
  e.worked("round axis 3, after eight days", lecture_body, round_3, 700000);
  e.worked("round axis 1, after eight days", lecture_body, round_1, 700000);
  e.worked("a day and a half before", lecture_body, round_3, -123456.7);
  e.worked("signs reversed", lecture_body, {-0.4, 0.1, -0.6}, 500000);
  e.special("time 0", lecture_body, round_1, 0);
  e.special("starting with ω₂ = 0, round axis 3", lecture_body, {0.5, 0, -0.8}, 4e5);
  e.special("starting with ω₂ = 0, round axis 1", lecture_body, {-0.9, 0, 0.3}, -4e5);
  e.special("starting with ω₁ = 0", lecture_body, {0, -0.7, 0.8}, 1e6);
  e.special("starting with ω₃ = 0", lecture_body, {0.9, 0.3, 0}, 1e6);
  e.special("not far from the separatrix, round axis 3", lecture_body, {0.6, 0.5, 0.465}, 3e5);
  e.special("not far from the separatrix, round axis 1", lecture_body, {0.6, 0.5, 0.39}, 3e5);
  e.special("a flat body", {1, 2, 3}, {0.1, 1, 0.2}, 3e5);
  e.special("a small wobble", lecture_body, {0.05, 0.03, -1}, 8e5);
  e.special("moments close together", {1, 1.07, 1.15}, {0.3, -0.2, 0.5}, 6e5);
  e.special("after one period", lecture_body, round_3, ExactTop(lecture_body, round_3).period());
  e.limit("time 0", round_1, "No time has passed.");
  e.limit("after one period", round_3, "On the axes of the body the motion repeats itself.");
  e.random("round axis 3", 6, round_axis(3), any::spin(1e5, 1e6));
  e.random("round axis 1", 6, round_axis(1), any::spin(1e5, 1e6));
  e.random("within a minute", 4, round_axis(1), any::spin(2, 60));
  e.tolerance(1e-7, "After a million seconds the last digits of the period have become an error of a few 10⁻⁹.");
  e.scale([](auto&, auto& w, auto) { return w.norm(); });
  e.sweep<2>({"I = (1.2, 2, 2.7) kg m², ω = (0.4, −0.9, 0.6) rad/s at t = 0: a minute of the eighth day",
              "t − 604800 s (s)", "body component of ω (rad/s)"},
             {"omega_1", "omega_2", "omega_3"}, {0, 40, 121}, [](auto t) { return 604800 + t; });

  mistakes_of_exact_rotation(e);
  e.conserves("T is constant.", [](auto& I, auto...) { return I; });
  e.conserves("L keeps its length.", [](auto& I, auto...) { return Vector3d(I.cwiseAbs2()); });
  e.route("whole periods left out, the rest integrated", [](auto& I, auto& w, auto t) {
    const Elliptic top(I, w);
    return integrated(I, w, std::fmod(t, 4 * std::comp_ellint_1(top.k) / top.rate)).omega;
  });
  e.route("the arithmetic-geometric mean", [](auto& I, auto& w, auto t) { return ExactTop(I, w).omega(t); });
  e.route("Jacobi's Fourier series", [](auto& I, auto& w, auto t) {
    const Elliptic top(I, w);
    const double K = std::comp_ellint_1(top.k), other_K = std::comp_ellint_1(sqrt(1 - top.k * top.k));
    const double nome = std::exp(-pi * other_K / K), z = pi / (2 * K) * (top.rate * t + ellint_1(top.k, top.phase));
    double cn = 0, sn = 0, dn = 0.25;
    for (int n = 0; n < 60; ++n) {
      const double power = pow(nome, n + 0.5), odd = power * power;
      sn += power / (1 - odd) * sin((2 * n + 1) * z);
      cn += power / (1 + odd) * cos((2 * n + 1) * z);
      if (n > 0) dn += pow(nome, n) / (1 + pow(nome, 2 * n)) * cos(2 * n * z);
    }
    return top.omega(2 * pi / (top.k * K) * cn, 2 * pi / (top.k * K) * sn, 2 * pi / K * dn);
  });
  e.survivor("jacobi_cn(k, - u)", "cn is an even function.");
  e.survivor("squares[2] >=", "Zero is the separatrix, which is no legal input.");
  e.survivor("copysign( -1.0", "copysign takes the size of its first argument only.");
  e.survivor("copysign(-1,", "copysign takes the size of its first argument only.");
  e.survivor("ellint_1( -k", "The modulus enters squared.");
  e.survivor("isfinite", "No legal input leads there.");
  e.survivor("I[1] * (I[2] - I[1]) * squares[2]",
             "With a modulus above 1, cn and dn exchange their parts, and the motion is the same.");
}
