// Colours for counts of iterations: bands of blue, white and gold that repeat; black inside of the set.
#ifndef MANDELBROT_COLORS_H
#define MANDELBROT_COLORS_H

// A wave of period 1 that rises and falls like the square of a sine.
fixed<16,16> wave(fixed<24,16> x)
{
    fixed<16,16> rise = abs(2*(x % 1) - 1) * 0.9999;
    return sat fixed<16,16>(rise*rise*(3 - 2*rise));
}

// What `count`, of at most `most`, is shown as. Without colours its two bytes are shown as they are, for those who count.
void show_count(fixed<16,0> count, uniform int most, uniform fixed<16,12> bands, uniform bool plain,
                output fixed<8,8> shown[3])
{
    if (plain) {
        fixed<8,8> low = count >> 8, high = count >> 16;
        shown = { low, high, 0 };
    } else {
        fixed<24,16> level = count;
        fixed<24,16> x = bands * sqrt(level);
        shown = { wave(x + 0.12), wave(x + 0.21), wave(x + 0.30) };
        if (count >= most) shown = { 0, 0, 0 };
    }
}

#endif
