/// @file
/// Has the stack been used up? For signal handlers: no allocation, no locks.
#pragma once

#include <signal.h>
#include <sys/resource.h>
#include <ucontext.h>

#include <cstdint>

namespace workbook {

class Stack {
 public:
  /// To be called near the beginning of the program, where the stack is still short.
  void measure() {
    begin_ = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    rlimit limit{};
    ::getrlimit(RLIMIT_STACK, &limit);
    size_ = static_cast<std::uintptr_t>(limit.rlim_cur);
  }

  /// For a handler of SIGSEGV: was it a stack that grew too far?
  bool overflowed(const siginfo_t& info, const void* context) const {
    return is_beyond(reinterpret_cast<std::uintptr_t>(info.si_addr), largest_step) ||
           is_beyond(pointer_in(*static_cast<const ucontext_t*>(context)), begin_);
  }

 private:
  static constexpr std::uintptr_t margin = std::uintptr_t{256} * 1024;
  static constexpr std::uintptr_t largest_step = std::uintptr_t{16} * 1024 * 1024;

  /// Near the lower end of the stack or, by at most `reach`, below it.
  bool is_beyond(std::uintptr_t address, std::uintptr_t reach) const {
    const std::uintptr_t depth = begin_ - address;
    return address != 0 && address < begin_ && depth + margin > size_ && (depth < size_ || depth - size_ < reach);
  }

  /// The stack pointer of the interrupted code: beyond the end even before an array as large as that is touched there.
  static std::uintptr_t pointer_in([[maybe_unused]] const ucontext_t& context) {
#if defined(__x86_64__)
    return static_cast<std::uintptr_t>(context.uc_mcontext.gregs[REG_RSP]);
#elif defined(__aarch64__)
    return static_cast<std::uintptr_t>(context.uc_mcontext.sp);
#else
    return 0;
#endif
  }

  std::uintptr_t begin_ = 0;
  std::uintptr_t size_ = 0;
};

}  // namespace workbook
