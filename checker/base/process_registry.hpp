/// @file
/// The programs that the checker has running, so that none of them outlives a checker that is told to end. The kernel
/// ends a program with its parent, but not the children of that program: a compiler's driver has some.
#pragma once

#include <sys/types.h>

namespace workbook::process_registry {

/// Remembers a program that leads its own process group.
void add(pid_t leader) noexcept;

/// Forgets it. To be called before it is waited for: afterwards its number may name another.
void remove(pid_t leader) noexcept;

/// From now on SIGINT, SIGTERM, SIGHUP and SIGQUIT end the programs first and then the checker, in the usual way.
/// A signal that is ignored stays ignored.
void end_with_the_checker();

}  // namespace workbook::process_registry
