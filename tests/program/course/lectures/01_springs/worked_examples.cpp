//! [energy]
// A spring of 2 N/m, stretched by 3 m, holds 9 J.
//! [energy]
