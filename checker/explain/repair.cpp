#include "checker/explain/repair.hpp"

#include "checker/base/text.hpp"
#include "checker/compile/compile.hpp"
#include "checker/explain/variants.hpp"
#include "checker/judging/comparison.hpp"
#include "checker/sandbox/worker_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>
#include <regex>
#include <set>
#include <utility>

namespace workbook {

namespace {

/// The variants whose lines the compiler objects to.
std::set<int> uncompilable(const VariantUnit& unit, const std::string& compiler_output) {
  static const std::regex place(R"(^variants\.cpp:(\d{1,7}):)");
  std::set<int> objected;
  for (const std::string& line : lines_of(compiler_output)) {
    std::smatch found;
    const std::string head = cut(line, 200);
    if (std::regex_search(head, found, place)) objected.insert(unit.variant_at(std::stoi(found[1])));
  }
  objected.erase(-1);
  return objected;
}

/// All variants that compile, in one executable; those that do not are erased.
std::optional<std::filesystem::path> compile_variants(const DiagnosticTask& task, std::vector<Variant>& variants,
                                                      const Toolchain& toolchain, const std::filesystem::path& cache) {
  constexpr int most_tries = 4;  // the compiler stops at its twentieth error
  CompileLimits limits;
  limits.time = std::chrono::seconds(10);
  for (int tries = 0; tries < most_tries && !variants.empty(); ++tries) {
    const VariantUnit unit(task.submission.text, variants, task.reference);
    const Submission all{"variants.cpp", "variants.cpp", unit.text()};
    const Compilation compilation =
        compile({.submission = all, .exercise = task.reference.name, .signature = task.reference.signature}, toolchain,
                cache, limits);
    if (compilation.executable) return compilation.executable;
    const std::set<int> objected = uncompilable(unit, compilation.details);
    if (objected.empty()) break;
    std::vector<Variant> rest;
    for (std::size_t k = 0; k < variants.size(); ++k)
      if (!objected.contains(static_cast<int>(k))) rest.push_back(std::move(variants[k]));
    variants = std::move(rest);
  }
  return std::nullopt;
}

/// Runs variants in one process as long as they behave.
class VariantRunner {
 public:
  VariantRunner(const DiagnosticTask& task, std::filesystem::path program)
      : reference_(task.reference), program_(std::move(program)), order_(task.reference.cases.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    // What fails today comes first: almost every variant fails there too.
    std::ranges::stable_partition(order_, [&](std::size_t index) {
      return std::ranges::find(task.judgement.failing, index) != task.judgement.failing.end();
    });
  }

  bool is_right(std::size_t variant) {
    // The original took a moment only: what takes long is another one's endless loop.
    budget_ = {std::min(deadline_, Clock::now() + std::chrono::milliseconds(300)), 0.3, std::size_t{1} << 20};
    return std::ranges::all_of(order_, [&](std::size_t index) {
      if (!worker_ || !worker_->running()) worker_ = std::make_unique<Worker>(program_, run_profile(), budget_);
      const Case& one = reference_.cases[index];
      const Reply reply = worker_->call({one.inputs, one.expected.rows, one.expected.cols},
                                        static_cast<std::int32_t>(variant) << protocol::variant_shift);
      return has_usable_value(reply, one) && passes(reference_, index, reply.value);
    });
  }

 private:
  const ExerciseReference& reference_;
  const std::filesystem::path program_;
  std::vector<std::size_t> order_;
  const Clock::time_point deadline_ = Clock::now() + std::chrono::seconds(4);
  Budget budget_;
  std::unique_ptr<Worker> worker_;
};

/// The first that is right at every case.
std::optional<Variant> first_right(const DiagnosticTask& task, std::vector<Variant> variants,
                                   const Toolchain& toolchain, const std::filesystem::path& cache) {
  try {
    const auto program = compile_variants(task, variants, toolchain, cache);
    if (!program) return std::nullopt;
    VariantRunner runner(task, *program);
    for (std::size_t k = 0; k < variants.size(); ++k)
      if (runner.is_right(k)) return variants[k];
  } catch (const std::exception&) {  // it is a help only; what matters has been judged
  }
  return std::nullopt;
}

}  // namespace

std::optional<Finding> decisive_finding(const DiagnosticTask& task, const std::vector<Finding>& findings,
                                        const Toolchain& toolchain, const std::filesystem::path& cache) {
  const SourceText source(task.submission.text);
  const auto right = first_right(task, fixed_variants(source, findings), toolchain, cache);
  if (!right) return std::nullopt;
  const auto found = std::ranges::find_if(findings, [&](const Finding& finding) {
    return finding.name == right->kind && finding.line == right->place.line && finding.column == right->place.column;
  });
  return *found;
}

std::optional<Finding> slip_of_one_token(const DiagnosticTask& task, const Toolchain& toolchain,
                                         const std::filesystem::path& cache) {
  const SourceText source(task.submission.text);
  const auto right = first_right(task, one_token_variants(source, task.reference), toolchain, cache);
  if (!right) return std::nullopt;
  return source.finding(
      right->place, "slip_" + right->kind,
      fmt::format("with {} here, the result is right at all {} cases.", right->words, task.reference.cases.size()));
}

}  // namespace workbook
