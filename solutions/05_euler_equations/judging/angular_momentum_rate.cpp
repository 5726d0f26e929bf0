#include "solutions/05_euler_equations/shared.hpp"

void judge_angular_momentum_rate(Lecture& lecture) {
  auto& e = lecture.exercise(&angular_momentum_rate,
                             {{"I", regular_tensor}, {"omega", rad_per_s}, {"omega_rate", rad_per_s2}},
                             {"L_rate", newton_metre});
  const Vector3d rate0(0.1, 0.2, -0.3);
  e.worked("the four masses of lecture 03", tensor_of_four_masses, example_omega, rate0);
  e.special("steady rotation", tensor_of_four_masses, example_omega, zero);
  e.special("set off from rest", tensor_of_four_masses, zero, rate0);
  e.special("a sphere", tensor_of_sphere, example_omega, rate0);
  e.special("principal axes", tensor_of_example, example_omega, rate0);
  e.special("a free body, where L stays", tensor_of_example, example_omega,
            euler_equations(example_moments, example_omega, zero));
  e.random("a random body", 10, &Random::inertia_tensor, any::vector(2), any::vector(4));
  e.scale([](auto& I, auto& w, auto& rate) { return I.norm() * max(w.squaredNorm() + rate.norm(), 1e-3); });
  e.sweep<2>({"The four masses at ω = (0.3, −0.2, 0.5) rad/s, speeded up along ω", "rate of |ω| (rad/s²)",
              "component of dL/dt (N m)"},
             {"x", "y", "z"}, {-1, 1}, [](auto rate) { return rate * example_omega.normalized(); });

  e.term("I dω/dt", 1, [](auto& I, auto&, auto& rate) { return I * rate; });
  e.term("ω × L", 1, [](auto& I, auto& w, auto&) { return cross(w, I * w); });
  e.wrong_terms("This is I dω/dt, the rate seen from the body; its turning adds ω × L.", "body_rate_only", {1, 0});
  e.wrong_terms("The sign of ω × L is wrong: (d/dt)_inertial is (d/dt)_body *plus* ω×.", "sign", {1, -1});
  e.wrong("This is ω × (I dω/dt); the two summands are I dω/dt and ω × (Iω).", "cross_of_rate",
          [](auto& I, auto& w, auto& rate) { return cross(w, I * rate); });
  e.wrong("ω × (I dω/dt) is added here; what ω crosses is L = Iω itself.", "cross_of_rate_added",
          [](auto& I, auto& w, auto& rate) { return I * rate + cross(w, I * rate); });
  e.wrong_terms("This is ω × L alone; when ω changes too, I dω/dt is added.", "turning_only", {0, 1});
  e.wrong_input<0>({products_missing, "euler_equations_general"}, "diagonal_only", diagonal_part);
  e.wrong_input<0>({products_sign, "euler_equations_general"}, "products_flipped", products_flipped);
  e.wrong_terms("ω × L enters twice, for the turning of the axes; it does once.", "tensor_rate_doubled", {1, 2});
  e.wrong("dω/dt × L is added here; the axes turn with ω, so it is ω × L that is added to I dω/dt.", "rate_crossed",
          [](auto& I, auto& w, auto& rate) { return I * rate + cross(rate, I * w); });
  e.route("the tensor's own rate, [ω]I − I[ω]",
          [](auto& I, auto& w, auto& rate) { return I * rate + (skew(w) * I - I * skew(w)) * w; });
  e.route("on principal axes, as on the slides", [](auto& I, auto& w, auto& rate) -> Vector3d {
    const auto [moments, axes] = PrincipalFrame(I);
    return axes * (L_of(moments, axes.transpose() * rate) + L_of(differences(moments), products(axes.transpose() * w)));
  });
  e.route("the torque that does it", [](auto& I, auto& w, auto& rate) {
    // Euler's equations are linear in the torque: solve them for the torque that gives this rate.
    return I * (rate - euler_equations_general(I, w, zero));
  });
}
