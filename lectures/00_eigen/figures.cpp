// Figures of lecture 00.
#include "lectures/support/figure.hpp"

int main(int argc, char** argv) { return workbook::draw_figures(argc, argv, {}); }
