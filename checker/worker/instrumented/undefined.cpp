// The functions that GCC and Clang call where -fsanitize=undefined finds something. The compilers' own library would
// look at files before it says anything, which the sandbox forbids; and here it is enough to know what and where.
#include "checker/worker/instrumented/eyes.hpp"

#include <stdlib.h>

#include <cstdint>

namespace {

using workbook::sightings::Undefined;

/// How the compilers lay out what they pass.
struct SourceLocation {
  const char* file;
  std::uint32_t line;
  std::uint32_t column;
};

struct TypeDescriptor {
  std::uint16_t kind;  ///< 0: whole number
  std::uint16_t info;  ///< whole number: bit 0 is set if it is signed; the others are the logarithm of its bits
  char name[1];        ///< "'int [3]'"

  /// Of a number of at most 64 bits, which travels in the pointer itself.
  long number(void* handle) const {
    const auto bits = reinterpret_cast<std::uintptr_t>(handle);
    const unsigned width = 1u << (info >> 1);
    if (kind != 0 || width >= 64) return static_cast<long>(bits);
    const unsigned unused = 64 - width;
    const bool is_signed = (info & 1) != 0;
    return is_signed ? static_cast<long>(bits << unused) >> unused : static_cast<long>(bits << unused >> unused);
  }
};

struct Overflow {
  SourceLocation place;
  const TypeDescriptor* type;
};

struct Shift {
  SourceLocation place;
  const TypeDescriptor* left;
  const TypeDescriptor* right;
};

struct OutOfBounds {
  SourceLocation place;
  const TypeDescriptor* array;
  const TypeDescriptor* index;
};

void say_of_two(Undefined what, const Overflow* overflow, void* left, void* right) {
  const TypeDescriptor& type = *overflow->type;
  workbook::say_undefined(what, type.name, workbook::facts(type.number(left), type.number(right)));
}

}  // namespace

extern "C" {

void __ubsan_handle_add_overflow(const Overflow* overflow, void* left, void* right);
void __ubsan_handle_sub_overflow(const Overflow* overflow, void* left, void* right);
void __ubsan_handle_mul_overflow(const Overflow* overflow, void* left, void* right);
void __ubsan_handle_divrem_overflow(const Overflow* overflow, void* left, void* right);
void __ubsan_handle_negate_overflow(const Overflow* overflow, void* number);
void __ubsan_handle_shift_out_of_bounds(const Shift* shift, void* left, void* right);
void __ubsan_handle_out_of_bounds(const OutOfBounds* access, void* index);
void __ubsan_handle_float_cast_overflow(const void* conversion, void* number);
void __ubsan_handle_missing_return(const void* place);
void __ubsan_handle_builtin_unreachable(const void* place);

void __ubsan_handle_add_overflow(const Overflow* overflow, void* left, void* right) {
  say_of_two(Undefined::sum, overflow, left, right);
}

void __ubsan_handle_sub_overflow(const Overflow* overflow, void* left, void* right) {
  say_of_two(Undefined::difference, overflow, left, right);
}

void __ubsan_handle_mul_overflow(const Overflow* overflow, void* left, void* right) {
  say_of_two(Undefined::product, overflow, left, right);
}

void __ubsan_handle_divrem_overflow(const Overflow* overflow, void* left, void* right) {
  say_of_two(Undefined::quotient, overflow, left, right);
}

void __ubsan_handle_negate_overflow(const Overflow* overflow, void* number) {
  workbook::say_undefined(Undefined::negative, overflow->type->name, workbook::facts(overflow->type->number(number)));
}

void __ubsan_handle_shift_out_of_bounds(const Shift* shift, void* left, void* right) {
  workbook::say_undefined(Undefined::shift, shift->left->name,
                          workbook::facts(shift->left->number(left), shift->right->number(right)));
}

void __ubsan_handle_out_of_bounds(const OutOfBounds* access, void* index) {
  workbook::say_undefined(Undefined::index, access->array->name, workbook::facts(access->index->number(index)));
}

void __ubsan_handle_float_cast_overflow(const void*, void*) {
  workbook::say_undefined(Undefined::conversion, "", workbook::facts());
}

// The code behind these two must not be reached.
void __ubsan_handle_missing_return(const void*) {
  workbook::say_undefined(Undefined::missing_return, "", workbook::facts());
  workbook::stop_watching();
  ::_Exit(1);
}

void __ubsan_handle_builtin_unreachable(const void*) { ::abort(); }
}
