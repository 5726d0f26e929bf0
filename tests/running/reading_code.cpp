// Reading source texts and compilers' messages, without any compiler.
#include "checker/compile/code_text.hpp"
#include "checker/compile/diagnostics.hpp"
#include "checker/compile/eigen_type.hpp"
#include "checker/compile/plain_words.hpp"
#include "checker/compile/tokens.hpp"

#include <doctest/doctest.h>

#include <string>

namespace workbook::testing {

TEST_CASE("comments and texts become spaces, and lines keep their length") {
  CHECK(code_only("a // b\nc") == "a     \nc");
  CHECK(code_only("a /* b\nc */ d") == "a     \n     d");
  CHECK(code_only("f(\"a\\\"b\", 'c')") == "f(\"    \", ' ')");
  CHECK(code_only("R\"x(1/2)\" )x\" + 1") == "R\"          \" + 1");
  CHECK(code_only("1'000'000 + 'a'") == "1'000'000 + ' '");
  CHECK(code_only("// goes on \\\n1/2\n3") == "            \n   \n3");
  CHECK(code_only("\"not closed\n1/2") == "\"          \n1/2");
}

TEST_CASE("signs of two letters are one token, numbers keep their exponents, and the preprocessor is left out") {
  const std::string code = "#define A 1/2\nx+=1.5e-3*v.y::z<<2;";
  std::string joined;
  for (const Token& token : tokens_of(code)) joined += std::string(token.text) + " ";
  CHECK(joined == "x += 1.5e-3 * v . y :: z << 2 ; ");
}

TEST_CASE("a caret stands where a terminal shows the column") {
  CHECK(excerpt("return y;", 8) == "return y;\n       ^");
  CHECK(excerpt("\treturn y;", 16) == "        return y;\n               ^");
  CHECK(excerpt("x", 0) == "x");
  CHECK(excerpt("", 1) == "\n^");
  CHECK(excerpt("x", 100) == "x\n ^");
  CHECK(excerpt("a\x1b[0m", 1) == "a?[0m\n^");
  CHECK(byte_at_column("ä = 角 + y", 10) == 11);
  CHECK(column_of("ä = 角 + y", 11) == 10);
}

TEST_CASE("a long line is cut around its caret") {
  const std::string shown = excerpt(std::string(300, 'a') + "X" + std::string(300, 'b'), 301);
  const std::size_t end = shown.find('\n');
  CHECK(shown.starts_with("…a"));
  CHECK(shown.substr(0, end).ends_with("b…"));
  const std::string line = shown.substr(0, end);
  CHECK(line.substr(byte_at_column(line, static_cast<int>(shown.size() - end - 1)), 1) == "X");
}

TEST_CASE("the shapes of Eigen's types are understood") {
  const auto noun = [](const char* type) { return noun_for(read_type(type)); };
  CHECK(noun("Eigen::Matrix<double, 3, 1>") == "3×1 vector");
  CHECK(noun("const Eigen::Transpose<Eigen::Matrix<double, 3, 1, 0, 3, 1> >") == "1×3 row vector");
  CHECK(noun("Eigen::Product<Eigen::Transpose<Eigen::Matrix<double, 3, 1> >, Eigen::Matrix<double, 3, 3>, 0>") ==
        "1×3 row vector");
  CHECK(noun("Eigen::Product<Eigen::Matrix<double, 3, 1>, Eigen::Matrix<double, 3, 1>, 0>") == "");
  CHECK(noun("Eigen::Matrix<double, -1, -1>") == "matrix");
  CHECK(noun("Eigen::Matrix3Xd") == "3×n matrix");
  CHECK(noun("double") == "number");
  CHECK(noun("std::string") == "");
  CHECK(short_name(read_type("Eigen::Matrix<double, 3, -1>")) == "Matrix3Xd");
  CHECK(short_name(read_type("Eigen::Matrix<int, 3, 1>")) == "");
}

TEST_CASE("what is no type does no harm") {
  for (const char* text : {"", "<", ">", "<>", "A<", "A<>", "A<,>", "A<B>::C<D>", "Matrix<", "Eigen::Matrix<double>",
                           "Eigen::Matrix<double, x, y>"})
    CHECK(noun_for(read_type(text)).empty());
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "A<";
  CHECK(noun_for(read_type(deep + std::string(5000, '>'))).empty());
}

TEST_CASE("messages are told without the noise of templates") {
  CHECK(in_plain_words("'Eigen::Vector3d' {aka 'class Eigen::Matrix<double, 3, 3>'} has no member named 'x'") ==
        "'Vector3d' has no member named 'x'");
  CHECK(in_plain_words("cannot convert 'const Eigen::CwiseUnaryOp<Eigen::internal::scalar_opposite_op<double>, const "
                       "Eigen::Matrix<double, 3, 1> >' to 'double' in return") ==
        "cannot convert 'const 3×1 expression' to 'double' in return");
  CHECK(in_plain_words("in 'T f(T) [with T = Eigen::Matrix<double, 3, 1>; int n = 3]': no") == "in 'T f(T)': no");
  CHECK(
      in_plain_words("no match for 'operator<<' in 'std::map<int, std::vector<std::string, std::allocator<std::string> "
                     "> >'") == "no match for 'operator<<' in 'std::map<int, std::vector<std::string> >'");
  CHECK(in_plain_words("'\\U000003c9' was not declared") == "'ω' was not declared");
  CHECK(in_plain_words("{aka ' [with ") == "{aka '");
}

TEST_CASE("an error in a header has the place of the line that led to it") {
  const auto found = diagnostics(
      "In file included from /somewhere/Core:164,\n                 from <command-line>:\n"
      "/somewhere/Dot.h: In instantiation of 'f() [with T = int]':\n"
      "a.cpp:4:9:   required from 'T g(T)'\na.cpp:8:3:   required from here\n"
      "/somewhere/Dot.h:75:3: error: static assertion failed: NO_WAY\n   75 |   a.cpp:1:1: error: no\n      |   ^~\n"
      "/somewhere/Dot.h:75:3: note: because\n"
      "a.cpp: In function 'h()':\na.cpp:9:1: warning: odd [-Wodd]\na.cpp:10: error: no column\n",
      "a.cpp");
  REQUIRE(found.size() == 3);
  CHECK(found[0].place.line == 4);
  CHECK(found[0].place.column == 9);
  CHECK(found[0].header == "/somewhere/Dot.h");
  CHECK(found[0].text == "static assertion failed: NO_WAY");
  CHECK(found[0].notes == std::vector<std::string>{"because"});
  CHECK(found[1].severity == Severity::warning);
  CHECK(found[1].option == "-Wodd");
  CHECK(found[1].text == "odd");
  CHECK(found[2].place.line == 10);
  CHECK(found[2].place.column == 0);
}

TEST_CASE("an error in a header that the file includes has the place of the #include") {
  const auto found = diagnostics("In file included from a.cpp:2:\n/somewhere/deque:7:1: error: odd\n", "a.cpp");
  REQUIRE(found.size() == 1);
  CHECK(found[0].place.line == 2);
}

}  // namespace workbook::testing
