#include "checker/messages/worked_examples.hpp"

#include "checker/messages/program.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string examples_need_files_that_compile() {
  return fmt::format("These files do not compile, so the examples cannot run; `{}` on each says why:",
                     command("check"));
}

std::string examples_could_not_be_built(const std::string& lecture) {
  return fmt::format("The worked examples of {} could not be built.", lecture);
}

std::string examples_took_too_long(const std::string& lecture) {
  return fmt::format(
      "The examples ended before their end (out of time): a function of yours never returns, or is far too slow; `{}` "
      "finds it.",
      command("check " + lecture));
}

std::string examples_crashed(int signal, const std::string& lecture) {
  return fmt::format(
      "The examples ended before their end (signal {}): a function of yours crashes or uses up the memory; `{}` finds "
      "it.",
      signal, command("check " + lecture));
}

std::string examples_printed_too_much() {
  return "The examples printed more than is read: a function of yours prints; remove that, or keep it out of the loop.";
}

std::string examples_left_no_report(int exit_status) {
  return fmt::format(
      "The examples left no report that can be read (exit status {}): a function of yours prints something or ends the "
      "program; remove that, and try again.",
      exit_status);
}

std::string example_is_not_started(const std::string& title) {
  return fmt::format("{} (needs a function that is not started)", title);
}

std::string example_comes_out_otherwise(const std::string& title) {
  return fmt::format("{} (comes out otherwise)", title);
}

std::string examples_come_out(std::size_t passed, std::size_t total, const std::string& lecture) {
  if (total == 1) {
    return passed == 1 ? fmt::format("The one worked example of {} comes out with your functions.", lecture)
                       : fmt::format("The one worked example of {} does not come out with your functions.", lecture);
  }
  return fmt::format("{} of {} worked examples of {} come out with your functions.", passed, total, lecture);
}

}  // namespace workbook::messages
