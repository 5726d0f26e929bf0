/// @file
/// Which functions an object file defines and which it needs.
#pragma once

#include "checker/compile/toolchain.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace workbook {

/// A function as the linker sees it.
struct Symbol {
  std::string linker_name;
  std::string signature;  ///< "rigid::kinetic_energy(const Matrix3d&, const Vector3d&)"; the result type is not known

  std::string name() const { return signature.substr(0, signature.find('(')); }  ///< "rigid::kinetic_energy"
};

struct ObjectFile {
  std::vector<Symbol> defined;  ///< in the order of the file; also those visible in the file only
  std::vector<Symbol> undefined;

  bool defines(const std::string& linker_name) const;
};

/// @throws ToolchainError if the symbols cannot be listed
ObjectFile read_object_file(const std::filesystem::path& object, const Toolchain& toolchain);

}  // namespace workbook
