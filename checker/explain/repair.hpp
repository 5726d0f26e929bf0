/// @file
/// A wrong value explained by trying: with which small change would the file be right at every case?
#pragma once

#include "checker/compile/toolchain.hpp"
#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/judging/judge.hpp"
#include "checker/source/submission.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace workbook {

/// A file whose values are wrong.
struct WrongFile {
  const Submission& submission;
  const ExerciseReference& reference;
  const Judgement& judgement;
  const Toolchain& toolchain;
  const std::filesystem::path& cache;
};

/// The finding about the code that is the whole reason: with it fixed, all cases are right.
std::optional<Finding> decisive_finding(const WrongFile& file, const std::vector<Finding>& findings);

/// The one token with which all cases are right: its place and its kind, not the answer.
std::optional<Finding> slip_of_one_token(const WrongFile& file);

}  // namespace workbook
