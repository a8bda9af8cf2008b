// What a host of any bus does with its `read`, `write` and `refused`: it configures a drive, and waits until that has stopped.  Included
// by the module of the host.
//
// Doc: docs/integration.md   Test: tests/rtl/bench.sh

  localparam logic [11:0] kControl = 12'h00c, kStatus = 12'h010, kLock = 12'h020;
  localparam logic [31:0] kLockKey = 32'h0000_c0de, kStopped = 32'h0000_0800;

  // Looks at STATUS every so many clocks until the drive has stopped, or so often.
  task automatic until_stopped(input int every, input int most, output int looks);
    logic [31:0] value;
    looks = 0;
    do begin
      repeat (every) @(negedge clk);
      looks = looks + 1;
      read(kStatus, value);
    end while ((value & kStopped) == 0 && looks < most);
  endtask

  // The words of rtl/config/NAME.mem behind the lock, each read back, then CONTROL.configured.  `errors`: words that are not kept.
  // A file that is not there leaves `count` 0.
  localparam int kWords = 256;
  localparam logic [63:0] kNone = 64'hffff_ffff_ffff_ffff;
  logic [63:0] words[0:kWords-1];
  task automatic load(input string file);
    for (int i = 0; i < kWords; ++i) words[i] = kNone;
    $readmemh(file, words);
  endtask
  task automatic configure(input string file, output int errors, output int count);
    load(file);
    write_config(errors, count);
  endtask
  // What `load` has read; or what is left of it.
  task automatic write_config(output int errors, output int count);
    logic [31:0] value;
    logic runs, bad;
    errors = 0;
    count = 0;
    read(kStatus, value);
    runs = (value & kStopped) == 0;
    write(kControl, 32'd0);
    write(kLock, kLockKey);
    for (int i = 0; i < kWords; ++i) begin
      if (words[i] != kNone) begin
        count = count + 1;
        write(words[i][43:32], words[i][31:0]);
        bad = refused;
        read(words[i][43:32], value);
        if (bad || refused || value != words[i][31:0]) errors = errors + 1;
      end
    end
    write(kLock, 32'd0);
    write(kControl, 32'd1);
    if ((runs || refused) && errors == 0) errors = 1;
  endtask
