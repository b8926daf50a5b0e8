// Sample list (chapters III.E and III.J): the edges that were visible on the line before, as sample points of this line,
// and the list that this line leaves for the next. Its words, two a segment block, lie in a memory of their own: the
// pixel of the next sample point and the address of its word. A word may be written for the next line before this line
// has read it; a sample point found left of the span ends the old list.
//
// Latency: a sample point 1 cycle after read_i when it was read ahead, otherwise 2. Refuses nothing.

module sample_list (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     frame_start_i,
  input  vsg_pkg::pixel_t          width_i,
  input  logic                     line_start_i,
  // from the sample space generator: the first sample point at or right of a pixel
  input  logic                     read_i,
  input  vsg_pkg::pixel_t          from_pixel_i,
  output logic                     sample_valid_o,
  output vsg_pkg::pixel_t          sample_o,
  // from the decision processor
  input  logic                     store_i,
  input  vsg_pkg::sample_point_t   point_i,
  // from the blocks that take segment blocks: a block never used has no sample words
  input  logic                     clear_i,
  input  vsg_pkg::ptr_t            clear_block_i,
  // to the tally, and lock-step
  output vsg_pkg::count_t          count_o,
  output vsg_pkg::trace_sample_t   trace_o
);

  localparam int Depth = vsg_pkg::SegmentBlocks;
  localparam int AddressW = vsg_pkg::PtrW + 1;
  localparam int WordW = vsg_pkg::IntegerBits + AddressW;
  typedef logic [vsg_pkg::PtrAddrW-1:0] address_t;

  typedef enum logic [1:0] {
    StIdle,
    StCheck,
    StWord
  } state_e;

  state_e state_d, state_q;
  vsg_pkg::pixel_t pixel_d, pixel_q, from_d, from_q;
  vsg_pkg::sample_address_t at_d, at_q, last_d, last_q;                         // this line's list
  vsg_pkg::pixel_t next_pixel_d, next_pixel_q, next_last_pixel_d, next_last_pixel_q;
  vsg_pkg::sample_address_t next_first_d, next_first_q, next_last_d, next_last_q;  // the next line's

  logic [WordW-1:0] left_mem  [Depth];
  logic [WordW-1:0] right_mem [Depth];
  logic [WordW-1:0] left_q, right_q, word;
  assign word = at_q.side ? right_q : left_q;

  vsg_pkg::pixel_t word_pixel;
  assign word_pixel = word[WordW-1:AddressW];

  // The first point of a list is kept in registers; later ones are written into the word of the one before.
  logic append;
  assign append = store_i && (next_first_q.block != '0) && (point_i.pixel > next_last_pixel_q);

  logic write_left, write_right;
  address_t write_address;
  logic [WordW-1:0] write_word;
  assign write_left    = clear_i || (append && !next_last_q.side);
  assign write_right   = clear_i || (append && next_last_q.side);
  assign write_address = clear_i ? clear_block_i[vsg_pkg::PtrAddrW-1:0] : next_last_q.block[vsg_pkg::PtrAddrW-1:0];
  assign write_word    = clear_i ? '0 : {point_i.pixel, point_i.address};

  logic read_word;
  assign read_word = (state_q == StCheck);

  always_ff @(posedge clk_i) begin
    if (write_left) left_mem[write_address] <= write_word;
    if (read_word) left_q <= left_mem[at_q.block[vsg_pkg::PtrAddrW-1:0]];
  end
  always_ff @(posedge clk_i) begin
    if (write_right) right_mem[write_address] <= write_word;
    if (read_word) right_q <= right_mem[at_q.block[vsg_pkg::PtrAddrW-1:0]];
  end

  always_comb begin
    state_d           = state_q;
    pixel_d           = pixel_q;
    from_d            = from_q;
    at_d              = at_q;
    last_d            = last_q;
    next_pixel_d      = next_pixel_q;
    next_last_pixel_d = next_last_pixel_q;
    next_first_d      = next_first_q;
    next_last_d       = next_last_q;
    sample_valid_o    = 1'b0;
    sample_o          = pixel_q;
    count_o           = '0;
    trace_o           = '0;
    case (state_q)
      StIdle: begin
        from_d = from_pixel_i;
        if (read_i) state_d = StCheck;
      end
      StCheck: begin
        state_d        = StIdle;
        sample_valid_o = 1'b1;
        if (pixel_q < from_q) begin
          pixel_d  = width_i;
          sample_o = width_i;
          if (at_q != last_q) begin
            sample_valid_o = 1'b0;
            state_d        = StWord;
          end
        end
      end
      StWord: begin
        pixel_d = word_pixel;
        at_d    = word[AddressW-1:0];
        if (word_pixel < from_q || word_pixel > width_i) begin
          count_o.stale_samples = 1'b1;
          pixel_d               = width_i;
          at_d                  = last_q;
        end
        sample_o       = pixel_d;
        sample_valid_o = 1'b1;
        state_d        = StIdle;
      end
      default: state_d = StIdle;
    endcase

    if (store_i) begin
      count_o.samples_stored = 1'b1;
      if (next_first_q.block == '0) begin
        next_first_d = point_i.address;
        next_pixel_d = point_i.pixel;
      end
      if (next_first_q.block == '0 || append) begin
        next_last_d       = point_i.address;
        next_last_pixel_d = point_i.pixel;
        trace_o.valid     = 1'b1;
        trace_o.point     = point_i;
      end
    end
    if (line_start_i) begin
      at_d               = next_first_q;
      last_d             = next_last_q;
      pixel_d            = next_pixel_q;
      next_first_d       = '0;
      next_pixel_d       = width_i;
    end
    if (frame_start_i) begin
      state_d            = StIdle;
      next_first_d       = '0;
      next_last_d        = '0;
      next_pixel_d       = width_i;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q           <= StIdle;
      pixel_q           <= '0;
      from_q            <= '0;
      at_q              <= '0;
      last_q            <= '0;
      next_pixel_q      <= '0;
      next_last_pixel_q <= '0;
      next_first_q      <= '0;
      next_last_q       <= '0;
    end else begin
      state_q           <= state_d;
      pixel_q           <= pixel_d;
      from_q            <= from_d;
      at_q              <= at_d;
      last_q            <= last_d;
      next_pixel_q      <= next_pixel_d;
      next_last_pixel_q <= next_last_pixel_d;
      next_first_q      <= next_first_d;
      next_last_q       <= next_last_d;
    end
  end

endmodule
