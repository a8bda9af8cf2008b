// drive_registers: steplock::DriveRegisters, printed by hlsgen from hls/bus/drive_registers.hpp:23.
// Do not edit: change the C++ and print again.

module drive_registers (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        request_write_i,
    input  logic        request_read_i,
    input  logic [9:0]  request_index_i,
    input  logic [31:0] request_data_i,
    input  logic [3:0]  request_strobes_i,  // bytes of `data` that count
    input  logic [31:0] word_i,  // the word register at `request.index`, or 0
    input  logic        hole_i,
    input  logic        refused_i,  // a write here changes nothing
    input  logic        unlocked_i,
    input  logic        tick_i,  // the slow time base
    input  logic [3:0]  drive_state_i,
    input  logic [3:0]  drive_reason_i,
    input  logic        drive_locked_i,
    input  logic        drive_reverse_i,
    input  logic [25:0] drive_frequency_i,  // u0.32
    input  logic [15:0] drive_duty_i,  // u1.15
    input  logic [15:0] drive_phase_error_i,  // s0.16
    input  logic [15:0] drive_counts_crossings_i,  // events, stops at 65535
    input  logic [15:0] drive_counts_missed_i,  // events, stops at 65535
    input  logic [15:0] drive_counts_freewheel_long_i,  // events, stops at 65535
    input  logic [15:0] drive_counts_limit_hits_i,  // events, stops at 65535
    input  logic [15:0] drive_counts_retries_i,  // events, stops at 65535
    output logic        command_configured_o,  // the words are valid; until then all six gates are off
    output logic        command_run_o,
    output logic        command_reverse_o,
    output logic        command_brake_to_stop_o,  // else coast
    output logic        command_clear_fault_o,  // a rising edge re-arms, once `run` is low and the cause is gone
    output logic        stopped_o,  // idle or in fault, and not told to run
    output logic [31:0] data_o,  // of the last read
    output logic        read_error_o,  // it was of a hole
    output logic        write_error_o,  // the last write was refused
    output logic        interrupt_o
);
  localparam logic [3:0] State_kIdle = 4'd0;
  localparam logic [3:0] State_kFault = 4'd10;
  localparam logic [3:0] Reason_kNone = 4'd0;

  logic configured;
  logic run;
  logic reverse;
  logic brake_to_stop;
  logic clear;  // to the drive, one clock
  logic cleared;  // a one was written since the drive's fault
  logic drive_fault;
  logic watchdog_fault;
  logic [3:0] fault_reason;
  logic [4:0] interrupts;
  logic [4:0] enabled;
  logic [11:0] period;  // ticks
  logic [11:0] left;  // ticks to the next heartbeat
  logic starting;  // no lock since `run` rose
  logic was_faulted;
  logic was_locked;
  logic [25:0] shot_frequency;  // u0.32
  logic [15:0] shot_duty;  // u1.15
  logic [15:0] shot_phase_error;  // s0.16
  logic [15:0] shot_counts_crossings;  // events, stops at 65535
  logic [15:0] shot_counts_missed;  // events, stops at 65535
  logic [15:0] shot_counts_freewheel_long;  // events, stops at 65535
  logic [15:0] shot_counts_limit_hits;  // events, stops at 65535
  logic [15:0] shot_counts_retries;  // events, stops at 65535
  logic [31:0] data;  // the answer to the last read
  logic read_error;
  logic write_error;

  wire command_configured = configured && !watchdog_fault;  // line 57
  wire either_130 = drive_state_i == State_kIdle || drive_state_i == State_kFault;  // line 130
  wire both_75 = request_write_i && !refused_i;  // line 75
  wire both_140 = period != 12'd0 && command_configured;  // line 140
  wire [9:0] sum_77 = request_index_i - 10'd9;  // line 77
  wire both = both_75 && sum_77[9:1] == 9'd0;
  wire both_141 = both_140 && tick_i && left == 12'd0 && !both;  // line 141
  wire choice =
      (both_75 && request_strobes_i[0] && request_index_i == 10'd3) ? request_data_i[1] : run;
  wire both_79 = both_75 && request_index_i == 10'd5;  // line 79
  wire [8:0] either_76 = {1'b0, {8{request_strobes_i[0]}}} | (request_strobes_i[1] ? 9'd256 : 9'd0);
  wire [11:0] ones = request_data_i[11:0] & {{3{either_76[8]}}, either_76};  // line 76
  wire drive_fault_next = drive_state_i == State_kFault || (drive_fault && !cleared);
  wire choice_2 = both_79 ? !ones[1] && watchdog_fault : watchdog_fault;
  wire both_160 = drive_state_i == State_kFault && !was_faulted;  // line 160
  wire [4:0] kept = (both_75 && request_index_i == 10'd6) ? ~ones[4:0] : 5'd31;  // line 91
  wire both_153 = drive_locked_i && !was_locked;  // line 153
  wire [3:0] sum_154 = drive_state_i + 4'd7;  // line 154
  wire [3:0] choice_154 =  // line 154
      (drive_locked_i || !was_locked) ? 4'd0 :
      (sum_154[3:1] == 3'd0) ? 4'd8 :
      4'd0;
  wire [3:0] wide_157 =  // line 157
      {1'b0, {1'b0, (both_141 ? 2'd2 : 2'd0) | {1'b0, both_160}} | (both_153 ? 3'd4 : 3'd0)};
  wire [4:0] choice_168 = (both_153 && starting) ? 5'd16 : 5'd0;  // line 168
  wire [4:0] events = {1'b0, wide_157 | choice_154} | choice_168;  // line 158
  wire [8:0] inverse_104 = ~either_76;  // line 104
  wire [11:0] either_105 = ones | (period & {{3{inverse_104[8]}}, inverse_104});  // line 105

  always_ff @(posedge clk) begin
    if (both_75) begin
      if (request_strobes_i[0]) begin
        if (request_index_i == 10'd3) begin
          configured <= request_data_i[0];
          reverse <= request_data_i[2];
          brake_to_stop <= request_data_i[3];
        end
        if (request_index_i == 10'd7) begin
          enabled <= request_data_i[4:0];
        end
      end
      clear <= request_index_i == 10'd5 && ones[0];
      if (request_index_i == 10'd9) begin
        period <= either_105;
      end
      if (request_index_i == 10'd11) begin
        shot_frequency <= drive_frequency_i;
        shot_duty <= drive_duty_i;
        shot_phase_error <= drive_phase_error_i;
        shot_counts_crossings <= drive_counts_crossings_i;
        shot_counts_missed <= drive_counts_missed_i;
        shot_counts_freewheel_long <= drive_counts_freewheel_long_i;
        shot_counts_limit_hits <= drive_counts_limit_hits_i;
        shot_counts_retries <= drive_counts_retries_i;
      end
      write_error <= 1'b0;
    end else begin
      clear <= 1'b0;
      if (request_write_i) begin
        write_error <= refused_i;
      end
    end
    run <= !both_141 && choice;  // line 110
    if (both_160) begin
      cleared <= 1'b0;
      fault_reason <= drive_reason_i;
    end else begin
      cleared <=
          (drive_state_i != State_kFault || was_faulted) && (cleared || (both_79 && ones[0]));
    end
    drive_fault <= drive_fault_next;
    watchdog_fault <= both_141 || choice_2;  // line 110
    interrupts <= (interrupts & kept) | events;  // line 92
    if (both_75 && request_index_i == 10'd9) begin
      left <= either_105;
    end else if (both || !both_140) begin
      left <= period;
    end else if (tick_i && !(tick_i && left == 12'd0)) begin
      left <= left - 12'd1;
    end
    starting <= !run || (starting && !both_153);
    was_faulted <= drive_state_i == State_kFault;  // line 62
    was_locked <= drive_locked_i;
    if (request_read_i) begin
      if (hole_i) begin
        data <= 32'd0;
      end else begin
        logic [3:0] wide_189;
        logic [9:0] wide_194;
        logic [11:0] choice_130;
        logic [11:0] wide_196;
        logic [5:0] part_182;
        logic [15:0] choice_68;
        logic [31:0] choice_68_2;  // line 68
        wide_189 =  // line 189
            {1'b0, {1'b0, (run ? 2'd2 : 2'd0) | {1'b0, configured}} | (reverse ? 3'd4 : 3'd0)};
        wide_194 =  // line 194
            {1'b0,
            {1'b0, {drive_reason_i, 4'd0} | {4'd0, drive_state_i}} |
            (drive_locked_i ? 9'd256 : 9'd0)};
        choice_130 =  // line 130
            run ? 12'd0 :
            either_130 ? 12'd2048 :
            12'd0;
        wide_196 =  // line 196
            {1'b0,
            {1'b0, wide_194 | (drive_reverse_i ? 10'd512 : 10'd0)} |
            (unlocked_i ? 11'd1024 : 11'd0)};
        part_182 = request_index_i[5:0];  // line 182
        choice_68 = (part_182 == 6'd16) ? shot_counts_retries : 16'd0;  // line 68
        case (part_182)
          6'd0: choice_68_2 = 32'd1398033483;
          6'd1: choice_68_2 = 32'd256;
          6'd2: choice_68_2 = 32'd3121;
          6'd3: choice_68_2 = {28'd0, wide_189 | (brake_to_stop ? 4'd8 : 4'd0)};
          6'd4: choice_68_2 = {20'd0, wide_196 | choice_130};
          6'd5: choice_68_2 =
              {24'd0,
              {6'd0, (watchdog_fault ? 2'd2 : 2'd0) | {1'b0, drive_fault_next}} |
              {fault_reason, 4'd0}};
          6'd6: choice_68_2 = {27'd0, interrupts};
          6'd7: choice_68_2 = {27'd0, enabled};
          6'd9: choice_68_2 = {20'd0, period};
          6'd12: choice_68_2 = {6'd0, shot_frequency};
          6'd13: choice_68_2 = {shot_phase_error, 16'd0} | {16'd0, shot_duty};
          6'd14: choice_68_2 = {shot_counts_missed, 16'd0} | {16'd0, shot_counts_crossings};
          6'd15: choice_68_2 =
              {shot_counts_limit_hits, 16'd0} | {16'd0, shot_counts_freewheel_long};
          default: choice_68_2 = {16'd0, choice_68};
        endcase
        data <= word_i | choice_68_2;
      end
      read_error <= hole_i;
    end
    if (rst) begin
      configured <= 1'b0;
      run <= 1'b0;
      reverse <= 1'b0;
      brake_to_stop <= 1'b0;
      clear <= 1'b0;
      cleared <= 1'b0;
      drive_fault <= 1'b0;
      watchdog_fault <= 1'b0;
      fault_reason <= Reason_kNone;
      interrupts <= 5'd0;
      enabled <= 5'd0;
      period <= 12'd0;
      left <= 12'd0;
      starting <= 1'b1;
      was_faulted <= 1'b0;
      was_locked <= 1'b0;
      shot_frequency <= 26'd0;
      shot_duty <= 16'd0;
      shot_phase_error <= 16'sd0;
      shot_counts_crossings <= 16'd0;
      shot_counts_missed <= 16'd0;
      shot_counts_freewheel_long <= 16'd0;
      shot_counts_limit_hits <= 16'd0;
      shot_counts_retries <= 16'd0;
      data <= 32'd0;
      read_error <= 1'b0;
      write_error <= 1'b0;
    end
  end

  assign command_configured_o = command_configured;
  assign command_run_o = run;
  assign command_reverse_o = reverse;
  assign command_brake_to_stop_o = brake_to_stop;
  assign command_clear_fault_o = clear;
  assign stopped_o = !run && either_130;
  assign data_o = data;
  assign read_error_o = read_error;
  assign write_error_o = write_error;
  assign interrupt_o = (interrupts & enabled) != 5'd0;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, request_data_i[31:12], request_strobes_i[3:2], sum_77[0], sum_154[0]};
endmodule
