#include "checker/compile/diagnostics.hpp"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <sstream>
#include <string_view>
#include <utility>

namespace workbook {
namespace {

bool contains_any(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](std::string_view part) { return text.find(part) != std::string_view::npos; });
}

/// Takes ":12" from the front of a text.
std::optional<int> take_number(std::string_view& text) {
  if (!text.starts_with(':')) return std::nullopt;
  int number = 0;
  const auto [stop, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
  if (error != std::errc() || number < 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return number;
}

/// "error", "warning" or "note" behind a place, with its text.
struct Remark {
  std::string_view kind;
  std::string_view text;
  std::string_view header;
};

/// "Dot.h" for "Dot.h:75:3".
std::string_view without_place(std::string_view file) {
  for (int i = 0; i < 2; ++i) {
    const std::size_t last = file.find_last_not_of("0123456789");
    if (last != std::string_view::npos && file[last] == ':' && last + 1 < file.size()) file = file.substr(0, last);
  }
  return file;
}

std::optional<Remark> remark_in(std::string_view line) {
  std::optional<Remark> first;
  std::size_t first_at = std::string_view::npos;
  for (const std::string_view kind : {"fatal error", "error", "warning", "note"}) {
    const std::string mark = ": " + std::string(kind) + ": ";
    const std::size_t at = line.find(mark);
    if (at == std::string_view::npos || at >= first_at) continue;
    first_at = at;
    first = Remark{kind, line.substr(at + mark.size()), without_place(line.substr(0, at))};
  }
  return first;
}

/// Goes through the lines and remembers what led to the next error.
class Reader {
 public:
  explicit Reader(std::string file_name) : file_name_(std::move(file_name)) {}

  void read(std::string_view line) {
    if (read_include(line)) return;
    if (line.starts_with(' ')) return;  // the line of code that is shown, with its caret
    std::string_view rest = line;
    const std::optional<Place> place = take_place(rest);
    if (place && rest.starts_with("   ")) return read_context(line, *place);
    std::optional<Remark> remark = remark_in(place ? std::string_view(rest) : line);
    if (remark) {
      if (remark->kind == "note")
        add_note(remark->text);
      else
        add(*remark, place);
    } else if (line.find(":   ") != std::string_view::npos) {
      read_context(line, std::nullopt);
    } else if (line.find(": In ") != std::string_view::npos || line.find(": At ") != std::string_view::npos) {
      begin_context(line);
    }
  }

  std::vector<Diagnostic> take() { return std::move(found_); }

 private:
  /// Takes "name:12:5:" from the front.
  std::optional<Place> take_place(std::string_view& line) const {
    if (!line.starts_with(file_name_)) return std::nullopt;
    std::string_view rest = line.substr(file_name_.size());
    const std::optional<int> number = take_number(rest);
    if (!number) return std::nullopt;
    const std::optional<int> column = take_number(rest);
    if (!rest.starts_with(':')) return std::nullopt;
    // ": error: " is looked for with its colon, "   required from" without.
    line = rest.substr(1).starts_with("   ") ? rest.substr(1) : rest;
    return Place{*number, column.value_or(0)};
  }

  /// "In file included from twice.cpp:1," and "                 from twice.cpp:1:"
  bool read_include(std::string_view line) {
    std::string_view rest = line;
    const bool begins = rest.starts_with("In file included from ");
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    if (!begins && !(line.starts_with("        ") && rest.starts_with("from "))) return false;
    if (begins) include_ = {};
    rest.remove_prefix(begins ? std::string_view("In file included from ").size() : 5);
    if (include_.line == 0 && rest.starts_with(file_name_)) {
      rest.remove_prefix(file_name_.size());
      include_.line = take_number(rest).value_or(0);
    }
    return true;
  }

  void begin_context(std::string_view line) {
    context_.clear();
    led_by_ = {};
    context_.emplace_back(line);
  }

  /// "twice.cpp:4:5:   required from here"
  void read_context(std::string_view line, std::optional<Place> place) {
    context_.emplace_back(line);
    if (place && led_by_.line == 0) led_by_ = *place;
  }

  void add(const Remark& remark, std::optional<Place> place) {
    Diagnostic one;
    one.severity = remark.kind == "warning" ? Severity::warning : Severity::error;
    one.text = remark.text;
    if (place) {
      one.place = *place;
    } else {
      one.place = led_by_.line > 0 ? led_by_ : include_;
      one.header = remark.header;
    }
    if (const std::size_t option = one.text.rfind(" [-W"); option != std::string::npos && one.text.ends_with(']')) {
      one.option = one.text.substr(option + 2, one.text.size() - option - 3);
      one.text.resize(option);
    }
    one.context = context_;
    found_.push_back(std::move(one));
    include_ = {};
  }

  void add_note(std::string_view text) {
    if (!found_.empty() && found_.back().notes.size() < 10) found_.back().notes.emplace_back(text);
  }

  std::string file_name_;
  std::vector<Diagnostic> found_;
  std::vector<std::string> context_;
  Place led_by_;   // the innermost place in the student's file that asked for a template
  Place include_;  // the #include that led to the next error
};

}  // namespace

std::vector<Diagnostic> diagnostics(const std::string& output, const std::string& file_name) {
  Reader reader(file_name);
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) reader.read(line);
  return reader.take();
}

bool ran_out_of_memory(const std::string& output) {
  return contains_any(output, {"out of memory", "virtual memory exhausted", "Killed signal terminated program",
                               "memory exhausted", "Cannot allocate memory"});
}

bool grew_too_large(const std::string& output) {
  return contains_any(output, {"File too large", "File size limit exceeded"});
}

}  // namespace workbook
