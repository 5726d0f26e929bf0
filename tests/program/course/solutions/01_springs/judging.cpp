/// @file
/// How the exercises of the tiny course are judged.
#include "rigid/springs.hpp"
#include "solutions/judging/lecture.hpp"

namespace {

using namespace rigid;
using namespace workbook;
using namespace workbook::judging;

using Spring = std::tuple<double, Vector3d>;

constexpr Unit stiffness = units::newton / units::metre;

Spring draw(Random& random) { return {random.uniform(1.5, 5), random.vector(2.0)}; }

}  // namespace

void workbook::judging::describe(Lecture& lecture) {
  auto& energy = lecture.exercise("spring_energy", &spring_energy);
  energy.argument("k", stiffness).argument("x", units::metre).result("E", units::joule);
  energy.worked("2 N/m stretched by 3 m", 2, Vector3d(3, 0, 0));
  energy.random("a random spring", 6, draw);
  energy.misconception("no_half", "The factor ½ is missing.", "springs_energy",
                       [](double k, const Vector3d& x) { return k * x.squaredNorm(); });
  energy.misconception("not_squared", "The stretch enters once, not squared.", "springs_energy",
                       [](double k, const Vector3d& x) { return 0.5 * k * x.norm(); });
  energy.misconception("no_stiffness", "The stiffness does not enter.", "springs_energy",
                       [](double, const Vector3d& x) { return 0.5 * x.squaredNorm(); });
  energy.route("dot product", [](double k, const Vector3d& x) { return k * x.dot(x) / 2; });
  energy.route("work", [](double k, const Vector3d& x) { return -0.5 * spring_force(k, x).dot(x); });
  energy.route("by components",
               [](double k, const Vector3d& x) { return (k * x[0] * x[0] + k * x[1] * x[1] + k * x[2] * x[2]) / 2; });
  energy.sweep({"Energy", "x (m)", "E (J)"}, {0, 2, 11},
               [](double x) {
                 return Spring{3, Vector3d(x, 0, 0)};
               },
               {{"E", 0, 0}});

  auto& force = lecture.exercise("spring_force", &spring_force);
  force.argument("k", stiffness).argument("x", units::metre).result("F", units::newton);
  force.worked("2 N/m stretched by (3, 1, 2) m", 2, Vector3d(3, 1, 2));
  force.random("a random spring", 6, draw);
  force.misconception("away", "The force points away from rest; a spring pulls back.", "springs_force",
                      [](double k, const Vector3d& x) -> Vector3d { return k * x; });
  force.misconception("direction_only", "The force has the right direction, but the stretch does not enter.",
                      "springs_force", [](double k, const Vector3d& x) -> Vector3d { return -k * x.normalized(); });
  force.misconception("no_stiffness", "The stiffness does not enter.", "springs_force",
                      [](double, const Vector3d& x) -> Vector3d { return -x; });
  force.route("by components", [](double k, const Vector3d& x) -> Vector3d {
    return {-k * x[0], -k * x[1], -k * x[2]};
  });
  force.route("factored", [](double k, const Vector3d& x) -> Vector3d { return x * -k; });
  force.route("gradient of the energy", [](double k, const Vector3d& x) -> Vector3d {
    Vector3d gradient;
    for (int i = 0; i < 3; ++i) {
      gradient[i] = (spring_energy(k, x + Vector3d::Unit(i)) - spring_energy(k, x - Vector3d::Unit(i))) / 2;
    }
    return -gradient;
  });
  force.sweep({"Force", "x (m)", "F (N)"}, {0, 2, 11},
              [](double x) {
                return Spring{3, Vector3d(x, 1, 0)};
              },
              {{"F_x", 0, 0}, {"F_y", 1, 0}});
}
