#include "lectures/support/result.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>

namespace workbook {

namespace {

/// "energy" of the running test case "energy: The tensor gives …".
std::string example() {
  const std::string title = doctest::getContextOptions()->currentTest->m_name;
  return title.substr(0, title.find(':'));
}

/// All that the program prints; written when it ends.
class Pages {
 public:
  ~Pages() {
    const char* file = std::getenv("WORKBOOK_PRINTED");
    if (file == nullptr) return;
    std::ofstream out(file, std::ios::app);
    // Doxygen knows no formulas in a quoted part: they are written as HTML.
    for (const auto& [name, text] : shown_)
      out << fmt::format("[{0}]\n<div class=\"result\">\\htmlonly\n{1}\\endhtmlonly</div>\n[{0}]\n\n", name, text);
    out << values_;
  }

  void add(const std::string& html, const std::string& name, const Eigen::MatrixXd& value) {
    shown_[example()] += html;
    values_ += fmt::format("value\t{}\t{}", example(), name);
    for (const double number : value.reshaped<Eigen::RowMajor>()) values_ += fmt::format("\t{:.17g}", number);
    values_ += '\n';
  }

 private:
  std::map<std::string, std::string> shown_;
  std::string values_;
};

Pages& pages() {
  static Pages the_pages;
  return the_pages;
}

/// A number in TeX. A rounded zero is printed as 0, never as −0 or 1e-17.
std::string in_tex(double number, double size, int digits) {
  if (!std::isfinite(number)) throw std::domain_error("a result must be finite");
  if (std::abs(number) <= 1e-15 * size) return "0";
  // 1234 is easier to read than 1.23·10³.
  if (std::abs(number) >= 1000 && std::abs(number) < 1e5) digits = std::max(digits, std::abs(number) < 1e4 ? 4 : 5);
  std::string text = fmt::format("{:.{}g}", number, digits);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  const std::string mantissa = text.substr(0, exponent);
  return fmt::format("{}10^{{{}}}",
                     mantissa == "1"    ? ""
                     : mantissa == "-1" ? "-"
                                        : mantissa + R"(\cdot )",
                     std::stoi(text.substr(exponent + 1)));
}

std::string in_tex(const Eigen::MatrixXd& value, int digits) {
  const double size = value.size() > 0 ? value.cwiseAbs().maxCoeff() : 0.0;
  const bool is_vector = value.cols() == 1;
  std::string text;
  for (Eigen::Index i = 0; i < value.rows(); ++i) {
    for (Eigen::Index j = 0; j < value.cols(); ++j) {
      if (i + j > 0) text += is_vector ? R"(,\ )" : j == 0 ? R"(\\)" : "&";
      text += in_tex(value(i, j), size, digits);
    }
  }
  if (value.size() == 1) return text;
  return is_vector ? "(" + text + ")" : R"(\begin{pmatrix})" + text + R"(\end{pmatrix})";
}

}  // namespace

void result(const std::string& name, double value, const std::string& unit, const std::string& remark, int digits) {
  result(name, Eigen::MatrixXd::Constant(1, 1, value), unit, remark, digits);
}

void result(const std::string& name, const Eigen::MatrixXd& value, const std::string& unit, const std::string& remark,
            int digits) {
  const std::string shown_unit = unit.empty() || unit == "°" ? unit : "&nbsp;" + unit;
  pages().add(fmt::format("<p>\\({} = {}\\){}{}.</p>\n", name, in_tex(value, digits), shown_unit,
                          remark.empty() ? "" : ", " + remark),
              name, value);
}

void result_table(const std::vector<std::string>& heads, const Eigen::MatrixXd& values, int digits) {
  if (static_cast<std::size_t>(values.cols()) != heads.size())
    throw std::invalid_argument("a table of results needs a head for each of its columns");
  std::string html = fmt::format("<table><tr><th>{}</th></tr>\n", fmt::join(heads, "</th><th>"));
  for (const auto& row : values.rowwise()) {
    html += "<tr>";
    for (const double number : row) html += fmt::format("<td>\\({}\\)</td>", in_tex(number, 0.0, digits));
    html += "</tr>\n";
  }
  pages().add(html + "</table>\n", "table", values);
}

}  // namespace workbook
