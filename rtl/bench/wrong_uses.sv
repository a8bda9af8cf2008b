// What a drive does when it is used wrongly: six_step_axi, its host, and the motor of motor.sv.
//
//     tools/bench verilator wrong_uses +use=5
//
// It prints one row: the use, what the drive says in the end, the rotor in r/min, the highest current over the limit, and for how many
// us at a stretch it was more than 1.15 of it, and when the end was, in ms.  FAILED: a promise of drive_properties was broken, or
// the drive is in lock at another speed than its rotor.  Uses from 1 on; 0 is the right one.
//
// Doc: docs/wrong_uses.md   Test: tests/rtl/wrong_uses.sh

`timescale 1ns / 1ps

module wrong_uses;
  localparam int kMs = 24_000, kLeast = 200, kMost = 2500;  // clocks; ms
  localparam real kLimitA = 7.0, kClockHz = 24.0e6;
  localparam int kPolePairs = 8;
  localparam logic [11:0] kControl = 12'h00c, kStatus = 12'h010, kFault = 12'h014, kLock = 12'h020, kSet = 12'h044, kClear = 12'h048;

  logic clk = 1'b0, rst = 1'b1, fault = 1'b0;
  always #20 clk = ~clk;

  wire [2:0] high, low;
  wire locked, latched;
  wire [5:0] gates = {high, low};

  int use_ = 0;
  wire [2:0] turned;  // the motor's comparators
  wire limited;
  // What the drive sees of them.
  wire [2:0] seen = use_ == 8 ? 3'b000 : use_ == 9 ? 3'b111 : use_ == 10 ? {turned[2], turned[0], turned[1]} : use_ == 11 ? ~turned : turned;
  wire limit = use_ == 12 ? 1'b1 : use_ == 13 ? 1'b0 : limited;

  hosted_drive drive (
      .clk(clk), .rst(rst), .comparator(seen), .limit(limit), .fault(fault), .high(high), .low(low), .locked(locked), .latched(latched)
  );
  judge judge (
      .clk(clk), .rst(rst), .high(high), .low(low), .locked(locked), .latched(latched), .rpm(motor.rpm), .peak_a(motor.peak_a)
  );
  bind six_step_axi drive_properties properties (.*, .fault_pin(pins_fault_i));
  motor motor (.clk(clk), .high(high), .low(low), .comparator(turned), .limit(limited));

  // At most so long at a stretch beyond 1.15 of the limit, in clocks.
  int beyond = 0, longest = 0;
  logic over;
  always @(posedge clk) begin
    over = 1'b0;
    for (int k = 0; k < 3; k++) if (motor.i[k] > 1.15 * kLimitA || motor.i[k] < -1.15 * kLimitA) over = 1'b1;
    beyond <= over ? beyond + 1 : 0;
    if (beyond > longest) longest <= beyond;
  end

  function automatic string name;
    case (use_)
      0: return "as it should be";
      1: return "clock of half the rate that the words are for";
      2: return "clock of twice the rate";
      3: return "never configured";
      4: return "every second word not written";
      5: return "no word written, configured";
      6: return "least duty above the greatest";
      7: return "dead time 0, and minimum on-time 255";
      8: return "comparators low for ever";
      9: return "comparators high for ever";
      10: return "comparators of u and v swapped";
      11: return "all comparators inverted";
      12: return "limit's comparator high for ever";
      13: return "limit's comparator low for ever";
      14: return "rotor locked";
      15: return "direction changed every ms";
      16: return "started and stopped every ms";
      17: return "reset in the middle of a run";
      18: return "all words written again while it runs";
      19: return "set speed 0";
      20: return "greatest set speed that the register holds";
      21: return "configured taken away while it runs";
      22: return "run before it is configured";
      23: return "fault pin up for one clock of 1000";
      24: return "all gains of the loop 1";
      default: return "";
    endcase
  endfunction

  function automatic string state_name(input logic [3:0] state);
    case (state)
      4'd0: return "idle";
      4'd5: return "accelerate";
      4'd6: return "pull in";
      4'd7: return "in lock";
      4'd8: return "slow down";
      4'd9: return "retry delay";
      4'd10: return "fault";
      default: return "another state";
    endcase
  endfunction
  function automatic string reason_name(input logic [3:0] reason);
    case (reason)
      4'd1: return "fault pin";
      4'd2: return "over-current";
      4'd3: return "step-out";
      4'd4: return "stall";
      4'd5: return "wrong lock";
      4'd6: return "no lock";
      4'd9: return "blocked";
      default: return "another reason";
    endcase
  endfunction

  // Changes a word of a stopped drive.
  task automatic change(input logic [11:0] address, input logic [31:0] clear, input logic [31:0] set);
    logic [31:0] old;
    drive.host.write(kLock, 32'h0000_c0de);
    drive.host.read(address, old);
    drive.host.write(address, (old & ~clear) | set);
    drive.host.write(kLock, 32'd0);
  endtask

  task automatic begin_use;
    drive.host.load(file);
    if (use_ == 4) for (int i = 0; i < 256; i += 2) drive.host.words[i] = drive.host.kNone;
    if (use_ == 5) for (int i = 0; i < 256; ++i) drive.host.words[i] = drive.host.kNone;
    if (use_ == 22) drive.host.write(kControl, 32'd2);
    if (use_ != 3) drive.host.write_config(errors, count);
    change(12'h0bc, 32'h0f00_0000, 32'h0100_0000);  // one failed attempt: it is to end soon
    case (use_)
      6: change(12'h0dc, 32'hffff_ffff, 32'h0800_7000);
      7: change(12'h084, 32'h00ff_00ff, 32'h0000_00ff);
      14: motor.load_nm = 10.0;
      19: change(12'h0cc, 32'hffff_ffff, 32'd0);
      20: change(12'h0cc, 32'hffff_ffff, 32'h03ff_ffff);
      24: change(12'h098, 32'hffff_ffff, 32'hffff_ffff);
      default: ;
    endcase
    motor.pace = use_ == 1 ? 2.0 : use_ == 2 ? 0.5 : 1.0;
    drive.host.write(kSet, use_ == 3 ? 32'd2 : 32'd3);
  endtask

  // In each ms.
  task automatic go_on(input int ms);
    case (use_)
      15: if (ms < kLeast) drive.host.write(ms % 2 == 1 ? kSet : kClear, 32'd4);
      16: if (ms < kLeast) drive.host.write(ms % 2 == 1 ? kSet : kClear, 32'd2);
      17: if (ms == 60) begin
        rst = 1'b1;
        @(negedge clk) rst = 1'b0;
      end
      18: if (ms == 60 || ms == 90) begin
        for (int i = 0; i < 256; ++i) if (drive.host.words[i] != drive.host.kNone) drive.host.write(drive.host.words[i][43:32], drive.host.words[i][31:0]);
      end
      21: if (ms == 60) drive.host.write(kClear, 32'd1);
      23: begin
        fault = 1'b1;
        @(negedge clk) fault = 1'b0;
      end
      default: ;
    endcase
  endtask

  string file;
  int errors, count, ms = 0, off = 0;
  logic [31:0] status, reason, value;
  real told;
  logic settled;
  string in_the_end;
  initial begin
    if (!$value$plusargs("config=%s", file) || !$value$plusargs("use=%d", use_)) judge.fail("no +config=FILE.mem, or no +use=N");
    repeat (4) @(negedge clk);
    rst = 1'b0;
    repeat (4) @(negedge clk);
    begin_use;
    settled = 1'b0;
    while (!settled && ms < kMost) begin
      go_on(ms);
      off = 0;
      repeat (kMs) begin
        @(negedge clk);
        if (gates == 6'd0) off = off + 1;
      end
      ms = ms + 1;
      drive.host.read(kStatus, status);
      settled = ms > kLeast && ((off == kMs && (status[3:0] == 4'd0 || status[3:0] == 4'd10)) || locked);
    end
    drive.host.write(12'h02c, 32'd1);  // SNAPSHOT
    drive.host.read(12'h030, value);
    drive.host.read(kFault, reason);
    told = value * kClockHz / 4294967296.0 * 10.0 / kPolePairs / motor.pace;
    in_the_end = reason[0] ? {"fault: ", reason_name(reason[7:4])} : settled ? state_name(status[3:0]) : {"tries on: ", state_name(status[3:0])};
    $display("| %0d | %s | %s | %0.0f | %0.2f | %0.1f | %0d |", use_, name(), in_the_end, motor.rpm, motor.peak_a / kLimitA,
             longest * 1.0e6 * motor.pace / kClockHz, ms);
    if (locked && (told < 0.95 * motor.rpm || told > 1.05 * motor.rpm))
      judge.fail($sformatf("in lock at %0.0f r/min, and the rotor turns at %0.0f", told, motor.rpm));
    $finish;
  end
endmodule
