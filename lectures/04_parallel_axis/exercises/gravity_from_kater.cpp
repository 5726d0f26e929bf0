// A rigid pendulum of unknown mass and moment of inertia swings on one knife edge, at h1 from its centre of mass,
// with the period T1, and on another one, at h2 on the opposite side, with the period T2. What is the acceleration of
// free fall?
#include <rigid/parallel_axis.hpp>

namespace rigid {

double gravity_from_kater(double h1, double T1, double h2, double T2) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
