/// @file
/// A closer look at a failure. The student's file is compiled once more, for looking and not for judging, and the
/// failing case runs again, with a witness beside the function. What it finds explains a verdict and never makes one.
#pragma once

#include "checker/compile/toolchain.hpp"
#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/judging/judgement.hpp"

#include <filesystem>
#include <vector>

namespace workbook {

/// A file that was compiled, run and judged.
struct SecondLookTask {
  const std::filesystem::path& file;
  const ExerciseReference& reference;
  const Observation& observation;
  const Judgement& judgement;
};

/// Is there something that a closer look could explain? Not where the diagnosis already names the mistake.
bool deserves_second_look(const Judgement& judgement);

/// What a closer look brings to light; nothing where it fails for whatever reason. Never throws.
/// @param scratch  a folder to work in; nothing is left there
std::vector<Finding> second_look(const SecondLookTask& task, const Toolchain& toolchain,
                                 const std::filesystem::path& scratch);

/// The same with a file that is compiled for looking already.
/// @throws LaunchError, SandboxError, RejectedFile
std::vector<Finding> second_look_with(const std::filesystem::path& witness, const SecondLookTask& task,
                                      const Toolchain& toolchain);

}  // namespace workbook
