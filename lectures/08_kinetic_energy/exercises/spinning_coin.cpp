// A thin coin is about to settle on a table: it rolls on its edge without slipping, its plane inclined to the table,
// its centre at rest. The rate at which the point of contact runs around.
#include <rigid/kinetic_energy.hpp>

namespace rigid {

double spinning_coin(double radius, double g, double inclination) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
