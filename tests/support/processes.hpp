/// @file
/// The processes that a test has started.
#pragma once

namespace workbook::testing {

/// True if no process that the test started, nor any child of it, still exists.
bool nothing_left_running();

}  // namespace workbook::testing
