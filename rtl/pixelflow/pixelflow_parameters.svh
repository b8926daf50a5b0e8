// The one home of every size of the pixel processors. The RTL includes this file, and the C++ golden model, the microcode,
// the drivers and the tests take the same values from a header that the build makes of it. A value is changed here. On the
// command line of a tool (-DPIXELFLOW_MULTIPLIER_BITS=8) it changes for that one run alone: lint, synthesis, a chip of a test.

`ifndef PIXELFLOW_PARAMETERS_SVH
`define PIXELFLOW_PARAMETERS_SVH

// Processing elements of a chip. 32 chips of 256 make the array of a node.
`ifndef PIXELFLOW_ELEMENTS
`define PIXELFLOW_ELEMENTS 256
`endif

// Bytes of memory of an element; an address has 8 bits, so at most 256.
`ifndef PIXELFLOW_MEMORY_BYTES
`define PIXELFLOW_MEMORY_BYTES 256
`endif

// Multiplier bits that an element works off in a cycle: 1, 2, 4 or 8. A multiplication step takes 8 over this many cycles.
`ifndef PIXELFLOW_MULTIPLIER_BITS
`define PIXELFLOW_MULTIPLIER_BITS 2
`endif

// Columns and rows of a region: one element a sample.
`ifndef PIXELFLOW_REGION_WIDTH
`define PIXELFLOW_REGION_WIDTH 128
`endif
`ifndef PIXELFLOW_REGION_HEIGHT
`define PIXELFLOW_REGION_HEIGHT 64
`endif

// Bytes of a packet of the composition network, and how many of them, the first ones, are depth.
`ifndef PIXELFLOW_PACKET_BYTES
`define PIXELFLOW_PACKET_BYTES 32
`endif
`ifndef PIXELFLOW_DEPTH_BYTES
`define PIXELFLOW_DEPTH_BYTES 4
`endif

// Instructions that the stream buffer holds.
`ifndef PIXELFLOW_STREAM_WORDS
`define PIXELFLOW_STREAM_WORDS 1024
`endif

// Clock of the array, in MHz: half that of the networks.
`ifndef PIXELFLOW_CLOCK_MHZ
`define PIXELFLOW_CLOCK_MHZ 100
`endif

`endif
