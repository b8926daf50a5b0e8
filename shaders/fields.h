// What a node's host finds out about distance fields, as their surfaces take it.
#ifndef FIELDS_H
#define FIELDS_H

// Lights that the host tells the visibility of, the scene's first: a byte of the pixel's packets each. Others are taken
// to reach everything.
const int kHostLights = 2;

// 255/256, the most that a byte holds, stands for 1.
fixed<9,8> share(fixed<8,8> visibility)
{
    return visibility + (visibility >> 7);
}

// How much of a light arrives; `count` lights came before it.
fixed<9,8> seen(fixed<8,8> visibility[2], uniform int count)
{
    fixed<9,8> arriving = 1;
    if (count < kHostLights)
        arriving = share(visibility[count]);
    return arriving;
}

#endif
