// Templates of Eigen's decompositions, instantiated once: each takes the compiler seconds in every file that uses it.
#include "checker/base/text.hpp"
#include "checker/compile/toolchain.hpp"

#include <fmt/format.h>

#include <set>

namespace workbook {

namespace fs = std::filesystem;

namespace {

#define SOLVE(decomposition) \
  "template void Eigen::" decomposition "<{M}>::_solve_impl<{V}, {V}>(const {V}&, {V}&) const;\n"
#define COMPUTE(decomposition, options)                           \
  "template Eigen::" decomposition "<{M}>& Eigen::" decomposition \
  "<{M}>::compute<{M}>(const Eigen::EigenBase<{M}>&" options ");\n"

/// Where a file holds the word, it needs these templates for its types of matrices.
constexpr struct {
  const char* word;
  const char* templates;
} decompositions[] = {
    {"EigenSolver",
     "template class Eigen::RealSchur<{M}>;\n"
     "template class Eigen::HessenbergDecomposition<{M}>;\n"
     "template class Eigen::EigenSolver<{M}>;\n" COMPUTE("EigenSolver", ", bool")},
    {"SelfAdjointEigenSolver",
     "template class Eigen::SelfAdjointEigenSolver<{M}>;\n" COMPUTE("SelfAdjointEigenSolver", ", int")},
    {"(?:setF|F)romTwoVectors", "template class Eigen::JacobiSVD<Eigen::Matrix<double, 2, 3>>;\n"},
    {"JacobiSVD|jacobiSvd", "template class Eigen::JacobiSVD<{M}>;\n"},
    {"PartialPivLU|partialPivLu|lu", "template class Eigen::PartialPivLU<{M}>;\n" SOLVE("PartialPivLU")},
    {"FullPivLU|fullPivLu", "template class Eigen::FullPivLU<{M}>;\n" SOLVE("FullPivLU")},
    {"ColPivHouseholderQR|colPivHouseholderQr",
     "template class Eigen::ColPivHouseholderQR<{M}>;\n" SOLVE("ColPivHouseholderQR")},
    {"HouseholderQR|householderQr", "template class Eigen::HouseholderQR<{M}>;\n" SOLVE("HouseholderQR")},
    {"LDLT|ldlt", "template class Eigen::LDLT<{M}>;\n" COMPUTE("LDLT", "") SOLVE("LDLT")},
    {"LLT|llt", "template class Eigen::LLT<{M}>;\n" COMPUTE("LLT", "") SOLVE("LLT")},
};

#undef SOLVE
#undef COMPUTE

}  // namespace

std::vector<Instantiation> instantiations(const Toolchain& toolchain, std::string_view source) {
  std::set<std::string> sizes;  // square ones, of doubles
  for (const Match& type : search_all(source, R"(\bMatrix(?:([234X])d\b|\s*<\s*double\s*,\s*([56])\s*,\s*\2\s*>))"))
    sizes.insert(type[1] == "X" ? "Eigen::Dynamic" : type[1] + type[2]);
  std::set<std::string> templates;
  for (const auto& each : decompositions)
    if (search(source, fmt::format(R"(\b(?:{})\b)", each.word)))
      for (const std::string& size : sizes)
        templates.insert(fmt::format(fmt::runtime(each.templates),
                                     fmt::arg("M", fmt::format("Eigen::Matrix<double, {0}, {0}>", size)),
                                     fmt::arg("V", fmt::format("Eigen::Matrix<double, {}, 1>", size))));
  std::vector<Instantiation> all;
  for (const std::string& each : templates) {
    const fs::path object = toolchain.directory / fmt::format("instantiated_{}.o", fingerprint(each));
    if (make_object(toolchain, object, each).empty())
      all.push_back({replaced(each, "\\btemplate\\b", "extern template"), object});
  }
  return all;
}

}  // namespace workbook
