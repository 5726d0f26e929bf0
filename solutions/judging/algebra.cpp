#include "solutions/judging/algebra.hpp"

namespace workbook::judging {

#define WORKBOOK_ALGEBRA template
#include "solutions/judging/algebra.inc"

}  // namespace workbook::judging
