// One thing is said otherwise than several.
#include "checker/messages/failures.hpp"
#include "checker/messages/machine.hpp"
#include "checker/messages/reference_files.hpp"
#include "checker/messages/reporting.hpp"
#include "checker/messages/workbook_in_order.hpp"
#include "checker/messages/worked_examples.hpp"

#include <doctest/doctest.h>

using namespace workbook;

TEST_CASE("one thing is said otherwise than several") {
  CHECK(messages::more_columns(1) == "(1 more column not shown)");
  CHECK(messages::more_columns(7) == "(7 more columns not shown)");
  CHECK(messages::more_numbers(1) == "(1 more number not shown)");
  CHECK(messages::more_numbers(2) == "(2 more numbers not shown)");
  CHECK(messages::results_are_there(1, 1) == "results of 1 lecture, 1 exercise");
  CHECK(messages::results_are_there(8, 55) == "results of 8 lectures, 55 exercises");
  CHECK(messages::cases_right(0, 1) == "(0 of 1 case right)");
  CHECK(messages::cases_right(1, 14) == "(1 of 14 cases right)");
  CHECK(messages::few_misconceptions(1, 3) == "There is 1 misconception, fewer than 3.");
  CHECK(messages::few_routes(1, 3) == "There is 1 route, fewer than 3.");
  CHECK(messages::few_deciding_cases(1, 6) == "There is 1 deciding case, fewer than 6.");
  CHECK(messages::another_number_of_hints("a.md", 1, 3) ==
        "a.md: 1 hint instead of 3; separate them by lines of three dashes.");
  CHECK(messages::to_mend(1) == "1 thing to mend.");
  CHECK(messages::to_mend(3) == "3 things to mend.");
  CHECK(messages::in_order({1, 1, 1, 1, 1}) ==
        "In order: 1 lecture, 1 exercise, 1 right route, 1 wrong answer, 1 seed.");
  CHECK(messages::expected_items(1, messages::OnePer::row, 2) == "expected 1 item (one per row), found 2");
  CHECK(messages::expected_row(1, 2) == "expected a row of 1 number, found a list of 2");
  CHECK(messages::expected_scales(1, 2) == "expected 1 number, found 2");
  CHECK(messages::units_do_not_fit(1, 3) == "the result has 1 unit but 3 numbers");
  CHECK(messages::examples_come_out(0, 1, "01_springs") ==
        "The one worked example of 01_springs does not come out with your functions.");
}

TEST_CASE("worked examples that run out of time are said to") {
  CHECK(messages::examples_took_too_long("01_springs") ==
        "The examples ended before their end (out of time): a function of yours never returns, or is far too slow; "
        "`checker check 01_springs` finds it.");
}
