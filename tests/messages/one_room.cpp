// Everything that the checker says to a person stands in checker/messages, so that it can be translated.
#include "tests/messages/source_text.hpp"
#include "tests/support/files.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using namespace workbook::testing;

namespace {

/// Words that are meant for a program.
struct Exception {
  std::string file;       ///< or a folder with its slash
  std::string beginning;  ///< of the literal; empty: every one of the file
  std::string reason;
};

const std::vector<Exception> exceptions = {
    {"checker/commands/examples.cpp", "not started", "the text of rigid::NotStarted, as doctest reports it"},
    {"checker/commands/report.cpp", "report --html", "what to type, which is the same in every language"},
    {"checker/compile/compile_mistakes.cpp", "", "patterns of what compilers print, and C++"},
    {"checker/compile/diagnostics.cpp", "", "what compilers print"},
    {"checker/compile/eigen_type.cpp", "", "types of C++"},
    {"checker/compile/kept_expressions.cpp", "", "C++, and what compilers print of it"},
    {"checker/compile/warning_mistakes.cpp", "", "patterns of what compilers print"},
    {"checker/course/stub.cpp", "namespace rigid", "C++"},
    {"checker/course/stub.cpp", "  throw NotStarted", "C++"},
    {"checker/course/stub.cpp", "throw NotStarted", "C++"},
    {"checker/course/stub.cpp", "}}  // namespace rigid", "C++"},
    {"checker/report/completion_script.cpp", "", "a script for bash"},
    {"checker/report/overlay.cpp", "svg noenhanced", "gnuplot"},
    {"checker/report/overlay.cpp", "pngcairo noenhanced", "gnuplot"},
    {"checker/report/overlay_script.cpp", "", "gnuplot, and the shell that starts it"},
    {"checker/report/terminal_picture.cpp", "sixelgd", "gnuplot"},
    {"checker/report/terminal_picture.cpp", "dumb", "gnuplot"},
    {"checker/report/terminal_report.cpp", "check {}", "what to type, which is the same in every language"},
    {"checker/worker/instrumented/eyes.cpp", "Too few coefficients", "what Eigen's assertion says"},
    {"checker/worker/instrumented/sighting.hpp", "no padding may travel", "for who changes what is sent"},
    {"checker/worker/eigen_assertion.cpp", "Too few coefficients", "what Eigen's assertion says"},
    {"checker/worker/protocol.hpp", "no padding may travel", "for who changes the frames"},
};

/// One sentence of one file.
struct Speech {
  std::string file;  ///< from the workbook's root
  Literal literal;
};

fs::path root() { return WORKBOOK_ROOT; }

bool is_below(const std::string& file, const std::string& beginning) { return file.starts_with(beginning); }

bool excuses(const Exception& exception, const Speech& speech) {
  return is_below(speech.file, exception.file) && speech.literal.text.starts_with(exception.beginning);
}

/// The C++ files of the checker, from the workbook's root.
std::vector<std::string> sources() {
  std::vector<std::string> files;
  for (const fs::path& file : files_below(root() / "checker")) {
    if (file.extension() == ".cpp" || file.extension() == ".hpp")
      files.push_back(file.lexically_relative(root()).generic_string());
  }
  std::ranges::sort(files);
  return files;
}

std::vector<Speech> speech_outside_messages() {
  std::vector<Speech> found;
  for (const std::string& file : sources()) {
    if (is_below(file, "checker/messages/")) continue;
    for (const Literal& literal : string_literals(read(root() / file))) {
      if (is_speech(literal.text)) found.push_back({file, literal});
    }
  }
  return found;
}

std::string place_of(const std::string& file, const Literal& literal) {
  return file + ":" + std::to_string(literal.line) + ": \"" + literal.text + "\"\n";
}

}  // namespace

TEST_CASE("what people read stands in checker/messages") {
  std::string found;
  for (const Speech& speech : speech_outside_messages()) {
    const auto excused = [&](const Exception& exception) { return excuses(exception, speech); };
    if (std::ranges::any_of(exceptions, excused)) continue;
    found += place_of(speech.file, speech.literal);
  }
  CHECK_MESSAGE(found.empty(),
                ("Move these into checker/messages; if a program reads them, add an exception here:\n" + found));
}

TEST_CASE("every exception is still needed") {
  const std::vector<Speech> all = speech_outside_messages();
  for (const Exception& exception : exceptions) {
    const bool needed = std::ranges::any_of(all, [&](const Speech& speech) { return excuses(exception, speech); });
    CHECK_MESSAGE(needed, ("Take this exception away: " + exception.file + ", \"" + exception.beginning + "\""));
  }
}

TEST_CASE("commands are named as they are typed, never with a name of the program's own") {
  std::string found;
  for (const std::string& file : sources()) {
    for (const Literal& literal : string_literals(read(root() / file))) {
      if (has(literal.text, "`checker ")) found += place_of(file, literal);
    }
  }
  CHECK_MESSAGE(found.empty(), ("Write these with messages::command:\n" + found));
}

TEST_CASE("messages know of data and judging only") {
  const std::regex include("#include \"checker/([a-z]+)/");
  for (const std::string& file : sources()) {
    if (!is_below(file, "checker/messages/")) continue;
    const std::string text = read(root() / file);
    for (std::sregex_iterator found(text.begin(), text.end(), include), end; found != end; ++found) {
      const std::string room = (*found)[1];
      const bool allowed = room == "messages" || room == "data" || room == "judging";
      CHECK_MESSAGE(allowed, (file + " includes a header of checker/" + room));
    }
  }
}

TEST_CASE("literals are found where C++ has them, and nowhere else") {
  const auto texts = [](const std::string& source) {
    std::vector<std::string> found;
    for (const Literal& literal : string_literals(source)) found.push_back(literal.text);
    return found;
  };
  using Texts = std::vector<std::string>;
  CHECK(texts("say(\"one\");  // \"two\"\n/* \"three\"\n */ say(\"four\");") == Texts{"one", "four"});
  CHECK(texts(R"(say("a \" b", '"', "c // d"); n = 1'000; say("e");)") == Texts{R"(a \" b)", "c // d", "e"});
  CHECK(texts("say(R\"x(a \" )\" b)x\", \"c\");") == Texts{"a \" )\" b", "c"});
  CHECK(texts("").empty());
  CHECK(texts("say(\"\");") == Texts{""});
  CHECK(texts("say(\"never closed") == Texts{"never closed"});
  CHECK(string_literals("\n\nsay(\"here\");").front().line == 3);
}

TEST_CASE("two words make speech; options, paths, keys and placeholders do not") {
  for (const char* speech : {"The file is empty.", "Hint {} of {}", "{} is missing", "\\nnot started\\n", "don't stop",
                             "“the case” {}", "one, two", "yours − expected"}) {
    CHECK_MESSAGE(is_speech(speech), speech);
  }
  for (const char* no_speech : {"", "expected", "--seed", "lectures/{}/notes.md", "{} = {}{}", "exercise_name", "[{}]",
                                "I V − V D", "{}: {} {}", "\\r\\n", "a b c"}) {
    CHECK_MESSAGE(!is_speech(no_speech), no_speech);
  }
}
