// Polygon blocks (figure 4) and the list of changing polygons, last in, first out. The word is split like that of segment
// memory: front side, active bit with the list's link, first segment. Latency: a polygon's word one cycle after read_i;
// the changing polygon one cycle after take_i. Refuses nothing; the tally counts polygons loaded.

module polygon_memory (
  input  logic                clk_i,
  input  logic                rst_ni,
  // load: a polygon a cycle, numbered in order
  input  logic                frame_start_i,
  input  logic                load_i,
  input  logic                load_front_i,
  output logic                load_full_o,
  // from the segment generator, the edge loader and the depth comparator
  input  logic                read_i,
  input  vsg_pkg::poly_ptr_t  read_polygon_i,
  input  logic                mark_i,          // put the polygon read last into the changing list
  // from the polygon segment lists and the segment eliminator
  input  logic                set_first_i,
  input  vsg_pkg::poly_ptr_t  set_polygon_i,
  input  vsg_pkg::ptr_t       set_segment_i,
  // from the segment eliminator: takes the polygon changed last; its word is there in the next cycle
  input  logic                take_i,
  output vsg_pkg::poly_ptr_t  changing_o,      // 0: the list is empty
  // word read or taken
  output logic                front_o,
  output logic                active_o,
  output vsg_pkg::ptr_t       first_segment_o,
  // to the tally
  output vsg_pkg::count_t     count_o
);

  localparam int Depth = vsg_pkg::PolygonBlocks;
  localparam int LinkW = vsg_pkg::PolyW + 1;

  logic                      front_mem [Depth];
  logic [LinkW-1:0]          link_mem  [Depth];  // active bit, next changing polygon
  logic [vsg_pkg::PtrW-1:0]  first_mem [Depth];

  vsg_pkg::poly_ptr_t loaded_q, loaded_d, changing_q, changing_d, read_q, read_d;
  logic taken_q;  // the word of the polygon taken is being read: unlink it in this cycle

  logic                      front_q;
  logic [LinkW-1:0]          link_q;
  logic [vsg_pkg::PtrW-1:0]  first_q;

  typedef logic [vsg_pkg::PolyAddrW-1:0] address_t;
  vsg_pkg::poly_ptr_t load_number, address;
  address_t write_address, first_address;
  assign load_number = loaded_q + 1'b1;
  assign load_full_o = loaded_q == vsg_pkg::PolygonBlockCount;
  assign address     = take_i ? changing_q : read_polygon_i;
  assign write_address = load_i ? load_number[vsg_pkg::PolyAddrW-1:0] : read_q[vsg_pkg::PolyAddrW-1:0];

  logic             link_write, first_write;
  logic [LinkW-1:0] link_word;
  assign link_write   = load_i || mark_i || taken_q;
  assign link_word    = mark_i ? {1'b1, changing_q} : '0;
  assign first_write  = load_i || set_first_i;
  assign first_address = load_i ? load_number[vsg_pkg::PolyAddrW-1:0] : set_polygon_i[vsg_pkg::PolyAddrW-1:0];

  always_ff @(posedge clk_i) begin
    if (load_i) front_mem[load_number[vsg_pkg::PolyAddrW-1:0]] <= load_front_i;
    if (read_i || take_i) front_q <= front_mem[address[vsg_pkg::PolyAddrW-1:0]];
  end
  always_ff @(posedge clk_i) begin
    if (link_write) link_mem[write_address] <= link_word;
    if (read_i || take_i) link_q <= link_mem[address[vsg_pkg::PolyAddrW-1:0]];
  end
  always_ff @(posedge clk_i) begin
    if (first_write) first_mem[first_address] <= load_i ? '0 : set_segment_i;
    if (read_i || take_i) first_q <= first_mem[address[vsg_pkg::PolyAddrW-1:0]];
  end

  always_comb begin
    loaded_d   = loaded_q;
    changing_d = changing_q;
    read_d     = read_q;
    if (load_i) loaded_d = load_number;
    if (read_i || take_i) read_d = address;
    if (mark_i) changing_d = read_q;
    if (taken_q) changing_d = link_q[vsg_pkg::PolyW-1:0];
    if (frame_start_i) begin
      loaded_d   = '0;
      changing_d = '0;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      loaded_q   <= '0;
      changing_q <= '0;
      read_q     <= '0;
      taken_q    <= 1'b0;
    end else begin
      loaded_q   <= loaded_d;
      changing_q <= changing_d;
      read_q     <= read_d;
      taken_q    <= take_i;
    end
  end

  assign changing_o      = changing_q;
  assign front_o         = front_q;
  assign active_o        = link_q[LinkW-1];
  assign first_segment_o = first_q;

  always_comb begin
    count_o = '0;
    count_o.polygons       = load_i;
    count_o.front_polygons = load_i && load_front_i;
    count_o.polygon_writes = load_i;
  end

endmodule
