// Edge blocks (figure 4), sorted by the scan line they enter on: a bucket a line, last in, first out. Loading takes an edge
// block through valid/ready, up to five cycles each: the polygons that it bounds are looked at, and edges that bound no
// front polygon or are horizontal are counted and rejected, not stored. Latency of the readers: one cycle. Refuses: an
// edge outside the scan lines of the frame, more edges than there are numbers (error_o, held until the next frame).

module edge_memory (
  input  logic                clk_i,
  input  logic                rst_ni,
  // frame: buckets are cleared, a cycle a line, before the first edge is taken
  input  logic                frame_start_i,
  input  vsg_pkg::line_t      height_i,
  output logic                clearing_o,
  // load
  input  logic                load_valid_i,
  output logic                load_ready_o,
  input  vsg_pkg::edge_t      load_edge_i,
  output logic                loading_o,       // an edge is being looked at
  output vsg_pkg::error_e     error_o,
  // to the polygon memory
  output logic                polygon_read_o,
  output vsg_pkg::poly_ptr_t  polygon_o,
  input  logic                polygon_front_i,
  // from the segment generator
  input  logic                bucket_read_i,
  input  vsg_pkg::line_t      bucket_line_i,
  output vsg_pkg::edge_ptr_t  bucket_edge_o,
  input  logic                edge_read_i,
  input  vsg_pkg::edge_ptr_t  edge_number_i,
  output vsg_pkg::edge_t      edge_o,
  output vsg_pkg::edge_ptr_t  edge_next_o,
  // to the tally
  output vsg_pkg::count_t     count_o
);

  localparam int Lines = 1 << vsg_pkg::CoordW;
  localparam int WordW = vsg_pkg::EdgeW + vsg_pkg::EdgeBlockW;

  typedef enum logic [2:0] {
    StIdle,
    StClear,
    StFirst,
    StSecond,
    StBucket,
    StStore
  } state_e;

  state_e state_d, state_q;
  vsg_pkg::line_t     clear_d, clear_q;
  vsg_pkg::edge_ptr_t number_d, number_q;
  vsg_pkg::edge_t     loaded_d, loaded_q;
  vsg_pkg::error_e    error_d, error_q;

  logic [vsg_pkg::EdgeW-1:0] bucket_mem [Lines];
  logic [WordW-1:0]          edge_mem   [vsg_pkg::EdgeBlocks];
  logic [vsg_pkg::EdgeW-1:0] bucket_q;
  logic [WordW-1:0]          word_q;

  logic bucket_write, bucket_read, store;
  vsg_pkg::line_t bucket_address;
  vsg_pkg::edge_ptr_t bucket_word;
  logic [vsg_pkg::EdgeAddrW-1:0] edge_address;

  // The last line on which an edge is present must lie below the last of the frame.
  logic [vsg_pkg::CoordW:0] last_line;
  logic in_frame;
  assign last_line = {1'b0, loaded_q.first_line} + {1'b0, loaded_q.lines} - 1'b1;
  assign in_frame  = (loaded_q.first_line != '0) && (last_line < {1'b0, height_i});

  always_comb begin
    state_d  = state_q;
    clear_d  = clear_q;
    number_d = number_q;
    loaded_d = loaded_q;
    error_d  = error_q;
    count_o  = '0;
    load_ready_o   = 1'b0;
    polygon_read_o = 1'b0;
    polygon_o      = loaded_q.second_polygon;
    bucket_write   = 1'b0;
    bucket_read    = bucket_read_i;
    bucket_address = bucket_line_i;
    bucket_word    = '0;
    store          = 1'b0;
    case (state_q)
      StIdle: begin
        load_ready_o = (error_q == vsg_pkg::ErrorNone);
        polygon_o    = load_edge_i.first_polygon;
        if (load_valid_i && load_ready_o) begin
          if (number_q == vsg_pkg::EdgeBlockCount) begin
            error_d = vsg_pkg::ErrorEdgeMemoryFull;
          end else begin
            loaded_d           = load_edge_i;
            number_d           = number_q + 1'b1;
            polygon_read_o     = 1'b1;
            count_o.edges      = 1'b1;
            count_o.edge_reads = 1'b1;
            state_d            = StFirst;
          end
        end
      end
      StClear: begin
        bucket_write   = 1'b1;
        bucket_address = clear_q;
        clear_d        = clear_q + 1'b1;
        if (clear_q == height_i) state_d = StIdle;
      end
      StFirst: begin
        count_o.polygon_reads = 1'b1;
        polygon_read_o        = (loaded_q.second_polygon != '0);
        state_d = polygon_front_i ? StBucket : (loaded_q.second_polygon != '0) ? StSecond : StIdle;
      end
      StSecond: begin
        count_o.polygon_reads = polygon_front_i;
        state_d               = polygon_front_i ? StBucket : StIdle;
      end
      StBucket: begin
        count_o.front_edges = 1'b1;
        bucket_read         = 1'b1;
        bucket_address      = loaded_q.first_line;
        state_d             = StStore;
        if (loaded_q.lines == '0) begin
          state_d = StIdle;
        end else begin
          count_o.entered_edges = 1'b1;
          if (!in_frame) begin
            error_d = vsg_pkg::ErrorOutOfFrame;
            state_d = StIdle;
          end
        end
      end
      StStore: begin
        count_o.edge_writes = 1'b1;
        store               = 1'b1;
        bucket_write        = 1'b1;
        bucket_address      = loaded_q.first_line;
        bucket_word         = number_q;
        state_d             = StIdle;
      end
      default: state_d = StIdle;
    endcase
    if (frame_start_i) begin
      state_d  = StClear;
      clear_d  = '0;
      number_d = '0;
      error_d  = vsg_pkg::ErrorNone;
    end
  end

  assign edge_address = store ? number_q[vsg_pkg::EdgeAddrW-1:0] : edge_number_i[vsg_pkg::EdgeAddrW-1:0];

  always_ff @(posedge clk_i) begin
    if (bucket_write) bucket_mem[bucket_address] <= bucket_word;
    else if (bucket_read) bucket_q <= bucket_mem[bucket_address];
  end
  always_ff @(posedge clk_i) begin
    if (store) edge_mem[edge_address] <= {bucket_q, loaded_q};
    else if (edge_read_i) word_q <= edge_mem[edge_address];
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q  <= StIdle;
      clear_q  <= '0;
      number_q <= '0;
      loaded_q <= '0;
      error_q  <= vsg_pkg::ErrorNone;
    end else begin
      state_q  <= state_d;
      clear_q  <= clear_d;
      number_q <= number_d;
      loaded_q <= loaded_d;
      error_q  <= error_d;
    end
  end

  assign clearing_o    = (state_q == StClear);
  assign loading_o     = (state_q != StIdle);
  assign error_o       = error_q;
  assign bucket_edge_o = bucket_q;
  assign edge_o        = word_q[vsg_pkg::EdgeBlockW-1:0];
  assign edge_next_o   = word_q[WordW-1:vsg_pkg::EdgeBlockW];

endmodule
