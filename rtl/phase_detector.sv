// phase_detector: steplock::PhaseDetector, printed by hlsgen from hls/six_step/phase_detector.hpp:28.
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
    output logic        missed_o  // strobe: it stands for a crossing that was not found
);
  localparam logic [1:0] Evidence_kCrossings = 2'd1;
  localparam logic [1:0] Evidence_kSectors = 2'd2;

  logic [15:0] error;  // s0.16
  logic update;
  logic missed;
  logic answered;  // this step has had its crossing, or needs none
  logic before_;  // before_seen, from the step that a commutation ends
  logic turned;  // following: a whole turn since the last change or miss

  wire [15:0] magnitude = error ^ {{15{error[15]}}, error[15]};  // line 55
  wire [15:0] window = (watch_i == Evidence_kSectors) ? 16'd8192 : window_i;  // line 56
  wire [15:0] found = {{15{before_}}, before_};  // line 76
  wire [17:0] difference_101 = {2'd0, before_ ? expected_i : lead_error_i} - {2'd0, found};
  wire [17:0] difference_101_2 = {2'd0, expected_i} - {2'd0, crossing_phase_i};  // line 101
  wire both = crossing_i && !answered;
  wire [16:0] place = turned ? 17'd0 : 17'd65536;  // line 101
  wire [17:0] difference_101_3 = {1'b0, place} - {2'd0, phase_i};  // line 101
  wire both_2 = elapsed_i && turned;
  wire both_80 = !detector_i && step_i != (reverse_i ? 3'd2 : 3'd5);  // line 80
  wire choice = commutate_i ? both_80 : crossing_i || answered;
  wire choice_2 = (watch_i == Evidence_kSectors && !changed_i) ? !(elapsed_i ^ !turned) : turned;

  always_ff @(posedge clk) begin
    if (rst) begin
      error <= 16'sd0;
      update <= 1'b0;
      missed <= 1'b0;
      answered <= 1'b1;
      before_ <= 1'b0;
      turned <= 1'b0;
    end else begin
      if (watch_i == Evidence_kCrossings) begin
        if (commutate_i) begin
          if (!answered) begin
            if ($signed(difference_101) < -18'sd32768) begin
              error <= 16'd32768;
            end else if ($signed(difference_101) < 18'sd32767) begin
              error <= difference_101[15:0];
            end else begin
              error <= 16'd32767;
            end
          end
          update <= !answered;
        end else begin
          if (both) begin
            if ($signed(difference_101_2) < -18'sd32768) begin
              error <= 16'd32768;
            end else if ($signed(difference_101_2) < 18'sd32767) begin
              error <= difference_101_2[15:0];
            end else begin
              error <= 16'd32767;
            end
          end
          update <= both;
        end
        missed <= commutate_i && !answered;
        before_ <= before_seen_i;
      end else begin
        if (watch_i == Evidence_kSectors) begin
          if (changed_i) begin
            if ($signed(difference_101_3) < -18'sd32768) begin
              error <= 16'd32768;
            end else if ($signed(difference_101_3) < 18'sd32767) begin
              error <= difference_101_3[15:0];
            end else begin
              error <= 16'd32767;
            end
          end else if (both_2) begin
            error <= 16'd32768;
          end
        end
        update <= watch_i == Evidence_kSectors && (changed_i || both_2);
        missed <= watch_i == Evidence_kSectors && !changed_i && both_2;
      end
      answered <= watch_i != Evidence_kCrossings || choice;
      turned <= !commutate_i && choice_2;  // line 68
    end
  end

  assign error_o = error;
  assign update_o = update;
  assign good_o = update && !missed && magnitude < window;
  assign missed_o = missed;
endmodule
