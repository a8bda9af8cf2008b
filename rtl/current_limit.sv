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
  logic cut;  // off-time
  logic released;  // the comparator fell in this off-time
  logic hit;  // the first clock of an off-time
  logic [3:0] stuck;  // cuts in a row without release

  wire on = on_i && !cut;  // line 37
  wire both_41 = on && left == 12'd0;  // line 41
  wire hit_next = both_41 && comparator_i && words_off_time_i != 12'd0;
  wire either_50 = released || !comparator_i;  // line 50

  always_ff @(posedge clk) begin
    if (hit_next) begin
      left <= words_off_time_i;
      cut <= 1'b1;
    end else begin
      logic both_43;
      both_43 = cut && left[11:1] == 11'd0;  // line 43
      if (cut || on_i) begin
        if (both_43) begin
          left <= {4'd0, words_blanking_i};
          if (either_50) begin
            stuck <= 4'd0;
          end else begin
            logic [4:0] sum_46;
            sum_46 = {1'b0, stuck} + 5'd1;  // line 46
            if (!(sum_46[4] && sum_46[3:0] != 4'd15)) begin
              stuck <= sum_46[3:0];
            end
          end
        end else if (both_41) begin
          if (!comparator_i) begin
            stuck <= 4'd0;
          end
        end else begin
          left <= left - 12'd1;
        end
      end else begin
        left <= {4'd0, words_blanking_i};
      end
      cut <= both_43 ^ cut;
    end
    released <= cut && either_50;
    hit <= hit_next;
    if (rst) begin
      left <= 12'd0;
      cut <= 1'b0;
      released <= 1'b0;
      hit <= 1'b0;
      stuck <= 4'd0;
    end
  end

  assign on_o = on;
  assign hit_o = hit;
  assign stuck_o = stuck;
endmodule
