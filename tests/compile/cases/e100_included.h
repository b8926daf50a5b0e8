#define LEVEL 1
#bad
