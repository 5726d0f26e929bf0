#include "checker/compile/diagnostics.hpp"

#include "checker/base/text.hpp"

#include <algorithm>
#include <map>

namespace workbook {

CompilerOutput read_compiler_output(std::string_view output, const std::string& shown_name,
                                    const std::function<bool(const std::string&)>& may_be_shown) {
  constexpr std::size_t longest_head = 1000;
  constexpr std::size_t longest_text = 12000;  // of an error, of its notes, of its context
  constexpr const char* placed =
      R"(^([^ ].*?):(\d{1,9})(?::(\d{1,9}))?: (?:(fatal error|error|Error|warning|note): )?)";
  CompilerOutput result;
  std::map<std::string, bool> allowed;
  std::string context;
  Place led_by;       // the innermost place in the student's file that asked for a template
  Place included_at;  // the #include that led to the next error
  bool is_hidden = false;
  bool in_warning = false;
  for (std::size_t at = 0, end = 0; at < output.size(); at = end + 1) {
    end = std::min(output.find('\n', at), output.size());
    const std::string_view line = output.substr(at, end - at);
    const std::string_view head = line.substr(0, longest_head);
    if (const Match include = search(head, R"(^(?:In file included| {10,}) from (.+?):(\d{1,9})[:,])")) {
      if (head[0] == 'I') included_at = {};
      if (include[1] == unit_name && included_at.line == 0) included_at.line = std::stoi(include[2]);
      continue;  // paths of this machine
    }
    Match found = search(head, placed);
    const bool has_place{found};
    if (!has_place) found = search(head, "^([^ ].*?): (?:In|At) ");
    const bool in_unit = found[1] == unit_name;
    if (found) {
      const auto [file, is_new] = allowed.try_emplace(found[1], in_unit);
      if (is_new && !in_unit) file->second = may_be_shown(file->first);
      is_hidden = !file->second;
      if (is_hidden && result.foreign_file.empty()) result.foreign_file = file->first;
    } else if (!head.starts_with(' ')) {
      is_hidden = false;  // what is quoted below a place belongs to it
    }
    if (!is_hidden && found) {
      const std::string text(line.substr(found[0].size(), longest_text));
      const Place place = has_place ? Place{std::stoi(found[2]), found[3].empty() ? 0 : std::stoi(found[3])} : Place{};
      const std::string kind = found[4];
      if (kind.empty()) {
        // "header.h: In instantiation of 'f() [with T = …]':" begins, "unit.cpp:4:5:   required from here" goes on.
        in_warning = false;
        if (!has_place) context.clear();
        if (!has_place || (in_unit && led_by.line == 0)) led_by = place;
        if (const std::size_t with = text.rfind(" [with "); with != std::string::npos && context.size() < longest_text)
          context += text.substr(with + 7) + "\n";
      } else if (kind != "note") {
        in_warning = kind == "warning";
        result.diagnostics.push_back({!in_warning,
                                      in_unit           ? place
                                      : led_by.line > 0 ? led_by
                                                        : included_at,
                                      in_unit ? "" : found[1], text, "", "", context});
        Diagnostic& one = result.diagnostics.back();
        if (const std::size_t option = text.rfind(" [-W"); option != std::string::npos && text.ends_with(']')) {
          one.option = text.substr(option + 2, text.size() - option - 3);
          one.text.resize(option);
        }
        one.text = in_words_of_gcc(one.text);
        included_at = {};
      } else if (!result.diagnostics.empty() && result.diagnostics.back().notes.size() < longest_text) {
        Diagnostic& noted = result.diagnostics.back();
        noted.notes += text + "\n";
        // As clang says what led to an error: afterwards.
        if (in_unit && noted.place.line == 0 && text.ends_with("requested here")) noted.place = place;
      }
    }
    if (is_hidden || in_warning) continue;
    result.shown += in_unit ? shown_name : "";
    result.shown += line.substr(in_unit ? unit_name.size() : 0);
    result.shown += '\n';
  }
  return result;
}

}  // namespace workbook
