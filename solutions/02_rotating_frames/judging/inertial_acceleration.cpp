#include "solutions/02_rotating_frames/shared.hpp"

void judge_inertial_acceleration(Lecture& lecture) {
  auto& e = lecture.exercise(
      &inertial_acceleration,
      {{"a_body", m_per_s2}, {"v_body", m_per_s}, {"r", metre}, {"omega", rad_per_s}, {"alpha", rad_per_s2}},
      {"a_inertial", m_per_s2});
  e.worked("the vectors of the lecture", example_a, example_v, example_r, example_omega, example_alpha);
  e.special("at rest in a steadily rotating frame", zero, zero, example_r, example_omega, zero);
  e.special("the frame does not turn", example_a, example_v, example_r, zero, zero);
  e.special("the frame begins to turn", example_a, example_v, example_r, zero, example_alpha);
  e.special("on the axis", example_a, example_v, 2 * example_omega, example_omega, zero);
  e.special("at rest in the inertial frame", {0, -4, 0}, {2, 0, 0}, {0, 1, 0.5}, {0, 0, 2}, zero);
  e.random("a random motion", 10, any::vector(2), any::vector(2), any::vector(2), any::vector(2), any::vector(2));
  e.scale([](auto& a, auto& v, auto& r, auto& w, auto& alpha) {
    return a.norm() + 2 * w.norm() * v.norm() + alpha.norm() * r.norm() + w.squaredNorm() * r.norm();
  });
  e.sweep<3>({"The lecture's motion in a frame that turns faster and faster about its axis", "|ω| (rad/s)",
              "inertial acceleration (m/s²)"},
             {"x", "y", "z"}, {0, 2}, [](auto rate) { return rate * example_omega.normalized(); });

  e.term("a_body", 1, [](auto& a, auto&, auto&, auto&, auto&) { return a; });
  e.term("ω × v", 2, [](auto&, auto& v, auto&, auto& w, auto&) { return cross(w, v); });
  e.term("α × r", 1, [](auto&, auto&, auto& r, auto&, auto& alpha) { return cross(alpha, r); });
  e.term("ω × (ω × r)", 1, [](auto&, auto&, auto& r, auto& w, auto&) { return cross(w, cross(w, r)); });
  e.wrong_terms("The Coriolis term lacks its 2: ω × v arises twice, from the turning of v and the change of ω × r.",
                "coriolis_without_two", {1, 1, 1, 1});
  e.wrong_terms("The Euler term α × r is missing; it is there when ω changes.", "no_euler_term", {1, 2, 0, 1});
  e.wrong_terms({"The term ω × (ω × r) is missing or zero; without brackets, as (ω × ω) × r, it vanishes.", brackets},
                "no_centripetal_term", {1, 2, 1, 0});
  e.wrong_terms({"ω × (ω × r) has the wrong sign: it is added here, and points towards the axis by itself.", brackets},
                "centripetal_sign", {1, 2, 1, -1});
  e.wrong_terms("The Coriolis term has the wrong sign: it is +2 ω × v here.", "coriolis_sign", {1, -2, 1, 1});
  e.wrong_terms("The Euler term has the wrong sign: it is +α × r here.", "euler_sign", {1, 2, -1, 1});
  e.wrong_terms({"Three terms are subtracted, as in the forces; here they are added.", "rotating_frames_forces"},
                "fictitious_signs", {1, -2, -1, -1});
  e.wrong_terms("The Coriolis term 2 ω × v is missing for a moving point.", "no_coriolis_term", {1, 0, 1, 1});
  e.wrong_terms("The acceleration in the rotating frame, a_body, does not enter.", "a_body_lost", {0, 2, 1, 1});
  e.wrong_terms("This is a_body alone; three terms are to be added.", "a_body_only", {1, 0, 0, 0});
  e.wrong_terms("This is the transport theorem for v_body, which is not yet the inertial velocity.", "transported_once",
                {1, 1, 0, 0});
  e.wrong_terms("ω × (ω × r) enters three times, twice with v_body + ω × r in the Coriolis term for v_body.",
                "inertial_velocity", {1, 2, 1, 3});
  e.wrong_output({"−ω² r stands for ω × (ω × r); the distance from the axis counts, not r itself.", brackets},
                 "omega_squared_r", [](auto& a, auto&, auto&, auto& r, auto& w, auto&) { a -= w * w.dot(r); });
  e.wrong_output("α is crossed with the velocity here; the Euler term is α × r.", "euler_with_velocity",
                 [](auto& sum, auto&, auto& v, auto& r, auto&, auto& alpha) { sum += cross(alpha, v - r); });
  e.route("the transport theorem twice", [](auto& a, auto& v, auto& r, auto& w, auto& alpha) {
    const Vector3d velocity = v + cross(w, r), rate_of_velocity_in_body = a + cross(alpha, r) + cross(w, v);
    return rate_of_velocity_in_body + cross(w, velocity);
  });
  e.route("matrices", [](auto& a, auto& v, auto& r, auto& w, auto& alpha) {
    // d²A/dt² of the attitude at the instant when A = 1 is [α] + [ω]².
    return (skew(alpha) + skew(w) * skew(w)) * r + 2 * skew(w) * v + a;
  });
  e.route("ω (ω·r) − ω² r", [](auto& a, auto& v, auto& r, auto& w, auto& alpha) {
    return a - 2 * cross(v, w) - cross(r, alpha) + w * w.dot(r) - r * w.dot(w);
  });
}
