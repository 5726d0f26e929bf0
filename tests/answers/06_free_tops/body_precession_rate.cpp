//! wrong: sign
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I1, double I3, double omega3) { return omega3 * (I1 - I3) / I1; }
}  // namespace rigid

//! wrong: divided by the other moment
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I1, double I3, double omega3) { return omega3 * (I3 - I1) / I3; }
}  // namespace rigid

//! wrong: size only
#include <cmath>
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I1, double I3, double omega3) { return std::abs(omega3 * (I3 - I1) / I1); }
}  // namespace rigid

//! wrong: the spin is forgotten
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I1, double I3, double omega3) { return (I3 - I1) / I1; }
}  // namespace rigid

//! wrong: the inverse, as in the period of the wobble
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I1, double I3, double omega3) { return omega3 * I1 / (I3 - I1); }
}  // namespace rigid

//! wrong: moments exchanged in the list
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I3, double I1, double omega3) { return omega3 * (I3 - I1) / I1; }
}  // namespace rigid

//! wrong: whole numbers
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I1, double I3, double omega3) {
  const int difference = I3 - I1;
  return omega3 * difference / I1;
}
}  // namespace rigid

//! wrong: a sphere turns with its spin
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I1, double I3, double omega3) {
  if (I1 == I3) return omega3;
  return omega3 * (I3 - I1) / I1;
}
}  // namespace rigid

//! right: quotient first
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I1, double I3, double omega3) { return (I3 - I1) / I1 * omega3; }
}  // namespace rigid

//! right: difference of two angular momenta
#include <rigid/free_tops.hpp>
namespace rigid {
double body_precession_rate(double I1, double I3, double omega3) {
  const double L = I3 * omega3;
  return (L - I1 * omega3) / I1;
}
}  // namespace rigid
