#include "rigid/springs.hpp"
#include "solutions/judging/judging.hpp"

void judge_spring_force(Lecture& lecture) {
  auto& e = lecture.exercise(&spring_force, {{"k", positive(newton / metre)}, {"x", metre}}, {"F", newton});
  e.worked("2 N/m stretched by (3, 1, 2) m", 2, {3, 1, 2});
  e.special("at rest", 2, zero);
  e.special("a very soft spring", 1e-9, {1, 0, 0});
  e.scale([](auto k, auto& x) { return or_one(k * x.norm()); });
  e.limit("at rest", zero, "Nothing is stretched.");
  e.limit("a very soft spring", {-1e-9, 0, 0}, "It is proportional to k.");
  e.measured("a luggage scale", {}, 1962, {0.05, 0, 0});
  e.random("a random spring", 6, any::uniform(1.5, 5), any::vector(2));
  e.sweep({"Force", "x (m)", "F (N)"}, {"F_x", "F_y"}, {0, 2, 11}, [](auto x) { return tuple(3, Vector3d(x, 1, 0)); });

  e.wrong_output("The force points away from rest; a spring pulls back.", "away", negated);
  e.wrong("The force has the right direction, but the stretch does not enter.", "direction_only",
          [](auto k, auto& x) { return -k * x.normalized(); });
  e.wrong_input<0>("The stiffness does not enter.", "no_stiffness", fixed(1.0));
  e.route("by components", [](auto k, auto& x) { return Vector3d(-k * x[0], -k * x[1], -k * x[2]); });
  e.route("factored", [](auto k, auto& x) { return x * -k; });
  e.route("gradient of the energy", [](auto k, auto& x) {
    const double h = or_one(x.norm());  // the energy is quadratic: any step is exact
    Vector3d force;
    for (int i = 0; i < 3; ++i)
      force[i] = (spring_energy(k, x - h * Vector3d::Unit(i)) - spring_energy(k, x + h * Vector3d::Unit(i))) / (2 * h);
    return force;
  });
}
