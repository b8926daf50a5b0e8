// Writes instruction streams for the pixel processors.
#pragma once
#include "cmodel/pixelflow/program.h"
