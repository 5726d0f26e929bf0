// What a worked example says when it meets a function that the student has not written yet.
#include <rigid/vocabulary.hpp>

#include <doctest/doctest.h>

REGISTER_EXCEPTION_TRANSLATOR(const rigid::NotStarted& missing) {
  return doctest::String("not started: ") + missing.function;
}
