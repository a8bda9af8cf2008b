// Random traffic for sinusoidal_axi: a host that does what it likes, ADCs whose codes jump or do not come, and a fault pin, while
// drive_properties looks on.
//
//     tools/bench verilator random_sinusoidal_traffic [+clocks=200000] [+seed=1]
//
// Doc: docs/integration.md   Test: tests/rtl/properties.sh

`timescale 1ns / 1ps

module random_sinusoidal_traffic;
  localparam int kConversion = 40;  // clocks
  localparam int kBus = 2731;       // code of the dc voltage: 24 of 36 V

  logic clk = 1'b0;
  always #20 clk = ~clk;

  logic fault = 1'b0, valid = 1'b0;
  logic [11:0] code_u = 12'd0, code_v = 12'd0, code_dc = 12'(kBus);
  wire sample;
  // All by the names of the drive's ports.
  wire rst, random, axi_awvalid_i, axi_awready_o, axi_wvalid_i, axi_wready_o, axi_bvalid_o, axi_bready_i;
  wire axi_arvalid_i, axi_arready_o, axi_rvalid_o, axi_rready_i, interrupt_o, locked_o, fault_o;
  wire [11:0] axi_awaddr_i, axi_araddr_i;
  wire [31:0] axi_wdata_i, axi_rdata_o;
  wire [3:0] axi_wstrb_i;
  wire [1:0] axi_bresp_o, axi_rresp_o;
  wire gates_uh_o, gates_ul_o, gates_vh_o, gates_vl_o, gates_wh_o, gates_wl_o;
  // Seldom, since a drive that is stopped calibrates its ADCs anew before a gate is on, which takes longer than a busy host lets it run.
  traffic #(.WRITES(400)) traffic (.*);
  sinusoidal_axi dut (
      .*, .clock_khz_i(20'd24_000),
      .fault_i(fault), .codes_valid_i(valid), .codes_u_i(code_u), .codes_v_i(code_v), .codes_dc_i(code_dc), .sample_o(sample)
  );
  drive_properties #(.SINUSOIDAL(1'b1)) properties (.*, .fault_pin(fault));

  // Between the edges, at which the host moves, so that every simulator sees the same.  Currents stay within a few codes, or the drive
  // would never get behind its calibration; now and then one is anything, the bus is, or a sample is lost.
  dice #(.SALT(1)) dice ();
  int left = 0;
  function automatic logic wild(input int between);
    int drawn;
    drawn = dice.draw(between);
    return random && drawn == 0;
  endfunction
  function automatic logic [11:0] code(input int middle);
    logic [11:0] any, near;
    any = 12'(dice.bits());
    near = 12'(middle + dice.draw(9) - 4);
    return wild(200) ? any : near;
  endfunction
  always @(posedge clk) begin
    #5;
    valid = !wild(400) && left == 1;
    if (left > 0) left = left - 1;
    if (sample) begin
      left = kConversion;
      code_u = code(0);
      code_v = code(0);
      code_dc = code(kBus);
    end
    fault = dice.now_and_then(fault, 3000, 10);
    if (!random || rst) fault = 1'b0;
  end
  initial traffic.play;
endmodule
