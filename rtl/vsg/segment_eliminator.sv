// Segment Eliminator (chapter III.B, figure 7): packs the segment lists of the changing polygons so that every block has
// both edges, returns empty blocks to the free list, and enters blocks made complete into the X-sort list.
//
// Latency: 2 cycles a polygon, 2 to 3 a block, 2 a block from which an edge is sought, and the X-sort. Refuses nothing:
// a polygon without a right edge gets no width and is counted.

module segment_eliminator (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      frame_start_i,
  // control
  input  logic                      start_i,
  output logic                      done_o,
  // polygon memory
  output logic                      take_o,
  input  vsg_pkg::poly_ptr_t        changing_i,
  input  vsg_pkg::ptr_t             first_segment_i,
  output logic                      set_first_o,
  output vsg_pkg::poly_ptr_t        set_polygon_o,
  output vsg_pkg::ptr_t             set_segment_o,
  // free list
  output logic                      return_o,
  output vsg_pkg::ptr_t             returned_o,
  // X-sort list
  output logic                      sort_o,
  output vsg_pkg::sort_command_e    sort_command_o,
  output vsg_pkg::ptr_t             sort_block_o,
  output vsg_pkg::ptr_t             sort_start_o,
  output vsg_pkg::pixel_t           sort_pixel_o,
  output vsg_pkg::ptr_t             unlink_previous_o,
  output vsg_pkg::ptr_t             unlink_next_o,
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
    StPolygon,      // is there a changing polygon?
    StPolygonWord,
    StBlock,        // is there a block?
    StBlockWord,
    StDonor,        // is there a block that may give a right edge?
    StDonorWord,
    StUnlink,       // the donor's left edge was in the X-sort list
    StUnlinkWait,
    StDonorWrite,
    StSort,         // a complete block not yet in the X-sort list
    StSortWait,
    StWrite
  } state_e;

  state_e state_d, state_q;
  vsg_pkg::poly_ptr_t polygon_d, polygon_q;
  vsg_pkg::ptr_t at_d, at_q, previous_d, previous_q, donor_d, donor_q;
  vsg_pkg::segment_t block_d, block_q;
  vsg_pkg::groups_t changed_d, changed_q;              // groups of block_q to be written
  vsg_pkg::groups_t donor_groups_d, donor_groups_q;    // groups of the donor that are emptied

  logic left_lives, right_lives, empty;
  assign left_lives  = word_i.left_lines[vsg_pkg::CoordW+1];
  assign right_lives = word_i.right_lines[vsg_pkg::CoordW+1];
  assign empty       = (word_i.left_lines == '0) && (word_i.right_lines == '0);

  logic block_ready;  // block_q is complete
  logic sorted;
  assign sorted = ((state_q == StBlockWord) ? word_i.x_previous : block_q.x_previous) != vsg_pkg::NotSorted;

  assign set_polygon_o     = polygon_q;
  assign set_segment_o     = word_i.polygon_next;
  assign returned_o        = at_q;
  assign sort_block_o      = (state_q == StUnlink) ? donor_q : at_q;
  assign sort_start_o      = previous_q;
  assign sort_pixel_o      = vsg_pkg::next_pixel(block_q.left.x, block_q.left.dx);
  assign unlink_previous_o = word_i.x_previous;
  assign unlink_next_o     = word_i.x_next;

  always_comb begin
    state_d        = state_q;
    polygon_d      = polygon_q;
    at_d           = at_q;
    previous_d     = previous_q;
    donor_d        = donor_q;
    block_d        = block_q;
    changed_d      = changed_q;
    donor_groups_d = donor_groups_q;
    done_o         = 1'b0;
    take_o         = 1'b0;
    set_first_o    = 1'b0;
    return_o       = 1'b0;
    sort_o         = 1'b0;
    sort_command_o = vsg_pkg::SortInsert;
    request_o      = '0;
    count_o        = '0;
    block_ready    = 1'b0;
    case (state_q)
      StIdle: if (start_i) state_d = StPolygon;
      StPolygon: begin
        polygon_d = changing_i;
        if (changing_i == '0) begin
          done_o  = 1'b1;
          state_d = StIdle;
        end else begin
          take_o                 = 1'b1;
          count_o.polygon_reads  = 1'b1;
          count_o.polygon_writes = 1'b1;
          state_d                = StPolygonWord;
        end
      end
      StPolygonWord: begin
        previous_d = '0;
        at_d       = first_segment_i;
        state_d    = StBlock;
      end

      StBlock: begin
        if (at_q == '0) begin
          state_d = StPolygon;
        end else begin
          count_o.segment_reads = 2'd1;
          request_o.valid       = 1'b1;
          request_o.block       = at_q;
          state_d               = StBlockWord;
        end
      end
      StBlockWord: begin
        block_d   = word_i;
        changed_d = '0;
        donor_d   = word_i.polygon_next;
        if (empty) begin
          if (previous_q != '0) begin
            count_o.segment_writes      = 2'd1;
            request_o.valid             = 1'b1;
            request_o.groups            = vsg_pkg::GroupPolygonNext;
            request_o.block             = previous_q;
            request_o.word.polygon_next = word_i.polygon_next;
          end else begin
            set_first_o = 1'b1;
          end
          return_o                = 1'b1;
          count_o.blocks_returned = 1'b1;
          at_d                    = word_i.polygon_next;
          state_d                 = StBlock;
        end else if (!right_lives) begin
          state_d = StDonor;
        end else if (!left_lives) begin
          block_d.left        = word_i.right;
          block_d.left_lines  = word_i.right_lines;
          block_d.right_lines = '0;
          changed_d           = vsg_pkg::GroupLeft | vsg_pkg::GroupLeftLines;
          state_d             = StDonor;
        end else begin
          block_ready = 1'b1;
        end
      end

      StDonor: begin
        if (donor_q == '0) begin
          // The polygon is not closed on this line.
          count_o.unclosed_polygons = 1'b1;
          block_d.right.x     = block_q.left.x;
          block_d.right.dx    = block_q.left.dx;
          block_d.right_lines = '0;
          changed_d           = changed_q | vsg_pkg::GroupRight | vsg_pkg::GroupRightLines;
          block_ready         = 1'b1;
        end else begin
          count_o.segment_reads = 2'd1;
          request_o.valid       = 1'b1;
          request_o.block       = donor_q;
          state_d               = StDonorWord;
        end
      end
      StDonorWord: begin
        if (left_lives) begin
          block_d.right          = word_i.left;
          block_d.right_lines    = word_i.left_lines;
          changed_d              = changed_q | vsg_pkg::GroupRight | vsg_pkg::GroupRightLines;
          count_o.segment_writes = 2'd1;
          donor_groups_d         = vsg_pkg::GroupLeftLines;
          state_d                = StDonorWrite;
          if (word_i.x_previous != vsg_pkg::NotSorted) begin
            donor_groups_d = vsg_pkg::GroupLeftLines | vsg_pkg::GroupXPrevious;
            state_d        = StUnlink;
          end
        end else if (right_lives) begin
          block_d.right          = word_i.right;
          block_d.right_lines    = word_i.right_lines;
          changed_d              = changed_q | vsg_pkg::GroupRight | vsg_pkg::GroupRightLines;
          count_o.segment_writes = 2'd2;
          donor_groups_d         = vsg_pkg::GroupLeftLines | vsg_pkg::GroupRightLines;
          state_d                = StDonorWrite;
        end else begin
          donor_d = word_i.polygon_next;
          state_d = StDonor;
        end
      end
      StUnlink: begin
        sort_o         = 1'b1;
        sort_command_o = vsg_pkg::SortUnlink;
        state_d        = StUnlinkWait;
      end
      StUnlinkWait: if (sort_done_i) state_d = StDonorWrite;
      StDonorWrite: begin
        request_o.valid           = 1'b1;
        request_o.groups          = donor_groups_q;
        request_o.block           = donor_q;
        request_o.word.x_previous = vsg_pkg::NotSorted;
        block_ready               = 1'b1;
      end

      StSort: begin
        sort_o  = 1'b1;
        state_d = StSortWait;
      end
      StSortWait: begin
        block_d.x_previous = sort_previous_i;
        block_d.x_next     = sort_next_i;
        changed_d          = changed_q | vsg_pkg::GroupXPrevious | vsg_pkg::GroupXNext;
        if (sort_done_i) begin
          state_d = StWrite;
        end else begin
          changed_d = changed_q;
        end
      end
      StWrite: begin
        request_o.valid  = 1'b1;
        request_o.groups = changed_q;
        request_o.block  = at_q;
        request_o.word   = block_q;
        previous_d       = at_q;
        at_d             = block_q.polygon_next;
        state_d          = StBlock;
      end
      default: state_d = StIdle;
    endcase

    if (block_ready) begin
      if (!sorted) begin
        state_d = StSort;
      end else if (changed_d != '0) begin
        state_d = StWrite;
      end else begin
        previous_d = at_q;
        at_d       = block_d.polygon_next;
        state_d    = StBlock;
      end
    end
    if (frame_start_i) state_d = StIdle;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q        <= StIdle;
      polygon_q      <= '0;
      at_q           <= '0;
      previous_q     <= '0;
      donor_q        <= '0;
      block_q        <= '0;
      changed_q      <= '0;
      donor_groups_q <= '0;
    end else begin
      state_q        <= state_d;
      polygon_q      <= polygon_d;
      at_q           <= at_d;
      previous_q     <= previous_d;
      donor_q        <= donor_d;
      block_q        <= block_d;
      changed_q      <= changed_d;
      donor_groups_q <= donor_groups_d;
    end
  end

endmodule
