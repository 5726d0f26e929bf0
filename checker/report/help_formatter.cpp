#include "checker/report/help_formatter.hpp"

#include "checker/messages/help.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace workbook {

namespace {

constexpr std::size_t indent = 2;

/// The whole of a text that may span paragraphs. Lines that begin with a blank stand as they are.
std::string paragraphs(const std::string& text, const Console& console) {
  std::string result;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    result += (line.starts_with(' ') ? line : console.wrapped(line)) + "\n";
    begin = end + 1;
  }
  return result;
}

}  // namespace

HelpFormatter::HelpFormatter(const Console& console) : console_(console) {
  label("Positionals", messages::arguments_heading());
  label("SUBCOMMAND", messages::command_placeholder());
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string text = Formatter::make_help(app, std::move(name), mode);
  for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
  return text;
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return paragraphs(app->get_description(), console_) + "\n";
}

std::string HelpFormatter::make_footer(const CLI::App* app) const {
  const std::string footer = app->get_footer();
  return footer.empty() ? "" : paragraphs(footer, console_);
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  return entry(make_option_name(option, is_positional) + make_option_opts(option), make_option_desc(option));
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  const std::string description = command->get_description();
  return entry(command->get_name(), description.substr(0, description.find('\n')));
}

std::string HelpFormatter::entry(const std::string& name, const std::string& meaning) const {
  const std::size_t column = std::clamp<std::size_t>(console_.width() / 3, 12, 28);
  const std::string margin(indent, ' ');
  if (meaning.empty()) return margin + name + "\n";
  const std::string body = console_.wrapped(meaning, column);
  if (indent + display_width(name) + 1 > column) return fmt::format("{}{}\n{}\n", margin, name, body);
  return fmt::format("{}{}{}\n", margin, padded(name, column - indent), body.substr(column));
}

}  // namespace workbook
