// hall_decoder: steplock::HallDecoder, printed by hlsgen from hls/six_step/hall_decoder.hpp:27.
// Do not edit: change the C++ and print again.

module hall_decoder (
    input  logic       clk,
    input  logic       rst,  // synchronous, active high
    input  logic       u_i,  // synchronised
    input  logic       v_i,  // synchronised
    input  logic       w_i,  // synchronised
    input  logic [9:0] hold_i,  // clocks
    output logic [2:0] sector_o,  // 0 to 5: of the last legal code
    output logic       legal_o,  // the code that stands is legal
    output logic       moved_o,  // one clock: the sector is new, and the rotor went on to it
    output logic       reverse_o,  // the last move went down
    output logic       jumped_o  // one clock: the sector is new, and says nothing about speed
);
  logic [2:0] code;  // u v w, one clock ago
  logic [9:0] left;  // clocks until the code counts
  logic stood;  // none: it counts
  logic [2:0] last;  // the last legal one that counted
  logic [2:0] sector;  // 0 to 5: its sector
  logic legal;  // of the last code that counted
  logic moved;  // one clock: to a neighbour, in earnest
  logic reverse;  // the last move went down
  logic sure;  // there was a move since the last jump
  logic back;  // the sector is the one before the last move's
  logic jumped;  // one clock: to no neighbour

  wire [2:0] code_next = (u_i ? 3'd4 : 3'd0) | {1'b0, v_i ? 2'd2 : 2'd0} | {2'd0, w_i};  // line 72
  wire [2:0] other = code ^ last;  // line 54
  wire [2:0] sum_57 = other - 3'd1;  // line 57

  always_ff @(posedge clk) begin
    code <= code_next;  // line 72
    if (code_next == code) begin
      if (!stood) begin
        left <= left - 10'd1;
      end
      stood <= stood || left == 10'd1;
    end else begin
      left <= hold_i;
      stood <= hold_i == 10'd0;
    end
    if (stood) begin
      logic either;
      logic either_2;
      either = code == 3'd5 || code == 3'd4 || code == 3'd6;
      either_2 = either || code == 3'd2 || code == 3'd3 || code == 3'd1;
      if (!legal || code != last) begin
        if (either_2) begin
          logic choice_61;
          logic choice;
          choice_61 = (legal && other != 3'd4) ? sum_57[2:1] == 2'd0 : legal;  // line 61
          choice = (other != 3'd4 && legal) ? sum_57[2:1] == 2'd0 : legal;
          last <= code;
          case (code)
            3'd1: sector <= 3'd5;
            3'd2: sector <= 3'd3;
            3'd3: sector <= 3'd4;
            3'd4: sector <= 3'd1;
            3'd5: sector <= 3'd0;
            default: sector <= 3'd2;
          endcase
          if (choice) begin
            logic differ_55;
            logic equal_55;
            logic equal_55_2;
            logic choice_55;
            logic both_58;
            logic differ_59;
            differ_55 = code[1] ^ code[2];  // line 55
            equal_55 = code[0] == code[2];  // line 55
            equal_55_2 = code[2] == code[1];  // line 55
            choice_55 =  // line 55
                (other == 3'd4) ? equal_55_2 :
                (other == 3'd2) ? differ_55 :
                equal_55;
            both_58 = sure && (choice_55 ^ reverse);  // line 58
            differ_59 = both_58 ^ back;  // line 59
            moved <= !differ_59;
            if (!differ_59) begin
              if (other == 3'd4) begin
                reverse <= equal_55_2;
              end else if (other == 3'd2) begin
                reverse <= differ_55;
              end else begin
                reverse <= equal_55;
              end
            end
            back <= both_58 && !back;
          end else begin
            moved <= 1'b0;
            back <= 1'b0;
          end
          sure <= choice || choice_61;
          jumped <= !choice;
        end else begin
          moved <= 1'b0;
          jumped <= 1'b0;
        end
      end else begin
        moved <= 1'b0;
        jumped <= 1'b0;
      end
      legal <= either_2;
    end else begin
      moved <= 1'b0;
      jumped <= 1'b0;
    end
    if (rst) begin
      code <= 3'd0;
      left <= 10'd0;
      stood <= 1'b1;
      last <= 3'd0;
      sector <= 3'd0;
      legal <= 1'b0;
      moved <= 1'b0;
      reverse <= 1'b0;
      sure <= 1'b0;
      back <= 1'b0;
      jumped <= 1'b0;
    end
  end

  assign sector_o = sector;
  assign legal_o = legal;
  assign moved_o = moved;
  assign reverse_o = reverse;
  assign jumped_o = jumped;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, sum_57[0]};
endmodule
