// A free satellite has flexible aerials that turn energy of rotation into heat until nothing changes any more. How
// much heat is produced, and how fast does the satellite rotate in the end? Return {heat, rate}. The moments come in
// any order.
#include <rigid/free_tops.hpp>

namespace rigid {

Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
