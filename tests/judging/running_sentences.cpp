// What is said of a running function where less is known than usual.
#include "checker/messages/running.hpp"

#include <doctest/doctest.h>

#include <csignal>

using namespace workbook;

TEST_CASE("a condition of Eigen without its sizes still gets its general sentence") {
  CHECK(messages::eigen_assertion("index >= 0 && index < size()", {}) ==
        "an index lies outside its vector; a vector of size n has the indices 0 to n - 1.");
  CHECK(messages::eigen_assertion("something new", {1, 2}) ==
        "here Eigen asks for something that does not hold: “something new”.");
  CHECK(messages::eigen_stopped("something new") ==
        "Eigen stopped the calculation, because this does not hold: something new");
}

TEST_CASE("what follows << and is too large is not called an empty matrix") {
  CHECK(messages::eigen_stopped("m_xpr.rows() >= other.rows() && m_xpr.cols() >= other.cols()\n      && \"Cannot "
                                "comma-initialize a 0x0 matrix (operator<<)\"") ==
        "Eigen stopped the calculation: what follows << is larger than the matrix or vector that it shall fill");
}

TEST_CASE("a check of the standard library without its numbers names the container") {
  CHECK(messages::library_assertion("reference std::vector<_Tp, _Alloc>::operator[](size_type)", "__n < this->size()",
                                    {}) == "an index is outside its vector.");
  CHECK(messages::library_assertion("int f()", "__count > 0", {}) ==
        "a function of the standard library asks for something that does not hold: “__count > 0”.");
  CHECK(messages::array_index(3, "") == "index 3 is outside its array.");
}

TEST_CASE("a long or broken text of a student is quoted in short, on one line") {
  const std::string sentence = messages::thrown("first\nsecond" + std::string(500, 'x'));
  CHECK(sentence.find('\n') == std::string::npos);
  CHECK(sentence.size() < 200);
  CHECK(messages::thrown("vector: (which is odd) >= (which is more)") ==
        "the exception “vector: (which is odd) >= (which is more)” is thrown here.");
}

TEST_CASE("sentences stand alone where there is no line") {
  CHECK(messages::at_no_line("the result") == "The result");
  CHECK(messages::at_no_line("") == "");
}

TEST_CASE("entries that were never set are counted where there are many") {
  CHECK(messages::entries_never_set({"component 1", "component 2", "component 3", "component 4"}, 9) ==
        "component 1, component 2, component 3 and 1 more of the result are never given a value.");
  CHECK(messages::entries_never_set({"the result"}, 1) == "the result is never given a value.");
}
