#include "solutions/01_frame_derivatives/shared.hpp"

void judge_inertial_rate(Lecture& lecture) {
  auto& e =
      lecture.exercise(&inertial_rate, {{"rate_body", m_per_s}, {"omega", rad_per_s}, {"V", metre}}, {"rate", m_per_s});
  // V stands for any vector; here it is taken for a position.
  e.worked("the vectors of the lecture", {0.4, -0.3, 0.6}, example_omega, {1, 2, -1});
  e.special("V is fixed in the rotating frame", zero, example_omega, {1, 2, -1});
  e.special("V is fixed in the inertial frame", {0.8, -0.8, -0.8}, example_omega, {1, 2, -1});
  e.special("the frame does not turn", {0.4, -0.3, 0.6}, zero, {1, 2, -1});
  e.special("V lies along ω", {0.4, -0.3, 0.6}, example_omega, 2 * example_omega);
  e.random("a random vector", 8, any::vector(2), any::vector(3), any::vector(2));
  e.scale([](auto& rate, auto& w, auto& V) { return rate.norm() + w.norm() * V.norm(); });
  e.sweep({"A vector of 2 m turns in the x–y plane of a frame with ω = (0.3, −0.2, 0.5) rad/s, at 1 rad/s",
           "direction of V (rad)", "inertial rate (m/s)"},
          {"x", "y", "z"}, {0, 2 * pi},
          [](auto angle) { return tuple(2 * in_xy_plane(angle + pi / 2), example_omega, 2 * in_xy_plane(angle)); });

  e.term("the body's rate", 1, [](auto& rate, auto&, auto&) { return rate; });
  e.term("ω × V", 1, [](auto&, auto& w, auto& V) { return cross(w, V); });
  e.wrong_terms("ω × V has the wrong sign: it is added to the body's rate, and V × ω = −ω × V.", "sign", {1, -1});
  e.wrong_terms("This is the body's rate; the turning of the basis vectors adds ω × V.", "body_rate_only", {1, 0});
  e.wrong_terms("This is ω × V alone, right for a vector fixed in the rotating frame only.", "cross_only", {0, 1});
  e.wrong("This comes out when ω is crossed with the rate of V; it must be crossed with V itself.", "cross_with_rate",
          [](auto& rate, auto& w, auto&) { return rate + cross(w, rate); });
  e.wrong_terms("The body's rate enters with the wrong sign: both parts are added.", "rate_sign", {-1, 1});
  e.wrong_terms("The whole result has the wrong sign: both parts are added.", "both_signs", {-1, -1});
  e.wrong_terms("ω × V enters twice; the 2 belongs to the Coriolis term, a second derivative.", "factor_two", {1, 2});
  e.wrong("This comes out when ω and V are multiplied component by component; a cross product is needed.",
          "componentwise", [](auto& rate, auto& w, auto& V) -> Vector3d { return rate + w.cwiseProduct(V); });
  e.wrong("|ω| V is added here, which points along V; a rotating vector changes across itself, by ω × V.",
          "speed_times_vector", [](auto& rate, auto& w, auto& V) { return rate + w.norm() * V; });
  e.route("with the cross matrix", [](auto& rate, auto& w, auto& V) { return skew(w) * V + rate; });
  e.route("the sum over turning basis vectors", [](auto& rate, auto& w, auto& V) {
    Vector3d sum = zero;
    for (int i = 0; i < 3; ++i) sum += rate[i] * Vector3d::Unit(i) + V[i] * cross(w, Vector3d::Unit(i));
    return sum;
  });
  e.route("component by component", [](auto& rate, auto& w, auto& V) {
    return Vector3d(rate[0] - (w[2] * V[1] - w[1] * V[2]), rate[1] - (w[0] * V[2] - w[2] * V[0]),
                    rate[2] - (w[1] * V[0] - w[0] * V[1]));
  });
}
