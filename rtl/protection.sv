// protection: steplock::Protection, printed by hlsgen from hls/six_step/protection.hpp:27.
// Do not edit: change the C++ and print again.

module protection (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        running_i,  // locked and under speed control
    input  logic        tick_i,  // time base of the wrong-lock test
    input  logic        commutate_i,  // a new step began
    input  logic        good_i,  // strobe: a crossing near its place
    input  logic        missed_i,  // strobe: a step without a crossing
    input  logic [25:0] frequency_i,  // u0.32, VCO turns per clock
    input  logic [15:0] duty_i,  // u1.15
    input  logic [15:0] bemf_duty_i,  // u1.15
    input  logic [15:0] freewheel_i,  // u0.16, of the present or last step
    input  logic [3:0]  stuck_i,  // hits of the current limit in a row with its comparator never released
    input  logic        fault_pin_i,  // synchronised
    input  logic        hall_i,  // steps come from the Hall sensors
    input  logic        hall_illegal_i,  // their code is 000 or 111
    input  logic [5:0]  words_misses_i,  // score at which a lock counts as lost: a miss adds 2, a good crossing takes 1
    input  logic [25:0] words_stall_i,  // u0.32: slower than this in speed control is a stall
    input  logic [15:0] words_slip_i,  // duty above the back-EMF's that no right lock shows
    input  logic [15:0] words_freewheel_i,  // u0.16: freewheeling for longer than this part of a step is wrong
    input  logic [11:0] words_wrong_lock_i,  // for how long; 0 disables the test
    input  logic [3:0]  words_over_current_i,  // limit hits in a row with the comparator never released; 0 disables
    output logic        lost_o,  // give up this try
    output logic        fatal_o,  // latch a fault, in any state
    output logic [3:0]  reason_o,
    output logic        freewheel_long_o  // strobe: the step that ended freewheeled for too long
);
  localparam logic [3:0] Reason_kNone = 4'd0;
  localparam logic [3:0] Reason_kStall = 4'd4;
  localparam logic [3:0] Reason_kWrongLock = 4'd5;
  localparam logic [3:0] Reason_kHallCode = 4'd8;

  logic [5:0] score;  // of missed crossings
  logic [2:0] slow;  // slow steps in a row
  logic [11:0] wrong;  // ticks in a row that look like a wrong lock
  logic [1:0] hall;  // ticks in a row with an illegal code

  wire [6:0] sum_89 = {1'b0, score} + 7'd2;  // line 89
  wire both_90 = good_i && score != 6'd0;  // line 90
  wire [5:0] choice =
      missed_i ? (sum_89[6] ? 6'd63 : sum_89[5:0]) : score + {{5{both_90}}, both_90};
  wire [5:0] score_next = running_i ? choice : 6'd0;
  wire below_70 = words_misses_i - 6'd1 < score_next;  // line 70
  wire [2:0] choice_96 = (slow == 3'd6) ? 3'd6 : slow + 3'd1;  // line 96
  wire [2:0] choice_2 = commutate_i ? ((frequency_i < words_stall_i) ? choice_96 : 3'd0) : slow;
  wire both_71 = running_i && choice_2 == 3'd6;  // line 71
  wire [12:0] sum_103 = {1'b0, wrong} + 13'd1;  // line 103
  wire below_54 = words_freewheel_i < freewheel_i;  // line 54
  wire either_61 =  // line 61
      $signed({1'b0, words_slip_i}) < $signed({1'b0, duty_i} - {1'b0, bemf_duty_i}) || below_54;
  wire [11:0] choice_3 =
      tick_i ? (either_61 ? (sum_103[12] ? 12'd4095 : sum_103[11:0]) : 12'd0) : wrong;
  wire [11:0] wrong_next = running_i ? choice_3 : 12'd0;
  wire below_72 = words_wrong_lock_i - 12'd1 < wrong_next;  // line 72
  wire [1:0] choice_106 = (hall == 2'd2) ? 2'd2 : hall + 2'd1;  // line 106
  wire [1:0] choice_4 = tick_i ? ((hall_i && hall_illegal_i) ? choice_106 : 2'd0) : hall;
  wire both_73 = running_i && choice_4 == 2'd2;  // line 73
  wire below_69 = words_over_current_i - 4'd1 < stuck_i;  // line 69
  wire either_74 = fault_pin_i || below_69;  // line 74
  wire [1:0] choice_76 =  // line 76
      fault_pin_i ? 2'd1 :
      below_69 ? 2'd2 : 2'd3;

  always_ff @(posedge clk) begin
    if (rst) begin
      score <= 6'd0;
      slow <= 3'd0;
      wrong <= 12'd0;
      hall <= 2'd0;
    end else begin
      score <= score_next;
      if (running_i) begin
        slow <= choice_2;
        hall <= choice_4;
      end else begin
        slow <= 3'd0;
        hall <= 2'd0;
      end
      wrong <= wrong_next;
    end
  end

  assign lost_o = below_70 || both_71 || below_72 || both_73;
  assign fatal_o = either_74;
  assign reason_o =
      (either_74 || below_70) ? {2'd0, choice_76} :
      both_71 ? Reason_kStall :
      below_72 ? Reason_kWrongLock :
      both_73 ? Reason_kHallCode : Reason_kNone;
  assign freewheel_long_o = commutate_i && below_54;
endmodule
