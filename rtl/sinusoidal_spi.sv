// sinusoidal_spi: steplock::SinusoidalSpi, printed by hlsgen from hls/bus/sinusoidal_spi.hpp:20.
// Do not edit: change the C++ and print again.

module sinusoidal_spi (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        fault_i,  // asynchronous pin, active high
    input  logic        codes_valid_i,  // one clock: the codes are of a new sample
    input  logic [11:0] codes_u_i,  // s0.11, current of phase u
    input  logic [11:0] codes_v_i,  // s0.11, current of phase v
    input  logic [11:0] codes_dc_i,  // u0.12, dc voltage
    input  logic        spi_cs_n_i,
    input  logic        spi_sclk_i,
    input  logic        spi_mosi_i,
    output logic        gates_uh_o,  // phase U, high side
    output logic        gates_ul_o,  // phase U, low side
    output logic        gates_vh_o,  // phase V, high side
    output logic        gates_vl_o,  // phase V, low side
    output logic        gates_wh_o,  // phase W, high side
    output logic        gates_wl_o,  // phase W, low side
    output logic        sample_o,  // strobe: hold currents and dc voltage now
    output logic        interrupt_o,  // level
    output logic        locked_o,  // running, the estimate is claimed to be right
    output logic        fault_o,  // the drive's fault is latched
    output logic        spi_miso_o,
    output logic        spi_selected_o  // drive miso now, where several slaves share it
);
  logic reply_bit;  // at `place` of the read's answer
  logic reply_error;  // of the present frame's answer

  wire bus_miso;
  wire bus_selected;
  wire bus_writing;
  wire [4:0] bus_place;
  wire bus_request_write;
  wire bus_request_read;
  wire [9:0] bus_request_index;
  wire [31:0] bus_request_data;
  wire [3:0] bus_request_strobes;
  spi bus (
      .clk(clk),
      .rst(rst),
      .pins_cs_n_i(spi_cs_n_i),
      .pins_sclk_i(spi_sclk_i),
      .pins_mosi_i(spi_mosi_i),
      .reply_bit_i(reply_bit),
      .reply_error_i(reply_error),
      .miso_o(bus_miso),
      .selected_o(bus_selected),
      .writing_o(bus_writing),
      .place_o(bus_place),
      .request_write_o(bus_request_write),
      .request_read_o(bus_request_read),
      .request_index_o(bus_request_index),
      .request_data_o(bus_request_data),
      .request_strobes_o(bus_request_strobes)
  );

  wire drive_gates_uh;
  wire drive_gates_ul;
  wire drive_gates_vh;
  wire drive_gates_vl;
  wire drive_gates_wh;
  wire drive_gates_wl;
  wire drive_sample;
  wire drive_interrupt;
  wire drive_locked;
  wire drive_fault;
  wire [31:0] drive_data;
  wire drive_read_error;
  wire drive_write_error;
  sinusoidal_registered drive (
      .clk(clk),
      .rst(rst),
      .fault_i(fault_i),
      .codes_valid_i(codes_valid_i),
      .codes_u_i(codes_u_i),
      .codes_v_i(codes_v_i),
      .codes_dc_i(codes_dc_i),
      .request_write_i(bus_request_write),
      .request_read_i(bus_request_read),
      .request_index_i(bus_request_index),
      .request_data_i(bus_request_data),
      .request_strobes_i(bus_request_strobes),
      .gates_uh_o(drive_gates_uh),
      .gates_ul_o(drive_gates_ul),
      .gates_vh_o(drive_gates_vh),
      .gates_vl_o(drive_gates_vl),
      .gates_wh_o(drive_gates_wh),
      .gates_wl_o(drive_gates_wl),
      .sample_o(drive_sample),
      .interrupt_o(drive_interrupt),
      .locked_o(drive_locked),
      .fault_o(drive_fault),
      .data_o(drive_data),
      .read_error_o(drive_read_error),
      .write_error_o(drive_write_error)
  );

  always_ff @(posedge clk) begin
    reply_bit <= (drive_data & (32'd1 << bus_place)) != 32'd0;  // line 40
    if (bus_writing) begin
      reply_error <= drive_write_error;
    end else begin
      reply_error <= drive_read_error;
    end
    if (rst) begin
      reply_bit <= 1'b0;
      reply_error <= 1'b0;
    end
  end

  assign gates_uh_o = drive_gates_uh;
  assign gates_ul_o = drive_gates_ul;
  assign gates_vh_o = drive_gates_vh;
  assign gates_vl_o = drive_gates_vl;
  assign gates_wh_o = drive_gates_wh;
  assign gates_wl_o = drive_gates_wl;
  assign sample_o = drive_sample;
  assign interrupt_o = drive_interrupt;
  assign locked_o = drive_locked;
  assign fault_o = drive_fault;
  assign spi_miso_o = bus_miso;
  assign spi_selected_o = bus_selected;
endmodule
