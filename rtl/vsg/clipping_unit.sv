// Arithmetic unit of the Depth Comparator (chapter III.G, figures 12, 13 and 21) and the visible box. A segment is tried
// against the box: loaded into two quadrants, the box into the other two, and clipped until the gates decide. To find an
// intersection the two segments are tried again with ten places more, and the two X and two Z registers of figure 21
// close in on the crossing. Adders, comparators and shifts by one place.
//
// Latency: 3 cycles and one an add cycle; `add_cycles_o` counts as the paper does (loading and clipping cycles).
// Refuses nothing. Longer than a module should be: the registers of figure 12 are loaded, judged and read in one place.

module clipping_unit (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  input  logic                    frame_start_i,    // nothing is left of the frame before
  // from the depth comparator
  input  logic                    clear_i,          // a span begins: the box is empty
  input  logic                    start_i,
  input  vsg_pkg::candidate_t     candidate_i,
  input  logic                    from_x_sort_i,    // held until done_o
  input  logic                    searching_i,      // held until done_o
  output logic                    done_o,
  input  logic                    account_i,        // the look is over: the count is clamped as the listing clamps it
  output logic [vsg_pkg::AddW-1:0] add_cycles_o,
  output vsg_pkg::x_t             crossing_o,
  // from the sample space generator
  input  vsg_pkg::span_t          span_i,
  // to the depth comparator and the decision processor
  output vsg_pkg::box_t           box_o,
  // lock-step
  output vsg_pkg::trace_test_t    trace_o
);

  typedef enum logic [2:0] {
    StIdle,
    StLoad,
    StClip,
    StGrow,
    StSearchLoad,
    StSearch,
    StDone
  } state_e;

  localparam logic [vsg_pkg::AddW-1:0] MostAdds = vsg_pkg::AddsEntries[vsg_pkg::AddW-1:0];

  state_e state_d, state_q;
  vsg_pkg::candidate_t candidate_d, candidate_q;
  vsg_pkg::box_t box_d, box_q, grown;
  vsg_pkg::outcome_e outcome_d, outcome_q;
  logic [vsg_pkg::AddW-1:0] add_cycles_d, add_cycles_q;
  vsg_pkg::halving_t halvings_d, halvings_q;
  vsg_pkg::pixel_t left_d, left_q, right_d, right_q;        // candidate clipped to the span
  logic left_le_d, left_le_q, left_ge_d, left_ge_q, right_le_d, right_le_q, right_ge_d, right_ge_q;
  vsg_pkg::x_t left_clip_d, left_clip_q, right_clip_d, right_clip_q;
  logic nl_d, nl_q, ol_d, ol_q, nr_d, nr_q, or_d, or_q;     // behind at the left and right clip point, last add cycle

  // --- loading

  vsg_pkg::pixel_t x_left_pixel, x_right_pixel, span_left, span_right, left, right, box_left, box_right;
  assign x_left_pixel  = vsg_pkg::pixel_of(candidate_q.x_left);
  assign x_right_pixel = vsg_pkg::pixel_of(candidate_q.x_right);
  assign span_left     = span_i.left;
  assign span_right    = span_i.right;
  assign left          = (x_left_pixel > span_left) ? x_left_pixel : span_left;
  assign right         = (x_right_pixel < span_right) ? x_right_pixel : span_right;
  assign box_left      = box_q.left;
  assign box_right     = box_q.right;

  logic left_le, left_ge, right_le, right_ge, disjoint_ends;
  assign left_le       = (left <= box_left);
  assign left_ge       = (left >= box_left);
  assign right_le      = (right <= box_right);
  assign right_ge      = (right >= box_right);
  assign disjoint_ends = (!left_ge && !right_ge) || (!left_le && !right_le);

  vsg_pkg::x_t left_clip, right_clip;
  assign left_clip  = {left_le ? box_left : left, {vsg_pkg::FracX{1'b0}}};
  assign right_clip = {right_ge ? box_right : right, {vsg_pkg::FracX{1'b0}}};

  vsg_pkg::z_t z_left, z_right, z_min, z_max;
  logic rising;
  assign z_left  = candidate_q.z_left;
  assign z_right = candidate_q.z_right;
  assign rising  = (z_left < z_right);
  assign z_min   = rising ? z_left : z_right;
  assign z_max   = rising ? z_right : z_left;

  vsg_pkg::pixel_t width;
  vsg_pkg::halving_t extent;
  assign width  = x_right_pixel - x_left_pixel;
  assign extent = searching_i ? {width, {vsg_pkg::SearchShift{1'b0}}} : {{vsg_pkg::SearchShift{1'b0}}, width};

  // A box of several segments is loaded as the diagonal that falls against the new line.
  logic one, old_rising;
  vsg_pkg::z_t old_left_min, old_left_max, old_right_min, old_right_max;
  assign one           = (box_q.segments == {{vsg_pkg::BoxW-1{1'b0}}, 1'b1});
  assign old_rising    = one ? box_q.rising : !rising;
  assign old_left_min  = (one || !rising) ? box_q.z_min : box_q.z_max;
  assign old_left_max  = (one || rising) ? box_q.z_max : box_q.z_min;
  assign old_right_min = (one || rising) ? box_q.z_min : box_q.z_max;
  assign old_right_max = (one || !rising) ? box_q.z_max : box_q.z_min;

  // --- the four quadrants

  logic load, step;
  vsg_pkg::z_t nl_min, nl_max, nr_min, nr_max, ol_min, ol_max, or_min, or_max;
  logic new_rising, new_rising_right, kept_rising, kept_rising_right;

  clip_quadrant u_new_left (
    .clk_i, .rst_ni, .load_i(load), .step_i(step),
    .x_left_i(candidate_q.x_left - left_clip), .x_right_i(candidate_q.x_right - left_clip),
    .z_min_i(z_min), .z_max_i(z_max), .rising_i(rising),
    .z_min_o(nl_min), .z_max_o(nl_max), .rising_o(new_rising)
  );
  clip_quadrant u_new_right (
    .clk_i, .rst_ni, .load_i(load), .step_i(step),
    .x_left_i(candidate_q.x_left - right_clip), .x_right_i(candidate_q.x_right - right_clip),
    .z_min_i(z_min), .z_max_i(z_max), .rising_i(rising),
    .z_min_o(nr_min), .z_max_o(nr_max), .rising_o(new_rising_right)
  );
  clip_quadrant u_old_left (
    .clk_i, .rst_ni, .load_i(load), .step_i(step),
    .x_left_i(box_q.x_left - left_clip), .x_right_i(box_q.x_right - left_clip),
    .z_min_i(old_left_min), .z_max_i(old_left_max), .rising_i(old_rising),
    .z_min_o(ol_min), .z_max_o(ol_max), .rising_o(kept_rising)
  );
  clip_quadrant u_old_right (
    .clk_i, .rst_ni, .load_i(load), .step_i(step),
    .x_left_i(box_q.x_left - right_clip), .x_right_i(box_q.x_right - right_clip),
    .z_min_i(old_right_min), .z_max_i(old_right_max), .rising_i(old_rising),
    .z_min_o(or_min), .z_max_o(or_max), .rising_o(kept_rising_right)
  );
  logic unused_signs;
  assign unused_signs = &{1'b0, new_rising, new_rising_right, kept_rising_right};  // as loaded

  vsg_pkg::verdict_e verdict;
  logic nl, ol, nr, olr;
  assign nl  = (nl_min >= ol_max);
  assign ol  = (ol_min >= nl_max);
  assign nr  = (nr_min >= or_max);
  assign olr = (or_min >= nr_max);

  clip_verdict u_verdict (
    .new_left_le_i(left_le_q), .new_left_ge_i(left_ge_q), .new_right_le_i(right_le_q), .new_right_ge_i(right_ge_q),
    .new_behind_left_i(nl), .old_behind_left_i(ol), .new_behind_right_i(nr), .old_behind_right_i(olr),
    .exhausted_i(halvings_q == '0), .verdict_o(verdict)
  );

  box_growth u_growth (
    .box_i(box_q), .candidate_i(candidate_q), .left_i(left_q), .right_i(right_q),
    .same_i(left_le_q && left_ge_q && right_le_q && right_ge_q), .left_le_i(left_le_q), .right_ge_i(right_ge_q),
    .new_left_min_i(nl_min), .new_left_max_i(nl_max), .new_right_min_i(nr_min), .new_right_max_i(nr_max),
    .old_left_min_i(ol_min), .old_left_max_i(ol_max), .old_right_min_i(or_min), .old_right_max_i(or_max),
    .new_rising_i(rising), .old_rising_i(kept_rising),
    .new_behind_left_i(nl_q), .old_behind_left_i(ol_q), .new_behind_right_i(nr_q), .old_behind_right_i(or_q),
    .box_o(grown)
  );

  // --- figure 21

  logic search_load, search_step, search_finished;
  crossing_search u_search (
    .clk_i, .rst_ni, .load_i(search_load), .x_left_i(left_clip_q), .x_right_i(right_clip_q),
    .z_left_i({nl_min[vsg_pkg::ZW-1], nl_min} - {ol_min[vsg_pkg::ZW-1], ol_min}),
    .z_right_i({nr_min[vsg_pkg::ZW-1], nr_min} - {or_min[vsg_pkg::ZW-1], or_min}),
    .step_i(search_step), .finished_o(search_finished), .crossing_o
  );

  logic replaces;
  vsg_pkg::box_t replaced;
  always_comb begin
    replaced             = box_q;
    replaced.segments    = '0;
    replaced.segments[0] = 1'b1;
    replaced.x_left      = candidate_q.x_left;
    replaced.x_right     = candidate_q.x_right;
    replaced.z_min       = z_min;
    replaced.z_max       = z_max;
    replaced.left        = (state_q == StLoad) ? left : left_q;
    replaced.right       = (state_q == StLoad) ? right : right_q;
    replaced.edge_inside = candidate_q.edge_inside;
    replaced.front         = candidate_q.block;
    replaced.front_polygon = candidate_q.polygon;
    replaced.rising        = rising;
    replaced.halvings      = extent;
  end

  always_comb begin
    state_d      = state_q;
    candidate_d  = candidate_q;
    box_d        = box_q;
    outcome_d    = outcome_q;
    add_cycles_d = add_cycles_q;
    halvings_d   = halvings_q;
    left_d       = left_q;
    right_d      = right_q;
    left_le_d    = left_le_q;
    left_ge_d    = left_ge_q;
    right_le_d   = right_le_q;
    right_ge_d   = right_ge_q;
    left_clip_d  = left_clip_q;
    right_clip_d = right_clip_q;
    nl_d         = nl_q;
    ol_d         = ol_q;
    nr_d         = nr_q;
    or_d         = or_q;
    load         = 1'b0;
    step         = 1'b0;
    search_load  = 1'b0;
    search_step  = 1'b0;
    replaces     = 1'b0;
    case (state_q)
      StIdle: begin
        candidate_d = candidate_i;
        if (start_i) state_d = StLoad;
      end
      StLoad: begin
        add_cycles_d = {{vsg_pkg::AddW-2{1'b0}}, from_x_sort_i, !from_x_sort_i};
        left_d       = left;
        right_d      = right;
        left_le_d    = left_le;
        left_ge_d    = left_ge;
        right_le_d   = right_le;
        right_ge_d   = right_ge;
        halvings_d   = (extent < box_q.halvings) ? box_q.halvings : extent;
        if (box_q.segments == '0) begin
          outcome_d = vsg_pkg::OutcomeFirst;
          replaces  = 1'b1;
          state_d   = StDone;
        end else if (disjoint_ends) begin
          outcome_d = vsg_pkg::OutcomeBoxed;
          state_d   = searching_i ? StSearchLoad : StGrow;
        end else begin
          load         = 1'b1;
          left_clip_d  = left_clip;
          right_clip_d = right_clip;
          state_d      = StClip;
        end
      end
      StClip: begin
        add_cycles_d = add_cycles_q + 1'b1;
        nl_d         = nl;
        ol_d         = ol;
        nr_d         = nr;
        or_d         = olr;
        case (verdict)
          vsg_pkg::VerdictNewInFront: begin
            outcome_d = vsg_pkg::OutcomeReplaces;
            replaces  = 1'b1;
            state_d   = StDone;
          end
          vsg_pkg::VerdictBoxed: begin
            outcome_d = vsg_pkg::OutcomeBoxed;
            state_d   = searching_i ? StSearchLoad : StGrow;
          end
          vsg_pkg::VerdictNewBehind: begin
            outcome_d = vsg_pkg::OutcomeHidden;
            state_d   = StDone;
          end
          default: begin
            step       = 1'b1;
            halvings_d = {1'b0, halvings_q[vsg_pkg::HalvingW-1:1]};
          end
        endcase
      end
      StGrow: begin
        box_d   = grown;
        state_d = StDone;
      end
      StSearchLoad: begin
        box_d.segments = box_q.segments + 1'b1;
        search_load    = 1'b1;
        state_d        = StSearch;
      end
      StSearch: begin
        search_step  = !search_finished;
        add_cycles_d = search_finished ? add_cycles_q : add_cycles_q + 1'b1;
        if (search_finished) state_d = StDone;
      end
      StDone: state_d = StIdle;
      default: state_d = StIdle;
    endcase
    if (replaces) box_d = replaced;
    if (clear_i) box_d.segments = '0;
    if (account_i) begin
      if (add_cycles_q == '0) add_cycles_d[0] = 1'b1;
      if (add_cycles_q > MostAdds) add_cycles_d = MostAdds;
    end
    if (frame_start_i) begin
      state_d      = StIdle;
      box_d        = '0;
      add_cycles_d = '0;
      left_clip_d  = '0;
      right_clip_d = '0;
      nl_d         = 1'b0;
      ol_d         = 1'b0;
      nr_d         = 1'b0;
      or_d         = 1'b0;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q      <= StIdle;
      candidate_q  <= '0;
      box_q        <= '0;
      outcome_q    <= vsg_pkg::OutcomeHidden;
      add_cycles_q <= '0;
      halvings_q   <= '0;
      left_q       <= '0;
      right_q      <= '0;
      {left_le_q, left_ge_q, right_le_q, right_ge_q} <= '0;
      left_clip_q  <= '0;
      right_clip_q <= '0;
      {nl_q, ol_q, nr_q, or_q} <= '0;
    end else begin
      state_q      <= state_d;
      candidate_q  <= candidate_d;
      box_q        <= box_d;
      outcome_q    <= outcome_d;
      add_cycles_q <= add_cycles_d;
      halvings_q   <= halvings_d;
      left_q       <= left_d;
      right_q      <= right_d;
      {left_le_q, left_ge_q, right_le_q, right_ge_q} <= {left_le_d, left_ge_d, right_le_d, right_ge_d};
      left_clip_q  <= left_clip_d;
      right_clip_q <= right_clip_d;
      {nl_q, ol_q, nr_q, or_q} <= {nl_d, ol_d, nr_d, or_d};
    end
  end

  assign done_o       = (state_q == StDone);
  assign box_o        = box_q;
  assign add_cycles_o = add_cycles_q;

  always_comb begin
    trace_o              = '0;
    trace_o.valid        = done_o;
    trace_o.block        = candidate_q.block;
    trace_o.from_x_sort  = from_x_sort_i;
    trace_o.intersecting = searching_i;
    trace_o.outcome      = outcome_q;
    trace_o.add_cycles   = add_cycles_q;
    trace_o.box          = box_q;
    trace_o.span         = span_i;
  end

endmodule
