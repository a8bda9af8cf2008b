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

  logic [15:0] error;  // s0.16
  logic update;
  logic missed;
  logic answered;  // this step has had its crossing, or needs none
  logic before_;  // before_seen, from the step that a commutation ends
  logic hid;  // the last update was of a step on the level after
  logic hurries;  // and the rotor led before it; until the next update
  logic turned;  // following: a whole turn since the last change or miss

  wire [15:0] magnitude = error ^ {16{error[15]}};  // line 61
  wire [15:0] window = (watch_i == Evidence_kSectors) ? 16'd8192 : window_i;  // line 62
  wire either_71 = watch_i != Evidence_kCrossings || !commutate_i || answered;  // line 71
  wire missed_next = !either_71 || (watch_i == Evidence_kSectors && elapsed_i && turned);
  wire both_109 = elapsed_i && turned;  // line 109
  wire either_73 =  // line 73
      !(watch_i != Evidence_kCrossings || !crossing_i || answered) ||
      (watch_i == Evidence_kSectors && changed_i);

  always_ff @(posedge clk) begin
    if (missed_next || either_73) begin
      logic [15:0] choice_106;
      logic [16:0] choice_77;
      logic [17:0] wide_77;
      logic [15:0] choice_109;
      logic [17:0] difference_77;
      choice_106 =  // line 106
          (!missed_next || before_) ? expected_i :
          (hid || (!error[15] && error[14:13] != 2'd0)) ? lead_error_i :
          16'd0;
      choice_77 =  // line 77
          (watch_i == Evidence_kSectors) ? ((turned || elapsed_i) ? 17'd0 : 17'd65536) :
          {1'b0, choice_106};
      wide_77 = {1'b0, choice_77};  // line 77
      choice_109 =  // line 109
          (watch_i == Evidence_kSectors) ? ((both_109 || !either_71) ? 16'd32768 : phase_i) :
          either_71 ? crossing_phase_i :
          {16{before_}};
      difference_77 = wide_77 - {2'd0, choice_109};  // line 77
      if (difference_77[17]) begin
        if (difference_77[17:15] == 3'd7) begin
          error <= difference_77[15:0];
        end else begin
          error <= 16'd32768;
        end
      end else if (difference_77[17:15] == 3'd0) begin
        error <= difference_77[15:0];
      end else begin
        error <= 16'd32767;
      end
    end
    case (watch_i)
      Evidence_kCrossings: begin
        if (answered) begin
          update <= 1'b0;
          missed <= 1'b0;
        end else begin
          logic either_2;
          either_2 = commutate_i || crossing_i;
          update <= either_2;
          missed <= commutate_i;
          if (either_2) begin
            logic inverse;
            inverse = !(!commutate_i || before_);
            hid <= inverse;
            hurries <= inverse && (hid || (!error[15] && error[14:12] != 3'd0));
          end
        end
        if (commutate_i) begin
          answered <= !detector_i && step_i != (reverse_i ? 3'd2 : 3'd5);
        end else begin
          answered <= crossing_i || answered;
        end
        turned <= 1'b0;
      end
      Evidence_kSectors: begin
        logic either;
        either = both_109 || changed_i;
        update <= either;
        missed <= both_109;
        answered <= 1'b1;
        hid <= !either && hid;
        hurries <= !either && hurries;
        turned <= !commutate_i && (turned ^ elapsed_i);
      end
      default: begin  // Evidence_kNothing, 2'd3
        update <= 1'b0;
        missed <= 1'b0;
        answered <= 1'b1;
        turned <= 1'b0;
      end
    endcase
    before_ <= before_seen_i;
    if (rst) begin
      error <= 16'sd0;
      update <= 1'b0;
      missed <= 1'b0;
      answered <= 1'b1;
      before_ <= 1'b0;
      hid <= 1'b0;
      hurries <= 1'b0;
      turned <= 1'b0;
    end
  end

  assign error_o = error;
  assign update_o = update;
  assign good_o = update && !missed && magnitude < window;
  assign missed_o = missed;
  assign hurries_o = hurries;
endmodule
