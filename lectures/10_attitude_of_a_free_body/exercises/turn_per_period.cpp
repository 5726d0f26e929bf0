// The angle through which the axis of the largest moment goes round L in one period of ω, whole turns counted. The
// moments come in ascending order.
#include <rigid/attitude_of_a_free_body.hpp>

namespace rigid {

double turn_per_period(const Vector3d& I, const Vector3d& omega0) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
