// What std::cout and its like need, linked where a student's file names them.
#include "checker/worker/serve.hpp"

#include <iostream>

namespace workbook {

void flush_streams() {
  std::cout.flush();
  std::clog.flush();
}

}  // namespace workbook
