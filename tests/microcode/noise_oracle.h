// Noise from its definition, in double precision, with a bound of what the formats of the two forms may add to it.
//
//   lattice point (i, j, k), indices modulo 256, 16-bit arithmetic:
//     x = i 9E37 + j 79B9 + k 85EB (hexadecimal), x ^= x >> 8, x *= 6A35, x ^= x >> 7, x *= B4D3, h = x >> 8
//   its value: q = h mod 16; u = q < 8 ? fx : fy; v = q < 4 ? fy : q is 12 or 14 ? fx : fz; +-u by bit 0, +-v by bit 1
//   weights 3 t^2 - 2 t^3; g mixed along x, then y, then z; noise = (g + 1) / 2, not below 0 nor above 1
// Coordinates that are not given are 0.
#ifndef VSG_TESTS_MICROCODE_NOISE_ORACLE_H_
#define VSG_TESTS_MICROCODE_NOISE_ORACLE_H_

namespace pixelflow_test {

// What a form loses: each as the largest error of one step.
struct NoiseFormat {
  double coordinate;  // of a coordinate
  double weight;      // of a weight, beside what the coordinate's error makes of it
  double first_mix;   // of a mix along x
  double mix;         // of a mix along y or z
  double result;
};

// Coordinates have 8 fraction bits as they come. A weight is floored to 8 bits. Corners have 8 fraction bits, a mix
// along x has 16 and is exact, the later ones are floored to 16; so is the result, and 1 becomes 1 - 2^-16.
inline constexpr NoiseFormat kFixedNoise = {0, 0x1p-8, 0, 0x1p-16, 0x1p-16};
// Coordinates are floored to 24 fraction bits. t^2 is floored to 32, which counts at most three times in the weight,
// and the weight to 32; mixes to 28. The result is rounded to nearest, to 24 bits.
inline constexpr NoiseFormat kFloatNoise = {0x1p-24, 0x1p-30, 0x1p-28, 0x1p-28, 0x1p-25};

// A value and how far from it a form with the given format may be.
struct Bounded {
  double value;
  double error;
};

// `point` has `dimensions` finite coordinates.
Bounded noise_by_definition(int dimensions, const double* point, const NoiseFormat& format);

}  // namespace pixelflow_test

#endif
