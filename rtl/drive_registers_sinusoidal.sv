// drive_registers_sinusoidal: steplock::DriveRegisters<steplock::Sinusoidal>, printed by hlsgen from hls/bus/drive_registers.hpp:38.
// Do not edit: change the C++ and print again.

module drive_registers_sinusoidal (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        request_write_i,
    input  logic        request_read_i,
    input  logic [9:0]  request_index_i,
    input  logic [31:0] request_data_i,
    input  logic [3:0]  request_strobes_i,  // bytes of `data` that count
    input  logic [31:0] word_i,  // of the last read, if it was of a word or a constant, else 0
    input  logic        hole_i,
    input  logic        refused_i,  // a write here changes nothing
    input  logic        unlocked_i,
    input  logic        no_period_i,  // the bridge has to stay off
    input  logic        tick_i,  // the slow time base
    input  logic [3:0]  drive_state_i,
    input  logic [3:0]  drive_reason_i,
    input  logic        drive_locked_i,
    input  logic        drive_reverse_i,
    input  logic [15:0] drive_speed_i,  // s0.15
    input  logic [15:0] drive_reference_i,  // s0.15
    input  logic [15:0] drive_i_gamma_i,  // s0.15
    input  logic [15:0] drive_i_delta_i,  // s0.15
    input  logic [15:0] drive_angle_i,  // u0.16, turns
    input  logic [11:0] drive_v_dc_i,  // u0.12
    input  logic [13:0] drive_on_u_i,  // clocks
    input  logic [13:0] drive_on_v_i,  // clocks
    input  logic [13:0] drive_on_w_i,  // clocks
    input  logic [3:0]  drive_retries_i,
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
  localparam logic [3:0] SinusoidalState_kIdle = 4'd0;
  localparam logic [3:0] SinusoidalState_kFault = 4'd9;
  localparam logic [3:0] SinusoidalReason_kNone = 4'd0;

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
  logic taken;  // a snapshot since the reset
  logic read;  // a read since the reset
  logic [31:0] data;  // the answer to the last read, of what stands here
  logic read_error;
  logic write_error;

  wire both_65 = request_write_i && !refused_i && request_index_i == 10'd11;  // line 65
  wire [31:0] now_0 = {drive_reference_i, 16'd0} | {16'd0, drive_speed_i};  // line 213
  wire [31:0] now_1 = {drive_i_delta_i, 16'd0} | {16'd0, drive_i_gamma_i};  // line 213
  wire [27:0] now_2 = {drive_v_dc_i, 16'd0} | {12'd0, drive_angle_i};  // line 213
  wire [29:0] now_3 = {drive_on_v_i, 16'd0} | {16'd0, drive_on_u_i};  // line 213
  wire [29:0] now_4 = {drive_on_w_i, 16'd0} | {26'd0, drive_retries_i};  // line 213
  wire either_139 =  // line 139
      drive_state_i == SinusoidalState_kIdle || drive_state_i == SinusoidalState_kFault;

  wire [31:0] copies_0_data;
  telemetry_copy copies_0 (
      .clk(clk),
      .rst(rst),
      .read_i(request_read_i),
      .address_i({2'd0, !hole_i && request_index_i == 10'd12 && taken}),
      .write_i(both_65),
      .write_address_i(3'd1),
      .write_data_i(now_0),
      .data_o(copies_0_data)
  );

  wire [31:0] copies_1_data;
  telemetry_copy copies_1 (
      .clk(clk),
      .rst(rst),
      .read_i(request_read_i),
      .address_i({2'd0, !hole_i && request_index_i == 10'd13 && taken}),
      .write_i(both_65),
      .write_address_i(3'd1),
      .write_data_i(now_1),
      .data_o(copies_1_data)
  );

  wire [31:0] copies_2_data;
  telemetry_copy copies_2 (
      .clk(clk),
      .rst(rst),
      .read_i(request_read_i),
      .address_i({2'd0, !hole_i && request_index_i == 10'd14 && taken}),
      .write_i(both_65),
      .write_address_i(3'd1),
      .write_data_i({4'd0, now_2}),
      .data_o(copies_2_data)
  );

  wire [31:0] copies_3_data;
  telemetry_copy copies_3 (
      .clk(clk),
      .rst(rst),
      .read_i(request_read_i),
      .address_i({2'd0, !hole_i && request_index_i == 10'd15 && taken}),
      .write_i(both_65),
      .write_address_i(3'd1),
      .write_data_i({2'd0, now_3}),
      .data_o(copies_3_data)
  );

  wire [31:0] copies_4_data;
  telemetry_copy copies_4 (
      .clk(clk),
      .rst(rst),
      .read_i(request_read_i),
      .address_i({2'd0, !hole_i && request_index_i == 10'd16 && taken}),
      .write_i(both_65),
      .write_address_i(3'd1),
      .write_data_i({2'd0, now_4}),
      .data_o(copies_4_data)
  );

  wire [31:0] shown = copies_0_data | copies_1_data | copies_2_data | copies_3_data | copies_4_data;
  wire [31:0] data_2 = read ? shown : 32'd0;  // line 225
  wire both_84 = request_write_i && !refused_i;  // line 84
  wire [9:0] sum_86 = request_index_i - 10'd9;  // line 86
  wire both = both_84 && sum_86[9:1] == 9'd0;
  wire either_87 = period == 12'd0 || !configured || watchdog_fault;  // line 87
  wire both_87 = !(either_87 || !tick_i) && left == 12'd0 && !both;  // line 87
  wire choice =
      (both_84 && request_strobes_i[0] && request_index_i == 10'd3) ? request_data_i[1] : run;
  wire both_88 = both_84 && request_index_i == 10'd5;  // line 88
  wire [8:0] either_85 = {1'b0, {8{request_strobes_i[0]}}} | (request_strobes_i[1] ? 9'd256 : 9'd0);
  wire [11:0] ones = request_data_i[11:0] & {{3{either_85[8]}}, either_85};  // line 85
  wire drive_fault_next = drive_state_i == SinusoidalState_kFault || (drive_fault && !cleared);
  wire choice_2 = both_88 ? !ones[1] && watchdog_fault : watchdog_fault;
  wire [4:0] kept = (both_84 && request_index_i == 10'd6) ? ~ones[4:0] : 5'd31;  // line 100
  wire both_162 = drive_locked_i && !was_locked;  // line 162
  wire [2:0] wide_165 =  // line 165
      {1'b0,
      (both_87 ? 2'd2 : 2'd0) | {1'b0, drive_state_i == SinusoidalState_kFault && !was_faulted}};
  wire [3:0] choice_163 =  // line 163
      (drive_locked_i || !was_locked) ? 4'd0 :
      (drive_state_i[3] && drive_state_i[2:1] == 2'd0) ? 4'd8 :
      4'd0;
  wire [4:0] wide_166 = {1'b0, {1'b0, wide_165 | (both_162 ? 3'd4 : 3'd0)} | choice_163};
  wire [4:0] choice_177 = (both_162 && starting) ? 5'd16 : 5'd0;  // line 177
  wire [4:0] events = wide_166 | choice_177;  // line 167

  always_ff @(posedge clk) begin
    if (both_84) begin
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
    end else begin
      clear <= 1'b0;
    end
    run <= !both_87 && choice;  // line 116
    if (drive_state_i != SinusoidalState_kFault || was_faulted) begin
      cleared <= cleared || (both_88 && ones[0]);
    end else begin
      cleared <= 1'b0;
      fault_reason <= drive_reason_i;
    end
    drive_fault <= drive_fault_next;
    watchdog_fault <= both_87 || choice_2;  // line 116
    interrupts <= (interrupts & kept) | events;  // line 101
    if (both_84 && request_index_i == 10'd9) begin
      logic [8:0] inverse_113;
      logic [11:0] either_114;
      inverse_113 = ~either_85;  // line 113
      either_114 = ones | (period & {{3{inverse_113[8]}}, inverse_113});  // line 114
      period <= either_114;
      left <= either_114;
      write_error <= 1'b0;
    end else begin
      if (both || either_87) begin
        left <= period;
      end else if (tick_i && !(tick_i && left == 12'd0)) begin
        left <= left - 12'd1;
      end
      if (request_write_i) begin
        write_error <= refused_i;
      end
    end
    starting <= !run || (starting && !both_162);
    was_faulted <= drive_state_i == SinusoidalState_kFault;  // line 71
    was_locked <= drive_locked_i;
    taken <= both_65 || taken;  // line 227
    read <= request_read_i || read;  // line 226
    if (request_read_i) begin
      if (hole_i) begin
        data <= 32'd0;
      end else begin
        logic [3:0] wide_191;
        logic [9:0] wide_196;
        logic [11:0] choice_139;
        logic [11:0] wide_198;
        logic [12:0] wide_199;
        logic [5:0] part_187;
        logic [11:0] choice_3;
        logic [12:0] choice_4;
        wide_191 =  // line 191
            {1'b0, {1'b0, (run ? 2'd2 : 2'd0) | {1'b0, configured}} | (reverse ? 3'd4 : 3'd0)};
        wide_196 =  // line 196
            {1'b0,
            {1'b0, {drive_reason_i, 4'd0} | {4'd0, drive_state_i}} |
            (drive_locked_i ? 9'd256 : 9'd0)};
        choice_139 =  // line 139
            run ? 12'd0 :
            either_139 ? 12'd2048 :
            12'd0;
        wide_198 =  // line 198
            {1'b0,
            {1'b0, wide_196 | (drive_reverse_i ? 10'd512 : 10'd0)} |
            (unlocked_i ? 11'd1024 : 11'd0)};
        wide_199 = {1'b0, wide_198 | choice_139};  // line 199
        part_187 = request_index_i[5:0];  // line 187
        case (part_187)
          6'd5: choice_3 =
              {4'd0,
              {6'd0, (watchdog_fault ? 2'd2 : 2'd0) | {1'b0, drive_fault_next}} |
              {fault_reason, 4'd0}};
          6'd6: choice_3 = {7'd0, interrupts};
          6'd7: choice_3 = {7'd0, enabled};
          6'd9: choice_3 = period;
          default: choice_3 = 12'd0;
        endcase
        choice_4 =
            (part_187 == 6'd3) ? {9'd0, wide_191 | (brake_to_stop ? 4'd8 : 4'd0)} :
            (part_187 == 6'd4) ? wide_199 | (no_period_i ? 13'd4096 : 13'd0) :
            {1'b0, choice_3};
        data <= {19'd0, choice_4};
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
      fault_reason <= SinusoidalReason_kNone;
      interrupts <= 5'd0;
      enabled <= 5'd0;
      period <= 12'd0;
      left <= 12'd0;
      starting <= 1'b1;
      was_faulted <= 1'b0;
      was_locked <= 1'b0;
      taken <= 1'b0;
      read <= 1'b0;
      data <= 32'd0;
      read_error <= 1'b0;
      write_error <= 1'b0;
    end
  end

  assign command_configured_o = configured && !(watchdog_fault || no_period_i);
  assign command_run_o = run;
  assign command_reverse_o = reverse;
  assign command_brake_to_stop_o = brake_to_stop;
  assign command_clear_fault_o = clear;
  assign stopped_o = !run && either_139;
  assign data_o = data_2 | word_i | data;
  assign read_error_o = read_error;
  assign write_error_o = write_error;
  assign interrupt_o = (interrupts & enabled) != 5'd0;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, request_data_i[31:12], request_strobes_i[3:2], sum_86[0]};
endmodule
