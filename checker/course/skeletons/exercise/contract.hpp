/// TODO: what it computes, in one sentence.
///
@PARAMETERS@/// @pre TODO: which inputs are legal; the degenerate ones by name
/// @return TODO: meaning, frame, unit
@SIGNATURE@;

