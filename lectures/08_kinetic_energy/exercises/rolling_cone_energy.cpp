// A solid uniform cone lies on its side on a level table and rolls without slipping, around its own apex. Its kinetic
// energy, from the rate at which the line of contact turns on the table.
#include <rigid/kinetic_energy.hpp>

namespace rigid {

double rolling_cone_energy(double M, double height, double half_angle, double rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
