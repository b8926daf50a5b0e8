#include "pixelflow/microcode/assembler.h"
