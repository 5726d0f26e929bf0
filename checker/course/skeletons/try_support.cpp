// What the prelude and a function that is not started need, where there is no worker around them.
#include <cstdio>
#include <exception>
#include <iostream>
#include <unistd.h>

void workbook::throw_eigen_error(const char* condition) { throw EigenError(condition); }

static const auto previous = std::set_terminate([] {
  std::fflush(stdout);
  try {
    std::rethrow_exception(std::current_exception());
  } catch (const rigid::NotStarted& missing) {
    std::fprintf(stderr, "%s is not started: write it first.\n", missing.function);
  } catch (const workbook::EigenError& error) {
    std::fprintf(stderr, "Eigen stopped the calculation; this should have held: %s\n", error.what());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "An exception ended the program: %s\n", error.what());
  } catch (...) {
    std::fprintf(stderr, "An exception ended the program.\n");
  }
  _exit(1);
});
