// The one home of every width and size of the Visible Segment Generator. The RTL includes this file, and the
// C++ golden model, the drivers and the tests take the same values from a header that the build makes of it.
// A value is changed here, or on the command line of the tool (-DVSG_FRACTION_BITS_X=12).

`ifndef VSG_PARAMETERS_SVH
`define VSG_PARAMETERS_SVH

// Fraction bits of X and of Z in a segment block (the 1970 program: 18 of a 36-bit word).
`ifndef VSG_FRACTION_BITS_X
`define VSG_FRACTION_BITS_X 18
`endif
`ifndef VSG_FRACTION_BITS_Z
`define VSG_FRACTION_BITS_Z 18
`endif

// Integer bits of X and of Z, the sign included: |z| < 2^16, one bit more for differences.
`ifndef VSG_INTEGER_BITS
`define VSG_INTEGER_BITS 18
`endif

// Segment blocks in segment memory; 64 when the machine is synthesised.
`ifndef VSG_SEGMENT_BLOCKS
`define VSG_SEGMENT_BLOCKS 8192
`endif

// Edge and polygon blocks that their memories hold.
`ifndef VSG_EDGE_BLOCKS
`define VSG_EDGE_BLOCKS 262144
`endif
`ifndef VSG_POLYGON_BLOCKS
`define VSG_POLYGON_BLOCKS 131072
`endif

// Bits of a screen coordinate: frames up to 8191 columns and as many scan lines.
`ifndef VSG_COORDINATE_BITS
`define VSG_COORDINATE_BITS 13
`endif

// Cycle of the segment memory in nanoseconds (chapter VII.D).
`ifndef VSG_MEMORY_CYCLE_NS
`define VSG_MEMORY_CYCLE_NS 200
`endif

`endif
