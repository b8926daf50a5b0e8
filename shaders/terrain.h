// Reflectance maps of terrain (Strat 1978): how bright a surface looks by its slopes p to the east and q to the north,
// for a sun that is the same everywhere.
#ifndef TERRAIN_H
#define TERRAIN_H

// The way to a distant light or viewer: east, north, up. Degrees; the azimuth clockwise from north, the elevation above
// the horizon.
void direction_to(uniform float azimuth, uniform float elevation, output uniform float way[3])
{
    uniform float a = radians(azimuth), e = radians(elevation);
    way = { sin(a)*cos(e), cos(a)*cos(e), sin(e) };
}

// Of a surface coloured by its height: `low` up to low_height, then over `middle`, halfway, to `high` from high_height on.
void color_of_height(signed fixed<24,8> height, uniform float low_height, uniform float high_height,
                     uniform fixed<16,14> low[3], uniform fixed<16,14> middle[3], uniform fixed<16,14> high[3],
                     output fixed<16,14> paint[3])
{
    uniform fixed<32,31> rate = 2/max(high_height - low_height, 1);
    uniform signed fixed<24,8> start = low_height;
    signed fixed<25,8> above = max(height - start, 0);
    fixed<16,14> place = min(above*rate, 2);
    paint = mix(low, middle, min(place, 1));
    if (place > 1)
        paint = mix(middle, high, place - 1);
}

#endif
