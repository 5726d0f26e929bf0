/// @file
/// How students' files are compiled and linked here; written when the workbook is built.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace workbook {

/// The toolchain file or something that it names cannot be used: one sentence. Never the student's fault.
struct ToolchainError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Toolchain {
  std::filesystem::path compiler;
  std::vector<std::string> flags;                          ///< the same as the prelude was precompiled with
  std::filesystem::path prelude;                           ///< included before the first line of a student's file
  std::vector<std::filesystem::path> include_directories;  ///< the only places that a student's file may include from
  std::filesystem::path workers;                           ///< directory of the workers' mains, EXERCISE.o
  std::vector<std::filesystem::path> support;              ///< objects that every worker needs
  std::vector<std::string> link_flags;
  std::filesystem::path nm;
  std::filesystem::path second_look;  ///< the toolchain file for looking at failures; empty: there is none
  std::filesystem::path addr2line;    ///< finds the line of an address; empty: there is none

  std::filesystem::path worker_object(const std::string& exercise) const { return workers / (exercise + ".o"); }
};

/// @throws ToolchainError if the file is missing or damaged
Toolchain read_toolchain(const std::filesystem::path& file);

/// @throws ToolchainError if one of the files that compiling this exercise needs is missing
void require_complete(const Toolchain& toolchain, const std::string& exercise);

}  // namespace workbook
