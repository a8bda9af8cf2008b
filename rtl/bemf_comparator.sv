// bemf_comparator: steplock::BemfComparator, printed by hlsgen from hls/six_step/bemf_comparator.hpp:29.
// Do not edit: change the C++ and print again.

module bemf_comparator (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        u_i,  // synchronised comparators: terminal above the reference
    input  logic        v_i,  // see u
    input  logic        w_i,  // see u
    input  logic [2:0]  step_i,  // 0 to 5
    input  logic        reverse_i,  // direction of rotation
    input  logic        commutate_i,  // one clock, the first of a new step
    input  logic        chop_i,  // the chopped gate is meant to be on
    input  logic [15:0] phase_i,  // u0.16, turns of this step
    input  logic [1:0]  words_sampling_i,
    input  logic [9:0]  words_blanking_i,  // clocks after each edge of the chopped gate
    input  logic [7:0]  words_sample_every_i,  // clocks between samples; 0 counts as 1
    input  logic [3:0]  words_samples_i,  // of the filter, 1 to 15; 0 counts as 1
    output logic        crossing_o,  // one clock, once in a step at most
    output logic [15:0] crossing_phase_o,  // u0.16, where in the step it was
    output logic        before_seen_o,  // the level from before the crossing showed in this step
    output logic [15:0] freewheel_o  // u0.16, where freewheeling last ended in its step; all ones: it did not
);
  localparam logic [1:0] Sampling_kOnTime = 2'd0;
  localparam logic [1:0] Sampling_kBoth = 2'd2;

  logic [9:0] left;  // clocks to the next sample
  logic chop;  // chop in the last clock
  logic [3:0] count;  // the filter: 0 is before the crossing
  logic before_seen;  // the filter reached 0 in this step
  logic found;  // the crossing of this step
  logic crossing;  // one clock after the sample that decided
  logic [15:0] before_;  // u0.16, last sample that left the filter at 0
  logic [15:0] place;  // u0.16, middle of that one and the one after
  logic [15:0] freewheel;  // u0.16, first sample that brought the filter to 0

  wire [3:0] full = (words_samples_i == 4'd0) ? 4'd1 : words_samples_i;  // line 102
  wire [16:0] sum_120 = {1'b0, before_} + {1'b0, phase_i};  // line 120

  always_ff @(posedge clk) begin
    if (commutate_i) begin
      left <= words_blanking_i;
      count <= full;
      before_seen <= 1'b0;
      found <= 1'b0;
      crossing <= 1'b0;
      if (!before_seen) begin
        freewheel <= 16'd65535;
      end
    end else begin
      logic differ_58;
      differ_58 = chop_i ^ chop;  // line 58
      if (differ_58) begin
        left <= words_blanking_i;
      end else if (left[9:1] == 9'd0) begin
        left <= {2'd0, words_sample_every_i};
      end else begin
        left <= left - 10'd1;
      end
      if (found) begin
        found <= 1'b1;
        crossing <= 1'b0;
      end else if (words_sampling_i == Sampling_kBoth ||
          ((words_sampling_i != Sampling_kOnTime) ^ chop_i)) begin
        if (differ_58) begin
          found <= 1'b0;
          crossing <= 1'b0;
        end else if (left[9:1] == 9'd0) begin
          logic choice_110;  // line 110
          case (step_i)
            3'd0, 3'd3: choice_110 = w_i;
            3'd1, 3'd4: choice_110 = v_i;
            default: choice_110 = u_i;
          endcase
          if (choice_110 ^ reverse_i ^ step_i[0]) begin
            case (count)
              4'd0, 4'd1: begin
                logic [15:0] choice;
                choice = before_seen ? freewheel : phase_i;
                case (count)
                  4'd0: begin
                    before_seen <= 1'b1;
                    before_ <= phase_i;
                    freewheel <= choice;
                  end
                  default: begin  // 4'd1
                    count <= count - 4'd1;
                    before_seen <= 1'b1;
                    before_ <= phase_i;
                    freewheel <= choice;
                  end
                endcase
              end
              default: count <= count - 4'd1;
            endcase
            found <= 1'b0;
            crossing <= 1'b0;
          end else begin
            logic [4:0] sum_119;
            logic at_most_119;
            logic both_122;
            sum_119 = {1'b0, count} + 5'd1;  // line 119
            at_most_119 = {1'b0, full} <= sum_119;  // line 119
            both_122 = before_seen && at_most_119;  // line 122
            if (at_most_119) begin
              count <= full;
            end else begin
              count <= sum_119[3:0];
            end
            found <= both_122;
            crossing <= both_122;
            if (count == 4'd0) begin
              place <= sum_120[16:1];
            end
          end
        end else begin
          found <= 1'b0;
          crossing <= 1'b0;
        end
      end else begin
        found <= 1'b0;
        crossing <= 1'b0;
      end
    end
    chop <= chop_i;
    if (rst) begin
      left <= 10'd0;
      chop <= 1'b0;
      count <= 4'd0;
      before_seen <= 1'b0;
      found <= 1'b0;
      crossing <= 1'b0;
      before_ <= 16'd0;
      place <= 16'd0;
      freewheel <= 16'd0;
    end
  end

  assign crossing_o = crossing;
  assign crossing_phase_o = place;
  assign before_seen_o = before_seen;
  assign freewheel_o = (commutate_i && !before_seen) ? 16'd65535 : freewheel;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, sum_120[0]};
endmodule
