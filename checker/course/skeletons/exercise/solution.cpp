#include "rigid/@CONTRACT@.hpp"

namespace rigid {

@UNNAMED@ {
  return @PLACEHOLDER@;  // TODO: the solution
}

}  // namespace rigid
