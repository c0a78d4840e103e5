#define DENSITY 2
