// Takes instructions from the stream and gives them to all elements: each for one cycle, a multiplication once for
// every digit of the multiplier, where the zero digits of an immediate multiplier are left out (but for one when all
// are zero). Control instructions act here. Instructions are taken from `start_i` to the End that follows; then
// `done_o` holds. An instruction that has to wait holds up what follows: WaitInbound until packets have arrived, Send
// and a write to the outbound packet while the last ones are still being sent. Latency: none; refuses the stream while
// it waits or is done.

module instruction_sequencer (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // from and to the host
  input  logic                         start_i,
  output logic                         done_o,
  // cycles since the start: executed ones, and waits for the stream, for inbound packets, for outbound ones
  output pixelflow_pkg::count_t        executed_o,
  output pixelflow_pkg::count_t        stream_waits_o,
  output pixelflow_pkg::count_t        inbound_waits_o,
  output pixelflow_pkg::count_t        send_waits_o,
  output pixelflow_pkg::count_t        instructions_o,   // taken from the stream
  // from the stream buffer
  input  logic                         valid_i,
  input  pixelflow_pkg::instruction_t  instruction_i,
  output logic                         ready_o,
  // to the elements
  output logic                         execute_o,
  output pixelflow_pkg::instruction_t  instruction_o,
  output pixelflow_pkg::digit_t        digit_o,
  // to and from the communication buffer
  input  logic                         arrived_i,
  output logic                         free_o,
  input  logic                         sending_i,
  output logic                         send_o
);

  localparam int unsigned R      = pixelflow_pkg::MultiplierBits;
  localparam int unsigned Digits = pixelflow_pkg::Digits;

  logic is_multiply, is_control, is_inbound, needs_outbound;
  assign is_multiply    = (instruction_i.kind == pixelflow_pkg::KindWide) &&
                          (instruction_i.fn == pixelflow_pkg::WideMultiply);
  assign is_control     = (instruction_i.kind == pixelflow_pkg::KindControl);
  assign is_inbound     = is_control && (instruction_i.fn == pixelflow_pkg::ControlWaitInbound);
  assign needs_outbound = (is_control && (instruction_i.fn == pixelflow_pkg::ControlSend)) ||
                          (instruction_i.kind == pixelflow_pkg::KindAlu &&
                           instruction_i.dest == pixelflow_pkg::ToPort);

  // Digits still to be worked off; the lowest is next.
  logic [Digits-1:0] wanted, worked_q, pending, next, left;
  pixelflow_pkg::digit_t digit;
  logic is_last;
  always_comb begin
    wanted = '0;
    for (int unsigned d = 0; d < Digits; d++) begin
      wanted[d] = is_multiply && (instruction_i.p != pixelflow_pkg::PImmediate || instruction_i.imm[d*R +: R] != '0);
    end
    if (wanted == '0) wanted[0] = 1'b1;
    pending = wanted & ~worked_q;
    next    = pending & (~pending + 1'b1);
    left    = pending & ~next;
    digit   = '0;
    for (int unsigned d = 0; d < Digits; d++) begin
      if (next[d]) digit = pixelflow_pkg::DigitWidth'(d);
    end
    is_last = (left == '0);
  end

  logic running_q, takes, waits_stream, waits_inbound, waits_send, is_end;
  assign waits_stream  = running_q && !valid_i;
  assign waits_inbound = running_q && valid_i && is_inbound && !arrived_i;
  assign waits_send    = running_q && valid_i && needs_outbound && sending_i;
  assign execute_o     = running_q && valid_i && !waits_inbound && !waits_send;
  assign takes         = execute_o && is_last;
  assign ready_o       = takes;
  assign instruction_o = instruction_i;
  assign digit_o       = digit;
  assign is_end        = is_control && (instruction_i.fn == pixelflow_pkg::ControlEnd);
  assign free_o        = execute_o && is_control && (instruction_i.fn == pixelflow_pkg::ControlFreeInbound);
  assign send_o        = execute_o && is_control && (instruction_i.fn == pixelflow_pkg::ControlSend);

  pixelflow_pkg::count_t executed_q, stream_waits_q, inbound_waits_q, send_waits_q, instructions_q;
  logic done_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      running_q       <= 1'b0;
      done_q          <= 1'b0;
      worked_q        <= '0;
      executed_q      <= '0;
      stream_waits_q  <= '0;
      inbound_waits_q <= '0;
      send_waits_q    <= '0;
      instructions_q  <= '0;
    end else if (start_i) begin
      running_q       <= 1'b1;
      done_q          <= 1'b0;
      worked_q        <= '0;
      executed_q      <= '0;
      stream_waits_q  <= '0;
      inbound_waits_q <= '0;
      send_waits_q    <= '0;
      instructions_q  <= '0;
    end else begin
      if (takes) worked_q <= '0;
      else if (execute_o) worked_q <= worked_q | next;
      if (takes && is_end) begin
        running_q <= 1'b0;
        done_q    <= 1'b1;
      end
      if (execute_o) executed_q <= executed_q + 1'b1;
      if (waits_stream) stream_waits_q <= stream_waits_q + 1'b1;
      if (waits_inbound) inbound_waits_q <= inbound_waits_q + 1'b1;
      if (waits_send) send_waits_q <= send_waits_q + 1'b1;
      if (takes) instructions_q <= instructions_q + 1'b1;
    end
  end

  assign done_o          = done_q;
  assign executed_o      = executed_q;
  assign stream_waits_o  = stream_waits_q;
  assign inbound_waits_o = inbound_waits_q;
  assign send_waits_o    = send_waits_q;
  assign instructions_o  = instructions_q;

endmodule
