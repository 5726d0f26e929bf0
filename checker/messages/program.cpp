#include "checker/messages/program.hpp"

#include <cstdlib>

namespace workbook::messages {

std::string program_name() {
  const char* typed = std::getenv("WORKBOOK_PROGRAM");
  return typed == nullptr || *typed == '\0' ? "checker" : typed;
}

std::string command(const std::string& arguments) { return program_name() + " " + arguments; }

}  // namespace workbook::messages
