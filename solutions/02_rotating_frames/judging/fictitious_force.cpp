#include "solutions/02_rotating_frames/shared.hpp"

void judge_fictitious_force(Lecture& lecture) {
  auto& e = lecture.exercise(
      &fictitious_force,
      {{"m", positive(kg)}, {"r", metre}, {"v_body", m_per_s}, {"omega", rad_per_s}, {"alpha", rad_per_s2}},
      {"F", newton});
  e.worked("2 kg with the motion of the lecture", 2, example_r, example_v, example_omega, example_alpha);
  e.special("at rest in a steadily rotating frame", 2, example_r, zero, example_omega, zero);
  e.special("the frame does not turn", 2, example_r, example_v, zero, zero);
  e.special("the frame begins to turn", 2, example_r, example_v, zero, example_alpha);
  e.special("on the axis, at rest", 2, 2 * example_omega, zero, example_omega, zero);
  e.random("a random motion", 10, any::uniform(1.5, 4), any::vector(2), any::vector(2), any::vector(2), any::vector(2));
  e.scale([](auto m, auto& r, auto& v, auto& w, auto& a) {
    return or_one(m * (2 * w.norm() * v.norm() + a.norm() * r.norm() + w.squaredNorm() * r.norm()));
  });
  e.sweep<1>({"A mass of 2 kg moves out along (1, 2, −1) from the axis, with the velocity, ω and α of the lecture",
              "distance from the origin (m)", "fictitious force (N)"},
             {"x", "y", "z"}, {0, 5}, [](auto distance) { return distance * example_r.normalized(); });

  e.term("m ω × v", -2, [](auto m, auto&, auto& v, auto& w, auto&) { return m * cross(w, v); });
  e.term("m α × r", -1, [](auto m, auto& r, auto&, auto&, auto& a) { return m * cross(a, r); });
  e.term("m ω × (ω × r)", -1, [](auto m, auto& r, auto&, auto& w, auto&) { return m * cross(w, cross(w, r)); });
  e.wrong_terms("Your force has the wrong sign: on the other side of Newton's law all three terms carry a minus.",
                "overall_sign", {2, 1, 1});
  e.wrong_terms("The Coriolis force lacks its factor 2: it is −2 m ω × v.", "coriolis_without_two", {-1, -1, -1});
  e.wrong_terms(
      "Your centrifugal force points towards the axis: its sign is wrong, or ω × r was subtracted from v_body, which "
      "already is the velocity seen in the frame.",
      "centrifugal_inward", {-2, -1, 1});
  e.wrong_terms("The Coriolis force has the wrong sign: it is −2 m ω × v, or 2 m v × ω.", "coriolis_sign", {2, -1, -1});
  e.wrong_terms("The Euler force has the wrong sign: it is −m α × r.", "euler_sign", {-2, 1, -1});
  e.wrong_terms("The Euler force −m α × r is missing; it is there when ω changes.", "no_euler_force", {-2, 0, -1});
  e.wrong_terms(
      "The Coriolis force −2 m ω × v is missing; it is there, in general, when the point moves in the rotating frame.",
      "no_coriolis_force", {0, -1, -1});
  e.wrong_terms({"The centrifugal force is missing or zero, as without its brackets: (ω × ω) × r.", brackets},
                "no_centrifugal_force", {-2, -1, 0});
  e.wrong_terms("The centrifugal force enters three times, twice with v_body + ω × r in the Coriolis force for v_body.",
                "inertial_velocity", {-2, -1, -3});
  e.wrong_output({"The centrifugal force is m ω² r here; the distance from the axis counts, not r itself.", brackets},
                 "omega_squared_r", [](auto& F, auto m, auto& r, auto&, auto& w, auto&) { F += m * w * w.dot(r); });
  for (const int only : {0, 1, 2})
    e.wrong("The mass multiplies one of the three terms here; it belongs to all of them.",
            "mass_once_" + std::to_string(only), [only](auto m, auto& r, auto& v, auto& w, auto& a) {
              Matrix3d terms;
              terms << -2 * cross(w, v), -cross(a, r), -cross(w, cross(w, r));
              terms.col(only) *= m;
              return Vector3d(terms.rowwise().sum());
            });
  e.wrong_input<0>("The mass does not enter: this is the acceleration, not the force.", "mass_lost", fixed(1.0));
  e.route("force by force", [](auto m, auto& r, auto& v, auto& w, auto& a) {
    return 2 * m * cross(v, w) + m * cross(r, a) + m * cross(cross(w, r), w);
  });
  e.route("centrifugal force from the axis", [](auto m, auto& r, auto& v, auto& w, auto& a) {
    const Vector3d axis = w.stableNormalized(), from_axis = r - axis * axis.dot(r);
    return m * (w.squaredNorm() * from_axis - 2 * w.norm() * cross(axis, v) - cross(a, r));
  });
  e.route("matrices", [](auto m, auto& r, auto& v, auto& w, auto& a) {
    return m * (skew(w).transpose() * (2 * v + skew(w) * r) + skew(a).transpose() * r);
  });
}
