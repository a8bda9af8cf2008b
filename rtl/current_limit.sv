// current_limit: steplock::CurrentLimit, printed by hlsgen from hls/bridge/current_limit.hpp:22.
// Do not edit: change the C++ and print again.

module current_limit (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        on_i,  // the PWM's pulse
    input  logic        comparator_i,  // synchronised: current above the limit
    input  logic [7:0]  words_blanking_i,  // clocks after switch-on in which the comparator is not believed
    input  logic [11:0] words_off_time_i,  // clocks; 0 disables the current limit
    output logic        on_o,  // what is left of the pulse
    output logic        hit_o,  // one clock, the first of an off-time
    output logic [3:0]  stuck_o  // cuts in a row without release, stops at 15
);
  logic [11:0] left;  // clocks of off-time (cut) or of blanking
  logic due;  // of them 1 or none
  logic none;  // none; in an off-time there is always one
  logic cut;  // off-time
  logic released;  // the comparator fell in this off-time
  logic hit;  // the first clock of an off-time
  logic [3:0] stuck;  // cuts in a row without release

  wire both_39 = on_i && none;  // line 39
  wire both_41 = cut && due;  // line 41
  wire hit_next = both_39 && comparator_i && words_off_time_i != 12'd0;
  wire either_48 = released || !comparator_i;  // line 48

  always_ff @(posedge clk) begin
    if (hit_next) begin
      left <= words_off_time_i;
      due <= words_off_time_i[11:1] == 11'd0;
      none <= 1'b0;
    end else if (!both_41 && (on_i || cut)) begin
      if (!both_39) begin
        left <= left - 12'd1;
        due <= due || left == 12'd2;
      end
      none <= both_39 || left == 12'd1;
    end else begin
      left <= {4'd0, words_blanking_i};
      due <= words_blanking_i[7:1] == 7'd0;
      none <= words_blanking_i == 8'd0;
    end
    cut <= hit_next || (both_41 ^ cut);  // line 64
    released <= cut && either_48;
    hit <= hit_next;
    if (both_41) begin
      if (either_48) begin
        stuck <= 4'd0;
      end else begin
        logic [4:0] sum_44;
        sum_44 = {1'b0, stuck} + 5'd1;  // line 44
        if (!(sum_44[4] && sum_44[3:0] != 4'd15)) begin
          stuck <= sum_44[3:0];
        end
      end
    end else if (both_39 && !comparator_i) begin
      stuck <= 4'd0;
    end
    if (rst) begin
      left <= 12'd0;
      due <= 1'b1;
      none <= 1'b1;
      cut <= 1'b0;
      released <= 1'b0;
      hit <= 1'b0;
      stuck <= 4'd0;
    end
  end

  assign on_o = on_i && !cut;
  assign hit_o = hit;
  assign stuck_o = stuck;
endmodule
