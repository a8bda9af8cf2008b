// phase_detector: steplock::PhaseDetector, printed by hlsgen from hls/six_step/phase_detector.hpp:33.
// Do not edit: change the C++ and print again.

module phase_detector (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic [1:0]  watch_i,  // what the error is made of
    input  logic        crossing_i,  // strobe: the back-EMF crossed zero
    input  logic [15:0] crossing_phase_i,  // u0.16, where in the step
    input  logic        before_seen_i,  // the level before the crossing showed in this step
    input  logic        commutate_i,  // first clock of a new step
    input  logic [2:0]  step_i,  // 0 to 5
    input  logic        reverse_i,  // the step counts down
    input  logic        changed_i,  // strobe: the sector moved by one
    input  logic        elapsed_i,  // strobe: a step's worth of VCO turns is over
    input  logic [15:0] phase_i,  // u0.16, turns of this step
    input  logic        detector_i,
    input  logic [15:0] expected_i,  // u0.16, the crossing's place in the step
    input  logic [15:0] lead_error_i,  // u0.16, error when the level before never showed
    input  logic [15:0] window_i,  // u0.16, errors below are good
    output logic [15:0] error_o,  // s0.16, turns of one step
    output logic        update_o,  // strobe: the error is new
    output logic        good_o,  // strobe: it is within the window (following: within 1/8)
    output logic        missed_o,  // strobe: it stands for a crossing that was not found
    output logic        hurries_o  // until the next one: freewheeling hid it, and the rotor led before
);
  localparam logic [1:0] Evidence_kCrossings = 2'd1;
  localparam logic [1:0] Evidence_kSectors = 2'd2;

  logic [17:0] error;  // s2.16: what is shown stops at its limits
  logic update;
  logic missed;
  logic answered;  // this step has had its crossing, or needs none
  logic before_;  // before_seen, from the step that a commutation ends
  logic hid;  // the last update was of a step on the level after
  logic hurries;  // and the rotor led before it; until the next update
  logic follows;  // the error is that of a sector
  logic turned;  // following: a whole turn since the last change or miss

  wire [16:0] magnitude = error[16:0] ^ {17{error[17]}};  // line 61
  wire choice = follows ? magnitude[16:13] == 4'd0 : magnitude < {1'b0, window_i};

  always_ff @(posedge clk) begin
    case (watch_i)
      Evidence_kCrossings, Evidence_kSectors: begin
        logic either_107;
        logic [15:0] choice_107;
        logic [16:0] choice_76;
        logic [17:0] wide_76;
        logic both_110;
        logic [15:0] choice_110;
        logic [17:0] difference_76;
        either_107 = !commutate_i || before_;  // line 107
        choice_107 =  // line 107
            either_107 ? expected_i :
            (hid || (!error[17] && error[16:13] != 4'd0)) ? lead_error_i :
            16'd0;
        choice_76 =  // line 76
            (watch_i == Evidence_kSectors) ? ((turned || elapsed_i) ? 17'd0 : 17'd65536) :
            {1'b0, choice_107};
        wide_76 = {1'b0, choice_76};  // line 76
        both_110 = elapsed_i && turned;  // line 110
        choice_110 =  // line 110
            (watch_i == Evidence_kSectors) ? (both_110 ? 16'd32768 : phase_i) :
            commutate_i ? {16{before_}} :
            crossing_phase_i;
        difference_76 = wide_76 - {2'd0, choice_110};  // line 76
        case (watch_i)
          Evidence_kCrossings: begin
            if (answered) begin
              update <= 1'b0;
              missed <= 1'b0;
            end else begin
              logic either_2;
              either_2 = commutate_i || crossing_i;
              if (either_2) begin
                error <= difference_76;
                hid <= !either_107;
                hurries <= !either_107 && (hid || (!error[17] && error[16:12] != 5'd0));
              end
              update <= either_2;
              missed <= commutate_i;
            end
            if (commutate_i) begin
              answered <= !detector_i && step_i != (reverse_i ? 3'd2 : 3'd5);
            end else begin
              answered <= crossing_i || answered;
            end
            turned <= 1'b0;
          end
          default: begin  // Evidence_kSectors
            logic either;
            either = both_110 || changed_i;
            if (either) begin
              error <= difference_76;
            end
            update <= either;
            missed <= both_110;
            answered <= 1'b1;
            hid <= !either && hid;
            hurries <= !either && hurries;
            turned <= !commutate_i && (turned ^ elapsed_i);
          end
        endcase
      end
      default: begin  // Evidence_kNothing, 2'd3
        update <= 1'b0;
        missed <= 1'b0;
        answered <= 1'b1;
        turned <= 1'b0;
      end
    endcase
    before_ <= before_seen_i;
    follows <= watch_i == Evidence_kSectors;  // line 69
    if (rst) begin
      error <= 18'sd0;
      update <= 1'b0;
      missed <= 1'b0;
      answered <= 1'b1;
      before_ <= 1'b0;
      hid <= 1'b0;
      hurries <= 1'b0;
      follows <= 1'b0;
      turned <= 1'b0;
    end
  end

  assign error_o =
      error[17] ? ((error[17:15] == 3'd7) ? error[15:0] : -16'sd32768) :
      (error[17:15] == 3'd0) ? error[15:0] :
      16'sd32767;
  assign update_o = update;
  assign good_o = !(!update || missed) && choice;
  assign missed_o = missed;
  assign hurries_o = hurries;
endmodule
