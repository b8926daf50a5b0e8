// Implied edges (chapter III.I): where two segments cross, a block holds the crossing's X. Found once, it waits in a list;
// found again on the next line it gets its increment and enters the X-sort list, so that it is a sample point of the
// lines to come; not found again, it goes back to the free list.
//
// Latency: 2 cycles a block of the list, 2 to 4 to insert or to take a block. Refuses: segment memory full (full_o).

module implied_edges (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      frame_start_i,
  input  vsg_pkg::pixel_t           width_i,
  input  logic                      last_lines_i,     // the line before the last, or the last: nothing is found again
  // control: a line begins
  input  logic                      line_start_i,
  output logic                      line_done_o,
  // from the decision processor: segments left_i and right_i cross at x_i
  input  logic                      crossing_i,
  input  vsg_pkg::ptr_t             left_i,
  input  vsg_pkg::ptr_t             right_i,
  input  vsg_pkg::x_t               x_i,              // held until done_o
  output logic                      done_o,
  output logic                      full_o,
  output vsg_pkg::sample_point_t    point_o,          // with done_o: pixel 0 when it is no sample point yet
  // free list and sample list
  output logic                      take_o,
  input  vsg_pkg::ptr_t             free_block_i,
  input  logic                      free_fresh_i,
  input  logic                      free_full_i,
  output logic                      return_o,
  output vsg_pkg::ptr_t             returned_o,
  output logic                      clear_samples_o,
  // X-sort list of the next line
  output logic                      sort_o,
  output vsg_pkg::ptr_t             sort_block_o,
  output vsg_pkg::pixel_t           sort_pixel_o,
  input  logic                      sort_done_i,
  input  vsg_pkg::ptr_t             sort_previous_i,
  input  vsg_pkg::ptr_t             sort_next_i,
  // segment memory
  output vsg_pkg::memory_request_t  request_o,
  input  vsg_pkg::segment_t         word_i,
  // to the tally
  output vsg_pkg::count_t           count_o
);

  typedef enum logic [3:0] {
    StIdle,
    StDiscard,      // return what was found on the line before and not again
    StDiscardWord,
    StLook,         // is there a block in the list?
    StWord,
    StUnlink,
    StAgain,        // found again
    StSort,
    StWrite,
    StTake
  } state_e;

  state_e state_d, state_q;
  vsg_pkg::ptr_t waiting_d, waiting_q;   // found on the line before, not yet matched
  vsg_pkg::ptr_t found_d, found_q;       // found on this line
  vsg_pkg::ptr_t at_d, at_q, previous_d, previous_q;

  // The match: increment and pixel on the next line.
  vsg_pkg::x_t increment, next;
  vsg_pkg::pixel_t pixel;
  assign increment = x_i - word_i.left.x;
  assign next      = x_i + increment;
  assign pixel     = vsg_pkg::pixel_of(next);

  // While the list is sorted other blocks are read: these keep what the match gave.
  vsg_pkg::x_t kept_increment_d, kept_increment_q;
  vsg_pkg::pixel_t kept_pixel_d, kept_pixel_q;
  assign kept_increment_d = (state_q == StAgain) ? increment : kept_increment_q;
  assign kept_pixel_d     = (state_q == StAgain) ? pixel : kept_pixel_q;

  logic same;
  assign same = (word_i.polygon[vsg_pkg::PtrW-1:0] == left_i) && (word_i.polygon_next == right_i);

  always_comb begin
    state_d         = state_q;
    waiting_d       = waiting_q;
    found_d         = found_q;
    at_d            = at_q;
    previous_d      = previous_q;
    line_done_o     = 1'b0;
    done_o          = 1'b0;
    full_o          = 1'b0;
    point_o         = '0;
    take_o          = 1'b0;
    return_o        = 1'b0;
    returned_o      = at_q;
    clear_samples_o = 1'b0;
    sort_o          = 1'b0;
    sort_block_o    = at_q;
    sort_pixel_o    = pixel;
    request_o       = '0;
    count_o         = '0;
    case (state_q)
      StIdle: begin
        previous_d = '0;
        at_d       = waiting_q;
        if (line_start_i) state_d = StDiscard;
        else if (crossing_i) state_d = StLook;
      end

      StDiscard: begin
        if (at_q == '0) begin
          waiting_d   = found_q;
          found_d     = '0;
          line_done_o = 1'b1;
          state_d     = StIdle;
        end else begin
          request_o.valid = 1'b1;
          request_o.block = at_q;
          state_d         = StDiscardWord;
        end
      end
      StDiscardWord: begin
        return_o                = 1'b1;
        count_o.blocks_returned = 1'b1;
        at_d                    = word_i.x_next;
        state_d                 = StDiscard;
      end

      StLook: begin
        if (at_q == '0) begin
          state_d = StTake;
          // A crossing first seen on the last line that shows anything would never be found again.
          if (last_lines_i) begin
            done_o  = 1'b1;
            state_d = StIdle;
          end
        end else begin
          count_o.segment_reads = 2'd1;
          request_o.valid       = 1'b1;
          request_o.block       = at_q;
          state_d               = StWord;
        end
      end
      StWord: begin
        if (same) begin
          state_d = (previous_q == '0) ? StAgain : StUnlink;
          if (previous_q == '0) waiting_d = word_i.x_next;
        end else begin
          previous_d = at_q;
          at_d       = word_i.x_next;
          state_d    = StLook;
        end
      end
      StUnlink: begin
        request_o.valid       = 1'b1;
        request_o.groups      = vsg_pkg::GroupXNext;
        request_o.block       = previous_q;
        request_o.word.x_next = word_i.x_next;
        state_d               = StAgain;
      end
      StAgain: begin
        if (vsg_pkg::inside_frame(pixel, width_i)) begin
          sort_o  = 1'b1;
          state_d = StSort;
        end else begin
          return_o                = 1'b1;
          count_o.blocks_returned = 1'b1;
          done_o                  = 1'b1;
          state_d                 = StIdle;
        end
      end
      StSort: if (sort_done_i) state_d = StWrite;
      StWrite: begin
        request_o.valid           = 1'b1;
        request_o.groups          = vsg_pkg::GroupXPrevious | vsg_pkg::GroupXNext | vsg_pkg::GroupLeft;
        request_o.block           = at_q;
        request_o.word.x_previous = sort_previous_i;
        request_o.word.x_next     = sort_next_i;
        request_o.word.left.x     = x_i;
        request_o.word.left.dx    = kept_increment_q;
        point_o.pixel             = kept_pixel_q;
        point_o.address.block     = at_q;
        done_o                    = 1'b1;
        state_d                   = StIdle;
      end

      StTake: begin
        state_d = StIdle;
        if (free_full_i) begin
          full_o = 1'b1;
        end else begin
          take_o                      = 1'b1;
          clear_samples_o             = free_fresh_i;
          count_o.blocks_taken        = 1'b1;
          count_o.implied_edges       = 1'b1;
          request_o.valid             = 1'b1;
          request_o.groups            = vsg_pkg::GroupAll;
          request_o.block             = free_block_i;
          request_o.word.x_previous   = vsg_pkg::NotSorted;
          request_o.word.x_next       = found_q;
          request_o.word.polygon[vsg_pkg::PtrW-1:0] = left_i;
          request_o.word.polygon_next = right_i;
          request_o.word.left.x       = x_i;
          request_o.word.implied      = 1'b1;
          found_d                     = free_block_i;
          done_o                      = 1'b1;
        end
      end
      default: state_d = StIdle;
    endcase
    if (frame_start_i) begin
      state_d   = StIdle;
      waiting_d = '0;
      found_d   = '0;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q          <= StIdle;
      waiting_q        <= '0;
      found_q          <= '0;
      at_q             <= '0;
      previous_q       <= '0;
      kept_increment_q <= '0;
      kept_pixel_q     <= '0;
    end else begin
      state_q          <= state_d;
      waiting_q        <= waiting_d;
      found_q          <= found_d;
      at_q             <= at_d;
      previous_q       <= previous_d;
      kept_increment_q <= kept_increment_d;
      kept_pixel_q     <= kept_pixel_d;
    end
  end

endmodule
