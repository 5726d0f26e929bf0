// Reading source texts and compilers' messages, without any compiler.
#include "checker/base/text.hpp"
#include "checker/compile/diagnostics.hpp"
#include "checker/source/source_text.hpp"

#include <doctest/doctest.h>

#include <ctime>
#include <string>

namespace workbook::testing {
namespace {

std::string code_of(const std::string& text) {
  const SourceText source(text);
  std::string code;
  for (int line = 1; line <= 3; ++line) code += source.marked_code({line, 1}).substr(1) + "|";
  return code;
}

CompilerOutput read_output(const std::string& output) {
  return read_compiler_output(output, "a.cpp", [](const std::string& file) { return file.starts_with("/allowed/"); });
}

}  // namespace

TEST_CASE("comments and texts become spaces, and lines keep their length") {
  CHECK(code_of("a // b\nc") == "a     |c||");
  CHECK(code_of("a /* b\nc */ d") == "a     |     d||");
  CHECK(code_of("f(\"ab\", 'c')") == "f(\"  \", ' ')|||");
  CHECK(code_of("R\"x(1/2)\" )x\" + 1") == " \"      \"   \" + 1|||");
  CHECK(code_of("1'000'000 + 'a'") == "1'000'000 + ' '|||");
  CHECK(code_of("// goes on \\\n1/2\n3") == "            |   |3|");
  CHECK(code_of("\"not closed\n1/2") == "\"          |1/2||");
}

TEST_CASE("a function is found where it is defined, in a text of any length") {
  const auto defines = [](const std::string& text) { return defines_function(SourceText(text), "twice"); };
  for (const char* text : {"double twice(double x) {", "double rigid::twice((a)(b)) noexcept {", "int& twice() {"})
    CHECK(defines(text));
  for (const char* text : {"y = twice(x) {", "double twice(double x);", "double twice(x {", "twice() {", "int twice"})
    CHECK_FALSE(defines(text));
  std::string hostile;
  while (hostile.size() < std::size_t{1} << 20) hostile += "a twice(";
  const std::clock_t begun = std::clock();
  CHECK_FALSE(defines(hostile));
  CHECK(std::clock() - begun < 2 * CLOCKS_PER_SEC);
}

TEST_CASE("an operator is one token, numbers keep their exponents, and lines of the preprocessor are marked") {
  const std::string code = "#define A \\\n 1/2\nx+=1.5e-3*v.y::z<<2;";
  std::string joined;
  const SourceText source(code);
  for (const Token& token : source.tokens()) joined += std::string(token.text) + (token.in_directive ? "# " : " ");
  CHECK(joined == "## define# A# 1# /# 2# x += 1.5e-3 * v . y :: z << 2 ; ");
}

TEST_CASE("a caret stands where a terminal shows the column") {
  CHECK(excerpt("return y;", 8) == "return y;\n       ^");
  CHECK(excerpt("\treturn y;", 9) == " return y;\n        ^");
  CHECK(excerpt("x", 0) == "x");
  CHECK(excerpt("", 1) == "\n^");
  CHECK(excerpt("x", 100) == "x\n ^");
  CHECK(SourceText("x").reason({999999999, 1}, "", "a line that is not there").line == 0);
  CHECK(excerpt("a\x1b[0m", 1) == "a?[0m\n^");
  CHECK(excerpt("/* ä ω */ y;", 13) == "/* ä ω */ y;\n" + std::string(10, ' ') + "^");
  const std::string shown = excerpt(std::string(300, 'a') + "X" + std::string(300, 'b'), 301);
  CHECK(shown.starts_with("…" + std::string(48, 'a') + "X" + std::string(20, 'b')));
  CHECK(shown.ends_with("b…\n" + std::string(49, ' ') + "^"));
}

TEST_CASE("messages are told without the noise of templates") {
  const std::pair<const char*, const char*> cases[] = {
      {"'Eigen::Vector3d' {aka 'class Eigen::Matrix<double, 3, 3>'} has no member", "'Matrix3d' has no member"},
      {"convert 'const Eigen::CwiseUnaryOp<Eigen::internal::scalar_opposite_op<double>, const Eigen::Matrix<double, 3, "
       "1> >' to",
       "convert 'const 3×1 vector' to"},
      {"in 'T f(T) [with T = Eigen::Matrix<double, 3, 1>; int n = 3]': no", "in 'T f(T)': no"},
      {"'operator<<' in 'std::map<int, std::vector<std::string, std::allocator<std::string> > >'",
       "'operator<<' in 'std::map<int, std::vector<std::string>>'"},
      {"f(std::vector<Eigen::Matrix<double, 3, 3, 0, 3, 3>, std::allocator<Eigen::Matrix<double, 3, 3, 0, 3, 3> > > "
       "const&, Eigen::Matrix<double, 3, -1, 0, 3, -1> const&)",
       "f(const std::vector<Matrix3d>&, const Matrix3Xd&)"},
      {"const Eigen::Transpose<Eigen::Matrix<double, 3, 1, 0, 3, 1> >", "const 1×3 row vector"},
      {"Eigen::Product<Eigen::Transpose<Eigen::Matrix<double, 3, 1> >, Eigen::Matrix<double, 3, 3>, 0>",
       "1×3 row vector"},
      {"Eigen::Product<Eigen::Matrix<double, 3, 1>, Eigen::Matrix<double, 3, 1>, 0>", "Product<Vector3d, Vector3d, 0>"},
      {"Eigen::Matrix<double, -1, -1>", "MatrixXd"},
      {"Eigen::Matrix<int, 3, 1>", "Vector3i"},
      {"Eigen::DenseBase<Eigen::Matrix<double, 3, 1> >::Scalar", "DenseBase<…>::Scalar"},
      {"{aka ' [with ", "{aka ' [with "},
      {"A<B>::C<D>", "A<…>::C<D>"},
      {"A< <> A<,> Matrix< Eigen::Matrix<double>", "A< <> A<,> Matrix< Matrix<double>"}};
  for (const auto& [said, plain] : cases) CHECK(in_plain_words(said) == plain);
}

TEST_CASE("an error in a header has the place of the line that led to it") {
  const CompilerOutput output = read_output(
      "In file included from /allowed/Core:164,\n                 from <command-line>:\n"
      "/allowed/Dot.h: In instantiation of 'f() [with T = int]':\n"
      "unit.cpp:4:9:   required from 'T g(T)'\nunit.cpp:8:3:   required from here\n"
      "/allowed/Dot.h:75:3: error: static assertion failed: NO_WAY\n   75 |   unit.cpp:1:1: error: no\n      |   ^~\n"
      "/allowed/Dot.h:75:3: note: because\n"
      "unit.cpp: In function 'h()':\nunit.cpp:9:1: warning: odd [-Wodd]\n    9 | odd\nunit.cpp:10: error: no column\n"
      "In file included from unit.cpp:2:\n/allowed/deque:7:1: error: odd\n"
      // As clang says it.
      "/allowed/Dot.h:5:1: error: other\nunit.cpp:12:7: note: in instantiation of 'g' requested here\n");
  const std::vector<Diagnostic>& found = output.diagnostics;
  REQUIRE(found.size() == 5);
  CHECK(found[0].place.line == 4);
  CHECK(found[0].place.column == 9);
  CHECK(found[0].header == "/allowed/Dot.h");
  CHECK(found[0].text == "static assertion failed: NO_WAY");
  CHECK(found[0].context == "T = int]':\n");
  CHECK(found[0].notes == "because\n");
  CHECK_FALSE(found[1].is_error);
  CHECK(found[1].option == "-Wodd");
  CHECK(found[1].text == "odd");
  CHECK(found[2].place.line == 10);
  CHECK(found[2].place.column == 0);
  CHECK(found[3].place.line == 2);
  CHECK(found[4].place.line == 12);
  CHECK(output.foreign_file.empty());
  CHECK(output.shown.find("a.cpp:10: error: no column\n") != std::string::npos);
  CHECK(output.shown.find("odd [-Wodd]") == std::string::npos);
  CHECK(output.shown.find("unit.cpp: In") == std::string::npos);
}

TEST_CASE("of a file that may not be included nothing is shown") {
  const CompilerOutput output = read_output(
      "In file included from unit.cpp:1:\n/etc/secret:1:1: error: 'word' does not name a type\n    1 | word:x:0\n"
      "      | ^~~~\n/etc/secret: In function 'word':\nunit.cpp:3:1: error: mine\n    3 | mine\n"
      "/etc/secret:2: Error: no such instruction: `word'\n/etc/secret:3:1: note: word\n");
  CHECK(output.foreign_file == "/etc/secret");
  CHECK(output.shown == "a.cpp:3:1: error: mine\n    3 | mine\n");
  REQUIRE(output.diagnostics.size() == 1);
  CHECK(output.diagnostics[0].notes.empty());
}

TEST_CASE("hostile texts do not hang the checker" * doctest::test_suite("thorough")) {
  constexpr double most_seconds = 20;  // for milliseconds; a scan in quadratic time would take hours
  const auto repeated = [](const std::string& text, std::size_t bytes) {
    std::string all;
    while (all.size() < bytes) all += text;
    return all;
  };
  constexpr std::size_t mebibyte = std::size_t{1} << 20;
  std::vector<std::string> sources = {"",     "\n", "/*",   "\"", "'",  "R\"(", "R\"x",
                                      "auto", "1/", "sin(", "#",  "\\", "\xff"};
  for (const char* text : {"Matrix3d a; ", "1'", "(", "}", "{", "sin(", "1/2;", "float ", "/*", "'", "R\"(", "//\\\n",
                           "x^2;", "a . transpose (", "\t", "\xe8\xa7\x92", "\n"})
    sources.push_back(repeated(text, mebibyte));
  for (const std::string& text : sources) {
    CAPTURE(text.substr(0, 20));
    const std::clock_t start = std::clock();
    const SourceText source(text);
    (void)text_mistakes(source);
    std::vector<Diagnostic> warnings(
        1000, {false, source.place_of(text.size() / 2), "", "unused variable 'x'", "-Wunused", "", ""});
    CHECK(warned_mistakes(warnings, source).size() <= 100);
    CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < most_seconds);
  }
  for (const char* text :
       {"A<", "(", "[with ", "{aka '", "'", "a.h:1:1: error: A<", "unit.cpp:1:1:   required from A<"}) {
    CAPTURE(text);
    const std::clock_t start = std::clock();
    const std::string line = repeated(text, 256 << 10);
    (void)in_plain_words("unit.cpp:1:1: error: " + line);
    const CompilerOutput output =
        read_output("unit.cpp:1:1: error: " + line + "\n" + repeated(text + std::string("\n"), 256 << 10));
    (void)first_error(output.diagnostics, SourceText("int x;"), "");
    CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < most_seconds);
  }
}

}  // namespace workbook::testing
