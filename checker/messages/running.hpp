/// @file
/// What a student reads of the running function: how it ended, and what a second look at a failure brought to light.
///
/// The sentences of the second look follow "Line 8: " and are therefore small at the beginning; at_no_line() makes them
/// stand alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace workbook::messages {

// --- how a call ended

/// Why Eigen stopped, from the condition as Eigen writes it.
std::string eigen_stopped(const std::string& condition);

/// "signal 11 (segmentation fault)", "the stack is used up", …
/// @param text  what the process could still say, may be empty
std::string crash(int signal, const std::string& text);

/// What to do about a crash.
std::string after_crash(int signal, const std::string& text);

/// The text of an exception that cannot say anything.
std::string foreign_exception();

/// The text of a crash whose stack is used up, as crash() and after_crash() know it.
std::string stack_is_used_up();

/// What a forbidden system call is for.
enum class Forbidden { file, process, program, network, signal_others, spy, change_files };

/// "open a file (openat)", to follow "tried to".
std::string system_call(Forbidden operation, const std::string& name);
std::string system_call(const std::string& name);
std::string system_call(long number);
std::string writing_a_file();

// --- what came back from the worker, where it is not the answer of the function

std::string not_a_reply();
std::string reply_to_something_else();
std::string reply_too_early();
std::string reply_of_impossible_shape();
std::string reply_of_unknown_status();
std::string more_than_one_reply();
std::string something_after_last_reply();
std::string line_closed();

// --- the second look

std::string at_no_line(std::string sentence);

/// @param facts  indices and sizes, as second_look/witness/eigen_facts.hpp lists them; may be empty
std::string eigen_assertion(const std::string& condition, const std::vector<long>& facts);

/// A check of the standard library failed. @param sides  of the comparison, index first; may be empty
std::string library_assertion(const std::string& function, const std::string& condition,
                              const std::vector<long>& sides);

std::string own_assertion(const std::string& condition);

/// An exception; `text` may be empty.
std::string thrown(const std::string& text);
std::string nobody_caught(const std::string& text);

/// "100000 · 100000 does not fit into the type int."
std::string whole_number_too_large(long left, const std::string& sign, long right, const std::string& type);
std::string division_by_whole_zero();
std::string shift(long number, long by);
/// @param type  of the array, "'int [3]'"
std::string array_index(long index, const std::string& type);
std::string conversion_to_whole_number();
std::string ends_without_return();

std::string recursion_without_end();
std::string stack_used_up();
std::string null_pointer();
std::string foreign_memory();
std::string damaged_memory();
std::string aborted();
std::string whole_number_division();
std::string trap_instruction();

enum class NonFinite { division_by_zero, zero_by_zero, undefined_division, root, too_large, from_function, other };

/// @param function  of the C library that was at work, for NonFinite::from_function; "" if unknown
std::string non_finite(NonFinite reason, const std::string& function = "");

/// Is there a sentence on what this function of the C library cannot compute?
bool has_domain(const std::string& function);

std::string never_set_here();
std::string never_set();
/// @param entries  names such as "component 2"
std::string entries_never_set(const std::vector<std::string>& entries, std::size_t of);

std::string still_at_work();
std::string still_at_work_between(int first_line, int last_line);
std::string still_printing();
std::string out_of_memory();
std::string forbidden(const std::string& operation);
std::string program_ended();

}  // namespace workbook::messages
