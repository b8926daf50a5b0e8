// Counters of a frame: those of the 1970 program (numbers 1 to 25 are those of its Q array) and what it had no counter
// for. The blocks' counts of a cycle are added in the next. A look at a segment begins with `mark` and ends with
// `account`: the references in between tell how long memory would have waited for the clipping registers, and the add
// cycles enter the histogram. Latency: one cycle. Refuses nothing; counters wrap at 2^32.

module tally (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     frame_start_i,
  input  vsg_pkg::count_t          count_i,
  input  logic                     port_access_i,
  // read-out
  input  logic [5:0]               select_i,
  output vsg_pkg::counter_t        counter_o,
  // lock-step: all counters
  output vsg_pkg::counters_t       trace_o
);

  localparam int Slot = 5;  // a counter has 2^5 bits of the packed vector
  localparam int PackedW = vsg_pkg::Counters << Slot;
  localparam int Histogram = 44;  // counter_e's CountAdds
  localparam logic [vsg_pkg::AddW-1:0] MostAdds = vsg_pkg::AddsEntries[vsg_pkg::AddW-1:0];

  logic [PackedW-1:0] step;                // what is added to each counter in this cycle
  logic [PackedW-1:0] counter_d, counter_q;
  vsg_pkg::counter_t marked_d, marked_q;   // references and pipeline when the look began
  vsg_pkg::counter_t now_d, most_q;

  // --- a look at a segment
  vsg_pkg::counter_t references, waited, due;
  logic [vsg_pkg::AddW-1:0] half_up, listed;
  logic [vsg_pkg::AddW:0] add_plus_one;
  assign references   = counter_q[(19 << Slot) +: vsg_pkg::CountW] + counter_q[(20 << Slot) +: vsg_pkg::CountW] +
                        counter_q[(13 << Slot) +: vsg_pkg::CountW];
  assign waited       = references - marked_q;
  assign add_plus_one = {1'b0, count_i.add_cycles} + 1'b1;
  assign half_up      = add_plus_one[vsg_pkg::AddW:1];
  assign due          = {{vsg_pkg::CountW-vsg_pkg::AddW{1'b0}}, half_up};
  always_comb begin
    listed = count_i.add_cycles;
    if (count_i.add_cycles == '0) listed = {{vsg_pkg::AddW-1{1'b0}}, 1'b1};
    if (count_i.add_cycles > MostAdds) listed = MostAdds;
  end

  // --- steps
  always_comb begin
    step = '0;
    step[1 << Slot] = count_i.slopes;
    step[2 << Slot] = count_i.intercepts;
    step[3 << Slot] = count_i.samples_stored;
    step[4 << Slot] = count_i.subdivisions;
    step[6 << Slot] = count_i.depth_tests;
    step[8 << Slot] = count_i.samples_deleted;
    step[9 << Slot] = count_i.steps_back;
    step[10 << Slot] = count_i.output_segments;
    step[11 << Slot] = count_i.intersections;
    step[12 << Slot] = count_i.halvings;
    step[13 << Slot] = count_i.pipeline;
    step[15 << Slot] = count_i.polygon_reads;
    step[16 << Slot] = count_i.polygon_writes;
    step[17 << Slot] = count_i.edge_reads;
    step[18 << Slot] = count_i.edge_writes;
    step[23 << Slot] = count_i.blocks_taken;
    step[24 << Slot] = count_i.blocks_returned;
    step[25 << Slot] = count_i.bucket_reads;
    step[27 << Slot] = count_i.implied_edges;
    step[28 << Slot] = count_i.insertions;
    step[29 << Slot] = count_i.not_at_end;
    step[32 << Slot] = count_i.stale_samples;
    step[33 << Slot] = count_i.unclosed_polygons;
    step[37 << Slot] = count_i.involved_lines;
    step[38 << Slot] = count_i.polygons;
    step[39 << Slot] = count_i.front_polygons;
    step[40 << Slot] = count_i.edges;
    step[41 << Slot] = count_i.front_edges;
    step[42 << Slot] = count_i.entered_edges;
    step[43 << Slot] = port_access_i;
    step[(19 << Slot) +: 2] = count_i.segment_reads;
    step[(20 << Slot) +: 2] = count_i.segment_writes;
    step[(26 << Slot) + 1] = count_i.crossings;  // two edges
    if (count_i.account && due > waited) step[(14 << Slot) +: vsg_pkg::CountW] = due - waited;
    if (count_i.account && count_i.tested) step[(30 << Slot) +: vsg_pkg::AddW] = count_i.add_cycles;
    if (count_i.account) step[(31 << Slot) +: vsg_pkg::AddW] = listed;
    if (count_i.blocks_taken && !count_i.blocks_returned) step[34 << Slot] = 1'b1;
    if (count_i.blocks_returned && !count_i.blocks_taken) step[(34 << Slot) +: vsg_pkg::CountW] = '1;
    step[(36 << Slot) +: vsg_pkg::CountW] = {
        {vsg_pkg::CountW-vsg_pkg::IntegerBits{count_i.density[vsg_pkg::IntegerBits-1]}}, count_i.density};
    for (int unsigned i = 0; i < vsg_pkg::AddsEntries; i++) begin
      step[(Histogram + i) << Slot] = count_i.account && (listed == i[vsg_pkg::AddW-1:0] + 1'b1);
    end
  end

  assign now_d  = counter_q[(34 << Slot) +: vsg_pkg::CountW] + step[(34 << Slot) +: vsg_pkg::CountW];
  assign most_q = counter_q[(35 << Slot) +: vsg_pkg::CountW];

  always_comb begin
    for (int unsigned i = 0; i < vsg_pkg::Counters; i++) begin
      counter_d[(i << Slot) +: vsg_pkg::CountW] =
          counter_q[(i << Slot) +: vsg_pkg::CountW] + step[(i << Slot) +: vsg_pkg::CountW];
    end
    if (now_d > most_q) counter_d[(35 << Slot) +: vsg_pkg::CountW] = now_d;
    marked_d = count_i.mark ? references : marked_q;
    if (frame_start_i) counter_d = '0;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      counter_q <= '0;
      marked_q  <= '0;
    end else begin
      counter_q <= counter_d;
      marked_q  <= marked_d;
    end
  end

  assign counter_o = counter_q[{select_i, {Slot{1'b0}}} +: vsg_pkg::CountW];
  assign trace_o   = counter_q;

endmodule
