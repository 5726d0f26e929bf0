// Figures of lecture @NUMBER@.
#include "lectures/support/figure.hpp"

int main(int argc, char** argv) { return workbook::draw_figures(argc, argv, {}); }
