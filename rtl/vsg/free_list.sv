// Free list: the segment block returned last is taken first; when none was returned, the next block never used. A stack
// whose top is a register, so that a block to take is always shown; in every cycle one may be taken or one returned, not both.
// Refuses to give when full_o; the taker stops the frame.

module free_list (
  input  logic           clk_i,
  input  logic           rst_ni,
  input  logic           frame_start_i,
  // from the blocks that take and return segment blocks
  input  logic           take_i,
  output vsg_pkg::ptr_t  block_o,
  output logic           fresh_o,   // never used in this frame
  output logic           full_o,    // no block is left
  input  logic           return_i,
  input  vsg_pkg::ptr_t  returned_i
);

  localparam int Depth = vsg_pkg::SegmentBlocks;
  typedef logic [vsg_pkg::PtrAddrW-1:0] address_t;
  localparam logic [vsg_pkg::PtrAddrW-1:0] Two = 2;

  logic [vsg_pkg::PtrW-1:0] stack_mem [Depth];
  vsg_pkg::ptr_t count_d, count_q;    // blocks returned and not taken again
  vsg_pkg::ptr_t used_d, used_q;      // blocks ever used
  vsg_pkg::ptr_t top_d, top_q, below_q;
  logic          reload_q;            // the top was taken: the one below is on its way

  vsg_pkg::ptr_t top;
  address_t below, above;
  assign top   = reload_q ? below_q : top_q;
  assign below = count_q[vsg_pkg::PtrAddrW-1:0] - Two;
  assign above = count_q[vsg_pkg::PtrAddrW-1:0] - 1'b1;

  assign fresh_o = (count_q == '0);
  assign full_o  = fresh_o && (used_q == vsg_pkg::SegmentBlockCount);
  assign block_o = fresh_o ? used_q + 1'b1 : top;

  always_comb begin
    count_d = count_q;
    used_d  = used_q;
    top_d   = top;
    if (take_i && !full_o) begin
      if (fresh_o) used_d = used_q + 1'b1;
      else count_d = count_q - 1'b1;
    end
    if (return_i) begin
      count_d = count_q + 1'b1;
      top_d   = returned_i;
    end
    if (frame_start_i) begin
      count_d = '0;
      used_d  = '0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (return_i && count_q != '0) stack_mem[above] <= top;
    below_q <= stack_mem[below];
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      count_q  <= '0;
      used_q   <= '0;
      top_q    <= '0;
      reload_q <= 1'b0;
    end else begin
      count_q  <= count_d;
      used_q   <= used_d;
      top_q    <= top_d;
      reload_q <= take_i && !fresh_o;
    end
  end

endmodule
