/// @file
/// `--help` laid out like a page of a manual, in lines that fit the terminal.
#pragma once

#include "checker/report/console.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace workbook {

/// CLI11's help, with paragraphs and descriptions wrapped to the width of the terminal.
class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(const Console& console);

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_footer(const CLI::App* app) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;

 private:
  /// A name and what it means, side by side, or one below the other on a narrow terminal.
  std::string entry(const std::string& name, const std::string& meaning) const;

  Console console_;
};

}  // namespace workbook
