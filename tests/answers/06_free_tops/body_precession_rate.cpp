#include <cmath>
#include <rigid/free_tops.hpp>
double body_precession_rate(double I1, double I3, double omega3) {
//! right: quotient first
double body_precession_rate(double I1, double I3, double omega3) { return (I3 - I1) / I1 * omega3; }
//! right: difference of two angular momenta
  const double L = I3 * omega3;
  return (L - I1 * omega3) / I1;
//! wrong: sign
double body_precession_rate(double I1, double I3, double omega3) { return omega3 * (I1 - I3) / I1; }
//! wrong: divided by the other moment
double body_precession_rate(double I1, double I3, double omega3) { return omega3 * (I3 - I1) / I3; }
//! wrong: size only
double body_precession_rate(double I1, double I3, double omega3) { return std::abs(omega3 * (I3 - I1) / I1); }
//! wrong: the spin is forgotten
double body_precession_rate(double I1, double I3, double omega3) { return (I3 - I1) / I1; }
//! wrong: the inverse, as in the period of the wobble
double body_precession_rate(double I1, double I3, double omega3) { return omega3 * I1 / (I3 - I1); }
//! wrong: moments exchanged in the list
double body_precession_rate(double I3, double I1, double omega3) { return omega3 * (I3 - I1) / I1; }
//! wrong: whole numbers
  const int difference = I3 - I1;
  return omega3 * difference / I1;
//! wrong: a sphere turns with its spin
  if (I1 == I3) return omega3;
  return omega3 * (I3 - I1) / I1;
//! wrong: brackets forgotten
  return omega3 * I3 - I1 / I1;
