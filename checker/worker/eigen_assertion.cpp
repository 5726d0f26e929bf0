#include "checker/worker/prelude.hpp"

#include <string_view>

namespace workbook {

void report_eigen_assertion(const char* condition) {
  // While `v << 1, f(), 3` is left because f threw, its destructor finds numbers missing; the first exception counts.
  if (std::uncaught_exceptions() > 0 &&
      std::string_view(condition).find("Too few coefficients") != std::string_view::npos)
    return;
  throw EigenError(condition);
}

}  // namespace workbook
