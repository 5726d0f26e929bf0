/// @file
/// What a student's file may use, all in one table. What is read without being run has its limits where it is read:
/// submissions and archives of a class in source/submission.hpp and grading/zip.cpp.
#pragma once

#include <chrono>
#include <cstddef>

namespace workbook::limits {

using Seconds = std::chrono::duration<double>;
inline constexpr std::size_t KiB = std::size_t{1} << 10, MiB = KiB << 10, GiB = MiB << 10;

// A function, at all cases of an exercise together; the time moves on while others have the processors.
inline constexpr Seconds run_time{10}, run_processor_time{5};
inline constexpr std::size_t run_output = 64 * KiB, run_memory = 512 * MiB, run_stack = 8 * MiB;
inline constexpr unsigned run_files = 8;
inline constexpr unsigned run_processes = 16;         // in a control group; bubblewrap's own are among them
inline constexpr std::chrono::milliseconds end{500};  // for a worker to end after its last call
inline constexpr std::chrono::seconds clearing_up{10};  // for bubblewrap after the worker has ended, on a busy machine

// The compiler, for all that it runs: of a processor; on a busy machine it may last five times as long.
inline constexpr Seconds compile_time{60};
inline constexpr int compile_time_on_busy_machines = 5;
inline constexpr std::size_t compile_output = 256 * KiB, compile_memory = 2 * GiB, compile_stack = 64 * MiB;
inline constexpr std::size_t compile_file = 64 * MiB, compile_temporary = 256 * MiB;
inline constexpr unsigned compile_files = 256, compile_processes = 64;

// The run that explains, beside sanitizers; they reserve terabytes of addresses, so it is resident memory that counts.
inline constexpr Seconds diagnostic_compile_time{30}, diagnostic_run_time{8}, diagnostic_run_processor_time{5};
inline constexpr std::size_t diagnostic_output = MiB, diagnostic_memory = GiB;
inline constexpr unsigned diagnostic_files = 32;

// Variants of a file, tried while a student waits; each compilation leaves out what it objected to, up to twenty
// errors.
inline constexpr int trial_compilations = 3;
inline constexpr Seconds trial_compile_time{60}, trial_of_one{0.5}, trial_processor_time{600}, repair_compile_time{3};

// A check: more than the limits up to the verdict together, 300 s to compile and 10 s to run.
inline constexpr std::chrono::seconds check{600};

}  // namespace workbook::limits
