// The compositor of a chip (section 5.1: pixels are combined as they pass from node to node, by a visibility test):
// takes a packet of its own element and one from the chip of the node before for the same element, and passes on the
// closer one. Depth is the first bytes of a packet, unsigned, least significant first; smaller is closer, and equal
// depth goes to the packet from upstream, so that the order of the nodes alone decides. Final colours travel without
// compositing. The mode may change while nothing is on its way. Latency: one cycle, a packet a cycle. Refuses what it
// cannot pass on.

module composition_port #(
  parameter int unsigned Lanes = pixelflow_pkg::Elements
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic [1:0]               mode_i,            // pixelflow_pkg::compose_e
  // from the communication buffer
  input  logic                     own_valid_i,
  input  pixelflow_pkg::packet_t   own_packet_i,
  output logic                     own_ready_o,
  // from the node before
  input  logic                     upstream_valid_i,
  input  pixelflow_pkg::packet_t   upstream_packet_i,
  output logic                     upstream_ready_o,
  // to the node behind
  output logic                     valid_o,
  output pixelflow_pkg::packet_t   packet_o,
  input  logic                     ready_i
);

  localparam pixelflow_pkg::lane_t LastLane = pixelflow_pkg::LaneWidth'(Lanes - 1);

  // What won last, an element a bit: further packets of a pixel follow its first.
  logic [Lanes-1:0] own_won_q;
  pixelflow_pkg::lane_t lane_q;

  logic [8*pixelflow_pkg::DepthBytes-1:0] own_depth, upstream_depth;
  logic own_closer, own_wins, needs_own, needs_upstream, present, room, passes;
  assign own_depth      = own_packet_i.depth;
  assign upstream_depth = upstream_packet_i.depth;
  assign own_closer     = (own_depth < upstream_depth);

  always_comb begin
    case (mode_i)
      pixelflow_pkg::ComposeOwn:    own_wins = 1'b1;
      pixelflow_pkg::ComposeCloser: own_wins = own_closer;
      pixelflow_pkg::ComposeRepeat: own_wins = own_won_q[lane_q];
      default:                      own_wins = 1'b0;
    endcase
  end
  assign needs_own      = (mode_i != pixelflow_pkg::ComposeUpstream);
  assign needs_upstream = (mode_i != pixelflow_pkg::ComposeOwn);
  assign present        = (own_valid_i || !needs_own) && (upstream_valid_i || !needs_upstream);

  logic valid_q;
  pixelflow_pkg::packet_t packet_q;
  assign room             = !valid_q || ready_i;
  assign passes           = present && room;
  assign own_ready_o      = passes && needs_own;
  assign upstream_ready_o = passes && needs_upstream;

  always_ff @(posedge clk_i) begin
    if (passes) packet_q <= own_wins ? own_packet_i : upstream_packet_i;
    if (passes && mode_i == pixelflow_pkg::ComposeCloser) own_won_q[lane_q] <= own_closer;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q <= 1'b0;
      lane_q  <= '0;
    end else begin
      if (room) valid_q <= present;
      if (passes) lane_q <= (lane_q == LastLane) ? '0 : lane_q + 1'b1;
    end
  end

  assign valid_o  = valid_q;
  assign packet_o = packet_q;

endmodule
