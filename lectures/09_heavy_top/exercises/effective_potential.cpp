// The energy of a heavy symmetric top with the momenta p_phi and p_psi that passes the inclination theta with θ̇ = 0:
// all of its kinetic energy, and the potential energy.
#include <rigid/heavy_top.hpp>

namespace rigid {

double effective_potential(double I1, double I3, double mgl, double p_phi, double p_psi, double theta) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
