/// @file
/// How students' files are compiled and linked here. CMake writes it; its parts are made when they are needed.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace workbook {

/// The toolchain file or something that it names cannot be used: one sentence. Never the student's fault.
struct ToolchainError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The names are the keys of toolchain.json.
struct Toolchain {
  std::filesystem::path compiler;
  std::vector<std::string> flags;                          ///< the same as the prelude was precompiled with
  std::filesystem::path prelude;                           ///< included before the first line of a student's file
  std::vector<std::filesystem::path> include_directories;  ///< the only places that a student's file may include from
  std::filesystem::path directory;                         ///< of all that is made
  std::vector<std::filesystem::path> support;              ///< objects that every worker needs; streams.o only some
  std::vector<std::string> link_flags;
  std::filesystem::path nm;
  std::filesystem::path diagnostic;    ///< the toolchain file for the diagnostic run; empty: there is none
  std::filesystem::path main_header;   ///< declares main_function, which a worker's main calls with the exercise
  std::string main_function;           ///< in namespace workbook
  std::filesystem::path main_include;  ///< where main_header includes from
  std::filesystem::path setup;         ///< checker/setup.sh, which makes the target in the build
  std::filesystem::path build;
  std::string target;
  std::filesystem::path sources;  ///< of the prelude: read where the compiler cannot use the precompiled one

  std::filesystem::path precompiled() const { return prelude.string() + ".gch"; }
  std::filesystem::path worker_object(const std::string& exercise) const {
    return directory / (exercise + ".worker.o");
  }
};

/// @throws ToolchainError if the file is missing or damaged
Toolchain read_toolchain(const std::filesystem::path& file);

/// Compiles a text of our own as students' files are, unless the object is there and not older than what all workers
/// share. Returns what is in the way; "" if nothing.
std::string make_object(const Toolchain& toolchain, const std::filesystem::path& object, const std::string& text);

/// Templates in an object of their own.
struct Instantiation {
  std::string declarations;
  std::filesystem::path object;
};

/// Of Eigen's decompositions, those that a file needs; the objects are made where they are not there. One that cannot
/// be made is left out, and what the file needs of it is compiled with the file.
std::vector<Instantiation> instantiations(const Toolchain& toolchain, std::string_view source);

/// Makes what compiling this exercise needs and is not there yet: the prelude, what all workers share, its worker's
/// main.
/// @throws ToolchainError if something is missing and cannot be made
void require_complete(const Toolchain& toolchain, const std::string& exercise);

}  // namespace workbook
