/// @file
/// The exercise file as shipped. It follows from the card and the signature, so it can be made anew at any time.
#pragma once

#include <filesystem>
#include <string>

namespace workbook {

/// The text of the stub: the task, the contract's header, the function with its TODO.
/// @param task       the card's line or two
/// @param contract   header without folder and ending, "inertia_tensor"
/// @param signature  "Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r)"
std::string stub_text(const std::string& task, const std::string& contract, const std::string& signature);

/// Has the student begun, as far as can be seen without compiling: the file is there and no longer says "not started".
bool is_begun(const std::filesystem::path& file);

}  // namespace workbook
