// X-sort list: the segments of a scan line in the order of their left edges, with back pointers (chapter III.F). The list
// of this line is consumed from its front while the list of the next line grows at its end; the pixel of that end is kept
// in a register, so that a segment which belongs there, as nearly all do, costs one write for the link.
//
// Latency of a command: 2 cycles to append to the next line's list; a step back or forward costs 2 more each.
// Refuses nothing; a command is given when the one before is done.

module x_sort (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      frame_start_i,
  input  logic                      line_start_i,     // the next line's list becomes this line's
  // from the segment eliminator, the depth comparator and the implied edges
  input  logic                      command_valid_i,
  input  vsg_pkg::sort_command_e    command_i,
  input  vsg_pkg::ptr_t             block_i,
  input  vsg_pkg::ptr_t             start_i,          // SortInsert: search from here, 0 from the front
  input  vsg_pkg::pixel_t           pixel_i,          // of the left edge: SortInsert this line, SortInsertNext the next
  input  vsg_pkg::ptr_t             x_previous_i,     // SortUnlink: links of the block
  input  vsg_pkg::ptr_t             x_next_i,
  output logic                      done_o,
  output vsg_pkg::ptr_t             x_previous_o,     // with done_o: links of the block inserted
  output vsg_pkg::ptr_t             x_next_o,
  // to and from the depth comparator: the front of this line's list
  output vsg_pkg::ptr_t             front_o,
  input  logic                      pop_i,
  input  vsg_pkg::ptr_t             pop_next_i,       // x_next of the front
  // segment memory
  output vsg_pkg::memory_request_t  request_o,
  input  vsg_pkg::segment_t         word_i,
  // to the tally
  output vsg_pkg::count_t           count_o
);

  typedef enum logic [3:0] {
    StIdle,
    StForwardStart,   // the word of the block to search from
    StForward,        // is there a block after?
    StForwardWord,    // its word
    StBack,           // does the block belong before the one at hand?
    StBackLink,       // the word of the end of the list
    StBackWord,       // the word of the block before
    StLinkBefore,
    StLinkAfter,
    StUnlinkBefore,
    StUnlinkAfter
  } state_e;

  state_e state_d, state_q;
  vsg_pkg::ptr_t first_d, first_q, last_d, last_q;
  vsg_pkg::ptr_t next_first_d, next_first_q, next_last_d, next_last_q;
  vsg_pkg::pixel_t next_last_pixel_d, next_last_pixel_q;

  logic for_next_d, for_next_q;                    // the command works on the next line's list
  vsg_pkg::ptr_t block_d, block_q, before_d, before_q, after_d, after_q;
  vsg_pkg::ptr_t before_previous_d, before_previous_q;
  vsg_pkg::pixel_t pixel_d, pixel_q, before_pixel_d, before_pixel_q;

  vsg_pkg::pixel_t word_pixel;
  assign word_pixel = vsg_pkg::next_pixel(word_i.left.x, word_i.left.dx);

  // Nothing follows the last block; its link holds whatever it held.
  logic at_end;
  assign at_end = (before_q == last_q) || (after_q == '0);

  always_comb begin
    state_d           = state_q;
    first_d           = first_q;
    last_d            = last_q;
    next_first_d      = next_first_q;
    next_last_d       = next_last_q;
    next_last_pixel_d = next_last_pixel_q;
    for_next_d        = for_next_q;
    block_d           = block_q;
    before_d          = before_q;
    after_d           = after_q;
    before_previous_d = before_previous_q;
    pixel_d           = pixel_q;
    before_pixel_d    = before_pixel_q;
    request_o         = '0;
    count_o           = '0;
    done_o            = 1'b0;
    case (state_q)
      StIdle: begin
        block_d = block_i;
        pixel_d = pixel_i;
        if (command_valid_i) begin
          for_next_d = 1'b0;
          case (command_i)
            vsg_pkg::SortInsert: begin
              before_d = start_i;
              after_d  = first_q;
              state_d  = StForward;
              if (start_i != '0) begin
                request_o.valid = 1'b1;
                request_o.block = start_i;
                state_d         = StForwardStart;
              end
            end
            vsg_pkg::SortUnlink: begin
              before_d = x_previous_i;
              after_d  = (block_i == last_q) ? '0 : x_next_i;
              state_d  = StUnlinkBefore;
            end
            default: begin
              count_o.insertions = 1'b1;
              for_next_d     = 1'b1;
              before_d       = next_last_q;
              after_d        = '0;
              before_pixel_d = next_last_pixel_q;
              state_d        = (next_last_q == '0 || pixel_i >= next_last_pixel_q) ? StLinkBefore : StBack;
            end
          endcase
        end
      end

      StForwardStart: begin
        after_d = word_i.x_next;
        state_d = StForward;
      end
      StForward: begin
        count_o.segment_reads = 2'd1;
        if (at_end) begin
          after_d = '0;
          state_d = StLinkBefore;
        end else begin
          request_o.valid = 1'b1;
          request_o.block = after_q;
          state_d         = StForwardWord;
        end
      end
      StForwardWord: begin
        if (pixel_q <= word_pixel) begin
          state_d = StLinkBefore;
        end else begin
          before_d = after_q;
          after_d  = word_i.x_next;
          state_d  = StForward;
        end
      end

      StBack: begin
        if (before_q == '0 || pixel_q >= before_pixel_q) begin
          state_d = StLinkBefore;
        end else begin
          count_o.segment_reads = 2'd1;
          count_o.steps_back    = 1'b1;
          count_o.not_at_end    = (after_q == '0);
          request_o.valid       = 1'b1;
          if (after_q == '0) begin
            request_o.block = before_q;
            state_d         = StBackLink;
          end else begin
            after_d         = before_q;
            before_d        = before_previous_q;
            request_o.valid = (before_previous_q != '0);
            request_o.block = before_previous_q;
            state_d         = (before_previous_q != '0) ? StBackWord : StLinkBefore;
          end
        end
      end
      StBackLink: begin
        after_d         = before_q;
        before_d        = word_i.x_previous;
        request_o.valid = (word_i.x_previous != '0);
        request_o.block = word_i.x_previous;
        state_d         = (word_i.x_previous != '0) ? StBackWord : StLinkBefore;
      end
      StBackWord: begin
        before_pixel_d    = word_pixel;
        before_previous_d = word_i.x_previous;
        state_d           = StBack;
      end

      StLinkBefore: begin
        count_o.segment_writes = (for_next_q && after_q != '0) ? 2'd2 : 2'd1;
        if (before_q != '0) begin
          request_o.valid       = 1'b1;
          request_o.groups      = vsg_pkg::GroupXNext;
          request_o.block       = before_q;
          request_o.word.x_next = block_q;
        end else if (for_next_q) begin
          next_first_d = block_q;
        end else begin
          first_d = block_q;
        end
        state_d = StLinkAfter;
        if (after_q == '0) begin
          if (for_next_q) begin
            next_last_d       = block_q;
            next_last_pixel_d = pixel_q;
          end else begin
            last_d = block_q;
          end
          done_o  = 1'b1;
          state_d = StIdle;
        end
      end
      StLinkAfter: begin
        request_o.valid           = 1'b1;
        request_o.groups          = vsg_pkg::GroupXPrevious;
        request_o.block           = after_q;
        request_o.word.x_previous = block_q;
        done_o                    = 1'b1;
        state_d                   = StIdle;
      end

      StUnlinkBefore: begin
        if (before_q != '0) begin
          request_o.valid       = 1'b1;
          request_o.groups      = vsg_pkg::GroupXNext;
          request_o.block       = before_q;
          request_o.word.x_next = after_q;
        end else begin
          first_d = after_q;
        end
        state_d = StUnlinkAfter;
      end
      StUnlinkAfter: begin
        if (block_q == last_q) begin
          last_d = before_q;
        end else begin
          request_o.valid           = 1'b1;
          request_o.groups          = vsg_pkg::GroupXPrevious;
          request_o.block           = after_q;
          request_o.word.x_previous = before_q;
        end
        done_o  = 1'b1;
        state_d = StIdle;
      end
      default: state_d = StIdle;
    endcase

    if (pop_i) first_d = (first_q == last_q) ? '0 : pop_next_i;
    if (line_start_i) begin
      first_d      = next_first_q;
      last_d       = next_last_q;
      next_first_d = '0;
      next_last_d  = '0;
    end
    if (frame_start_i) begin
      state_d      = StIdle;
      first_d      = '0;
      last_d       = '0;
      next_first_d = '0;
      next_last_d  = '0;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q           <= StIdle;
      first_q           <= '0;
      last_q            <= '0;
      next_first_q      <= '0;
      next_last_q       <= '0;
      next_last_pixel_q <= '0;
      for_next_q        <= 1'b0;
      block_q           <= '0;
      before_q          <= '0;
      after_q           <= '0;
      before_previous_q <= '0;
      pixel_q           <= '0;
      before_pixel_q    <= '0;
    end else begin
      state_q           <= state_d;
      first_q           <= first_d;
      last_q            <= last_d;
      next_first_q      <= next_first_d;
      next_last_q       <= next_last_d;
      next_last_pixel_q <= next_last_pixel_d;
      for_next_q        <= for_next_d;
      block_q           <= block_d;
      before_q          <= before_d;
      after_q           <= after_d;
      before_previous_q <= before_previous_d;
      pixel_q           <= pixel_d;
      before_pixel_q    <= before_pixel_d;
    end
  end

  assign x_previous_o = before_q;
  assign x_next_o     = after_q;
  assign front_o      = first_q;

endmodule
