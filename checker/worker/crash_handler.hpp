/// @file
/// What a worker still says when a signal ends it: which system call was forbidden, that the stack is used up, what was
/// thrown where nobody could catch it. The checker uses it as an explanation only; what ended the process it sees
/// itself.
#pragma once

namespace workbook {

/// The handlers install themselves before any static object of the student is made; calling this is enough to have
/// them.
void keep_crash_handler_linked();

}  // namespace workbook
