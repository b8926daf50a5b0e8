// Types of the Visible Segment Generator. Widths come from vsg_parameters.svh and are derived nowhere else.
//
// Numbers of blocks run from 1; 0 is none. The low bits of a number address its memory, so a memory of 2^n blocks holds
// 2^n of them (number 2^n lies at address 0). VSG_SEGMENT_BLOCKS must be a power of two.
//
// Longer than a file should be, as widths and packed structs of all blocks have this one home.
//
// Fixed point: X and Z are signed words with FracX and FracZ fraction bits and IntegerBits before the point.

`include "vsg_parameters.svh"

package vsg_pkg;

  parameter int FracX = `VSG_FRACTION_BITS_X;
  parameter int FracZ = `VSG_FRACTION_BITS_Z;
  parameter int IntegerBits = `VSG_INTEGER_BITS;
  parameter int XW = IntegerBits + FracX;
  parameter int ZW = IntegerBits + FracZ;
  parameter int CoordW = `VSG_COORDINATE_BITS;

  parameter int SegmentBlocks = `VSG_SEGMENT_BLOCKS;
  parameter int EdgeBlocks = `VSG_EDGE_BLOCKS;
  parameter int PolygonBlocks = `VSG_POLYGON_BLOCKS;
  parameter int PtrW = $clog2(SegmentBlocks + 1);
  parameter int PtrAddrW = $clog2(SegmentBlocks);
  parameter int EdgeW = $clog2(EdgeBlocks + 1);
  parameter int EdgeAddrW = $clog2(EdgeBlocks);
  parameter int PolyW = $clog2(PolygonBlocks + 1);
  parameter int PolyAddrW = $clog2(PolygonBlocks);
  // The polygon field of a segment block holds a segment number when the block is an implied edge.
  parameter int OwnerW = (PolyW > PtrW) ? PolyW : PtrW;

  parameter int SegmentEdgeW = XW + XW + ZW + ZW;                       // bits of segment_edge_t
  parameter int EdgeBlockW = PolyW + PolyW + CoordW + CoordW + SegmentEdgeW;  // bits of edge_t
  parameter logic [PtrW-1:0] SegmentBlockCount = SegmentBlocks[PtrW-1:0];
  parameter logic [EdgeW-1:0] EdgeBlockCount = EdgeBlocks[EdgeW-1:0];
  parameter logic [PolyW-1:0] PolygonBlockCount = PolygonBlocks[PolyW-1:0];

  parameter int CountW = 32;   // counters
  parameter int AddW = 16;     // add cycles of one depth test
  parameter int BoxW = 16;     // segments in a visible box
  // Extent of a segment in pixels, ten places more when an intersection is sought.
  parameter int SearchShift = 10;
  parameter int HalvingW = IntegerBits + SearchShift;

  typedef logic signed [XW-1:0] x_t;
  typedef logic signed [ZW-1:0] z_t;
  typedef logic signed [IntegerBits-1:0] pixel_t;
  typedef logic [CoordW-1:0] line_t;
  typedef logic signed [CoordW+1:0] lines_t;
  typedef logic [PtrW-1:0] ptr_t;
  typedef logic [EdgeW-1:0] edge_ptr_t;
  typedef logic [PolyW-1:0] poly_ptr_t;
  typedef logic [OwnerW-1:0] owner_t;
  typedef logic [HalvingW-1:0] halving_t;
  typedef logic [CountW-1:0] counter_t;

  // x_previous of a block that is not in the X-sort list.
  parameter logic [PtrW-1:0] NotSorted = '1;

  // Half a segment block (figure 5).
  typedef struct packed {
    x_t x;
    x_t dx;
    z_t z;
    z_t dz;
  } segment_edge_t;

  // Segment block, one word of segment memory. An implied edge holds its X in `left`, its two segments in `polygon` and
  // `polygon_next`, and the link of its list in `x_next`.
  typedef struct packed {
    ptr_t          x_previous;
    ptr_t          x_next;
    owner_t        polygon;
    ptr_t          polygon_next;
    lines_t        left_lines;    // minus the scan lines left; 0: that half is empty
    lines_t        right_lines;
    segment_edge_t left;
    segment_edge_t right;
    logic          implied;
    ptr_t          active_next;
  } segment_t;

  // Groups of fields with a write enable of their own.
  parameter int Groups = 9;
  typedef logic [Groups-1:0] groups_t;
  parameter logic [Groups-1:0] GroupXPrevious   = 9'h001;
  parameter logic [Groups-1:0] GroupXNext       = 9'h002;
  parameter logic [Groups-1:0] GroupPolygon     = 9'h004;
  parameter logic [Groups-1:0] GroupPolygonNext = 9'h008;
  parameter logic [Groups-1:0] GroupLeftLines   = 9'h010;
  parameter logic [Groups-1:0] GroupRightLines  = 9'h020;
  parameter logic [Groups-1:0] GroupLeft        = 9'h040;
  parameter logic [Groups-1:0] GroupRight       = 9'h080;
  parameter logic [Groups-1:0] GroupActive      = 9'h100;
  parameter logic [Groups-1:0] GroupAll         = 9'h1ff;

  // One access of segment memory; no group written means a read, whose word is there in the next cycle and stays until
  // the next read. One block at a time drives it, the others drive zeros.
  typedef struct packed {
    logic     valid;
    groups_t  groups;
    ptr_t     block;
    segment_t word;
  } memory_request_t;

  // Edge block (figure 4), as it is loaded.
  typedef struct packed {
    poly_ptr_t first_polygon;
    poly_ptr_t second_polygon;
    line_t     first_line;
    line_t     lines;
    x_t        x;
    x_t        dx;
    z_t        z;
    z_t        dz;
  } edge_t;

  // Sample word of an edge: block and half (0 left, 1 right).
  typedef struct packed {
    ptr_t block;
    logic side;
  } sample_address_t;

  // An edge that may become a sample point; pixel 0 when there is none.
  typedef struct packed {
    pixel_t          pixel;
    sample_address_t address;
  } sample_point_t;

  // Pixels left to right, both included, with the edges seen on its borders.
  typedef struct packed {
    pixel_t        left;
    pixel_t        right;
    sample_point_t at_left;
    sample_point_t at_right;
  } span_t;

  // A segment as the registers of the comparator are loaded from it.
  typedef struct packed {
    ptr_t      block;
    poly_ptr_t polygon;
    x_t        x_left;
    x_t        x_right;
    z_t        z_left;
    z_t        z_right;
    pixel_t    edge_inside;  // leftmost edge inside the span
  } candidate_t;

  // Visible box.
  typedef struct packed {
    logic [BoxW-1:0] segments;
    x_t              x_left;
    x_t              x_right;
    z_t              z_min;
    z_t              z_max;
    pixel_t          left;
    pixel_t          right;
    pixel_t          edge_inside;
    ptr_t            front;
    ptr_t            other;
    poly_ptr_t       front_polygon;
    poly_ptr_t       other_polygon;
    logic            rising;
    halving_t        halvings;
  } box_t;

  typedef enum logic [1:0] {
    OutcomeHidden,
    OutcomeReplaces,
    OutcomeBoxed,
    OutcomeFirst
  } outcome_e;

  typedef enum logic [2:0] {
    DecisionBackground,
    DecisionVisible,
    DecisionSubdivideAtEdge,
    DecisionSubdivideInMiddle,
    DecisionIntersection
  } decision_e;

  // Verdict of the gates of the comparator in one add cycle.
  typedef enum logic [1:0] {
    VerdictClip,
    VerdictNewInFront,
    VerdictBoxed,
    VerdictNewBehind
  } verdict_e;

  typedef enum logic [1:0] {
    SortInsert,      // into this line's list, searching forward
    SortUnlink,      // out of this line's list
    SortInsertNext   // into the next line's list, searching back from its end
  } sort_command_e;

  typedef enum logic [2:0] {
    ErrorNone,
    ErrorOutOfFrame,
    ErrorSegmentMemoryFull,
    ErrorEdgeMemoryFull,
    ErrorPolygonMemoryFull,
    ErrorTooManySpans
  } error_e;

  // Output to the display file: `polygon` is visible up to pixel `x_end` of scan line `y`.
  typedef struct packed {
    line_t     y;
    line_t     x_end;
    poly_ptr_t polygon;
  } visible_segment_t;

  // What the blocks count in a cycle. Each field has one source at a time, so the blocks' counts are ORed.
  typedef struct packed {
    logic       slopes;
    logic       intercepts;
    logic       samples_stored;
    logic       subdivisions;
    logic       depth_tests;
    logic       samples_deleted;
    logic       steps_back;
    logic       output_segments;
    logic       intersections;
    logic       halvings;
    logic       pipeline;
    logic       polygon_reads;
    logic       polygon_writes;
    logic       edge_reads;
    logic       edge_writes;
    logic [1:0] segment_reads;
    logic [1:0] segment_writes;
    logic       blocks_taken;
    logic       blocks_returned;
    logic       bucket_reads;
    logic       crossings;         // a segment is incremented: two crossings
    logic       implied_edges;
    logic       insertions;
    logic       not_at_end;
    logic       stale_samples;
    logic       unclosed_polygons;
    logic       polygons;
    logic       front_polygons;
    logic       edges;
    logic       front_edges;
    logic       entered_edges;
    logic       involved_lines;
    logic       mark;              // a segment is looked at: references are counted from here
    logic       account;           // its look is over
    logic       tested;            // and was a depth test
    logic [AddW-1:0] add_cycles;   // of that look, when `account`
    pixel_t     density;           // added to the point density
  } count_t;

  // Counters, in the order of the tally's trace port.
  parameter int Counters = 64;
  typedef logic [(Counters << 5)-1:0] counters_t;  // CountW = 32 bits each, the first lowest
  typedef enum logic [5:0] {
    CountSlopes = 6'd1, CountIntercepts = 6'd2, CountSamplesStored = 6'd3, CountSubdivisions = 6'd4,
    CountDepthTests = 6'd6, CountSamplesDeleted = 6'd8, CountStepsBack = 6'd9, CountOutputSegments = 6'd10,
    CountIntersections = 6'd11, CountHalvings = 6'd12, CountPipeline = 6'd13, CountWaiting = 6'd14,
    CountPolygonReads = 6'd15, CountPolygonWrites = 6'd16, CountEdgeReads = 6'd17, CountEdgeWrites = 6'd18,
    CountSegmentReads = 6'd19, CountSegmentWrites = 6'd20, CountBlocksTaken = 6'd23, CountBlocksReturned = 6'd24,
    CountBucketReads = 6'd25, CountCrossings = 6'd26, CountImpliedEdges = 6'd27, CountInsertions = 6'd28,
    CountNotAtEnd = 6'd29, CountAddCycles = 6'd30, CountAddCyclesListed = 6'd31, CountStaleSamples = 6'd32,
    CountUnclosedPolygons = 6'd33, CountBlocksNow = 6'd34, CountBlocksMost = 6'd35, CountPointDensity = 6'd36,
    CountInvolvedLines = 6'd37, CountPolygons = 6'd38, CountFrontPolygons = 6'd39, CountEdges = 6'd40,
    CountFrontEdges = 6'd41, CountEnteredEdges = 6'd42, CountPortAccesses = 6'd43,
    CountAdds = 6'd44   // to 63: looks by their add cycles, 1 to 20
  } counter_e;
  parameter int AddsEntries = 20;

  // --- trace ports, for lock-step

  typedef struct packed {
    logic      valid;
    edge_ptr_t number;
    poly_ptr_t polygon;
    x_t        x;
  } trace_edge_t;

  typedef struct packed {
    logic            valid;
    ptr_t            block;
    logic            from_x_sort;
    logic            intersecting;
    outcome_e        outcome;
    logic [AddW-1:0] add_cycles;
    box_t            box;
    span_t           span;
  } trace_test_t;

  typedef struct packed {
    logic            valid;
    decision_e       decision;
    logic [BoxW-1:0] segments;
    pixel_t          new_right;
    span_t           span;
  } trace_decision_t;

  typedef struct packed {
    logic          valid;
    sample_point_t point;
  } trace_sample_t;

  typedef struct packed {
    logic line_started;
    logic sort_started;
    logic line_finished;
  } trace_phase_t;

  // X of an edge on the line after the one it holds.
  function automatic logic signed [XW-1:0] next_x(input logic signed [XW-1:0] x, input logic signed [XW-1:0] dx);
    next_x = x + dx;
  endfunction

  // The pixel that an X falls on.
  function automatic logic signed [IntegerBits-1:0] pixel_of(input logic signed [XW-1:0] x);
    pixel_of = x[XW-1:FracX];
  endfunction

  // The pixel of an edge on the line after the one it holds.
  function automatic logic signed [IntegerBits-1:0] next_pixel(input logic signed [XW-1:0] x,
                                                               input logic signed [XW-1:0] dx);
    logic signed [XW-1:0] sum;
    sum = x + dx;
    next_pixel = sum[XW-1:FracX];
  endfunction

  // Crossings must fall on pixel 1 to the width of the frame.
  function automatic logic inside_frame(input logic signed [IntegerBits-1:0] pixel,
                                        input logic signed [IntegerBits-1:0] width);
    inside_frame = (pixel > 0) && (pixel <= width);
  endfunction

endpackage
