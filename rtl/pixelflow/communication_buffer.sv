// The communication buffers of a chip: one inbound and one outbound packet an element. The bytes lie beside the
// elements (pixel_row); here is who may touch them. Inbound packets come lane after lane, one a beat, until every
// element has its own; then none is taken until FreeInbound. Send hands the outbound packets over, and they go out lane
// after lane, one a beat; the sequencer holds up whoever would write them meanwhile. Latency: an outbound packet is
// offered one cycle after it is asked for. Refuses inbound packets while they are not free.

module communication_buffer #(
  parameter int unsigned Lanes = pixelflow_pkg::Elements
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  // from the load port
  input  logic                    load_valid_i,
  output logic                    load_ready_o,
  // to the elements: take and give packets
  output logic                    inbound_we_o,
  output pixelflow_pkg::lane_t    inbound_lane_o,
  output logic                    outbound_re_o,
  output pixelflow_pkg::lane_t    outbound_lane_o,
  // from and to the instruction sequencer
  output logic                    arrived_o,
  input  logic                    free_i,
  output logic                    sending_o,
  input  logic                    send_i,
  // to the composition port
  output logic                    own_valid_o,
  input  logic                    own_ready_i
);

  localparam pixelflow_pkg::lane_t LastLane = pixelflow_pkg::LaneWidth'(Lanes - 1);

  // Inbound.
  logic arrived_q;
  pixelflow_pkg::lane_t inbound_lane_q;
  assign load_ready_o   = !arrived_q;
  assign inbound_we_o   = load_valid_i && !arrived_q;
  assign inbound_lane_o = inbound_lane_q;
  assign arrived_o      = arrived_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      arrived_q      <= 1'b0;
      inbound_lane_q <= '0;
    end else begin
      if (free_i) arrived_q <= 1'b0;
      if (inbound_we_o) begin
        inbound_lane_q <= (inbound_lane_q == LastLane) ? '0 : inbound_lane_q + 1'b1;
        if (inbound_lane_q == LastLane) arrived_q <= 1'b1;
      end
    end
  end

  // Outbound: asked for while the packet before it leaves, so that one goes out in every cycle.
  logic reading_q, offered_q;
  pixelflow_pkg::lane_t reading_lane_q;
  assign outbound_re_o   = reading_q && (!offered_q || own_ready_i);
  assign outbound_lane_o = reading_lane_q;
  assign own_valid_o     = offered_q;
  assign sending_o       = reading_q || offered_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      reading_q      <= 1'b0;
      reading_lane_q <= '0;
      offered_q      <= 1'b0;
    end else begin
      if (send_i) reading_q <= 1'b1;
      if (outbound_re_o) begin
        offered_q      <= 1'b1;
        reading_lane_q <= (reading_lane_q == LastLane) ? '0 : reading_lane_q + 1'b1;
        if (reading_lane_q == LastLane) reading_q <= 1'b0;
      end else if (own_ready_i) begin
        offered_q <= 1'b0;
      end
    end
  end

endmodule
