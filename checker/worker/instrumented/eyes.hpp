/// @file
/// What a witness notices while the student's function runs, and how it tells the checker.
#pragma once

#include "checker/worker/instrumented/sighting.hpp"

namespace workbook {

/// From now on sightings can be sent.
void open_eyes(std::uint64_t nonce);

/// The student's function begins, and has ended.
void watch();
void stop_watching();

void say(sightings::What what, const char* text);

/// The function ended with an exception: the place is the one where it was thrown.
/// @param exception  nullptr if it is not a std::exception
void say_thrown(sightings::What what, const char* text, const void* exception);

/// The compiler's checks found something; only the first is told. @param type  as they name it
void say_undefined(sightings::Undefined what, const char* type, const Facts& facts);

void say_returned(int rows, int cols, const double* numbers);

}  // namespace workbook
