// Memory of one element: one port, which reads or writes in a cycle. The byte comes in the same cycle. Addresses beyond
// the memory read zero and are not written.

module pixel_memory (
  input  logic                  clk_i,
  input  pixelflow_pkg::byte_t  addr_i,
  input  logic                  re_i,
  output pixelflow_pkg::byte_t  rdata_o,
  input  logic                  we_i,
  input  pixelflow_pkg::byte_t  wdata_i
);

  localparam logic [8:0] LastAddress = 9'(pixelflow_pkg::MemoryBytes - 1);

  logic [7:0] bytes_mem [pixelflow_pkg::MemoryBytes];

  logic beyond;
  assign beyond  = ({1'b0, addr_i} > LastAddress);
  assign rdata_o = (re_i && !beyond) ? bytes_mem[addr_i] : '0;

  always_ff @(posedge clk_i) begin
    if (we_i && !beyond) bytes_mem[addr_i] <= wdata_i;
  end

endmodule
