/// @file
/// What the commands on demand take; program/on_demand_commands.cpp says what each means.
#pragma once

#include "checker/commands/commands.hpp"

namespace workbook {

struct ReportOptions : Chosen {
  fs::path html;
  std::string student;
};

struct FiguresOptions {
  std::string lecture;
  std::optional<fs::path> out;
  double seconds = 60.0;
};

struct TryOptions {
  std::optional<fs::path> file;  ///< with a case: the name of an exercise
  std::optional<std::string> case_name;
};

struct DebugOptions {
  std::string name;
  std::optional<std::string> case_name;
  bool build_only = false;
};

struct HandoutOptions {
  std::optional<fs::path> out, assignment;
  bool update = false;
  std::string message;
  std::optional<std::uint64_t> seed;
};

struct GradeOptions {
  fs::path submissions;
  std::optional<fs::path> out, roster, assignment, overrides, copy;
  std::optional<std::uint64_t> seed;
  std::string attempts, only, shard;
  std::vector<fs::path> references, merged;
  bool who = false, with_missing = false, allow_reduced = false;
  double explain_minutes = 10.0;
};

struct ExportOptions {
  std::string system;
  std::optional<fs::path> out, assignment;
  std::optional<std::uint64_t> seed;
  std::string image = "rigid-body-workbook";
};

struct SelfCheckOptions {
  std::vector<std::string> names;
  int seeds = 3;
  bool quick = false, prove = false, record = false;
};

struct NewOptions {
  std::string name, lecture, signature;
};

// Of these the program checker has only a way to the program that has them all.
int report(const Course& course, const ReportOptions& options);
int figures(const Course& course, const FiguresOptions& options);
int live(const Course& course, const std::string& lecture);
int examples(const Course& course, const std::string& lecture);
int try_out(const Course& course, const TryOptions& options);
int debug(const Course& course, const DebugOptions& options);
int handout(const Course& course, const HandoutOptions& options);
int grade(const Course& course, const GradeOptions& options);
int export_recipe(const Course& course, const ExportOptions& options);
int self_check(const Course& course, const SelfCheckOptions& options);
int new_lecture(const Course& course, const NewOptions& options);
int new_exercise(const Course& course, const NewOptions& options);

}  // namespace workbook
