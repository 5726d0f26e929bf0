#include "rigid/@CONTRACT@.hpp"
#include "solutions/judging/judging.hpp"

void judge_@NAME@(workbook::judging::Lecture& lecture) {
  using namespace workbook::judging;
  // TODO: the units in place of none.
  auto& e = lecture.exercise(&rigid::@NAME@, {@QUANTITIES@}, {"result", none});
  e.random("a random input", 10, [](Random& random) { return std::tuple{@DRAWN@}; });
  e.scale(1.0);  // TODO: remove it; the size of the expected numbers will do in most cases
  // TODO: worked and special cases, three wrong answers, three routes, what every right result has, a sweep to plot.
}
