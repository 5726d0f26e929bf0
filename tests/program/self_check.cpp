// self-check: every fault that an author can make is found, with the file and the fix.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;

TEST_CASE("every fault of the files of an exercise or a lecture is named with its file and what is needed") {
  CourseCopy().check_story("self_check");
}

TEST_CASE("self-check --prove names lost digits, changes that no case finds and a record that does not fit") {
  CourseCopy().check_story("proving");
}
