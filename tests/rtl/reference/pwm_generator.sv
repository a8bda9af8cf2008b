// PwmGenerator (hls/bridge/pwm_generator.hpp) as one would write it by hand: the yardstick for the
// size of what the generator prints.  Same ports, same behaviour in every clock.

module pwm_generator (
    input  logic        clk,
    input  logic        rst,
    input  logic [13:0] on_clocks_i,
    input  logic [13:0] period_i,
    input  logic [13:0] minimum_i,
    input  logic        centred_i,
    input  logic [7:0]  tick_periods_i,
    output logic        on_o,
    output logic        start_o,
    output logic        tick_o
);

  logic [13:0] left;      // clocks of the period, with this one
  logic [12:0] lead;      // clocks to the pulse
  logic [13:0] pulse;     // clocks of the pulse
  logic [7:0]  periods;   // periods to the next tick
  logic        first, waiting, always_on;

  // One bit more than the counter: the borrow says that it stood at zero.
  wire [13:0] lead_less  = {1'b0, lead} - 14'd1;
  wire [14:0] pulse_less = {1'b0, pulse} - 15'd1;
  wire [14:0] rest       = {1'b0, period_i} - {1'b0, on_clocks_i};

  wire ending     = left[13:1] == 13'd0;
  wire idle       = ending && !left[0];
  wire rise       = waiting && lead_less[13];
  wire counting   = rise || (on_o && !first);
  wire last_count = periods[7:1] == 7'd0;
  wire long_on    = on_clocks_i >= minimum_i;
  wire short_off  = rest[14] || rest[13:0] < minimum_i;

  always_ff @(posedge clk) begin
    first <= ending;
    if (ending) begin
      left      <= period_i;
      pulse     <= on_clocks_i;
      lead      <= centred_i ? rest[13:1] : 13'd0;
      waiting   <= long_on;
      always_on <= long_on && short_off;
    end else begin
      left <= left - 14'd1;
      if (counting) pulse <= pulse_less[13:0];
      if (waiting) lead <= lead_less[12:0];
      if (rise) waiting <= 1'b0;
    end
    if (first && !idle) periods <= last_count ? tick_periods_i : periods - 8'd1;

    on_o    <= !idle && (always_on || (counting && !pulse_less[14]));
    start_o <= first && !idle;
    tick_o  <= first && !idle && last_count;

    if (rst) begin
      left      <= 14'd0;
      lead      <= 13'd0;
      pulse     <= 14'd0;
      periods   <= 8'd0;
      first     <= 1'b0;
      waiting   <= 1'b0;
      always_on <= 1'b0;
      on_o      <= 1'b0;
      start_o   <= 1'b0;
      tick_o    <= 1'b0;
    end
  end

endmodule
