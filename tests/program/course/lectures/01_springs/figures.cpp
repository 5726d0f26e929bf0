// A course without figures.
