// hall_decoder: steplock::HallDecoder, printed by hlsgen from hls/six_step/hall_decoder.hpp:29.
// Do not edit: change the C++ and print again.

module hall_decoder #(
    parameter logic DECODES = 1'b1
) (
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

  wire [2:0] other = code ^ last;  // line 57
  wire [2:0] sum_60 = other - 3'd1;  // line 60

  always_ff @(posedge clk) begin
    if (DECODES) begin
      logic [2:0] code_2;
      code_2 = (u_i ? 3'd4 : 3'd0) | {1'b0, v_i ? 2'd2 : 2'd0} | {2'd0, w_i};  // line 75
      code <= code_2;
      if (code_2 == code) begin
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
            last <= code;
            case (code)
              3'd1: sector <= 3'd5;
              3'd2: sector <= 3'd3;
              3'd3: sector <= 3'd4;
              3'd4: sector <= 3'd1;
              3'd5: sector <= 3'd0;
              default: sector <= 3'd2;
            endcase
            if (legal) begin
              logic either_3;
              either_3 = other == 3'd4 || sum_60[2:1] == 2'd0;
              if (either_3) begin
                logic choice_58;
                logic both_61;
                logic differ_62;
                choice_58 =  // line 58
                    (other == 3'd4) ? code[2] == code[1] :
                    (other == 3'd2) ? code[1] ^ code[2] :
                    code[0] == code[2];
                both_61 = sure && (choice_58 ^ reverse);  // line 61
                differ_62 = both_61 ^ back;  // line 62
                moved <= !differ_62;
                if (!differ_62) begin
                  reverse <= choice_58;
                end
                back <= both_61 && !back;
              end else begin
                moved <= 1'b0;
                back <= 1'b0;
              end
              sure <= either_3;
              jumped <= !either_3;
            end else begin
              moved <= 1'b0;
              sure <= 1'b0;
              back <= 1'b0;
              jumped <= 1'b1;
            end
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
    end else begin
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
  wire unused = &{1'b0, sum_60[0]};
endmodule
