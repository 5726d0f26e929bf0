#include "checker/data/reason.hpp"

namespace workbook {

std::string to_string(ReasonKind kind) {
  constexpr const char* names[] = {"code",       "repair",  "misconception", "term",  "transform", "input_transform",
                                   "difference", "split",   "independence",  "entry", "place",     "accuracy",
                                   "learnt",     "property"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace workbook
