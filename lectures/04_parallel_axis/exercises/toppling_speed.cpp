// A uniform block slides over a smooth floor until its lower front edge meets a low fixed ridge, from which it
// neither rebounds nor slips. Above which speed does it topple over the ridge?
#include <rigid/parallel_axis.hpp>

namespace rigid {

double toppling_speed(double length, double height, double g) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
