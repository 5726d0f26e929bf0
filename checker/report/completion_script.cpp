#include "checker/report/completion_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace workbook {

namespace {

/// "--seed", "-h": every way to write an option.
std::vector<std::string> spellings(const CLI::Option* option) {
  std::vector<std::string> all;
  for (const std::string& name : option->get_lnames()) all.push_back("--" + name);
  for (const std::string& name : option->get_snames()) all.push_back("-" + name);
  return all;
}

/// What bash completes for a value of a type.
std::string completion_of(const std::string& type) {
  if (type == "EXERCISE") return "compgen -W \"$exercises\" -- \"$current\"";
  if (type == "LECTURE") return "compgen -W \"$lectures\" -- \"$current\"";
  if (type == "NAME") return "compgen -W \"$exercises $lectures\" -- \"$current\"";
  if (type == "FILE") return "compgen -f -- \"$current\"";
  if (type == "FOLDER") return "compgen -d -- \"$current\"";
  return ":";
}

/// One branch per command: its options, and what its arguments may be.
std::string branch(const CLI::App& command, const std::string& name) {
  std::vector<std::string> words;
  std::vector<std::string> arguments;
  for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
    words.push_back(below->get_name());
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) arguments.push_back(completion_of(option->get_type_name()));
    for (const std::string& spelling : spellings(option)) words.push_back(spelling);
  }
  std::string text = fmt::format("    {})\n      compgen -W '{}' -- \"$current\"\n", name.empty() ? "''" : name,
                                 fmt::join(words, " "));
  for (const std::string& argument : arguments) text += "      " + argument + "\n";
  return text + "      ;;\n";
}

/// Options with a value, by what completes the value.
std::map<std::string, std::vector<std::string>> options_with_value(const CLI::App& app) {
  std::map<std::string, std::vector<std::string>> by_completion;
  const auto gather = [&](const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_positional() || option->get_items_expected_max() == 0) continue;
      std::vector<std::string>& same = by_completion[completion_of(option->get_type_name())];
      for (const std::string& spelling : spellings(option)) {
        if (std::find(same.begin(), same.end(), spelling) == same.end()) same.push_back(spelling);
      }
    }
  };
  gather(app);
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) gather(*command);
  return by_completion;
}

}  // namespace

std::string completion_script(const CLI::App& app, const std::vector<std::string>& exercises,
                              const std::vector<std::string>& lectures) {
  std::string values;
  for (const auto& [completion, options] : options_with_value(app)) {
    values += fmt::format("    {})\n      {}\n      return\n      ;;\n", fmt::join(options, "|"), completion);
  }
  std::string branches = branch(app, "");
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    branches += branch(*command, command->get_name());
  return fmt::format(R"(# Completion for the checker of the Rigid Body Workbook: source this file in bash.
_rigid_body_workbook_words() {{
  local exercises='{}'
  local lectures='{}'
  case $previous in
{}  esac
  case $command in
{}  esac
}}

_rigid_body_workbook() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} command='' word
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    [[ $word == -* ]] || {{ command=$word; break; }}
  done
  mapfile -t COMPREPLY < <(_rigid_body_workbook_words)
}}

complete -o filenames -F _rigid_body_workbook checker checker/run ./checker/run
)",
                     fmt::join(exercises, " "), fmt::join(lectures, " "), values, branches);
}

}  // namespace workbook
