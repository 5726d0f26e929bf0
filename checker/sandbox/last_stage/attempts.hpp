/// @file
/// What checker/sandbox/last_stage/last_stage.cpp tries to find out how strong its sandbox is.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <unistd.h>

namespace workbook {

struct Attempt {
  const char* what;
  bool (*succeeds)();
  bool is_for_compilers = true;  ///< false: they are allowed to, or reach nothing by it but what they started
};

inline constexpr Attempt attempts[] = {
    {"read a file", [] { return ::open("/etc/passwd", O_RDONLY | O_CLOEXEC) >= 0; }},
    {"write a file", [] { return ::open(".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600) >= 0; }},
    {"open a connection", [] { return ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0) >= 0; }},
    {"trace another process", [] { return ::ptrace(PTRACE_SEIZE, ::getppid(), nullptr, nullptr) == 0; }},
    {"signal another process", [] { return ::kill(::getppid(), 0) == 0; }, false},
    {"start a process",
     [] {
       const pid_t started = ::fork();
       if (started == 0) ::_exit(0);
       return started > 0;
     },
     false}};

}  // namespace workbook
