// Active list (chapter III.F): segments taken from the X-sort list that reach beyond the right sample point; those that end
// inside the span go to a second list, in case the span is subdivided. Links lie in the segment blocks; this block holds
// the ends. Latency: none; removal and restoring write one link in the cycle of the command. Refuses nothing.

module active_list (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      line_start_i,
  // from the depth comparator
  input  logic                      span_start_i,
  output vsg_pkg::ptr_t             first_o,
  input  logic                      remove_i,      // takes out the segment after remove_previous_i (0: the first)
  input  vsg_pkg::ptr_t             remove_previous_i,
  input  vsg_pkg::ptr_t             remove_next_i,
  input  logic                      add_i,         // link_o is to be written into the block's active_next
  input  logic                      add_ending_i,
  input  vsg_pkg::ptr_t             add_block_i,
  output vsg_pkg::ptr_t             link_o,
  // from the decision processor: the span is subdivided, what ended in it is active again
  input  logic                      restore_i,
  // segment memory
  output vsg_pkg::memory_request_t  request_o,
  // to the tally
  output vsg_pkg::count_t           count_o
);

  vsg_pkg::ptr_t first_d, first_q, ending_d, ending_q, ending_last_d, ending_last_q;

  assign link_o = add_ending_i ? ending_q : first_q;

  always_comb begin
    first_d       = first_q;
    ending_d      = ending_q;
    ending_last_d = ending_last_q;
    request_o     = '0;
    count_o       = '0;
    if (span_start_i) ending_d = '0;
    if (remove_i) begin
      if (remove_previous_i == '0) begin
        first_d = remove_next_i;
      end else begin
        request_o.valid            = 1'b1;
        request_o.groups           = vsg_pkg::GroupActive;
        request_o.block            = remove_previous_i;
        request_o.word.active_next = remove_next_i;
      end
    end
    if (add_i) first_d = add_block_i;
    if (add_ending_i) begin
      ending_d = add_block_i;
      if (ending_q == '0) ending_last_d = add_block_i;
    end
    if (restore_i && ending_q != '0) begin
      request_o.valid            = 1'b1;
      request_o.groups           = vsg_pkg::GroupActive;
      request_o.block            = ending_last_q;
      request_o.word.active_next = first_q;
      first_d                    = ending_q;
      count_o.segment_reads      = 2'd1;
      count_o.segment_writes     = 2'd1;
    end
    if (line_start_i) first_d = '0;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      first_q       <= '0;
      ending_q      <= '0;
      ending_last_q <= '0;
    end else begin
      first_q       <= first_d;
      ending_q      <= ending_d;
      ending_last_q <= ending_last_d;
    end
  end

  assign first_o = first_q;

endmodule
