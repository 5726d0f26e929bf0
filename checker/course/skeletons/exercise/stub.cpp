// The task stands in include/rigid/@CONTRACT@.hpp; ./checker/run check @NAME@ shows it in short.
#include <rigid/@CONTRACT@.hpp>

namespace rigid {

@SIGNATURE@ {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
