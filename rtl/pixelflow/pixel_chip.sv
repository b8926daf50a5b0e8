// One chip of the array (section 5.1; 32 of 256 elements make a region of 128 x 64): stream buffer, instruction
// sequencer, elements in row form, communication buffer and composition port. Element i of chip c is sample c *
// Elements + i of the region, row after row, unless another place is loaded. Planes A x + B y + C have no adder tree
// here: an element reads its column and row, and microcode multiplies by uniform factors where planes are wanted.
// Latency: a word of the stream is executed in the cycle after it is taken at the earliest. Refuses what its parts
// refuse.

module pixel_chip (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // from and to the host
  input  logic                         start_i,
  output logic                         done_o,
  output pixelflow_pkg::count_t        executed_o,
  output pixelflow_pkg::count_t        stream_waits_o,
  output pixelflow_pkg::count_t        inbound_waits_o,
  output pixelflow_pkg::count_t        send_waits_o,
  output pixelflow_pkg::count_t        instructions_o,
  input  logic                         stream_valid_i,
  input  pixelflow_pkg::instruction_t  stream_instruction_i,
  output logic                         stream_ready_o,
  // places in the region; those of the chip's number come with the first cycle after reset
  input  logic [7:0]                   chip_i,
  input  logic                         place_i,
  input  pixelflow_pkg::lane_t         place_lane_i,
  input  pixelflow_pkg::byte_t         place_column_i,
  input  pixelflow_pkg::byte_t         place_row_i,
  // from the load port: inbound packets, element after element
  input  logic                         load_valid_i,
  input  pixelflow_pkg::packet_t       load_packet_i,
  output logic                         load_ready_o,
  // the composition network: from the node before, to the node behind
  input  logic [1:0]                   compose_i,      // pixelflow_pkg::compose_e
  input  logic                         upstream_valid_i,
  input  pixelflow_pkg::packet_t       upstream_packet_i,
  output logic                         upstream_ready_o,
  output logic                         valid_o,
  output pixelflow_pkg::packet_t       packet_o,
  input  logic                         ready_i,
  output logic                         sending_o,
  // trace: what the elements do in this cycle
  output logic                         trace_execute_o,
  output pixelflow_pkg::instruction_t  trace_instruction_o,
  output pixelflow_pkg::digit_t        trace_digit_o
);

  logic buffered_valid, buffered_ready, execute, arrived, free, sending, send;
  pixelflow_pkg::instruction_t buffered, instruction;
  pixelflow_pkg::digit_t digit;

  stream_buffer stream (
    .clk_i, .rst_ni,
    .valid_i(stream_valid_i), .instruction_i(stream_instruction_i), .ready_o(stream_ready_o),
    .valid_o(buffered_valid), .instruction_o(buffered), .ready_i(buffered_ready)
  );

  instruction_sequencer sequencer (
    .clk_i, .rst_ni, .start_i, .done_o,
    .executed_o, .stream_waits_o, .inbound_waits_o, .send_waits_o, .instructions_o,
    .valid_i(buffered_valid), .instruction_i(buffered), .ready_o(buffered_ready),
    .execute_o(execute), .instruction_o(instruction), .digit_o(digit),
    .arrived_i(arrived), .free_o(free), .sending_i(sending), .send_o(send)
  );

  logic inbound_we, outbound_re, own_valid, own_ready;
  pixelflow_pkg::lane_t inbound_lane, outbound_lane;
  pixelflow_pkg::packet_t own_packet;
  communication_buffer communication (
    .clk_i, .rst_ni, .load_valid_i, .load_ready_o,
    .inbound_we_o(inbound_we), .inbound_lane_o(inbound_lane),
    .outbound_re_o(outbound_re), .outbound_lane_o(outbound_lane),
    .arrived_o(arrived), .free_i(free), .sending_o(sending), .send_i(send),
    .own_valid_o(own_valid), .own_ready_i(own_ready)
  );

  logic placed_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) placed_q <= 1'b0;
    else placed_q <= 1'b1;
  end

  pixel_row elements (
    .clk_i, .rst_ni, .execute_i(execute), .instruction_i(instruction), .digit_i(digit),
    .place_all_i(!placed_q), .chip_i, .place_i, .place_lane_i, .place_column_i, .place_row_i,
    .inbound_we_i(inbound_we), .inbound_lane_i(inbound_lane), .inbound_packet_i(load_packet_i),
    .outbound_re_i(outbound_re), .outbound_lane_i(outbound_lane), .outbound_packet_o(own_packet)
  );

  composition_port composition (
    .clk_i, .rst_ni, .mode_i(compose_i),
    .own_valid_i(own_valid), .own_packet_i(own_packet), .own_ready_o(own_ready),
    .upstream_valid_i, .upstream_packet_i, .upstream_ready_o,
    .valid_o, .packet_o, .ready_i
  );

  assign sending_o           = sending;
  assign trace_execute_o     = execute;
  assign trace_instruction_o = instruction;
  assign trace_digit_o       = digit;

endmodule
