// Phong's highlight in fixed point, for surfaces whose normal and view are signed fixed<16,14> unit vectors.
#ifndef PHONG_H
#define PHONG_H

// The cosine between the eye and the mirror image of the light, to the power 2^doublings. `nl`, `ne` and `le` are the
// dot products of the normal with the light, of the normal with the eye and of the light with the eye.
fixed<16,15> highlight(signed fixed<16,14> nl, signed fixed<16,14> ne, signed fixed<16,14> le,
                       uniform int doublings)
{
    signed fixed<18,15> mirrored = 2*nl*ne - le;
    // Unit vectors in fixed point may be a little too long: a cosine above 1 would grow with every squaring.
    fixed<16,15> x = clamp(mirrored, 0, 1);
    uniform int i;
    for (i = 0; i < doublings; i++)
        x *= x;
    return x;
}

#endif
