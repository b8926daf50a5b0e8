// Buffer of the instruction stream (section 6.1.6: the stream is buffered for later execution): first in, first out. A
// word that comes in one cycle is offered in the next. Refuses words when it is full.

module stream_buffer #(
  parameter int unsigned Words = pixelflow_pkg::StreamWords   // a power of two
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // from the host
  input  logic                         valid_i,
  input  pixelflow_pkg::instruction_t  instruction_i,
  output logic                         ready_o,
  // to the instruction sequencer
  output logic                         valid_o,
  output pixelflow_pkg::instruction_t  instruction_o,
  input  logic                         ready_i
);

  localparam int unsigned AddressWidth = $clog2(Words);
  localparam logic [AddressWidth:0] Full = (AddressWidth + 1)'(Words);

  logic [$bits(instruction_i)-1:0] words_mem [Words];
  logic [AddressWidth:0] written_q, read_q;   // one bit more than an address tells full from empty

  assign ready_o       = (written_q - read_q != Full);
  assign valid_o       = (written_q != read_q);
  assign instruction_o = words_mem[read_q[AddressWidth-1:0]];

  always_ff @(posedge clk_i) begin
    if (valid_i && ready_o) words_mem[written_q[AddressWidth-1:0]] <= instruction_i;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      written_q <= '0;
      read_q    <= '0;
    end else begin
      if (valid_i && ready_o) written_q <= written_q + 1'b1;
      if (valid_o && ready_i) read_q <= read_q + 1'b1;
    end
  end

endmodule
