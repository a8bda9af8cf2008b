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

  logic due;  // left_ is 0 or 1
  logic floating_u;
  logic floating_v;
  logic floating_w;
  logic floating_rises;
  logic [9:0] left;  // clocks to the next sample
  logic chop;  // chop in the last clock
  logic [3:0] count;  // the filter: 0 is before the crossing
  logic before_seen;  // the filter reached 0 in this step
  logic found;  // the crossing of this step
  logic crossing;  // one clock after the sample that decided
  logic [15:0] before_;  // u0.16, last sample that left the filter at 0
  logic [15:0] place;  // u0.16, middle of that one and the one after
  logic [15:0] freewheel;  // u0.16, first sample that brought the filter to 0

  wire differ_58 = chop_i ^ chop;  // line 58
  wire floating_w_next = step_i == 3'd0 || step_i == 3'd3;  // line 67
  wire [3:0] full = (words_samples_i == 4'd0) ? 4'd1 : words_samples_i;  // line 107
  wire [16:0] sum_137 = {1'b0, before_} + {1'b0, phase_i};  // line 137

  always_ff @(posedge clk) begin
    if (differ_58 || commutate_i) begin
      due <= words_blanking_i[9:1] == 9'd0;
    end else if (due) begin
      due <= words_sample_every_i[7:1] == 7'd0;
    end else begin
      due <= left == 10'd2;
    end
    floating_u <= !(floating_w_next || step_i == 3'd1 || step_i == 3'd4);  // line 67
    floating_v <= step_i == 3'd1 || step_i == 3'd4;  // line 125
    floating_w <= floating_w_next;  // line 67
    floating_rises <= reverse_i ^ step_i[0];  // line 127
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
      if (differ_58) begin
        left <= words_blanking_i;
      end else if (due) begin
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
        end else if (due) begin
          if (((floating_u && u_i) || (floating_v && v_i) || (floating_w && w_i)) ^
              floating_rises) begin
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
            logic either_136;
            either_136 = count == full - 4'd1 || count == full;  // line 136
            if (either_136 || count == 4'd15) begin
              count <= full;
            end else begin
              count <= count + 4'd1;
            end
            case (count)
              4'd15: begin
                found <= before_seen;
                crossing <= before_seen;
              end
              default: begin
                logic both_139;
                both_139 = before_seen && either_136;  // line 139
                case (count)
                  4'd0: begin
                    found <= both_139;
                    crossing <= both_139;
                    place <= sum_137[16:1];
                  end
                  default: begin
                    found <= both_139;
                    crossing <= both_139;
                  end
                endcase
              end
            endcase
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
    chop <= chop_i;  // line 60
    if (rst) begin
      due <= 1'b1;
      floating_u <= 1'b0;
      floating_v <= 1'b0;
      floating_w <= 1'b0;
      floating_rises <= 1'b0;
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
  wire unused = &{1'b0, sum_137[0]};
endmodule
