#include "rigid/springs.hpp"
#include "solutions/judging/judging.hpp"

void judge_spring_energy(Lecture& lecture) {
  auto& e = lecture.exercise(&spring_energy, {{"k", positive(newton / metre)}, {"x", metre}}, {"E", joule});
  e.worked("2 N/m stretched by 3 m", 2, {3, 0, 0});
  e.measured("a luggage scale, read to 0.02 J", {0.02}, 1962, {0.05, 0, 0});
  e.random("a random spring", 6, any::uniform(1.5, 5), any::vector(2));
  e.sweep({"Energy", "x (m)", "E (J)"}, {"E"}, {0, 2, 11}, [](auto x) { return tuple(3, Vector3d(x, 0, 0)); });

  e.wrong_output("The factor ½ is missing.", "no_half", times(2));
  e.wrong("The stretch enters once, not squared.", "not_squared", [](auto k, auto& x) { return 0.5 * k * x.norm(); });
  e.wrong_input<0>("The stiffness does not enter.", "no_stiffness", fixed(1.0));
  e.route("dot product", [](auto k, auto& x) { return k * x.dot(x) / 2; });
  e.route("work", [](auto k, auto& x) { return -0.5 * spring_force(k, x).dot(x); });
  e.route("by components", [](auto k, auto& x) { return (k * x[0] * x[0] + k * x[1] * x[1] + k * x[2] * x[2]) / 2; });
}
